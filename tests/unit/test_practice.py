"""Findings of practice appear beyond their limit and not just before it, and at the limit that a spec sets."""

import numpy as np
import pytest

import chutecalc
from chutecalc.physics.wall import holding_depth, wall_friction, yield_locus
from chutecalc.results.findings import CRITERIA
from chutecalc.spec.limits import LIMITS
from tests.conftest import chute, vee, vee_friction

G = 9.80665


def of(solution, code):
    return [finding for finding in solution.findings() if finding.code == code]


def rectangular(width=0.5, **more):
    return {"body": {"shape": "rectangular", "width_m": width, **more}}


def straight(slope=60.0, length=1.0):
    return [{"kind": "straight", "slope_deg": slope, "length_m": length}]


def test_every_limit_begins_a_finding_and_is_in_force_where_the_spec_sets_it():
    assert {limit.finding for limit in LIMITS.values()} <= {criterion.code for criterion in CRITERIA}
    given = {f"limits.{key}": 0.5 for key in LIMITS if key not in ("min_velocity_ratio", "max_velocity_ratio")}
    design = chute().vary(given).design
    in_force = [LIMITS[key.removeprefix("limits.")].of(design.limits).item() for key in given]
    assert in_force == pytest.approx([0.5] * len(given))
    default = chute().design.limits
    assert all(
        limit.of(default).item() == pytest.approx(np.inf if limit.default is None else limit.default)
        for limit in LIMITS.values()
    )


def test_a_limit_is_quoted_as_it_is_in_force():
    base = chute(inlet={"velocity_m_s": 5.0, "slope_deg": 60.0}, segments=straight(42.0))
    assert not of(chutecalc.solve(base), "steep_impact")
    many = chutecalc.solve(base.vary({"limits.max_impact_angle_deg": [10.0, 17.0, 19.0]}))
    (steep,) = of(many, "steep_impact")
    assert steep.mask.tolist() == [True, True, False]
    assert "(limit 17°, set in the spec)" in steep.message(1)
    radians = chutecalc.solve(base.put({"limits.max_impact_angle_rad": 0.2}))
    assert len(of(radians, "steep_impact")) == 1


def test_a_range_of_velocity_ratios_is_a_range():
    with pytest.raises(chutecalc.SpecError, match=r"limits.min_velocity_ratio = 1.2 leaves no velocity ratio"):
        chute().put({"limits.min_velocity_ratio": 1.2})


@pytest.mark.parametrize(("slope", "factor"), [(15.0, 0.9999), (15.0, 1.0001)])
def test_hard_landing(slope, factor):
    # a straight at the stream's own slope that ends at once: the stream lands with v sin a
    velocity = 2.5 / np.sin(np.radians(slope)) * factor
    base = chute(
        inlet={"velocity_m_s": float(velocity), "slope_deg": slope},
        segments=straight(slope, 1e-3),
        receiver={"velocity_m_s": 9.0, "friction_deg": 30.0},
    )
    solution = chutecalc.solve(base)
    assert len(of(solution, "hard_landing")) == (factor > 1)
    pressure = solution.receiver["impact_pressure_kpa"][0]
    for share in (0.999, 1.001):
        limited = chutecalc.solve(
            base.put({"limits.max_velocity_into_m_s": 5.0, "limits.max_belt_impact_kpa": float(pressure * share)})
        )
        assert len(of(limited, "hard_landing")) == (share < 1)


@pytest.mark.parametrize(("ratio", "code"), [(0.899, "faster"), (0.901, ""), (1.099, ""), (1.101, "slower")])
def test_off_speed(ratio, code):
    solution = chutecalc.solve(
        chute(
            inlet={"velocity_m_s": 4.0 * ratio / np.cos(np.radians(10.0)), "slope_deg": 10.0},
            segments=straight(10.0, 1e-3),
            receiver={"velocity_m_s": 4.0, "friction_deg": 30.0},
        )
    )
    found = of(solution, "off_speed")
    assert len(found) == bool(code)
    for finding in found:
        assert f"make the stream {code}" in finding.message()


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_overfull(factor):
    deepest = 1000 / 3.6 / 800 / 4.0 / 0.5  # at the start of an accelerating stream
    body = rectangular(wall_height_m=deepest / 0.6 * factor)
    solution = chutecalc.solve(
        chute(sections=body, inlet={"velocity_m_s": 4.0, "slope_deg": 60.0}, segments=straight())
    )
    assert len(of(solution, "overfull")) == (factor < 1)
    without = chutecalc.solve(chute(sections=rectangular(), segments=straight(40.0)))
    assert not of(without, "overfull")


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_fine_stream(factor):
    base = chute(sections=rectangular(), inlet={"velocity_m_s": 4.0, "slope_deg": 60.0}, segments=straight())
    shallowest = chutecalc.solve(base).exit_depth[0]
    solution = chutecalc.solve(base.put({"material.lump_mm": float(1000.0 * shallowest * factor)}))
    assert len(of(solution, "fine_stream")) == (factor > 1)


