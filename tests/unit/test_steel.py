"""Steel that stands still: drawn at the design point, met by every other stream where it stands."""

from itertools import pairwise

import numpy as np
import pytest

import chutecalc
from tests.verification.second_cases import case, outcome, summary
from tests.verification.second_solver import Solver

HEAD = {
    "flow": {"rate_t_h": 1000.0},
    "material": {"density_kg_m3": 800.0, "internal_friction_deg": 50.0},
    "liners": {"wall": {"friction_deg": 25.0}, "worn": {"friction_deg": 30.0}},
    "sections": {"body": {"shape": "rectangular", "width_m": 0.8}},
    "inlet": {"velocity_m_s": 3.0, "slope_deg": 0.0},
}
FALL, SPOON = {"kind": "fall", "run_m": 1.0}, {"name": "spoon", "kind": "curve", "radius_m": 2.0, "to_slope_deg": 20.0}
BELT = {"belt": {"velocity_m_s": 3.0, "pulley_radius_m": 0.4, "material_depth_m": 0.2}}


def chute(**tables):
    segments = [FALL, SPOON | {"liner": "wall"}]
    return chutecalc.parse(HEAD | {"segments": segments} | tables)


def start_of(solution, name):
    surface = next(s for s in solution.trajectory.segment_solutions if s.segment.name == name).contact.surface
    return np.array([surface.x, surface.z, surface.slope])


def frozen_tables(data):
    """Return a spec's tables with every place explicit, from the second solver's own drawing of it."""
    solver = Solver(data)
    result = solver.run()
    tables = [dict(table) for table in data["segments"]]
    for k, (table, segment) in enumerate(zip(tables, result.segments, strict=True)):
        falls = k and tables[k - 1]["kind"] == "fall" and table["kind"] != "fall"
        if segment.setting is None or "start_m" in table or not falls:
            continue
        surface = segment.setting.surface
        table["start_m"] = [surface.x, surface.z]
        if table["kind"] in ("curve", "hood"):
            table["from_slope_deg"] = float(np.degrees(surface.slope))
        tables[k - 1] = {"kind": "fall", "onto_next": True}
    return data | {"segments": tables}


def test_the_steel_stands_still_while_the_inlet_varies():
    varied = chutecalc.solve(chute().vary({"inlet.velocity_m_s": [2.8, 3.0, 3.2]}))
    assert (np.ptp(start_of(varied, "spoon"), axis=1) == 0.0).all()
    alone = chutecalc.solve(chute())
    assert varied.status.tolist() == ["missed", "ok", "ok"]
    assert varied.exit_velocity[1] == pytest.approx(alone.exit_velocity[0], rel=1e-12)
    short = next(finding for finding in varied.findings() if finding.code == "missed")
    fall = 9.80665 * 0.5 * (1.0 / 3.0) ** 2  # the height of the spoon's start below the inlet
    assert short.numbers["before_m"][0] == pytest.approx(1.0 - 2.8 * np.sqrt(2 * fall / 9.80665), rel=1e-9)


def test_what_follows_the_stream_by_choice_moves_with_it():
    varied = chutecalc.solve(chute(model={"steel": "follows_stream"}).vary({"inlet.velocity_m_s": [2.8, 3.0, 3.2]}))
    assert varied.status.tolist() == ["ok"] * 3
    assert len(set(np.broadcast_to(start_of(varied, "spoon")[1], 3))) == 3


@pytest.mark.parametrize("tables", [{}, {"inlet": BELT}, {"inlet": BELT, "segments": [SPOON | {"liner": "wall"}]}])
def test_the_design_point_is_the_same_among_variants(tables):
    base = chute(**tables)
    key = "inlet.belt.velocity_m_s" if tables else "inlet.velocity_m_s"
    varied, alone = chutecalc.solve(base.vary({key: [3.0, 3.3]})), chutecalc.solve(base)
    assert varied.exit_velocity[0] == pytest.approx(alone.exit_velocity[0], rel=1e-12)
    assert start_of(varied, "spoon").T[0] == pytest.approx(start_of(alone, "spoon").T[0], rel=1e-12)


