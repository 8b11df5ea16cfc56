"""Aims of random chutes against fine grids.

python -m tests.verification.aim_cases 1000    compares so many, and prints each that is wrong with its seed
"""

from typing import Any, NamedTuple

import numpy as np

import chutecalc
from chutecalc.studies.keys import read_keys
from chutecalc.studies.variants import Variants
from tests import seeds
from tests.robustness.chutes import draws
from tests.verification.judging import main

TARGETS = ("exit_velocity_m_s", "exit_x_m", "max_depth_m", "exit_time_s")
FINE = 1001
"""Designs of a fine grid."""
MET = 1e-9
"""Largest error of a target, as a share of it above 1."""
JUMP = 1e-8
"""Largest error where the column crosses its target; more is a jump over it."""


class Case(NamedTuple):
    """A chute, a key with its bounds, and a target that lies between two designs."""

    chute: chutecalc.Chute
    path: str
    bounds: tuple[float, float]
    column: str
    target: float
    variants: Variants
    x: Any
    """Values of the key on the fine grid."""
    values: Any
    """The column there."""


def numbers(table, path=""):
    """Yield the numbers above 0 of a spec's data, with their paths."""
    for key, value in table.items() if isinstance(table, dict) else enumerate(table, 1):
        here = f"{path}.{key}".lstrip(".")
        if isinstance(value, dict | list):
            yield from numbers(value, here)
        elif isinstance(value, float) and value > 0:
            yield here, value


def case(seed: int) -> Case:
    """Return the case of a seed."""
    random = seeds.generator(17, 1, seed)
    for drawn in draws(17, 2, seed):
        if drawn.solution is None or not drawn.solution.ok[0]:
            continue
        chute, known = chutecalc.parse(drawn.data), list(numbers(drawn.data))
        path, value = known[random.integers(len(known))]
        low, high = 0.6 * value, 1.5 * value
        column = TARGETS[random.integers(len(TARGETS))]
        try:
            (key,) = read_keys([f"{path}={low}:{high}"], chute)
            variants = Variants(chute, [key.parameter], [column])
        except chutecalc.SpecError:
            continue  # a bound that the key does not take
        x = np.linspace(low, high, FINE)
        values = variants([x])[column][0]
        there = np.flatnonzero(np.isfinite(values))
        if there.size and np.ptp(values[there]) >= 1e-6 * np.abs(values[there]).max():
            first, second = values[random.choice(there, 2)]
            return Case(chute, path, (low, high), column, 0.5 * float(first + second), variants, x, values)
    raise AssertionError("draws end")


def judge(seed: int) -> tuple[str, list[str]]:
    """Return whether an aim is right: each sign change on the fine grid is found, and each solution is true."""
    of = case(seed)
    what = f"{of.path}={of.bounds[0]!r}:{of.bounds[1]!r} {of.column}={of.target!r}"
    off = of.values - of.target
    cells = np.flatnonzero(off[:-1] * off[1:] < 0.0)
    try:
        aim = chutecalc.aim(of.chute, {of.path: of.bounds}, {of.column: of.target}, jobs=1)
    except chutecalc.UsageError as error:
        level = np.abs(off) <= MET * max(1.0, abs(of.target))
        return ("without end", []) if (level[:-1] & level[1:]).any() else ("wrong", [what, str(error)])
    found = aim.values[of.path]
    wrong = []
    if aim.count:
        errors = np.abs(of.variants([found])[of.column][0] - of.target) / max(1.0, abs(of.target))
        wrong += [
            f"{value!r} is off by {error:.2g}" for value, error in zip(found, errors, strict=True) if not error <= MET
        ]
    near = 2e-6 * (of.bounds[1] - of.bounds[0])
    for k in cells:
        inside = (found >= of.x[k] - near) & (found <= of.x[k + 1] + near)
        if not inside.any() and (place := crossing(of, of.x[k], of.x[k + 1])) is not None:
            wrong.append(f"{place!r} is not found")
    if wrong:
        return "wrong", [what, *wrong]
    return ("found" if aim.count else "none"), []


def crossing(of: Case, low: float, high: float) -> float | None:
    """Return where the column crosses its target between two designs on either side; None where it jumps over it."""

    def off(x):
        return of.variants([np.array([x])])[of.column][0, 0] - of.target

    below = off(low) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        here = off(middle)
        if not np.isfinite(here):
            return None
        low, high = (middle, high) if (here < 0.0) == below else (low, middle)
    return middle if abs(here) < JUMP * max(1.0, abs(of.target)) else None


if __name__ == "__main__":
    raise SystemExit(main(judge, "Compares aims of random chutes with fine grids."))
