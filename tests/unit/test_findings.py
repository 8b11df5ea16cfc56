"""Each finding appears above its threshold and not just below it."""

import numpy as np
import pytest

import chutecalc
from chutecalc.results.criterion import criterion
from chutecalc.results.extremes import LARGEST
from chutecalc.results.finding import Severity
from tests.conftest import ROOT, chute, vee

G = 9.80665


def codes(solution):
    return [finding.code for finding in solution.findings()]


def found(solution, code):
    (finding,) = [finding for finding in solution.findings() if finding.code == code]
    return finding


def rectangular(width=0.5, **more):
    return {"body": {"shape": "rectangular", "width_m": width, **more}}


def test_stall_inside_a_segment():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 2.0, "slope_deg": 5.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
        )
    )
    finding = found(solution, "stall")
    assert (finding.severity, finding.segment) == ("failure", "straight")
    assert finding.s_m[0] == solution.trajectory.segment_solutions[0].exit.distance[0]
    travelled, slope = (finding.numbers[name][0] for name in ("travelled_m", "slope_deg"))
    assert travelled == pytest.approx(finding.s_m[0], rel=1e-15)
    assert slope == pytest.approx(5.0, rel=1e-15)
    assert f"falls to 0 after {travelled:.4g} m on the segment, at a slope of 5°" in finding.message()


def test_stall_at_an_impact():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 4.0, "slope_deg": 90.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 1.0}],
        )
    )
    finding = found(solution, "stall")
    assert finding.numbers["incidence_deg"][0] == pytest.approx(85.0)
    assert finding.numbers["steepest_deg"][0] < 85.0
    assert solution.segments[0].entry["velocity_m_s"][0] == 0.0


@pytest.mark.parametrize("above", [True, False])
def test_choke(above):
    # the stream is deepest at its start, Q/(v b)
    deepest = 1000 / 3.6 / 800 / 4.0 / 0.5
    wall = deepest * (0.999999 if above else 1.000001)
    solution = chutecalc.solve(
        chute(
            sections=rectangular(wall_height_m=wall),
            segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": 1.0}],
        )
    )
    assert ("choke" in codes(solution)) == above
    assert (solution.status[0] == "choke") == above


def test_a_choke_says_where_the_stream_would_stop_or_that_it_would_run_on():
    stops = chutecalc.solve(
        chute(
            sections=rectangular(wall_height_m=0.4),
            inlet={"velocity_m_s": 3.0, "slope_deg": 5.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
        )
    )
    assert "would stop" in found(stops, "choke").message()
    assert "the wall height of 15.75 in;" in found(stops, "choke").message(units="us")
    runs = chutecalc.solve(
        chute(
            sections=rectangular(wall_height_m=0.4),
            inlet={"velocity_m_s": 3.0, "slope_deg": 5.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 1.0}],
        )
    )
    assert "run on" in found(runs, "choke").message()


@pytest.mark.parametrize(("factor", "lost"), [(1.0001, True), (0.9999, False)])
def test_contact_lost_at_the_start_of_a_crest(factor, lost):
    radius, slope = 2.0, np.radians(10.0)
    velocity = np.sqrt(radius * G * np.cos(slope)) * factor
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 35.0}},
            inlet={"velocity_m_s": float(velocity), "slope_deg": 10.0},
            segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": 10.001}],
        )
    )
    assert ("contact_lost" in codes(solution)) == lost


def test_contact_lost_is_a_warning_where_a_fall_follows():
    crest = {"kind": "curve", "radius_m": 1.0, "to_slope_deg": 80.0}
    inlet = {"velocity_m_s": 5.0, "slope_deg": 20.0}
    alone = chutecalc.solve(chute(inlet=inlet, segments=[crest]))
    caught = chutecalc.solve(chute(inlet=inlet, segments=[crest, {"kind": "fall", "drop_m": 1.0}]))
    assert found(alone, "contact_lost").severity == "failure"
    assert found(caught, "contact_lost").severity == "warning"
    assert (alone.status[0], caught.status[0]) == ("contact_lost", "ok")


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_inadmissible_friction(off):
    limit = np.degrees(np.arctan(np.sin(np.radians(30.0))))
    solution = chutecalc.solve(
        chute(material={"internal_friction_deg": 30.0}, liners={"wall": {"friction_deg": float(limit + off)}})
    )
    assert ("inadmissible_friction" in codes(solution)) == (off > 0)


