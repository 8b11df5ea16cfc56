"""Optima of random problems against brute grids: keys of all kinds, limits, several states.

python -m tests.verification.optimise_cases 100    compares so many, and prints each that is worse with its seed
"""

from itertools import product
from typing import Any, NamedTuple

import numpy as np

import chutecalc
from chutecalc.studies.keys import key_arguments, read_keys
from chutecalc.studies.limit import Limit, read_limit
from chutecalc.studies.optimise.objective import Objective
from chutecalc.studies.optimise.problem import Problem
from tests import seeds
from tests.robustness.chutes import draws
from tests.verification.aim_cases import numbers
from tests.verification.judging import main

COLUMNS = ("exit_velocity_m_s", "exit_x_m", "exit_depth_m", "exit_time_s", "max_depth_m", "min_velocity_m_s")
GRID = 600
"""Designs of a grid, roughly."""
OPERATING = ("flow.", "material.internal", "liners.")
"""Beginnings of the paths that a case may set."""


class Case(NamedTuple):
    """A problem, and the best of its grid."""

    chute: chutecalc.Chute
    keys: dict[str, Any]
    objective: Objective
    limits: list[Limit]
    best: float
    """The objective in its worst state, its sign turned where it is maximised, at the best feasible design of the grid;
    infinite where none is feasible."""

    @property
    def text(self) -> str:
        """The problem, to repeat it."""
        goal = "minimise" if self.objective.sign > 0 else "maximise"
        return f"{self.keys!r} {goal} {self.objective.column} subject to {[limit.text for limit in self.limits]}"


def case(seed: int) -> Case:
    """Return the case of a seed."""
    random = seeds.generator(17, 5, seed)
    for drawn in draws(17, 6, seed):
        if drawn.solution is not None and drawn.solution.ok[0]:
            try:
                made = attempted(drawn.data, random)
            except chutecalc.ChutecalcError:
                continue  # a bound that the key does not take, or a case that is none
            if made is not None:
                return made
    raise AssertionError("draws end")


def attempted(data: dict[str, Any], random: np.random.Generator) -> Case | None:
    """Return a problem of a spec; None where no design of its grid gets through, or all are alike."""
    known = list(numbers(data))
    states = [(path, value) for path, value in known if path.startswith(OPERATING)]
    data = data | {
        "cases": {
            f"case{number}": {path: value * float(random.uniform(0.9, 1.1))}
            for number in range(random.integers(0, 3))
            for path, value in [states[random.integers(len(states))]]
        }
    }
    chute = chutecalc.parse(data)
    set_by_cases = {path for values in data["cases"].values() for path in values}
    free = [(path, value) for path, value in known if path not in set_by_cases]
    chosen = [free[k] for k in random.choice(len(free), min(len(free), random.integers(1, 4)), replace=False)]
    keys: dict[str, Any] = {path: (0.7 * value, 1.4 * value) for path, value in chosen}
    for path, (low, high) in list(keys.items())[1:]:
        if random.random() < 0.3:
            keys[path] = np.linspace(low, high, 5).tolist()
    guiding = [n for n, each in enumerate(data["segments"], 1) if each["kind"] not in ("fall",)]
    if guiding and len(data["liners"]) > 1 and random.random() < 0.4:
        keys[f"segments.{random.choice(guiding)}.liner"] = list(data["liners"])
    elif guiding and random.random() < 0.2:
        keys[f"segments.{random.choice(guiding)}.may_be_passed"] = [True, False]
    own = read_keys(key_arguments(keys), chute)
    names = [str(name) for name in random.permutation(COLUMNS)[:3]]
    objective = Objective(names[0], float(random.choice([-1.0, 1.0])))
    every = Problem(
        chute, own, objective, [Limit(name, 1.0, 0.0) for name in names[1:]], ("design", *chute.cases), jobs=1
    )
    rows = every.rows(grid(every))
    stands = rows.stands.all(axis=0)
    if stands.sum() < 20 or np.ptp(rows.worst[stands]) <= 1e-6 * np.abs(rows.worst[stands]).max():
        return None
    limits, allowed = [], stands
    for name in names[1 : 1 + random.integers(0, 3)]:
        sign = float(random.choice([-1.0, 1.0]))
        worst = (sign * rows.block[name]).max(axis=0)
        limit = read_limit(Limit(name, sign, sign * float(np.quantile(worst[stands], random.uniform(0.2, 0.9)))).text)
        limits.append(limit)
        allowed = allowed & (worst <= sign * limit.value)
    return Case(chute, keys, objective, limits, float(np.min(rows.worst[allowed], initial=np.inf)))


def grid(problem: Problem) -> np.ndarray:
    """Return a grid over the keys, with all choices, and as many values of each other key."""
    choices = np.prod([high + 1.0 for high, own in zip(problem.high, problem.continuous, strict=True) if not own])
    continuous = int(problem.continuous.sum())
    count = max(4, round((GRID / float(choices)) ** (1.0 / max(continuous, 1))))
    axes = [
        np.linspace(low, high, count) if own else np.arange(high + 1.0)
        for low, high, own in zip(problem.low, problem.high, problem.continuous, strict=True)
    ]
    return np.array(list(product(*axes)))


def judge(seed: int) -> tuple[str, list[str]]:
    """Return whether the best design is feasible as solved alone, and not worse than any of the grid."""
    of = case(seed)
    sign, name = of.objective.sign, of.objective.column
    goal = "minimise" if sign > 0 else "maximise"
    subject = [limit.text for limit in of.limits]
    found = chutecalc.optimise(of.chute, of.keys, **{goal: name}, subject=subject, jobs=1)
    if not found.feasible:
        return ("none", []) if of.best == np.inf else ("wrong", [of.text, f"none is feasible, {sign * of.best!r} is"])
    own = found.outcome
    wrong = [
        f"{limit.text}: {own[limit.column]}"
        for limit in of.limits
        if not (limit.sign * own[limit.column] <= limit.sign * limit.value).all()
    ]
    wrong += [] if (own["status"] == "ok").all() else [f"{own['status']}"]
    best = sign * float(found.worst[name][0])
    if not best <= of.best + 1e-9 * abs(of.best):
        wrong.append(f"{found}, and the grid has {sign * of.best!r}")
    return ("wrong", [of.text, *wrong]) if wrong else ("not worse", [])


if __name__ == "__main__":
    raise SystemExit(main(judge, "Compares optima of random problems with brute grids."))
