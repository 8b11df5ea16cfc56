"""Optima against known ones, brute grids and enumeration."""

import numpy as np
import pytest

import chutecalc
from chutecalc.studies.keys import key_arguments, read_keys
from chutecalc.studies.optimise import search
from chutecalc.studies.optimise.polish import polished
from chutecalc.studies.variants import Variants
from tests import seeds
from tests.conftest import ROOT, chute
from tests.verification.optimise_cases import judge

SPOON, SLOPE = "segments.spoon.radius_m", "segments.spoon.to_slope_deg"
COAL = ROOT / "specs" / "coal_hood_spoon.toml"
PROBLEMS = (4, 7, 21, 25)
"""Seeds of random problems that are solved within a second: with names and steps, with limits, in several states."""


def solved_grid(base, keys, columns, states=("design",), count=31):
    parameters = [key.parameter for key in read_keys(key_arguments(keys), base)]
    axes = [np.linspace(*bounds, count) for bounds in keys.values()]
    grid = [each.ravel() for each in np.meshgrid(*axes, indexing="ij")]
    return grid, Variants(base, parameters, columns, states)(grid)


@pytest.mark.parametrize(("delta", "best"), [(40, 75.9), (45, 80.5), (50, 83.3), (55, 85.3)])
def test_the_best_chamfer_between_flat_and_square_is_that_of_the_paper(delta, best):
    """Least equivalent friction at constant centre section, Figure 5, at A = 0.05 m²: in a very short straight."""
    base = chute(
        flow={"rate_t_h": 1000.0},
        material={"density_kg_m3": 800.0, "internal_friction_deg": float(delta)},
        liners={"wall": {"friction_deg": 25.0}},
        sections={"body": {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 80.0}},
        inlet={"velocity_m_s": 1000.0 / 3.6 / 800.0 / 0.05, "slope_deg": 45.0},
        segments=[{"kind": "straight", "slope_deg": 45.0, "length_m": 1e-3}],
    )
    found = chutecalc.optimise(base, {"beta": (60, 89)}, minimise="exit_equivalent_friction")
    assert found.values["chamfer_deg"][0] == pytest.approx(best, abs=0.05)
    assert found.binding == [[]]
    low, high = found.answers["chamfer_deg"].range
    ends = [
        chutecalc.solve(base.put({"sections.body.chamfer_deg": end})).exit["equivalent_friction"][0]
        for end in (low, high)
    ]
    for end, friction, bound in zip((low, high), ends, (60.0, 89.0), strict=True):
        assert friction / found.worst["exit_equivalent_friction"][0] == pytest.approx(1.01, rel=1e-6) or end == bound