def test_no_admissibility_without_an_angle_of_internal_friction():
    base = chute(
        liners={"wall": {"friction_deg": 39.0}}, segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 1.0}]
    )
    data = base.data
    data["material"] = {"density_kg_m3": 800.0, "pressure_ratio": 0.5}
    assert "inadmissible_friction" not in codes(chutecalc.solve(chutecalc.parse(data)))


@pytest.mark.parametrize("factor", [1.2499, 1.2501])
def test_decelerating_by_its_margin_to_the_critical_velocity(factor):
    # rectangular: tan a = μ (1 + K_v Q/(v_c b²)), so v_c is in closed form
    slope, wall, delta, width = np.radians(35.0), np.radians(25.0), np.radians(50.0), 0.5
    ratio = (1 - np.sin(delta)) / (1 + np.sin(delta))
    critical = ratio * 1000 / 3.6 / 800 / width**2 / (np.tan(slope) / np.tan(wall) - 1)
    solution = chutecalc.solve(
        chute(
            sections=rectangular(width),
            inlet={"velocity_m_s": float(critical * factor), "slope_deg": 35.0},
            segments=[{"kind": "straight", "slope_deg": 35.0, "length_m": 2.0}],
        )
    )
    if factor < 1.25:
        finding = found(solution, "decelerating")
        assert finding.numbers["critical_velocity_m_s"][0] == pytest.approx(critical, rel=1e-12)
        assert finding.numbers["margin"][0] == pytest.approx(factor, rel=1e-9)
    else:
        assert "decelerating" not in codes(solution)


@pytest.mark.parametrize(("slope", "flat"), [(24.999, True), (25.001, True), (31.0, False)])
def test_decelerating_on_a_slope_flatter_than_friction(slope, flat):
    # a wide base: equivalent and wall friction differ by less than 4 %, or 1°
    solution = chutecalc.solve(
        chute(
            sections=rectangular(4.0),
            inlet={"velocity_m_s": 4.0, "slope_deg": slope},
            segments=[{"kind": "straight", "slope_deg": slope, "length_m": 0.5}],
        )
    )
    assert ("decelerating" in codes(solution)) == flat


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_below_cut_off(off):
    def ends_at(slope):
        return chutecalc.solve(
            chute(
                sections=vee(45.0),
                inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
                segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": slope}],
            )
        )

    friction = ends_at(45.0).exit["equivalent_friction"][0]  # of a vee: of no depth
    limit = float(np.degrees(np.arctan(friction)) + 5.0)
    assert ("below_cut_off" in codes(ends_at(limit + off))) == (off < 0)
    finding = found(ends_at(limit - 1.0), "below_cut_off")
    assert "rule of thumb" in finding.message()


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_thick_stream_by_its_width(factor):
    # depth over width is Q/(v b²): largest at the entry of a chute on which the stream accelerates
    velocity = 1000 / 3.6 / 800 / 0.3**2 * factor
    solution = chutecalc.solve(
        chute(
            sections=rectangular(0.3),
            inlet={"velocity_m_s": velocity, "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 1.0}],
        )
    )
    assert ("thick_stream" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_thick_stream_by_its_radius(factor):
    depth = 1000 / 3.6 / 800 / 6.0 / 0.5
    solution = chutecalc.solve(
        chute(
            sections=rectangular(0.5),
            liners={"wall": {"friction_deg": 0.0}},  # without friction a falling stream only gains speed
            inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
            segments=[{"kind": "curve", "radius_m": depth / 0.1 * factor, "to_slope_deg": 60.0}],
        )
    )
    assert ("thick_stream" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_slow_stream(factor):
    # Fr² = v² b/(n A) = v³ b/(g cos a Q): 2 at the entry of an accelerating stream
    slope, flow = np.radians(60.0), 1000 / 3.6 / 800
    velocity = (4.0 * G * np.cos(slope) * flow / 0.5) ** (1 / 3) * factor
    solution = chutecalc.solve(
        chute(
            sections=rectangular(0.5),
            inlet={"velocity_m_s": float(velocity), "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 1.0}],
        )
    )
    assert ("slow_stream" in codes(solution)) == (factor < 1)


@pytest.mark.parametrize("angle", [20.0, 50.0])
def test_missing_load(angle):
    # a vee without a top: m = 1 - K = (1 - K_v) sin²β
    solution = chutecalc.solve(
        chute(sections=vee(angle), segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": 0.5}])
    )
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


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_above_chamfer(factor):
    base = {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 45.0}
    wetted = chutecalc.solve(chute()).segments[0].entry["chamfer_wetted_m"][0]
    solution = chutecalc.solve(chute(sections={"body": base | {"chamfer_m": float(wetted * factor)}}))
    assert ("above_chamfer" in codes(solution)) == (factor < 1)


def test_geometry_follows_flow_but_not_for_a_vertical_fall():
    segments = [{"kind": "fall", "drop_m": 1.0}, {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0}]
    slanting = chutecalc.solve(chute(segments=segments))
    vertical = chutecalc.solve(chute(inlet={"velocity_m_s": 0.0, "slope_deg": 40.0}, segments=segments))
    fixed = chutecalc.solve(chute(segments=[segments[0], segments[1] | {"from_slope_deg": 70.0}]))
    assert "geometry_follows_flow" in codes(slanting)
    assert "geometry_follows_flow" not in codes(vertical) + codes(fixed)


def test_findings_of_the_papers_worked_example_are_those_that_physics_names():
    def of(name):
        return chutecalc.solve(chutecalc.load(ROOT / f"specs/paper/{name}.toml"))

    for shape in ("square", "chamfered"):
        for delta in (30, 55):
            share = found(of(f"r1_d{delta}_{shape}"), "thick_stream").numbers["share"][0]
            assert 0.13 <= round(share, 2) <= 0.16
    assert found(of("r1_d30_square"), "slow_stream").numbers["froude"][0] == pytest.approx(1.99, abs=0.005)


def test_a_finding_masks_the_designs_it_is_about():
    base = chute(sections=rectangular(0.5), segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 1.0}])
    solution = chutecalc.solve(base.vary({"inlet.velocity_m_s": [1.0, 8.0, 1.5, 9.0], "inlet.slope_deg": 5.0}))
    stall = found(solution, "stall")
    assert (stall.mask == (solution.status == "stall")).all()
    assert stall.mask.any()
    assert not stall.mask.all()


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_steep_impact(off):
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 5.0, "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": 40.0 - off, "length_m": 1.0}],
        )
    )
    assert ("steep_impact" in codes(solution)) == (off > 0)


