"""A chute as a function of its numbers says what the chute itself says, wherever it is asked."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from itertools import islice

import numpy as np
import pytest
from scipy.optimize import brentq

import chutecalc
from tests import seeds
from tests.conftest import LEVEL, chute
from tests.robustness.chutes import random_specs

OUTPUTS = ("exit_velocity_m_s", "exit_depth_m", "exit_wear_w_m2", "exit_x_m", "error_estimate")
SPOON = "segments.spoon.radius_m"


def starter():
    return chutecalc.parse(LEVEL)


def numbers(table, path=""):
    """Yield all numbers of a spec, by their paths."""
    items = table.items() if isinstance(table, dict) else enumerate(table, 1)
    for key, value in items:
        here = f"{path}.{key}".lstrip(".")
        if isinstance(value, dict | list):
            yield from numbers(value, here)
        elif isinstance(value, float | int) and not isinstance(value, bool) and key != "format":
            yield here, float(value)


def expected(base, path, values):
    """Return what single designs give, one after the other; NaN where there is none."""
    computed = []
    for value in values:
        try:
            found = chutecalc.exits(base.vary({path: [value]}), columns=[name[5:] for name in OUTPUTS[:-1]])
        except chutecalc.SpecError as error:
            if error.designs is None:
                raise
            computed.append([np.nan] * len(OUTPUTS))
        else:
            ok = found.ok[0]
            computed.append(
                [*(found.exit[name[5:]][0] for name in OUTPUTS[:-1]), found.error_estimate[0] if ok else np.nan]
            )
    return np.array(computed).T


def agree(computed, right):
    return np.array_equal(computed, right, equal_nan=True)


def agree_within_rounding(computed, base, path, values):
    """Within what one digit more or less of the number does: NumPy's sine and C's may differ by as much.

    The number itself may change nothing, where others that sines are taken of do, and a flight magnifies that: to 3e-14
    with an old NumPy. An error estimate is relative, and such digits of 1 are rounding in it.
    """
    rounded = np.array([expected(base, path, values * (1.0 + step * 2e-16)) for step in range(-4, 5)])
    none = np.isnan(rounded)
    alike = np.where(np.isnan(computed), none.any(axis=0), ~none.all(axis=0))
    least, most = np.fmin.reduce(rounded), np.fmax.reduce(rounded)
    size = np.where((np.array(OUTPUTS) == "error_estimate")[:, None], 1.0, np.abs(most))
    spread = most - least + 1e-13 * size
    return bool((alike & (np.isnan(computed) | (computed >= least - spread) & (computed <= most + spread))).all())


def test_every_number_of_random_chutes():
    """By the recording and by a chute built again: the same numbers, and the same refusals."""
    random, traced = np.random.default_rng(5), 0
    for drawn in islice(random_specs(31), seeds.times(20)):
        data = {name: table for name, table in drawn.items() if name not in ("cases", "uncertainty")}
        try:
            base = chutecalc.parse(data)
            chutecalc.exits(base)
        except chutecalc.SpecError:
            continue
        for path, value in numbers(data):
            values = value * random.uniform(0.9, 1.1, 3)
            f = base.function([path], OUTPUTS)
            traced += f.traced
            try:
                right = expected(base, path, values)
            except chutecalc.SpecError:
                with pytest.raises(chutecalc.SpecError):
                    f(values)
                continue
            computed = np.array(f(values))
            assert np.array_equal([f(float(item)) for item in values], computed.T, equal_nan=True), (path, values)
            assert agree(computed, right) or agree_within_rounding(computed, base, path, values), (path, values)
    assert traced > 100


def test_several_at_once_are_those_of_vary():
    random = np.random.default_rng(1)
    changes = {
        SPOON: random.uniform(2.0, 4.0, 20),
        "liners.wall.friction_deg": random.uniform(15.0, 30.0, 20),
        "material.internal_friction_deg": random.uniform(35.0, 55.0, 20),
        "sections.body.chamfer_deg": random.uniform(20.0, 60.0, 20),
        "flow.rate_t_h": random.uniform(500.0, 1500.0, 20),
        "inlet.velocity_fpm": random.uniform(300.0, 800.0, 20),
    }
    base = chute(
        sections={"body": {"shape": "chamfered", "base_m": 0.4, "chamfer_deg": 45.0}},
        inlet={"velocity_m_s": 3.0, "slope_deg": 80.0},
        segments=[{"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0}],
    )
    f = base.function(list(changes), ["exit_velocity_m_s", "exit_pressure_kpa"])
    found, right = f(*changes.values()), chutecalc.exits(base.vary(changes), columns=["velocity_m_s", "pressure_kpa"])
    assert f.traced
    for values, name in zip(found, ("velocity_m_s", "pressure_kpa"), strict=True):
        # NumPy's tangent and C's may differ by a digit, which is 1e-16 of each number here
        assert values == pytest.approx(right.exit[name], rel=1e-14)


def test_a_root_finder_takes_it():
    f = starter().function({SPOON: (1.0, 6.0)})
    radius = brentq(lambda r: f(r) - 3.7, 1.0, 6.0, xtol=1e-12)
    assert chutecalc.solve(starter().vary({SPOON: radius})).exit_velocity[0] == pytest.approx(3.7, rel=1e-12)


def test_a_design_that_cannot_be_built_is_not_a_number_beside_those_that_can():
    base = chute(
        inlet={"velocity_m_s": 4.0, "slope_deg": 60.0},
        segments=[{"kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0}, {"kind": "fall", "drop_m": 1.0}],
    )
    f = base.function(["segments.1.to_slope_deg"])
    flat, none, steep = f([20.0, 60.0, 80.0])
    assert np.isfinite([flat, steep]).all()
    assert np.isnan(none)
    assert np.isnan(f(60.0))
    assert f(20.0) == flat


def test_what_the_receiver_gets():
    base = chute(
        receiver={"velocity_m_s": 4.0, "friction_deg": 30.0},
        segments=[{"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 20.0}],
        inlet={"velocity_m_s": 4.0, "slope_deg": 80.0},
    )
    f = base.function(["receiver.velocity_m_s", SPOON], ["receiver_velocity_ratio"])
    right = chutecalc.exits(base.vary({"receiver.velocity_m_s": [3.0, 5.0], SPOON: 2.5})).receiver["velocity_ratio"]
    assert np.array_equal(f([3.0, 5.0], 2.5), right)


def test_a_value_out_of_bounds_is_told():
    f = starter().function([SPOON])
    with pytest.raises(chutecalc.SpecError, match=r"at least 0\.001 m"):
        f(-1.0)
    with pytest.raises(chutecalc.SpecError, match="finite"):
        f(np.array([1.0, np.nan]))
    with pytest.raises(chutecalc.UsageError, match=r"from 2\.0 to 3\.0"):
        starter().function({SPOON: (2.0, 3.0)})(4.0)
    with pytest.raises(chutecalc.UsageError, match="takes 1 value"):
        f(1.0, 2.0)


@pytest.mark.parametrize(
    "path", ["segments.spoon.radius", "segments.9.radius_m", "flow", "segments.spoon.kind", "x.y", ""]
)
def test_a_path_to_no_number_is_told(path):
    with pytest.raises(chutecalc.SpecError, match="not a number"):
        starter().function([path])


@pytest.mark.parametrize("outputs", [[], ["velocity_m_s"], ["exit_time_s"], ["receiver_velocity_ratio"], ["exit_x"]])
def test_an_output_that_there_is_not_is_told(outputs):
    with pytest.raises(chutecalc.UsageError, match=r"no output|list of names"):
        starter().function([SPOON], outputs)


@pytest.mark.parametrize("outputs", [["exit_pressure_kpa", "exit_wear_w_m2", "exit_equivalent_friction"]])
def test_at_a_plate_the_impact_counts(outputs):
    base = chute(
        inlet={"velocity_m_s": 3.0, "slope_deg": 10.0},
        segments=[{"name": "wall", "kind": "plate", "slope_deg": 40.0, "length_m": 1.0}],
    )
    right = chutecalc.exits(base, columns=[name[5:] for name in outputs]).exit
    computed = base.function(["inlet.velocity_m_s"], outputs)(3.0)
    assert computed == tuple(right[name[5:]][0] for name in outputs)
    assert computed[0] > 0.0


@pytest.mark.parametrize(
    ("paths", "problem"),
    [
        ([SPOON, SPOON], "given twice"),
        ([SPOON, "segments.spoon.radius_mm"], "given twice"),
        ([SPOON, "segments.2.radius_m"], "given twice"),
        (["segments.0.radius_m"], "not a number"),
        (["inlet.at_ft.1"], "not a number"),
        (SPOON, "list of names"),
        ([3], "list of names"),
        ({SPOON: (2.0, 1.0)}, "limits"),
        ({SPOON: ("a", "b")}, "limits"),
        ({SPOON: 3.0}, "limits"),
    ],
)
def test_parameters_that_make_no_sense_are_told(paths, problem):
    with pytest.raises(chutecalc.ChutecalcError, match=problem):
        starter().function(paths)


@pytest.mark.parametrize("values", ["3", ["a"], [[1.0, 2.0]], 1j, None, 10**400])
def test_values_that_are_no_numbers_are_told(values):
    f = starter().function([SPOON])
    with pytest.raises(chutecalc.UsageError, match="give a number"):
        f(values)


def test_arrays_of_any_length():
    f = starter().function({SPOON: (1.0, 6.0)})
    assert f([]).size == 0
    assert f([3]).tolist() == [f(3)] == [f(np.float64(3.0))] == [f(np.array(3.0))]
    with pytest.raises(chutecalc.UsageError, match="all of the same length"):
        starter().function([SPOON, "flow.rate_t_h"])([1.0, 2.0], [1.0, 2.0, 3.0])


def test_a_function_is_of_one_design():
    with pytest.raises(chutecalc.UsageError, match="one design"):
        starter().vary({SPOON: [2.0, 3.0]}).function(["flow.rate_t_h"])


ENDS = [*(f"exit_{name}" for name in ("velocity_m_s", "s_m", "x_m", "z_m", "slope_deg", "depth_m")), "error_estimate"]


def long_spoon():
    return chute(
        inlet={"velocity_m_s": 4.0, "slope_deg": 80.0},
        segments=[{"name": "spoon", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0}],
    )


def test_each_of_many_is_what_it_is_alone():
    """More than are worked out at once; with steep friction the last of them stall."""
    f = long_spoon().function([SPOON, "liners.wall.friction_deg"], ENDS)
    radii, frictions = np.linspace(1.5, 4.0, 200), np.linspace(15.0, 50.0, 200)
    many = np.array(f(radii, frictions))
    alone = np.array([f(float(radius), float(friction)) for radius, friction in zip(radii, frictions, strict=True)])
    assert f.traced
    assert 20 < np.isnan(many[0]).sum() < 180
    assert np.array_equal(many.T, alone, equal_nan=True)


def never(*arguments):
    raise AssertionError("a table for one design")


CHUTES = {
    "a spoon": {"segments": [{"name": "last", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0}]},
    "a pipe": {
        "sections": {"body": {"shape": "circular", "radius_m": 0.4}},
        "segments": [{"name": "last", "kind": "curve", "radius_m": 3.0, "to_slope_deg": 5.0}],
    },
    "a chain": {
        "segments": [
            {"kind": "straight", "slope_deg": 70.0, "length_m": 1.0},
            {"kind": "fall", "drop_m": 1.0},
            {"name": "last", "kind": "curve", "from_slope_deg": 65.0, "radius_m": 3.0, "to_slope_deg": 5.0},
        ]
    },
}


@pytest.mark.parametrize("name", CHUTES)
def test_one_design_needs_no_table_and_is_what_solve_says(name, monkeypatch):
    base = chute(**({"inlet": {"velocity_m_s": 4.0, "slope_deg": 80.0}} | CHUTES[name]))
    f = base.function(["segments.last.radius_m", "liners.wall.friction_deg"], ENDS)
    monkeypatch.setattr("chutecalc.api.recording.run_recipe", never)
    monkeypatch.setattr("chutecalc.api.recording.run_ends", never)
    for radius, friction in ((3.0, 20.0), (2.5, 55.0), (2.0, 15.0), (3.0, 20.0)):
        computed = f(radius, friction)
        changed = {"segments.last.radius_m": radius, "liners.wall.friction_deg": friction}
        solution = chutecalc.solve(base.vary(changed), 1e-12)
        if solution.status[0] == "ok":
            right = [solution.exit[name.removeprefix("exit_")][0] for name in ENDS[:-1]]
            scale = np.maximum(np.abs(right), [0.0, 1.0, 1.0, 1.0, 1.0, 0.0])  # m and degrees, where they are near 0
            assert (np.abs(np.array(computed[:-1]) - right) <= 2e-10 * scale).all()
        else:
            assert np.isnan(computed).all()


def test_threads_share_a_function():
    f = long_spoon().function([SPOON, "liners.wall.friction_deg"], ENDS)
    cases = [(float(radius), float(15.0 + 10.0 * radius)) for radius in np.linspace(1.5, 4.0, 40)]
    right = [f(*case) for case in cases]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda case: f(*case), cases * 5))
    assert np.array_equal(found, right * 5, equal_nan=True)


def test_one_that_cannot_be_built_among_many_is_not_a_number():
    f = long_spoon().function(["segments.spoon.to_slope_deg"], ENDS)
    slopes = np.linspace(5.0, 60.0, 150)
    slopes[130] = 80.0  # the slope it begins with
    many = np.array(f(slopes))
    assert np.isnan(many[:, 130]).all()
    assert np.isfinite(np.delete(many[0], 130)).all()
    assert np.array_equal(many[:, 3], f(float(slopes[3])), equal_nan=True)


def test_a_failure_leaves_nothing_behind():
    f = long_spoon().function(["liners.wall.friction_deg"], ENDS)
    well = f(20.0)
    assert np.isfinite(well).all()
    assert np.isnan(f(50.0)).all()
    assert f(20.0) == well


@pytest.mark.parametrize("value", [20, np.float64(20.0), np.float32(20.0), np.int64(20), np.array(20.0)])
def test_any_kind_of_number_is_one(value):
    f = long_spoon().function(["liners.wall.friction_deg"])
    assert f.traced
    assert type(f(value)) is float
    assert f(value) == f(20.0)


def test_limits_hold_for_one_as_for_many():
    f = long_spoon().function({SPOON: (2.0, 3.0), "liners.wall.friction_deg": None})
    assert f(2.0, 20.0) == f([2.0], 20.0)[0]
    for radius in (1.9999, 3.0001, np.nan):
        with pytest.raises(chutecalc.UsageError, match=r"from 2\.0 to 3\.0"):
            f(radius, 20.0)
        with pytest.raises(chutecalc.UsageError, match=r"from 2\.0 to 3\.0"):
            f([radius], 20.0)


def test_other_processes_can_have_it():
    f = long_spoon().function({SPOON: (2.0, 4.0), "liners.wall.friction_deg": None}, ENDS[:2])
    same = pickle.loads(pickle.dumps(f))
    assert same(3.0, 20.0) == f(3.0, 20.0)
    assert repr(same) == repr(f) == f"<Function of {SPOON}, liners.wall.friction_deg: exit_velocity_m_s, exit_s_m>"
    with pytest.raises(chutecalc.UsageError):
        same(5.0, 20.0)
