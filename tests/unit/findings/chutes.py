"""Chutes in which findings appear, and what is found in them."""

import chutecalc
from tests.conftest import chute

G = 9.80665
PIPE = {"body": {"shape": "pipe", "radius_m": 0.3}}
LOCUS = {"wall": {"yield_locus_kpa": [[1.0, 0.6], [3.0, 1.4]]}}
PASSABLE = {"may_be_passed": True}


def codes(solution):
    return [finding.code for finding in solution.findings()]


def all_of(solution, code):
    return [finding for finding in solution.findings() if finding.code == code]


def found(solution, code):
    (finding,) = all_of(solution, code)
    return finding


def rectangular(width=0.5, **more):
    return {"body": {"shape": "rectangular", "width_m": width, **more}}


def fed(**belt):
    """Return a chute whose stream falls from a belt onto a floor."""
    floor = {"kind": "straight", "name": "floor", "start_m": [0.3, -0.5], "slope_deg": 55.0, "length_m": 6.0}
    data = chute(segments=[{"kind": "fall", "onto_next": True}, floor]).data
    return chutecalc.parse(data | {"inlet": {"belt": {"velocity_m_s": 3.0, "pulley_radius_m": 0.4} | belt}})


def solved(**tables):
    """Solve the base chute with tables replaced."""
    return chutecalc.solve(chute(**tables))


def along(slope, length=1.0, velocity=4.0):
    """Return inlet and segments of a stream that enters a straight along it."""
    return {
        "inlet": {"velocity_m_s": float(velocity), "slope_deg": slope},
        "segments": [{"kind": "straight", "slope_deg": slope, "length_m": length}],
    }