def test_passed_by():
    short = {"name": "short", "kind": "straight", "slope_deg": 60.0, "length_m": 0.05}
    long = {"name": "long", "kind": "straight", "slope_deg": 60.0, "length_m": 5.0}
    flying, along = ({"velocity_m_s": 3.0, "slope_deg": slope} for slope in (20.0, 60.0))
    leaves = chutecalc.solve(chute(inlet=flying, segments=[short, long]))
    follows = chutecalc.solve(chute(inlet=along, segments=[short, long]))
    allowed = chutecalc.solve(chute(inlet=flying, segments=[short | {"may_be_passed": True}, long]))
    assert (found(leaves, "passed_by").segment, found(leaves, "passed_by").severity) == ("short", "failure")
    assert (leaves.status[0], [each.status[0] for each in leaves.segments]) == ("missed", ["missed", "not_reached"])
    assert "passed_by" not in codes(follows)
    assert (found(allowed, "passed_by").severity, allowed.status[0]) == ("note", "ok")


@pytest.mark.parametrize("off", [-0.001, 0.001])
def test_not_accelerated(off):
    # a belt uphill at ε lifts material by friction only if μ_b cos ε > sin ε: up to its friction angle
    solution = chutecalc.solve(chute(receiver={"velocity_m_s": 9.0, "slope_deg": -(20.0 + off), "friction_deg": 20.0}))
    assert ("not_accelerated" in codes(solution)) == (off > 0)
    assert np.isinf(solution.receiver["acceleration_length_m"][0]) == (off > 0)


@pytest.mark.parametrize("share", [0.999, 1.001])
def test_inadmissible_friction_where_the_bound_on_a_locus_binds(share):
    # one slope through the origin: the locus is the material's own at share 1
    slope = float(np.sin(np.radians(50.0)) * share)
    rows = [[1.0, slope], [2.0, 2 * slope]]
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": rows}},
            inlet={"velocity_m_s": 4.0, "slope_deg": 60.0},
            segments=[{"kind": "straight", "slope_deg": 60.0, "length_m": 1.0}],
        )
    )
    findings = all_of(solution, "inadmissible_friction")
    assert len(findings) == (share > 1)
    for finding in findings:
        greatest = np.degrees(np.arctan(np.sin(np.radians(50.0))))
        assert f"{greatest:.4g}° = atan(sin 50°)" in finding.message()