@pytest.mark.parametrize("factor", [0.9999, 1.0001])
def test_narrow_for_lumps(factor):
    base = chute(sections=rectangular(0.6), inlet={"velocity_m_s": 4.0, "slope_deg": 60.0}, segments=straight())
    solution = chutecalc.solve(base.put({"material.lump_mm": 200.0 * factor}))
    assert len(of(solution, "narrow_for_lumps")) == (factor > 1)
    # a vee of 45° is twice as wide as a height: at a lump's, 2 lumps; half as steep it is 2/tan 22.5° = 4.8
    for angle, narrow in ((45.0, True), (22.5, False)):
        flat = chutecalc.solve(chute(material={"lump_mm": 300.0}, sections=vee(angle)))
        assert len(of(flat, "narrow_for_lumps")) == narrow


def test_narrow_for_lumps_at_the_narrow_end_of_a_taper():
    sections = {name: {"shape": "rectangular", "width_m": width} for name, width in (("wide", 0.9), ("narrow", 0.5))}
    segment = straight()[0] | {"section": ["wide", "narrow"]}
    solution = chutecalc.solve(
        chute(
            material={"lump_mm": 200.0},
            sections=sections,
            inlet={"velocity_m_s": 6.0, "slope_deg": 60.0},
            segments=[segment],
        )
    )
    (narrow,) = of(solution, "narrow_for_lumps")
    assert narrow.numbers["width_m"][0] == pytest.approx(0.5, rel=1e-12)
    assert narrow.s_m[0] == 1.0


@pytest.mark.parametrize(("end", "severity"), [(10.0, "note"), (0.0, "note"), (30.0, None)])
def test_what_stands_on_a_spoon_that_ends_flat(end, severity):
    """In a vee friction does not depend on depth, so the arc that is too flat is known, and its volume is ∫ A ds."""
    radius, angle = 2.0, np.degrees(np.arctan(vee_friction(25.0, 45.0, 50.0)))
    solution = chutecalc.solve(
        chute(
            sections=vee(),
            inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
            segments=[{"kind": "curve", "radius_m": radius, "to_slope_deg": end}],
        ),
        rtol=1e-12,
    )
    found = of(solution, "will_not_clear")
    assert [finding.severity for finding in found] == ([severity] if severity else [])
    for finding in found:
        length = radius * np.radians(angle - end)
        assert finding.numbers["standing_m"][0] == pytest.approx(length, rel=1e-11)
        assert finding.numbers["needed_deg"][0] == pytest.approx(angle, rel=1e-11)
        assert finding.s_m[0] == pytest.approx(radius * np.radians(80.0 - angle), rel=1e-11)
        nodes, weights = np.polynomial.legendre.leggauss(40)
        first = np.radians(80.0 - angle) / np.radians(80.0 - end)
        shares = first + (1.0 - first) * 0.5 * (1.0 + nodes)
        area = solution.trajectory.parts[-1].at(shares, ["area_m2"])["area_m2"][:, 0]
        assert finding.numbers["volume_m3"][0] == pytest.approx(0.5 * length * weights @ area, rel=1e-10)


@pytest.mark.parametrize(("limit", "severity"), [(0.99, "note"), (0.5, "warning")])
def test_most_of_a_segment_that_will_not_clear_is_a_warning_from_the_limit_on(limit, severity):
    base = chute(sections=vee(), inlet={"velocity_m_s": 6.0, "slope_deg": 20.0})
    solution = chutecalc.solve(
        base.put({"segments.1.slope_deg": 20.0, "segments.1.length_m": 1.0, "limits.max_standing_share": limit})
    )
    (found,) = of(solution, "will_not_clear")
    assert found.severity == ("warning" if limit < 1.0 else "note")
    assert found.numbers["standing_m"][0] == pytest.approx(1.0, rel=1e-12)


