"""Aims against brute grids: every solution that a fine grid brackets is found, and what is found is what was asked."""

from itertools import islice

import numpy as np

import chutecalc
from chutecalc.studies.keys import key_arguments, read_keys
from chutecalc.studies.variants import Variants
from tests import seeds
from tests.conftest import ROOT
from tests.robustness.chutes import draws

TARGETS = ("exit_velocity_m_s", "exit_x_m", "max_depth_m", "exit_time_s")
FINE = 1001
SPOON = "segments.spoon.radius_m"


def numbers(table, path=""):
    for key, value in table.items() if isinstance(table, dict) else enumerate(table, 1):
        here = f"{path}.{key}".lstrip(".")
        if isinstance(value, dict | list):
            yield from numbers(value, here)
        elif isinstance(value, float) and value > 0:
            yield here, value


def random_aims(count):
    """Yield random chutes that get through, each with a key, its bounds, a column and a value of it that there is."""
    random = seeds.generator(17, 1)
    usable = (drawn for drawn in draws(17, 2) if drawn.solution is not None and drawn.solution.ok[0])
    for drawn in islice(usable, count):
        chute = chutecalc.parse(drawn.data)
        known = list(numbers(drawn.data))
        path, value = known[random.integers(len(known))]
        low, high = 0.6 * value, 1.5 * value
        try:
            (key,) = read_keys([f"{path}={low}:{high}"], chute)
            variants = Variants(chute, [key.parameter], list(TARGETS))
        except chutecalc.SpecError:
            continue  # a bound that the key does not take
        column = TARGETS[random.integers(len(TARGETS))]
        x = np.linspace(low, high, FINE)
        values = variants([x])[column][0]
        there = np.flatnonzero(np.isfinite(values))
        if not there.size or np.ptp(values[there]) < 1e-6 * np.abs(values[there]).max():
            continue
        first, second = values[random.choice(there, 2)]
        yield chute, path, (low, high), column, 0.5 * float(first + second), variants, x, values


def crossing(variants, column, target, low, high):
    """Return where a column crosses its target between two designs on either side; None where it jumps over it."""

    def off(x):
        return variants([np.array([x])])[column][0, 0] - target

    below = off(low) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        here = off(middle)
        if not np.isfinite(here):
            return None
        low, high = (middle, high) if (here < 0.0) == below else (low, middle)
    return middle if abs(here) < 1e-8 * max(1.0, abs(target)) else None


def test_every_solution_that_a_fine_grid_brackets_is_found():
    found = 0
    for chute, path, bounds, column, target, variants, x, values in random_aims(seeds.times(20)):
        aim = chutecalc.aim(chute, {path: bounds}, {column: target})
        assert np.abs(aim.outcome[column] - target).max(initial=0.0) <= 1e-9 * max(1.0, abs(target))
        off = values - target
        for k in np.flatnonzero(off[:-1] * off[1:] < 0.0):
            place = crossing(variants, column, target, x[k], x[k + 1])
            if place is not None:
                width = bounds[1] - bounds[0]
                assert np.abs(aim.values[path] - place).min(initial=np.inf) < 2e-6 * width, (chute.data, path, column)
                found += 1
    assert found >= 8


def test_all_solutions_of_two_targets_are_found():
    """Against the crossings of the zero lines of both on a fine grid."""
    chute = chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml")
    keys = {"segments.spoon.to_slope_deg": (10.0, 60.0), SPOON: (1.0, 6.0)}
    parameters = [key.parameter for key in read_keys(key_arguments(keys), chute)]
    columns = ["exit_velocity_m_s", "exit_x_m"]
    variants = Variants(chute, parameters, columns)
    axes = [np.linspace(*bounds, 101) for bounds in keys.values()]
    grid = [each.ravel() for each in np.meshgrid(*axes, indexing="ij")]
    known = [variants(grid)[name][0].reshape(101, 101) for name in columns]
    for place in ((15, 30), (75, 20)):
        targets = {name: float(values[place] * 1.0001) for name, values in zip(columns, known, strict=True)}
        aim = chutecalc.aim(chute, keys, targets)
        cells = np.ones((100, 100), dtype=bool)
        for name, values in zip(columns, known, strict=True):
            corners = np.stack([values[i : i + 100, j : j + 100] for i in (0, 1) for j in (0, 1)]) - targets[name]
            cells &= (corners.min(axis=0) < 0.0) & (corners.max(axis=0) > 0.0)
        crossed = np.argwhere(cells)
        assert len(crossed)
        solutions = np.stack(list(aim.values.values()), axis=1)
        for i, j in crossed:
            middle = np.array([axes[0][i : i + 2].mean(), axes[1][j : j + 2].mean()])
            assert np.abs((solutions - middle) / np.array([50.0, 5.0])).max(axis=1).min() < 0.03


def test_both_solutions_of_a_column_that_turns_are_found_however_close():
    """The velocity at the exit of a chamfered spoon is least at some chamfer angle: two solutions above that."""
    chute = chutecalc.load(ROOT / "specs" / "paper" / "r3_d55_chamfered.toml")
    path, column = "sections.spoon.chamfer_deg", "exit_velocity_m_s"
    (key,) = read_keys([f"{path}=20:89"], chute)
    variants = Variants(chute, [key.parameter], [column], rtol=1e-12)
    x = np.linspace(20.0, 89.0, 4001)
    values = variants([x])[column][0]
    turn = int(values.argmin())
    assert 0 < turn < 4000
    for share in (1e-3, 1e-6, 1e-8):
        target = float(values[turn]) * (1.0 + share)
        found = chutecalc.aim(chute, {path: (20, 89)}, {column: target}).values[path]
        assert len(found) == 2
        assert found[0] < x[turn] < found[1] or share < 1e-7


def test_what_cannot_be_had_is_said_with_the_nearest():
    """No velocity of the belt gives so fast an end; slow belts miss the hood."""
    chute = chutecalc.load(ROOT / "specs" / "transfer_90.toml")
    path = "inlet.belt.velocity_m_s"
    aim = chutecalc.aim(chute, {path: (0.5, 6.0)}, {"exit_velocity_m_s": 30.0})
    assert aim.count == 0
    assert aim.nearest is not None
    assert "missed" in aim.tried


def test_more_keys_start_from_scattered_points():
    chute = chutecalc.load(ROOT / "specs" / "coal_hood_spoon.toml")
    bounds = {
        "segments.hood.radius_m": (1.0, 4.0),
        SPOON: (1.0, 5.0),
        "segments.spoon.to_slope_deg": (10.0, 50.0),
        "flow.rate_t_h": (500.0, 2000.0),
    }
    wanted = {"segments.hood.radius_m": 2.2, SPOON: 3.1, "segments.spoon.to_slope_deg": 31.0, "flow.rate_t_h": 1300.0}
    columns = ["exit_velocity_m_s", "exit_slope_deg", "exit_x_m", "max_depth_m"]
    parameters = [key.parameter for key in read_keys(key_arguments(bounds), chute)]
    block = Variants(chute, parameters, columns, rtol=1e-12)([np.array([value]) for value in wanted.values()])
    aim = chutecalc.aim(chute, bounds, {name: float(block[name][0, 0]) for name in columns})
    solutions = np.stack([aim.values[name] for name in wanted], axis=1)
    assert np.abs(solutions / np.array([*wanted.values()]) - 1.0).max(axis=1).min() < 1e-6