def test_no_missing_load_under_the_equilibrium_law():
    sections = vee(50.0)
    assert "missing_load" in codes(chutecalc.solve(chute(sections=sections)))
    assert "missing_load" not in codes(chutecalc.solve(chute(sections=sections, model={"friction_law": "equilibrium"})))


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_above_the_half_circle(factor):
    depth = 1000 / 3.6 / 800 / 4.0 / (0.5 * np.pi)  # r such that the half circle is just full: A = π r²/2
    radius = float(np.sqrt(depth) * factor)
    solution = chutecalc.solve(chute(sections={"body": {"shape": "circular", "radius_m": radius}}))
    assert ("above_chamfer" in codes(solution)) == (factor < 1)


LOCUS = {"wall": {"yield_locus_kpa": [[1.0, 0.6], [3.0, 1.4]]}}


def all_of(solution, code):
    return [finding for finding in solution.findings() if finding.code == code]


def test_a_taper_is_judged_where_it_is_worst():
    """Faster everywhere, and too slow at its narrow end: friction wins there below v_c = B1/A1."""
    sections = {name: {"shape": "rectangular", "width_m": width} for name, width in (("wide", 0.6), ("narrow", 0.16))}
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": 300.0},
            material={"density_kg_m3": 1000.0, "internal_friction_deg": 45.0},
            liners={"wall": {"friction_deg": 20.0}},
            sections=sections,
            inlet={"velocity_m_s": 4.0, "slope_deg": 22.0},
            segments=[{"kind": "straight", "slope_deg": 22.0, "length_m": 1.0, "section": ["wide", "narrow"]}],
        )
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


def stalled_on_a_locus(**more):
    return chutecalc.solve(
        chute(
            liners=LOCUS,
            sections=rectangular(0.5),
            inlet={"velocity_m_s": 2.0, "slope_deg": 5.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
            **more,
        )
    )


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


def test_a_slow_stream_on_a_locus_quotes_the_friction_where_it_is_slowest():
    """0.9 m/s at the end of a short flat chute: τ/σ at ρ g H there, not where it entered."""
    solution = chutecalc.solve(
        chute(
            liners=LOCUS,
            sections=rectangular(0.5),
            inlet={"velocity_m_s": 1.0, "slope_deg": 2.0},
            segments=[{"kind": "straight", "slope_deg": 2.0, "length_m": 0.02}],
        )
    )
    (slow,) = all_of(solution, "decelerating")
    end = {name: values[0] for name, values in solution.exit.items()}
    assert solution.status[0] == "ok"
    assert 0.0 < end["velocity_m_s"] < 1.0
    stress = end["pressure_kpa"]  # of a rectangle, above the first row: τ = 0.2 kPa + 0.4 σ
    assert stress > 1.0
    assert slow.numbers["friction_deg"][0] == pytest.approx(np.degrees(np.arctan(0.4 + 0.2 / stress)), rel=1e-12)


def test_a_slow_stream_that_gains_speed_at_any_velocity_is_not_told_to_decelerate():
    """In a vee friction does not depend on depth: on a steep one there is no velocity below which it wins."""
    solution = chutecalc.solve(
        chute(
            sections=vee(),
            inlet={"velocity_m_s": 0.3, "slope_deg": 50.0},
            segments=[{"kind": "straight", "slope_deg": 50.0, "length_m": 0.01}],
        )
    )
    assert solution.exit["velocity_m_s"][0] > 0.3
    assert "decelerating" not in codes(solution)


def test_the_range_of_a_locus_is_told_where_a_chute_leaves_it():
    (outside,) = all_of(stalled_on_a_locus(), "outside_locus")
    assert outside.numbers["most_kpa"][0] == np.inf
    assert outside.message().startswith("the floor carries ")
    assert "to ∞ kPa, but the yield locus was measured from 1 kPa to 3 kPa" in outside.message()
    inside = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": [[0.01, 0.006], [30.0, 14.0]]}},
            inlet={"velocity_m_s": 4.0, "slope_deg": 40.0},
            segments=[{"kind": "straight", "slope_deg": 40.0, "length_m": 2.0}],
        )
    )
    assert not all_of(inside, "outside_locus")


