"""Streams that are too thick or too slow for the model, or fill their section above its chamfers."""

import numpy as np
import pytest

from chutecalc.results.extremes import LARGEST
from tests.conftest import vee
from tests.unit.findings.chutes import PIPE, G, all_of, along, codes, found, rectangular, solved


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_thick_stream_by_its_width(factor):
    # depth over width is Q/(v b²): largest at the entry of a chute on which the stream accelerates
    velocity = 1000 / 3.6 / 800 / 0.3**2 * factor
    solution = solved(sections=rectangular(0.3), **along(60.0, velocity=velocity))
    assert ("thick_stream" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_thick_stream_by_its_radius(factor):
    depth = 1000 / 3.6 / 800 / 6.0 / 0.5
    solution = solved(
        sections=rectangular(0.5),
        liners={"wall": {"friction_deg": 0.0}},  # without friction a falling stream only gains speed
        inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
        segments=[{"kind": "curve", "radius_m": depth / 0.1 * factor, "to_slope_deg": 60.0}],
    )
    assert ("thick_stream" in codes(solution)) == (factor < 1)


def test_a_pipe_that_chokes_is_not_too_thick_for_its_vanishing_surface():
    """Depth is held against the greatest width: at most 1 in a pipe, however narrow its free surface is."""
    solution = solved(sections=PIPE, **along(15.0, length=9.0, velocity=3.0))
    assert solution.status[0] == "choke"
    assert "thick_stream" not in codes(solution)
    assert solution.trajectory.sampled[-1].extremes["thickness", LARGEST].value[0] <= 1.0


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_slow_stream(factor):
    # Fr² = v² b/(n A) = v³ b/(g cos a Q): 2 at the entry of an accelerating stream
    slope, flow = np.radians(60.0), 1000 / 3.6 / 800
    velocity = (4.0 * G * np.cos(slope) * flow / 0.5) ** (1 / 3) * factor
    solution = solved(sections=rectangular(0.5), **along(60.0, velocity=velocity))
    assert ("slow_stream" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("angle", [20.0, 50.0])
def test_missing_load(angle):
    # a vee without a top: m = 1 - K = (1 - K_v) sin²β
    solution = solved(sections=vee(angle), **along(40.0, length=0.5))
    ratio = (1 - np.sin(np.radians(50.0))) / (1 + np.sin(np.radians(50.0)))
    missing = (1 - ratio) * np.sin(np.radians(angle)) ** 2
    assert ("missing_load" in codes(solution)) == (missing > 0.1)
    if missing > 0.1:
        finding = found(solution, "missing_load")
        assert finding.numbers["missing_load"][0] == pytest.approx(missing, rel=1e-12)
        tangent = np.tan(np.radians(25.0))
        assert finding.numbers["equilibrium_friction"][0] == pytest.approx(
            tangent / np.cos(np.radians(angle)), rel=1e-12
        )


def test_no_missing_load_under_the_equilibrium_law():
    sections = vee(50.0)
    assert "missing_load" in codes(solved(sections=sections))
    assert "missing_load" not in codes(solved(sections=sections, model={"friction_law": "equilibrium"}))


def test_both_friction_laws_of_a_locus_are_told_each_at_its_own_pressure():
    """A 60° vee on a locus: the missing load's finding quotes what each law makes of the wall."""
    rows = [[0.5, 0.4], [6.0, 2.0]]
    laws = [
        solved(
            liners={"wall": {"yield_locus_kpa": rows}},
            model={"friction_law": law},
            sections={"body": {"shape": "vee", "chamfer_deg": 60.0}},
            **along(50.0, length=0.001, velocity=6.0),
        )
        for law in ("paper", "equilibrium")
    ]
    (missing,) = all_of(laws[0], "missing_load")
    paper, even = (law.segments[0].maximum["equivalent_friction"][0] for law in laws)
    assert missing.numbers["equivalent_friction"][0] == pytest.approx(paper, rel=1e-3)  # along a millimetre
    assert missing.numbers["equilibrium_friction"][0] == pytest.approx(even, rel=1e-3)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_above_chamfer(factor):
    base = {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0}
    wetted = solved().segments[0].entry["chamfer_wetted_m"][0]
    solution = solved(sections={"body": base | {"chamfer_m": float(wetted * factor)}})
    assert ("above_chamfer" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_above_the_half_circle(factor):
    depth = 1000 / 3.6 / 800 / 4.0 / (0.5 * np.pi)  # r such that the half circle is just full: A = π r²/2
    radius = float(np.sqrt(depth) * factor)
    solution = solved(sections={"body": {"shape": "circular", "radius_m": radius}})
    assert ("above_chamfer" in codes(solution)) == (factor < 1)


def test_geometry_follows_flow_but_not_for_a_vertical_fall():
    segments = [{"kind": "fall", "drop_m": 1.0}, {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0}]
    slanting = solved(segments=segments)
    vertical = solved(inlet={"velocity_m_s": 0.0, "slope_deg": 40.0}, segments=segments)
    fixed = solved(segments=[segments[0], segments[1] | {"from_slope_deg": 70.0}])
    assert "geometry_follows_flow" in codes(slanting)
    assert "geometry_follows_flow" not in codes(vertical) + codes(fixed)
