"""Wall friction that the material does not admit, and pressures at which nothing was measured."""

import numpy as np
import pytest

import chutecalc
from tests.conftest import chute
from tests.unit.findings.chutes import LOCUS, all_of, along, codes, rectangular, solved


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_inadmissible_friction(off):
    limit = np.degrees(np.arctan(np.sin(np.radians(30.0))))
    solution = solved(material={"internal_friction_deg": 30.0}, liners={"wall": {"friction_deg": float(limit + off)}})
    assert ("inadmissible_friction" in codes(solution)) == (off > 0)


def test_an_inadmissible_angle_is_quoted():
    solution = solved(liners={"wall": {"friction_deg": 40.0}})
    (finding,) = all_of(solution, "inadmissible_friction")
    greatest = np.degrees(np.arctan(np.sin(np.radians(50.0))))
    assert finding.numbers["friction_deg"][0] == pytest.approx(40.0, rel=1e-14)
    assert finding.numbers["greatest_deg"][0] == pytest.approx(greatest, rel=1e-14)
    assert "the wall friction of 40°" in finding.message()


def test_no_admissibility_without_an_angle_of_internal_friction():
    base = chute(
        liners={"wall": {"friction_deg": 39.0}}, segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 1.0}]
    )
    data = base.data
    data["material"] = {"density_kg_m3": 800.0, "pressure_ratio": 0.5}
    assert "inadmissible_friction" not in codes(chutecalc.solve(chutecalc.parse(data)))


@pytest.mark.parametrize("share", [0.999, 1.001])
def test_inadmissible_friction_where_the_bound_on_a_locus_binds(share):
    # one slope through the origin: the locus is the material's own at share 1
    slope = float(np.sin(np.radians(50.0)) * share)
    rows = [[1.0, slope], [2.0, 2 * slope]]
    solution = solved(liners={"wall": {"yield_locus_kpa": rows}}, **along(60.0))
    findings = all_of(solution, "inadmissible_friction")
    assert len(findings) == (share > 1)
    for finding in findings:
        greatest = np.degrees(np.arctan(np.sin(np.radians(50.0))))
        assert f"{greatest:.4g}° = atan(sin 50°)" in finding.message()


def test_the_range_of_a_locus_is_told_where_a_chute_leaves_it():
    (outside,) = all_of(stalled_on_a_locus(), "outside_locus")
    assert outside.numbers["most_kpa"][0] == np.inf
    assert outside.message().startswith("the floor carries ")
    assert "to ∞ kPa, but the yield locus was measured from 1 kPa to 3 kPa" in outside.message()
    inside = solved(liners={"wall": {"yield_locus_kpa": [[0.01, 0.006], [30.0, 14.0]]}}, **along(40.0, length=2.0))
    assert not all_of(inside, "outside_locus")


def test_an_impact_alone_can_leave_the_locus_and_meet_the_bound():
    """3 kPa and more under the impact, 1 to 3 kPa along the floor; a last line steeper than sin δ binds there alone."""

    def struck(last):
        return solved(
            flow={"rate_t_h": 3000.0},
            liners={"wall": {"yield_locus_kpa": [[0.5, 0.2], [4.0, 1.6], [4.1, 1.6 + 0.1 * last]]}},
            sections=rectangular(0.5),
            inlet={"velocity_m_s": 6.0, "slope_deg": 70.0},
            segments=[{"kind": "straight", "slope_deg": 45.0, "length_m": 2.0}],
        )

    solution = struck(11.0)
    floor = solution.segments[0]
    assert 0.5 < floor.minimum["pressure_kpa"][0] < floor.maximum["pressure_kpa"][0] < 4.0
    assert floor.impact["pressure_kpa"][0] > 4.1
    assert all_of(solution, "outside_locus")[0].s_m[0] == 0.0
    assert len(all_of(solution, "inadmissible_friction")) == 1
    assert not all_of(struck(0.4), "inadmissible_friction")


def stalled_on_a_locus(**more):
    return solved(liners=LOCUS, sections=rectangular(0.5), **more, **along(5.0, length=9.0, velocity=2.0))


def test_a_stall_on_a_locus_is_judged_at_the_pressure_of_rest():
    """There σ is infinite and μ the last slope, 0.4: no bound binds, and the friction reported is that of the entry."""
    solution = stalled_on_a_locus(material={"internal_friction_deg": 60.0})
    assert solution.status[0] == "stall"
    entry = solution.segments[0].entry["equivalent_friction"][0]
    ratio, depth = np.tan(np.radians(15.0)) ** 2, solution.segments[0].entry["depth_m"][0]
    wall = entry / (1 + ratio * depth / 0.5)
    (slow,) = all_of(solution, "decelerating")
    assert slow.numbers["friction_deg"][0] == pytest.approx(np.degrees(np.arctan(wall)), rel=1e-12)
    assert not all_of(solution, "inadmissible_friction")
    assert all_of(stalled_on_a_locus(material={"internal_friction_deg": 20.0}), "inadmissible_friction")