def test_an_impact_alone_can_leave_the_locus_and_meet_the_bound():
    """3 kPa and more under the impact, 1 to 3 kPa along the floor; a last line steeper than sin δ binds there alone."""

    def struck(last):
        return chutecalc.solve(
            chute(
                flow={"rate_t_h": 3000.0},
                liners={"wall": {"yield_locus_kpa": [[0.5, 0.2], [4.0, 1.6], [4.1, 1.6 + 0.1 * last]]}},
                sections=rectangular(0.5),
                inlet={"velocity_m_s": 6.0, "slope_deg": 70.0},
                segments=[{"kind": "straight", "slope_deg": 45.0, "length_m": 2.0}],
            )
        )

    solution = struck(30.0)
    floor = solution.segments[0]
    assert 0.5 < floor.minimum["pressure_kpa"][0] < floor.maximum["pressure_kpa"][0] < 4.0
    assert floor.impact["pressure_kpa"][0] > 4.1
    assert all_of(solution, "outside_locus")[0].s_m[0] == 0.0
    assert len(all_of(solution, "inadmissible_friction")) == 1
    assert not all_of(struck(0.4), "inadmissible_friction")


@pytest.mark.parametrize("walls", [{}, {"wall_height_m": 0.5}])
def test_what_a_stall_or_a_choke_brings_with_it_is_not_told_beside_it(walls):
    """On its way there the stream is above its chamfers, thick, and slow; a design that gets through is told so."""
    base = chute(
        sections={"body": {"shape": "chamfered", "base_m": 0.6, "chamfer_deg": 45.0, "chamfer_m": 0.1, **walls}},
        flow={"rate_t_h": 200.0},
        inlet={"velocity_m_s": 3.0, "slope_deg": 5.0},
        segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
    )
    told = {"thick_stream", "slow_stream", "above_chamfer"}
    solution = chutecalc.solve(base)
    assert solution.findings()[0].code == ("choke" if walls else "stall")
    assert told.isdisjoint(codes(solution))
    both = chutecalc.solve(base.vary({"inlet.velocity_m_s": [3.0, 0.2], "segments.1.length_m": [9.0, 0.0001]}))
    assert both.status.tolist() == [solution.status[0], "ok"]
    others = {finding.code: finding.mask.tolist() for finding in both.findings() if finding.code in told}
    assert others == {code: [False, True] for code in ("slow_stream", "above_chamfer")}


def test_an_impact_that_stops_the_stream_is_a_steep_one():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 4.0, "slope_deg": 85.0},
            liners={"wall": {"friction_deg": 35.0}},
            segments=[{"kind": "straight", "slope_deg": 15.0, "length_m": 2.0}],
        )
    )
    assert solution.status[0] == "stall"
    (steep,) = all_of(solution, "steep_impact")
    assert steep.numbers["incidence_deg"][0] == pytest.approx(70.0, rel=1e-12)
    assert steep.numbers["after_m_s"][0] == 0.0


def test_both_friction_laws_of_a_locus_are_told_each_at_its_own_pressure():
    """A 60° vee on a locus: the missing load's finding quotes what each law makes of the wall."""
    rows = [[0.5, 0.4], [6.0, 2.0]]
    laws = [
        chutecalc.solve(
            chute(
                liners={"wall": {"yield_locus_kpa": rows}},
                model={"friction_law": law},
                sections={"body": {"shape": "vee", "chamfer_deg": 60.0}},
                inlet={"velocity_m_s": 6.0, "slope_deg": 50.0},
                segments=[{"kind": "straight", "slope_deg": 50.0, "length_m": 0.001}],
            )
        )
        for law in ("paper", "equilibrium")
    ]
    (missing,) = all_of(laws[0], "missing_load")
    paper, even = (law.segments[0].maximum["equivalent_friction"][0] for law in laws)
    assert missing.numbers["equivalent_friction"][0] == pytest.approx(paper, rel=1e-3)  # along a millimetre
    assert missing.numbers["equilibrium_friction"][0] == pytest.approx(even, rel=1e-3)


