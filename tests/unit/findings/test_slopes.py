"""Floors on which friction wins, and spoons that do not clear themselves."""

import numpy as np
import pytest

from tests.conftest import vee
from tests.unit.findings.chutes import LOCUS, all_of, along, codes, found, rectangular, solved


@pytest.mark.parametrize("factor", [1.2499, 1.2501])
def test_decelerating_by_its_margin_to_the_critical_velocity(factor):
    # rectangular: tan a = μ (1 + K_v Q/(v_c b²)), so v_c is in closed form
    slope, wall, delta, width = np.radians(35.0), np.radians(25.0), np.radians(50.0), 0.5
    ratio = (1 - np.sin(delta)) / (1 + np.sin(delta))
    critical = ratio * 1000 / 3.6 / 800 / width**2 / (np.tan(slope) / np.tan(wall) - 1)
    solution = solved(sections=rectangular(width), **along(35.0, length=2.0, velocity=critical * factor))
    if factor < 1.25:
        finding = found(solution, "decelerating")
        assert finding.numbers["critical_velocity_m_s"][0] == pytest.approx(critical, rel=1e-12)
        assert finding.numbers["margin"][0] == pytest.approx(factor, rel=1e-9)
    else:
        assert "decelerating" not in codes(solution)


@pytest.mark.parametrize(("slope", "flat"), [(24.999, True), (25.001, True), (31.0, False)])
def test_decelerating_on_a_slope_flatter_than_friction(slope, flat):
    # a wide base: equivalent and wall friction differ by less than 4 %, or 1°
    solution = solved(sections=rectangular(4.0), **along(slope, length=0.5))
    assert ("decelerating" in codes(solution)) == flat


def test_a_taper_is_judged_where_it_is_worst():
    """Faster everywhere, and too slow at its narrow end: friction wins there below v_c = B1/A1."""
    sections = {name: {"shape": "rectangular", "width_m": width} for name, width in (("wide", 0.6), ("narrow", 0.16))}
    solution = solved(
        flow={"rate_t_h": 300.0},
        material={"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
        liners={"wall": {"friction_deg": 20.0}},
        sections=sections,
        inlet={"velocity_m_s": 4.0, "slope_deg": 22.0},
        segments=[{"kind": "straight", "slope_deg": 22.0, "length_m": 1.0, "section": ["wide", "narrow"]}],
    )
    (finding,) = all_of(solution, "decelerating")
    slope, mu = np.radians(22.0), np.tan(np.radians(20.0))
    ratio = np.tan(np.radians(22.5)) ** 2
    drag = mu * ratio * np.cos(slope) * 300 / 3600 / 0.16**2
    critical = drag / (np.sin(slope) - mu * np.cos(slope))
    assert critical == pytest.approx(5.07, abs=0.01)
    assert finding.numbers["critical_velocity_m_s"][0] == pytest.approx(critical, rel=1e-10)
    assert finding.numbers["velocity_m_s"][0] == solution.exit_velocity[0]
    assert finding.s_m[0] == pytest.approx(1.0, rel=1e-14)


def test_a_slow_stream_on_a_locus_quotes_the_friction_where_it_is_slowest():
    """0.9 m/s at the end of a short flat chute: τ/σ at ρ g H there, not where it entered."""
    solution = solved(liners=LOCUS, sections=rectangular(0.5), **along(2.0, length=0.02, velocity=1.0))
    (slow,) = all_of(solution, "decelerating")
    end = {name: values[0] for name, values in solution.exit.items()}
    assert solution.status[0] == "ok"
    assert 0.0 < end["velocity_m_s"] < 1.0
    stress = end["pressure_kpa"]  # of a rectangle, above the first row: τ = 0.2 kPa + 0.4 σ
    assert stress > 1.0
    assert slow.numbers["friction_deg"][0] == pytest.approx(np.degrees(np.arctan(0.4 + 0.2 / stress)), rel=1e-12)


def test_a_slow_stream_that_gains_speed_at_any_velocity_is_not_told_to_decelerate():
    """In a vee friction does not depend on depth: on a steep one there is no velocity below which it wins."""
    solution = solved(sections=vee(), **along(50.0, length=0.01, velocity=0.3))
    assert solution.exit["velocity_m_s"][0] > 0.3
    assert "decelerating" not in codes(solution)


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_below_cut_off(off):
    def ends_at(slope):
        return solved(
            sections=vee(45.0),
            inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
            segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": slope}],
        )

    friction = ends_at(45.0).exit["equivalent_friction"][0]  # of a vee: of no depth
    limit = float(np.degrees(np.arctan(friction)) + 5.0)
    assert ("below_cut_off" in codes(ends_at(limit + off))) == (off < 0)
    finding = found(ends_at(limit - 1.0), "below_cut_off")
    assert "rule of thumb" in finding.message()


def test_only_a_spoon_at_the_end_has_to_clear_itself():
    flat = {"kind": "straight", "slope_deg": 20.0, "length_m": 0.2}
    spoon = {"kind": "curve", "radius_m": 2.0, "from_slope_deg": 60.0, "to_slope_deg": 20.0}
    inlet = {"velocity_m_s": 5.0, "slope_deg": 60.0}
    for segments, expected in (
        ([spoon], True),
        ([spoon, flat], False),  # it ends in a straight, as flat as it may be
        ([spoon, {"kind": "fall", "drop_m": 1.0}], True),
        ([spoon, {"kind": "fall", "drop_m": 2.0}, spoon | {"from_slope_deg": 50.0, "to_slope_deg": 45.0}], False),
        ([{"kind": "curve", "radius_m": 9.0, "from_slope_deg": 10.0, "to_slope_deg": 20.0}], False),  # a crest
    ):
        slope = segments[0]["from_slope_deg"]
        solution = solved(inlet=inlet | {"slope_deg": slope}, segments=segments)
        if slope == 10.0:
            solution = solved(inlet={"velocity_m_s": 3.0, "slope_deg": 10.0}, segments=segments)
        assert solution.status[0] == "ok", segments
        assert bool(all_of(solution, "below_cut_off")) == expected, segments