def test_a_bed_at_rest_presses_a_locus_with_its_weight_alone():
    """A stream that a spoon presses hard has little friction there, and more once it stands: it falls with pressure."""
    rows = [[0.2, 0.16], [0.6, 0.34], [4.0, 1.6]]
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": rows}},
            sections=rectangular(),
            inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
            segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": 22.0}],
        )
    )
    (flat,) = [finding for finding in of(solution, "will_not_clear") if "needed_deg" in finding.numbers]
    end = solution.exit
    locus = yield_locus(*(1e3 * np.array(column)[:, None] for column in zip(*rows, strict=True)), np.array([1.0]))
    depth, slope = end["depth_m"], np.radians(end["slope_deg"])
    ratio = (1 - np.sin(np.radians(50.0))) / (1 + np.sin(np.radians(50.0)))
    at_rest = wall_friction(locus, 800.0 * G * np.cos(slope) * depth) * (1.0 + ratio * depth / 0.5)
    assert flat.numbers["needed_deg"][0] == pytest.approx(np.degrees(np.arctan(at_rest))[0], rel=1e-9)
    assert at_rest[0] > 1.15 * end["equivalent_friction"][0]


@pytest.mark.parametrize("bound", [0.45, 0.9, 5.0])
def test_a_bed_that_adhesion_holds_is_as_deep_as_the_locus_carries_it(bound):
    """By trial of many depths: the deepest whose shear the wall resists."""
    normal, shear = np.array([[1e3], [2e3], [5e3]]), np.array([[0.8e3], [1.2e3], [2.1e3]])
    wall = yield_locus(normal, shear, np.array([bound]))
    for slope in np.radians([40.0, 50.0, 70.0, 90.0]):
        depth = np.linspace(1e-6, 1.0, 2_000_001)
        stress = 8e3 * depth * np.cos(slope)
        held = wall_friction(wall, stress[:, None])[:, 0] * stress >= 8e3 * depth * np.sin(slope)
        deepest = depth[held].max() if held.any() else 0.0
        assert holding_depth(wall, np.array([slope]), np.array([8e3]))[0] == pytest.approx(deepest, abs=1e-6)


def test_a_bed_that_adhesion_holds_is_told_with_its_depth():
    adhesion, coefficient, slope = 0.2, 0.3, np.radians(50.0)  # kPa
    rows = [[1.0, adhesion + coefficient], [2.0, adhesion + 2.0 * coefficient]]
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"yield_locus_kpa": rows}},
            inlet={"velocity_m_s": 6.0, "slope_deg": 50.0},
            segments=straight(50.0),
        )
    )
    # while tan a < sin δ the material itself would shear first: δ = 50°, a = 50° is steeper, so nothing is held
    assert not of(solution, "will_not_clear")
    stronger = chutecalc.solve(
        chute(
            material={"internal_friction_deg": 70.0},
            liners={"wall": {"yield_locus_kpa": rows}},
            inlet={"velocity_m_s": 6.0, "slope_deg": 42.0},
            segments=straight(42.0),
        )
    )
    (held,) = of(stronger, "will_not_clear")
    slope = np.radians(42.0)
    depth = adhesion * 1e3 / (800.0 * G * (np.sin(slope) - coefficient * np.cos(slope)))
    assert held.numbers["depth_m"][0] == pytest.approx(depth, rel=1e-12)
    assert held.severity == "note"


def test_what_stands_and_what_bears_does_not_depend_on_the_batch():
    base = chute(
        material={"lump_mm": 100.0},
        liners={"wall": {"yield_locus_kpa": [[0.2, 0.16], [0.6, 0.34], [4.0, 1.6]], "thickness_mm": 20.0}},
        inlet={"velocity_m_s": 6.0, "slope_deg": 80.0},
        segments=[{"kind": "curve", "radius_m": 2.0, "to_slope_deg": 10.0}],
    )
    rates = [1000.0, 1007.0, 1013.0, 500.0, 1500.0]
    together = chutecalc.solve(base.vary({"flow.rate_t_h": rates}))
    (many,) = [finding for finding in of(together, "will_not_clear") if "standing_m" in finding.numbers]
    for number, rate in enumerate(rates):
        alone = chutecalc.solve(base.vary({"flow.rate_t_h": rate}))
        (one,) = [finding for finding in of(alone, "will_not_clear") if "standing_m" in finding.numbers]
        assert {name: values[0] for name, values in one.numbers.items()} == {
            name: values[number] for name, values in many.numbers.items()
        }
        loads, own = together.segments[0].loads, alone.segments[0].loads
        for name, values in own.items():
            assert np.array_equal(values, loads[name][number : number + 1], equal_nan=True), name