@pytest.mark.parametrize(("kind", "words"), [("curve", "less"), ("hood", "more")])
def test_a_loss_of_contact_quotes_what_would_keep_it(kind, words):
    """v² = R g cos a at the balance, for this radius as for this velocity."""
    velocity, slopes = (3.0, (10.0, 80.0)) if kind == "curve" else (5.0, (-40.0, 30.0))
    segment = {"kind": kind, "radius_m": 2.5, "from_slope_deg": slopes[0], "to_slope_deg": slopes[1]}
    inlet = {"velocity_m_s": velocity, "slope_deg": slopes[0]}
    solution = chutecalc.solve(chute(inlet=inlet, segments=[segment, {"kind": "fall", "drop_m": 3.0}]))
    lost = all_of(solution, "contact_lost")[0]
    numbers = {name: values[0] for name, values in lost.numbers.items()}
    weight = 9.80665 * np.cos(np.radians(numbers["slope_deg"]))
    assert numbers["balance_m_s"] == pytest.approx(np.sqrt(2.5 * weight), rel=1e-12)
    assert numbers["balance_m_s"] == pytest.approx(numbers["velocity_m_s"], rel=1e-9)  # it leaves there
    assert numbers["radius_m"] == pytest.approx(numbers["velocity_m_s"] ** 2 / weight, rel=1e-12)
    assert f"there it would keep contact at {numbers['balance_m_s']:.4g} m/s or {words}, " in lost.message()
    assert f"m or {'more' if kind == 'curve' else 'less'}; it flies on" in lost.message()
    assert f"{numbers['velocity_m_s']:.4g} m/s" in lost.message()


def test_an_inadmissible_angle_is_quoted():
    solution = chutecalc.solve(chute(liners={"wall": {"friction_deg": 40.0}}))
    (finding,) = all_of(solution, "inadmissible_friction")
    greatest = np.degrees(np.arctan(np.sin(np.radians(50.0))))
    assert finding.numbers["friction_deg"][0] == pytest.approx(40.0, rel=1e-14)
    assert finding.numbers["greatest_deg"][0] == pytest.approx(greatest, rel=1e-14)
    assert "the wall friction of 40°" in finding.message()


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
        solution = chutecalc.solve(chute(inlet=inlet | {"slope_deg": slope}, segments=segments))
        if slope == 10.0:
            solution = chutecalc.solve(chute(inlet={"velocity_m_s": 3.0, "slope_deg": 10.0}, segments=segments))
        assert solution.status[0] == "ok", segments
        assert bool(all_of(solution, "below_cut_off")) == expected, segments


PASSABLE = {"may_be_passed": True}


def test_a_fall_that_is_never_reached_says_so():
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 0.0, "slope_deg": 90.0},
            segments=[
                {"kind": "fall", "onto_next": True},
                {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [-0.9, -1.0]} | PASSABLE,
                {"name": "last", "kind": "fall", "run_m": 3.0},
            ],
        )
    )
    assert solution.status[0] == "missed"
    (missed,) = all_of(solution, "missed")
    assert (missed.segment, missed.severity) == ("last", "failure")
    assert missed.message() == (
        "the stream never reaches the end of the fall: it falls straight down, or too steeply to get 3 m away; give"
        " drop_m instead of run_m"
    )


@pytest.mark.parametrize(
    ("inlet", "passed", "fall", "reason"),
    [
        (
            {"velocity_m_s": 1.0, "slope_deg": 80.0},
            {"kind": "straight", "slope_deg": 30.0, "length_m": 1.0, "start_m": [-2.0, -4.0]},
            {"run_m": 0.5},
            "it is already past that distance; increase run_m",
        ),
        (
            {"velocity_m_s": 5.0, "slope_deg": 0.0},
            {"kind": "hood", "radius_m": 2.0, "from_slope_deg": 20.0, "to_slope_deg": 60.0, "start_m": [1.0, 2.0]},
            {"drop_m": 0.5},
            "it is already below that level; increase drop_m",
        ),
    ],
)
def test_a_fall_that_is_never_reached_says_why(inlet, passed, fall, reason):
    last = {"name": "last", "kind": "fall", **fall}
    passed = passed | PASSABLE
    solution = chutecalc.solve(chute(inlet=inlet, segments=[{"kind": "fall", "onto_next": True}, passed, last]))
    (missed,) = all_of(solution, "missed")
    assert missed.message() == f"the stream never reaches the end of the fall: {reason}"