def test_a_loose_tolerance_meets_the_steel_as_well():
    """The place is drawn to the last digits, and the stream of rtol 1e-3 comes by within its own error."""
    hood = {"name": "hood", "kind": "hood", "radius_m": 0.7, "to_slope_deg": 60.0, "liner": "worn"}
    base = chute(segments=[hood, FALL, SPOON | {"liner": "wall"}])
    for rtol in (1e-3, 1e-5, 1e-7, 1e-13):
        varied = chutecalc.solve(base.vary({"flow.rate_t_h": [1000.0]}), rtol=rtol)
        assert varied.status[0] == "ok", rtol


def test_geometry_is_drawn_anew_at_the_design_point_of_each():
    """Radius and velocity vary together: each radius is drawn at 3 m/s, and met at the other velocity."""
    hood = {"name": "hood", "kind": "hood", "radius_m": 0.7, "to_slope_deg": 60.0, "liner": "wall"}
    base = chute(segments=[hood, FALL, SPOON | {"liner": "wall"}])
    radii, friction = np.array([0.6, 0.7, 0.8]), np.array([24.0, 25.0, 24.5])
    path = "segments.hood.radius_m"
    together = chutecalc.solve(base.vary({path: radii, "liners.wall.friction_deg": friction}))
    for k in range(3):
        drawn = chutecalc.parse(chutecalc.freeze(base.put({path: float(radii[k])})))
        alone = chutecalc.solve(drawn.put({"liners.wall.friction_deg": float(friction[k])}))
        assert together.status[k] == alone.status[0]
        assert together.exit_velocity[k] == pytest.approx(alone.exit_velocity[0], rel=1e-10, nan_ok=True)


def test_variants_of_variants_stay_on_the_steel():
    base = chute()
    once = base.vary({"inlet.velocity_m_s": [3.1, 3.2]})
    twice = once.vary({"flow.rate_t_h": 1500.0}).vary({"segments.spoon.liner": "worn"})
    direct = base.vary({"inlet.velocity_m_s": [3.1, 3.2], "flow.rate_t_h": 1500.0, "segments.spoon.liner": "worn"})
    assert chutecalc.solve(twice).exit_velocity.tolist() == chutecalc.solve(direct).exit_velocity.tolist()
    assert (start_of(chutecalc.solve(twice), "spoon").T[0] == start_of(chutecalc.solve(once), "spoon").T[0]).all()


def test_digits_do_not_depend_on_the_batch():
    base = chute(inlet=BELT)
    changes = {
        "inlet.belt.velocity_m_s": np.linspace(2.5, 4.0, 40),
        "segments.spoon.radius_m": np.linspace(1.5, 2.5, 40),
        "flow.rate_t_h": np.linspace(500.0, 1500.0, 40),
    }
    together = chutecalc.solve(base.vary(changes))
    for k in (0, 7, 39):
        alone = chutecalc.solve(base.vary({path: values[k : k + 1] for path, values in changes.items()}))
        assert np.array_equal(alone.exit_velocity, together.exit_velocity[k : k + 1], equal_nan=True)
        assert np.array_equal(alone.status, together.status[k : k + 1])


def test_a_sweep_of_operating_keys_solves_what_comes_before_once():
    hood = {"name": "hood", "kind": "hood", "radius_m": 0.7, "to_slope_deg": 60.0, "liner": "worn"}
    base = chute(segments=[hood, FALL, SPOON | {"liner": "wall"}])
    solution = chutecalc.solve(base.vary({"liners.wall.friction_deg": np.linspace(20.0, 30.0, 50)}))
    assert [len(solved.exit.velocity) for solved in solution.trajectory.segment_solutions] == [1, 50, 50]


def test_functions_run_on_the_steel():
    base = chute()
    velocity = base.function(["inlet.velocity_m_s"])
    assert velocity.traced
    expected = chutecalc.solve(base.vary({"inlet.velocity_m_s": [3.0, 3.2]})).exit_velocity
    assert velocity([3.0, 3.2]) == pytest.approx(expected, rel=1e-10)
    mixed = base.function(["inlet.velocity_m_s", "segments.spoon.radius_m"])
    both = base.vary({"inlet.velocity_m_s": [3.2], "segments.spoon.radius_m": [2.5]})
    assert mixed(3.2, 2.5) == pytest.approx(chutecalc.solve(both).exit_velocity[0], rel=1e-10)


