"""Limits and symmetries that need no reference: special sections, energy, cuts, batches, scaling."""

import numpy as np
import pytest

import chutecalc
from tests import seeds
from tests.conftest import BASE, chute, spec, vee

G = 9.80665
FALL_AND_SPOON = [{"kind": "fall", "drop_m": 2.0}, {"kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0}]
REST = {"velocity_m_s": 0.0, "slope_deg": 90.0}


def rectangular(width, **more):
    return {"body": {"shape": "rectangular", "width_m": width, **more}}


def chamfered(base, angle, **more):
    return {"body": {"shape": "chamfered", "base_m": base, "chamfer_deg": angle, **more}}


def exits(sections, **tables):
    solution = chutecalc.solve(chute(sections=sections, inlet=REST, segments=FALL_AND_SPOON, **tables))
    return solution.exit_velocity[0], solution.exit_depth[0]


def test_chamfers_at_90_degrees_are_a_rectangle_to_rounding():
    # cos 90° is 6e-17 in doubles; what is left is a few ulp
    assert exits(chamfered(0.5, 90.0)) == pytest.approx(exits(rectangular(0.5)), rel=1e-15)


def test_chamfers_near_90_degrees_tend_to_a_rectangle_without_losing_digits():
    square = exits(rectangular(0.5))[0]
    # d(v)/dβ at 90° is of the order of v itself per radian; 1e-9° is 2e-11 rad
    assert exits(chamfered(0.5, 90.0 - 1e-9))[0] == pytest.approx(square, rel=1e-10)


def test_a_chamfer_that_flattens_out_leaves_the_wall_friction_alone():
    # χ = K C (1 - cos β)/(B + C cos β) is of the order of β²/2 · C/B: at β = 0.1° 1.5e-6 times a small share
    solution = chutecalc.solve(chute(sections=chamfered(2.0, 0.1), inlet=REST, segments=FALL_AND_SPOON))
    friction = solution.stations(points=11)["equivalent_friction"][0, 11:]
    assert np.abs(friction / np.tan(np.radians(25.0)) - 1).max() < 1.5e-6


def test_a_chamfered_section_without_a_base_is_a_vee():
    for more in ({}, {"chamfer_m": 0.1}):
        one, other = exits(chamfered(0.0, 50.0, **more)), exits(vee(50.0, **more))
        assert one == other
        assert np.isfinite(one).all()


def test_energy_is_kept_without_friction():
    solution = chutecalc.solve(
        chute(
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": 6.0, "slope_deg": 20.0},
            segments=[
                {"kind": "hood", "radius_m": 1.5, "to_slope_deg": 80.0},
                {"kind": "fall", "drop_m": 1.5},
                {"kind": "curve", "radius_m": 3.0, "to_slope_deg": 30.0},
                {"kind": "straight", "slope_deg": 30.0, "length_m": 2.0},
                {"kind": "curve", "radius_m": 30.0, "to_slope_deg": 40.0},
            ],
        )
    )
    stations = solution.stations(points=21)
    energy = 0.5 * stations["velocity_m_s"][0] ** 2 + G * stations["z_m"][0]
    assert np.abs(energy / 18.0 - 1).max() < 1e-12


@pytest.mark.parametrize("cut", [0.1, 0.37, 0.5, 0.9])
@pytest.mark.parametrize(
    "segment",
    [
        {"kind": "curve", "radius_m": 3.0, "from_slope_deg": 80.0, "to_slope_deg": 10.0},
        {"kind": "curve", "radius_m": 12.0, "from_slope_deg": 30.0, "to_slope_deg": 50.0},
        {"kind": "hood", "radius_m": 1.2, "from_slope_deg": 30.0, "to_slope_deg": 80.0},
        {"kind": "straight", "slope_deg": 45.0, "length_m": 4.0},
    ],
)
def test_a_chute_cut_in_two_gives_the_same_result(segment, cut):
    slope = segment.get("from_slope_deg", segment.get("slope_deg"))
    inlet = {"velocity_m_s": 5.0, "slope_deg": slope}
    if segment["kind"] == "straight":
        parts = [segment | {"length_m": 4.0 * cut}, segment | {"length_m": 4.0 * (1 - cut)}]
    else:
        middle = slope + cut * (segment["to_slope_deg"] - slope)
        parts = [segment | {"to_slope_deg": middle}, segment | {"from_slope_deg": middle}]
    sections = chamfered(0.4, 50.0, chamfer_m=0.12)

    one = chutecalc.solve(chute(sections=sections, inlet=inlet, segments=[segment]))
    two = chutecalc.solve(chute(sections=sections, inlet=inlet, segments=parts))

    assert one.status[0] == two.status[0] == "ok"
    tolerance = one.error_estimate[0] + two.error_estimate[0] + 1e-15
    assert abs(two.exit_velocity[0] / one.exit_velocity[0] - 1) <= tolerance <= 1e-10
    assert two.exit["s_m"][0] == pytest.approx(one.exit["s_m"][0], rel=1e-14)
    assert two.exit["time_s"][0] == pytest.approx(one.exit["time_s"][0], rel=1e-10)


def test_froude_similarity():
    """Lengths by λ, velocities by √λ, volume rates by λ^2.5: the same chute."""
    scale = 3.7

    def scaled(by):
        return chute(
            flow={"rate_t_h": 1000.0 * by**2.5},
            sections=chamfered(0.5 * by, 45.0, chamfer_m=0.15 * by),
            inlet={"velocity_m_s": 2.0 * by**0.5, "slope_deg": 70.0},
            segments=[
                {"kind": "fall", "drop_m": 1.0 * by},
                {"kind": "curve", "radius_m": 3.0 * by, "from_slope_deg": 75.0, "to_slope_deg": 20.0},
                {"kind": "straight", "slope_deg": 35.0, "length_m": 2.0 * by},
            ],
        )

    small, large = chutecalc.solve(scaled(1.0)), chutecalc.solve(scaled(scale))
    assert large.exit_velocity[0] == pytest.approx(small.exit_velocity[0] * scale**0.5, rel=1e-10)
    assert large.exit_depth[0] == pytest.approx(small.exit_depth[0] * scale, rel=1e-10)
    assert large.exit["time_s"][0] == pytest.approx(small.exit["time_s"][0] * scale**0.5, rel=1e-10)


MIXED = spec(
    sections=chamfered(0.4, 50.0, chamfer_m=0.1, wall_height_m=0.45),
    inlet={"velocity_m_s": 3.0, "slope_deg": 60.0},
    segments=[
        {"kind": "fall", "drop_m": 0.5},
        {"name": "spoon", "kind": "curve", "radius_m": 2.0, "from_slope_deg": 75.0, "to_slope_deg": 20.0},
        {"name": "crest", "kind": "curve", "radius_m": 1.5, "to_slope_deg": 60.0},
        {"name": "drop", "kind": "fall", "drop_m": 0.3},
        {"name": "floor", "kind": "straight", "slope_deg": 35.0, "length_m": 6.0},
    ],
)


def mixed(count, seed=5):
    """Designs of which some stall, some choke, some lose contact, some run through."""
    random = seeds.generator(seed)
    return {
        "flow.rate_t_h": np.exp(random.uniform(np.log(30), np.log(4000), count)),
        "liners.wall.friction_deg": random.uniform(5, 36, count),
        "material.internal_friction_deg": random.uniform(30, 60, count),
        "segments.spoon.radius_m": random.uniform(0.5, 6, count),
        "segments.crest.radius_m": random.uniform(0.3, 8, count),
    }


@pytest.mark.parametrize(("wall", "outcomes"), [(0.45, {"ok", "choke", "missed"}), (None, {"ok", "stall", "missed"})])
def test_a_designs_digits_do_not_depend_on_its_batch(wall, outcomes):
    body = chamfered(0.4, 50.0, chamfer_m=0.1, **({"wall_height_m": wall} if wall else {}))
    base = chutecalc.parse(MIXED | {"sections": body})
    changes = mixed(2000)
    together = chutecalc.solve(base.vary(changes))
    stations = together.stations(points=7)
    assert set(together.status) == outcomes

    random = seeds.generator(1)
    for size in (1, 2, 3, 7, 8, 9, 100, 433):
        rows = random.choice(2000, size, replace=False)
        alone = chutecalc.solve(base.vary({path: values[rows] for path, values in changes.items()}))
        assert (alone.status == together.status[rows]).all()
        assert np.array_equal(alone.exit_velocity, together.exit_velocity[rows], equal_nan=True)
        assert np.array_equal(alone.exit_depth, together.exit_depth[rows], equal_nan=True)
        assert np.array_equal(alone.error_estimate, together.error_estimate[rows], equal_nan=True)
        own = alone.stations(points=7)
        names = set(own["segment"][0])  # a flight that no design of the small batch takes is not there
        columns = np.isin(stations["segment"][0], list(names))
        for name in ("s_m", "x_m", "velocity_m_s", "depth_m", "time_s"):
            assert np.array_equal(own[name], stations[name][rows][:, columns], equal_nan=True), name


def test_one_design_varied_equals_its_own_spec_to_the_last_bit():
    base = chutecalc.parse(MIXED | {"model": {"steel": "follows_stream"}})  # else each spec draws its own steel
    changes = mixed(12)
    together = chutecalc.solve(base.vary(changes))
    for k in range(12):
        alone = chutecalc.solve(base.put({path: float(values[k]) for path, values in changes.items()}))
        assert np.array_equal(alone.exit_velocity, together.exit_velocity[k : k + 1], equal_nan=True)


def test_a_sweep_of_the_last_segment_solves_the_first_ones_once():
    base = chutecalc.parse(MIXED)
    solution = chutecalc.solve(base.vary({"segments.floor.length_m": np.linspace(1.0, 9.0, 50)}))
    assert [len(solved.exit.velocity) for solved in solution.trajectory.segment_solutions] == [1, 1, 1, 1, 50]


def test_more_wall_friction_is_never_faster():
    base = chutecalc.parse(
        spec(
            sections=chamfered(0.4, 50.0, chamfer_m=0.1),
            inlet={"velocity_m_s": 4.0, "slope_deg": 80.0},
            segments=[
                {"kind": "curve", "radius_m": 2.0, "to_slope_deg": 25.0},
                {"kind": "straight", "slope_deg": 25.0, "length_m": 3.0},
            ],
        )
    )
    solution = chutecalc.solve(base.vary({"liners.wall.friction_deg": np.linspace(0.0, 60.0, 301)}))
    velocity = np.nan_to_num(solution.exit_velocity)
    assert (np.diff(velocity) <= 1e-13 * velocity[:-1]).all()
    stalled = solution.status == "stall"
    assert stalled.any()
    assert (np.diff(stalled.astype(int)) >= 0).all()


def test_the_base_spec_is_left_alone_by_vary():
    base = chutecalc.parse(spec())
    base.vary({"flow.rate_kg_s": np.array([1.0, 2.0])})
    assert base.data == BASE