def test_a_stall_is_not_quoted_with_numbers_that_grow_without_bound():
    """One finding of each code and design, as for streams that do not stall, in words of its own."""
    base = chutecalc.load(ROOT / "specs/fails/stall.toml")
    many = chutecalc.solve(base.vary({"inlet.velocity_m_s": [1.5, 2.4]}))
    stalls = many.status == "stall"
    assert stalls.any()
    found = all_of(many, "decelerating")
    assert sum(finding.mask.astype(int) for finding in found).max() == 1
    (stalled,) = [finding for finding in found if (finding.mask & stalls).any()]
    assert "∞" not in stalled.message(int(np.flatnonzero(stalled.mask)[0]))
    assert "0 m/s" not in stalled.message(int(np.flatnonzero(stalled.mask)[0]))


def test_a_code_is_registered_once():
    with pytest.raises(ValueError, match="the finding 'stall' is registered twice, the second time in tests"):
        criterion("stall", Severity.NOTE, summary="")(lambda scene: [])


PIPE = {"body": {"shape": "pipe", "radius_m": 0.3}}


@pytest.mark.parametrize("body", [PIPE["body"], {"shape": "box", "width_m": 0.5, "height_m": 0.4}])
@pytest.mark.parametrize("above", [True, False])
def test_a_closed_section_chokes_where_it_runs_full(body, above):
    area = np.pi * 0.3**2 if body["shape"] == "pipe" else 0.2
    rate = 3.6 * 800.0 * 4.0 * area * (1.000001 if above else 0.999999)  # full at the entry, and faster below
    steep = {
        "inlet": {"velocity_m_s": 4.0, "slope_deg": 70.0},
        "segments": [{"kind": "straight", "slope_deg": 70.0, "length_m": 1.0}],
    }
    solution = chutecalc.solve(chute(flow={"rate_t_h": float(rate)}, sections={"body": body}, **steep))
    assert (solution.status[0] == "choke") == ("choke" in codes(solution)) == above
    assert "above_chamfer" not in codes(solution)
    if above:
        assert "fills the closed section up to its roof" in found(solution, "choke").message()


def test_a_pipe_that_chokes_is_not_too_thick_for_its_vanishing_surface():
    """Depth is held against the greatest width: at most 1 in a pipe, however narrow its free surface is."""
    solution = chutecalc.solve(
        chute(
            sections=PIPE,
            inlet={"velocity_m_s": 3.0, "slope_deg": 15.0},
            segments=[{"kind": "straight", "slope_deg": 15.0, "length_m": 9.0}],
        )
    )
    assert solution.status[0] == "choke"
    assert "thick_stream" not in codes(solution)
    assert solution.trajectory.sampled[-1].extremes["thickness", LARGEST].value[0] <= 1.0


def fed(**belt):
    """Return a chute whose stream falls from a belt onto a floor."""
    floor = {"kind": "straight", "name": "floor", "start_m": [0.3, -0.5], "slope_deg": 55.0, "length_m": 6.0}
    data = chute(segments=[{"kind": "fall", "onto_next": True}, floor]).data
    return chutecalc.parse(data | {"inlet": {"belt": {"velocity_m_s": 3.0, "pulley_radius_m": 0.4} | belt}})


@pytest.mark.parametrize("friction", [{}, {"friction_deg": 30.0}])
@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_slides_on_pulley(factor, friction):
    incline = 10.0
    thrown = np.sqrt(G * 0.4 * np.cos(np.radians(incline)))
    solution = chutecalc.solve(fed(velocity_m_s=factor * thrown, incline_deg=incline, **friction))
    assert ("slides_on_pulley" in codes(solution)) == (factor < 1)
    assert ("held_slope_deg" in solution.inlet) == (factor < 1)
    if factor < 1:
        finding = found(solution, "slides_on_pulley")
        assert (finding.severity, finding.segment, finding.s_m[0]) == ("warning" if friction else "note", "fall", 0.0)
        assert ("it slides on the pulley from" in finding.message()) == bool(friction)


