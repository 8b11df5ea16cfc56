"""The Pareto front of two objectives, by repeated optima of one under a limit of the other."""

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.studies.limit import Limit
from chutecalc.studies.optimise.binding import Binding, binding
from chutecalc.studies.optimise.objective import Objective
from chutecalc.studies.optimise.problem import Problem
from chutecalc.studies.optimise.search import best_place

ROUNDING = 1e-9
"""Share by which the end of a front may miss the best of its other objective."""

GENERATIONS = 30
"""Most generations of the evolution between the ends, where the points beside are known."""


def front_places(problem: Problem, second: Objective, points: int, seed: int) -> tuple[Array, list[list[Binding]]]:
    """Return the designs of a front, in the order of the first objective, and the limits that decide at each.

    Args:
        problem: of the first objective, in which designs need a value of the other one too.
        second: the other one.
        points: number of designs, if all are apart.
        seed: of what is random in the search.

    Returns:
        Places in the units of the keys, shape (designs, keys), and for each the limits that decide. Where no design
        is feasible, the one that violates least.
    """
    both_of = problem.objective, second

    def under(first: Objective, limits: tuple[Limit, ...]) -> Problem:
        chute, states = problem.chute, problem.variants.states
        return Problem(chute, problem.keys, first, limits, states, problem.no_warnings, problem.jobs, both_of)

    def worst(objective: Objective, place: Array) -> float:
        return float(under(objective, problem.limits).rows(place[None]).worst[0])

    first_best = best_place(problem, seed)
    if problem.rows(first_best[None]).violation[0] > 0.0:
        return first_best[None], [[]]
    other = under(second, problem.limits)
    second_best = best_place(other, seed)
    ends = worst(second, first_best), worst(second, second_best)
    found: list[tuple[Array, list[Binding]]] = []
    known = np.stack([first_best, second_best])
    for level in np.linspace(*ends, max(points, 2)):
        slack = ROUNDING * (abs(level) or 1.0)
        value = float(level) + slack if level in ends else float(f"{level:.6g}")  # as it is told
        limit = Limit(second.column, second.sign, second.sign * value)
        limited = under(problem.objective, (*problem.limits, limit))
        place = limited.rounded(best_place(limited, seed, known, GENERATIONS))
        if limited.rows(place[None]).violation[0] == 0.0:
            bound = binding(limited, place).binding
            if level in ends:  # no limit of the user: beyond it there is no front
                bound = [each for each in bound if each.limit != limit.text]
            found.append((place, bound))
            known = np.concatenate([known, place[None]])
    both = np.array([[worst(problem.objective, place), worst(second, place)] for place, _ in found])
    kept = [k for k in range(len(found)) if not _is_worse(both, k)]
    kept.sort(key=lambda k: both[k, 0])
    return np.array([found[k][0] for k in kept]), [found[k][1] for k in kept]


def _is_worse(both: Array, number: int) -> bool:
    """Return whether another point is better in one objective and not worse in the other, or an earlier one equal."""
    near = 1e-9 * (np.abs(both[number]) + 1e-300)
    not_worse = (both <= both[number] + near).all(axis=1)
    better = (both < both[number] - near).any(axis=1)
    return bool((not_worse & better).any() or not_worse[:number].any())