def test_the_fastest_end_of_a_spoon_is_where_gravity_and_friction_balance():
    """dv/ds = 0 at the exit slope: g sin a = μ_e (g cos a + v²/R)."""
    base = chute(
        inlet={"velocity_m_s": 3.0, "slope_deg": 80.0},
        segments=[{"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 30.0}],
    )
    found = chutecalc.optimise(
        base, {SLOPE: (1, 79)}, maximise="exit_velocity_m_s", columns=["exit_equivalent_friction"]
    )
    v, friction = (found.outcome[name][0, 0] for name in ("exit_velocity_m_s", "exit_equivalent_friction"))
    a, g = np.radians(found.values[SLOPE][0]), 9.80665
    assert g * np.sin(a) == pytest.approx(friction * (g * np.cos(a) + v**2 / 3.0), rel=1e-5)


def test_no_point_of_a_grid_is_better_in_random_problems():
    verdicts = [judge(seed) for seed in (*PROBLEMS, *range(100, 100 + seeds.times(len(PROBLEMS)) - len(PROBLEMS)))]
    assert [wrong for _, wrong in verdicts if wrong] == []


def test_a_grid_shows_what_is_worse(monkeypatch):
    """The judge of the test above sees an optimum that is worse, and one that breaks a limit."""
    monkeypatch.delenv(seeds.SEED, raising=False)
    monkeypatch.setattr("chutecalc.studies.optimise.optimise.best_place", lambda problem, seed: problem.low)
    assert [judge(seed)[0] for seed in PROBLEMS[:2]] == ["wrong", "wrong"]


STATES = """
[cases.surge]
"flow.rate_t_h" = 1300
[cases.wet]
"liners.ceramic.friction_deg" = 29
"""


def test_the_worst_state_counts():
    base, keys = chutecalc.parse(chutecalc.STARTER + STATES), {SPOON: (1.0, 4.0), SLOPE: (10.0, 60.0)}
    found = chutecalc.optimise(base, keys, maximise="exit_velocity_m_s", subject=["exit_depth_m>=0.11"])
    cases = chutecalc.solve_cases(base.put(found.changes()))
    assert tuple(cases.names) == found.states == ("design", "surge", "wet")
    numbers = [solution.exit_velocity[0] for solution in cases.solutions.values()]
    assert min(numbers) == pytest.approx(found.worst["exit_velocity_m_s"][0], rel=1e-9)
    assert all(solution.ok[0] and solution.exit["depth_m"][0] >= 0.11 for solution in cases.solutions.values())
    _, block = solved_grid(base, keys, ["exit_velocity_m_s", "exit_depth_m"], found.states, 15)
    fine = (block["status"] == "ok").all(axis=0) & (block["exit_depth_m"] >= 0.11).all(axis=0)
    assert fine.any()
    assert min(numbers) >= block["exit_velocity_m_s"].min(axis=0)[fine].max()
    alone = chutecalc.optimise(base, keys, maximise="exit_velocity_m_s", subject=["exit_depth_m>=0.11"], case="surge")
    assert alone.states == ("surge",)
    assert alone.worst["exit_velocity_m_s"][0] > min(numbers)


def test_names_and_steps_are_chosen_as_enumeration_chooses():
    base = chutecalc.load(COAL)
    keys = {
        "segments.spoon.liner": ["ceramic", "steel"],
        "segments.hood.liner": ["ceramic", "steel"],
        SLOPE: (20, 50, 5),
    }
    subject = ["segments.spoon.max_wear_w_m2<=7600"]
    found = chutecalc.optimise(base, keys, minimise="exit_velocity_m_s", subject=subject)
    best = np.inf, ()
    for spoon in ("ceramic", "steel"):
        for hood in ("ceramic", "steel"):
            for slope in range(20, 55, 5):
                put = {"segments.spoon.liner": spoon, "segments.hood.liner": hood, SLOPE: float(slope)}
                solution = chutecalc.solve(base.put(put))
                if solution.ok[0] and solution.segments["spoon"].maximum["wear_w_m2"][0] <= 7600:
                    best = min(best, (solution.exit_velocity[0], tuple(put.values())))
    assert best[1] == tuple(values[0] for values in found.values.values())
    mixed = chutecalc.optimise(base, keys | {SPOON: (2, 6)}, minimise="exit_velocity_m_s", subject=subject)
    assert mixed.worst["exit_velocity_m_s"][0] <= best[0]


def test_a_limit_changes_the_best_as_it_says():
    base, keys = chutecalc.load(COAL), {SPOON: (1.0, 6.0), SLOPE: (5.0, 60.0)}

    def best(limit):
        return chutecalc.optimise(base, keys, maximise="exit_x_m", subject=[f"exit_velocity_m_s>={limit}"])

    found = best(6.4)
    ((bound,),) = found.binding
    assert bound.limit == "exit_velocity_m_s>=6.4"
    assert bound.values == {"design": pytest.approx(6.4, rel=1e-8)}
    change = (best(6.41).worst["exit_x_m"][0] - best(6.39).worst["exit_x_m"][0]) / 0.02
    assert bound.change_per_unit == pytest.approx(change, rel=1e-2)
    assert bound.change_per_unit < 0.0


def test_a_limit_that_decides_in_several_states_is_one_with_one_change():
    """A geometric limit is the same in each state: its multipliers there may be shared in any way, and add up."""
    base, keys = chutecalc.parse(chutecalc.STARTER + STATES), {SPOON: (1.0, 4.0), SLOPE: (10.0, 60.0)}

    def best(limit):
        return chutecalc.optimise(base, keys, minimise="exit_velocity_m_s", subject=[f"exit_slope_deg>={limit}"])

    ((bound,),) = best(30.0).binding
    assert [*bound.values] == ["design", "surge", "wet"]
    change = (best(30.01).worst["exit_velocity_m_s"][0] - best(29.99).worst["exit_velocity_m_s"][0]) / 0.02
    assert bound.change_per_unit == pytest.approx(change, rel=1e-4)
    assert bound.change_per_unit > 0.0


def test_a_front_is_as_good_as_a_grid():
    base = chutecalc.load(COAL)
    keys = {SPOON: (1.0, 6.0), SLOPE: (5.0, 60.0)}
    front = chutecalc.optimise(base, keys, minimise="exit_x_m", maximise="exit_velocity_m_s", points=5)
    x, v = front.worst["exit_x_m"], front.worst["exit_velocity_m_s"]
    assert front.count >= 4
    assert (np.diff(x) > 0.0).all()
    assert (np.diff(v) > 0.0).all()
    _, block = solved_grid(base, keys, ["exit_x_m", "exit_velocity_m_s"])
    for k in range(front.count):
        reached = block["exit_velocity_m_s"][0] >= v[k]
        assert not reached.any() or x[k] <= block["exit_x_m"][0][reached].min() + 1e-9


def test_the_same_seed_gives_the_same_and_none_feasible_is_said():
    base = chutecalc.load(COAL)
    keys = {SPOON: (1.0, 6.0)}
    one, other = (chutecalc.optimise(base, keys, maximise="exit_velocity_m_s", seed=3) for _ in range(2))
    assert one.document() == other.document()
    none = chutecalc.optimise(base, keys, maximise="exit_velocity_m_s", subject=["exit_velocity_m_s<=1"])
    assert not none.feasible
    assert repr(none) == "<Optimum of exit_velocity_m_s: no feasible design>"


def test_where_nothing_is_feasible_the_closest_alone_is_polished(monkeypatch):
    """More starts and a direct search would take most of the time, and find what the evolution found."""
    base, keys = chutecalc.load(COAL), {SPOON: (1.0, 6.0), SLOPE: (10.0, 60.0)}
    starts = []
    monkeypatch.setattr(search, "polished", lambda problem, place: starts.append(place) or polished(problem, place))
    monkeypatch.setattr(search, "settled", lambda *_: pytest.fail("searched on"))
    none = chutecalc.optimise(base, keys, maximise="exit_x_m", subject=["exit_velocity_m_s<=4", "exit_slope_deg<=15"])
    assert not none.feasible
    assert len(starts) == 1
    _, block = solved_grid(base, keys, ["exit_velocity_m_s", "exit_slope_deg"])

    def beyond(values):
        return sum(
            np.maximum(values[name][0] / most - 1.0, 0.0)
            for name, most in (("exit_velocity_m_s", 4.0), ("exit_slope_deg", 15.0))
        )

    assert beyond(none.outcome)[0] <= np.nanmin(beyond(block)) * (1.0 + 1e-9)


def test_without_warnings_the_best_has_none():
    base = chutecalc.parse(chutecalc.STARTER)
    keys = {SPOON: (1.0, 6.0), SLOPE: (20.0, 60.0), "flow.rate_t_h": (200.0, 1500.0)}
    found = chutecalc.optimise(base, keys, maximise="exit_depth_m", no_warnings=True)
    assert found.feasible
    assert found.outcome["warnings"].tolist() == [[""]]
    free = chutecalc.optimise(base, keys, maximise="exit_depth_m")
    assert free.outcome["warnings"][0, 0] != ""
    assert free.worst["exit_depth_m"][0] > found.worst["exit_depth_m"][0]