def test_a_stream_on_a_pulley_is_told_its_bounds():
    held, slides = (chutecalc.solve(fed(velocity_m_s=1.0, **more)) for more in ({}, {"friction_deg": 30.0}))
    froude = 1.0 / (G * 0.4)
    for solution in (held, slides):
        inlet = {name: values[0] for name, values in solution.inlet.items()}
        assert np.cos(np.radians(inlet["held_slope_deg"])) == pytest.approx(froude, rel=1e-13)
        assert np.cos(np.radians(inlet["frictionless_slope_deg"])) == pytest.approx((froude + 2.0) / 3.0, rel=1e-13)
        assert inlet["frictionless_velocity_m_s"] == pytest.approx(np.sqrt(G * 0.4 * (froude + 2.0) / 3.0), rel=1e-13)
    bounds = [held.inlet[f"{name}_slope_deg"][0] for name in ("frictionless", "held")]
    assert held.inlet["slope_deg"][0] == bounds[1]
    assert bounds[0] < slides.inlet["slope_deg"][0] < bounds[1]
    assert "at 75.23° and 1 m/s if the belt holds it to the end" in found(held, "slides_on_pulley").message()
    assert "leaves at 75.23° and 196.9 fpm if" in found(held, "slides_on_pulley").message(units="us")


def test_only_the_slow_designs_of_a_batch_slide_on_the_pulley():
    solution = chutecalc.solve(fed(friction_deg=30.0).vary({"inlet.belt.velocity_m_s": [1.0, 3.0, 1.5]}))
    finding = found(solution, "slides_on_pulley")
    assert finding.mask.tolist() == [True, False, True]
    assert np.isnan(solution.inlet["slide_start_deg"]).tolist() == [False, True, False]


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_belt_overfull(factor):
    # a flat belt carries a parabola on its usable width: b² tan θ/6
    full = 3600.0 * 0.8 * 3.0 * (0.9 * 0.8 - 0.05) ** 2 * np.tan(np.radians(20.0)) / 6.0
    base = fed(width_m=0.8, trough_deg=0.0, surcharge_deg=20.0)
    solution = chutecalc.solve(base.put({"flow.rate_t_h": factor * full}))
    assert solution.inlet["belt_fill"][0] == pytest.approx(factor, rel=1e-13)
    assert ("belt_overfull" in codes(solution)) == (factor > 1)
    if factor > 1:
        message = found(solution, "belt_overfull").message(units="us")
        assert f"the load of {solution.inlet['load_area_m2'][0] / 0.3048**2:.4g} ft² fills" in message
        assert f"would cover {solution.inlet['load_width_m'][0] / 0.0254:.4g} in of belt" in message


@pytest.mark.parametrize("off", [-1e-6, 1e-6])
@pytest.mark.parametrize("name", ["lower", "upper"])
def test_edge_misses(name, off):
    base = fed(material_depth_m=0.1)
    lands = {edge.name: edge.numbers["landing_distance_m"][0] for edge in chutecalc.solve(base).edges}
    if name == "upper":  # the floor ends just before or behind where that edge lands
        moved = base.put({"segments.floor.length_m": lands[name] - off})
    else:  # or begins there
        along = (lands[name] + off) * np.array([np.cos(np.radians(55.0)), -np.sin(np.radians(55.0))])
        moved = base.put({"segments.floor.start_m": [0.3 + float(along[0]), -0.5 + float(along[1])]})
    solution = chutecalc.solve(moved)
    assert ("edge_misses" in codes(solution)) == (off > 0)
    if off > 0:
        finding = found(solution, "edge_misses")
        assert (finding.severity, finding.segment) == ("warning", "floor")
        assert finding.s_m[0] == solution.segments["fall"].exit["s_m"][0]
        assert finding.message().startswith(
            f"the {name} edge of the stream misses the segment on which its middle lands"
        )


def test_an_edge_that_lands_on_another_segment_misses():
    base = fed(material_depth_m=0.2)
    floor = base.data["segments"][1]
    lower = chutecalc.solve(base).edges[0].numbers
    # a short ledge just where the lower edge would come down, which the middle flies past
    x, z = lower["landing_x_m"][0] - 0.02, lower["landing_z_m"][0] + 0.05
    ledge = {"kind": "straight", "name": "ledge", "start_m": [x, z], "slope_deg": 60.0, "length_m": 0.05} | PASSABLE
    segments = [base.data["segments"][0], ledge, {"kind": "fall", "onto_next": True, "name": "on"}, floor]
    solution = chutecalc.solve(chutecalc.parse(base.data | {"segments": segments}))
    assert [edge.segment[0] for edge in solution.edges] == ["ledge", "floor", "floor"]
    finding = found(solution, "edge_misses")
    assert finding.segment == "floor"
    assert "the lower edge" in finding.message()
    assert "lands on another one" in finding.message()