AT_EXIT = ("s_m", "x_m", "z_m", "slope_deg", "velocity_m_s", "depth_m")


def exits_by_every_way(base, path, value):
    """Return the exit of a chute at its design point, on its steel, in a batch, as a function, and frozen."""
    variants = base.vary({path: [value, value]})
    function = base.function([path], [f"exit_{name}" for name in AT_EXIT])
    frozen = chutecalc.parse(chutecalc.freeze(base)) if chutecalc.solve(base).ok[0] else base
    return [
        *([solution.exit[name][0] for name in AT_EXIT] for solution in map(chutecalc.solve, (base, variants, frozen))),
        *([chutecalc.exits(chute, columns=AT_EXIT).exit[name][0] for name in AT_EXIT] for chute in (base, variants)),
        list(function(value)),
        [column[0] for column in function([value, value])],
    ]


def test_a_stream_that_flies_past_the_last_segment_leaves_the_chute_where_it_left_steel():
    plate = {"name": "plate", "kind": "plate", "slope_deg": 30.0, "length_m": 1.0, "may_be_passed": True}
    receiver = {"velocity_m_s": 2.0, "friction_deg": 28.0, "at_m": [0.0, -4.0]}
    base = chute(segments=[{"kind": "fall", "drop_m": 2.0}, plate | {"liner": "wall"}], receiver=receiver)
    for found in exits_by_every_way(base, "inlet.velocity_m_s", 3.0):
        assert found == pytest.approx([0.0, 0.0, 0.0, 0.0, 3.0, np.nan], nan_ok=True, abs=0.0)
    landing = 3.0 * np.sqrt(2 * 4.0 / 9.80665)
    assert chutecalc.solve(base).receiver["landing_x_m"][0] == pytest.approx(landing, rel=1e-12)
    ended = chute(segments=[{"kind": "fall", "drop_m": 2.0}])  # a fall that is the last is where the chute ends
    assert chutecalc.solve(ended).exit["z_m"][0] == pytest.approx(-2.0, rel=1e-12)


def test_a_stream_that_lifts_off_its_last_curve_has_the_depth_of_there():
    crest = {"name": "crest", "kind": "curve", "radius_m": 1.0, "from_slope_deg": 20.0, "to_slope_deg": 60.0}
    inlet = {"velocity_m_s": 5.0, "slope_deg": 20.0}  # v² > g r cos 20°: it leaves at once
    receiver = {"velocity_m_s": 2.0, "friction_deg": 28.0, "at_m": [0.0, -4.0]}
    base = chute(segments=[crest | {"liner": "wall"}], inlet=inlet, receiver=receiver)
    depth = 1000.0 / 3.6 / 800.0 / 5.0 / 0.8
    for found in exits_by_every_way(base, "inlet.velocity_m_s", 5.0):
        assert found[4:] == pytest.approx([5.0, depth], rel=1e-12)


@pytest.mark.parametrize("first", range(0, 300, 60))
def test_random_chutes_meet_their_steel_as_a_second_solver_has_it(first):
    """The second solver draws the chute itself, writes down the places, and runs another stream on them."""
    compared = 0
    for seed in range(first, first + 60):
        data, base = case(seed)
        kinds = [table["kind"] for table in data["segments"]]
        if "belt" in data["inlet"] or ("fall", "fall") in pairwise(kinds):
            continue  # what a spec cannot say with start_m
        changes = {"inlet.velocity_m_s": data["inlet"]["velocity_m_s"] * 1.07, "flow.rate_t_h": 1234.0}
        ours = chutecalc.solve(base.vary(changes))
        there = frozen_tables(data)
        there["inlet"] = there["inlet"] | {"velocity_m_s": changes["inlet.velocity_m_s"]}
        there["flow"] = there["flow"] | {"rate_t_h": 1234.0}
        theirs = summary(Solver(there).run())
        if outcome(theirs)[0] != ours.status[0]:
            continue  # at an edge; counted below
        compared += 1
        assert ours.exit_velocity[0] == pytest.approx(theirs["exit_velocity"], rel=1e-6, nan_ok=True), seed
    assert compared >= 40
