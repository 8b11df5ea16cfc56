"""What an optimum says of each key: its bound, how much it changes, how flat the optimum is, and where it fails."""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask
from chutecalc.studies.optimise.binding import CLOSE, AtOptimum
from chutecalc.studies.optimise.borders import Edge, borders
from chutecalc.studies.optimise.problem import Problem, Rows

FLAT = 0.01
"""Share of the objective by which it may be worse in the ranges of keys."""


class KeyAnswer(NamedTuple):
    """What an optimum says of a key."""

    value: Any
    """Its best value, a number or a name."""
    bound: str
    """``lower`` or ``upper`` if it lies on that bound of its own, else empty."""
    change_per_unit: float
    """Change of the objective in its worst states for each unit of the key, all others as they are; NaN for choices."""
    range: tuple[Any, ...]
    """Least and greatest value within 1 % of the best objective and feasible; of names all such."""
    fails: tuple[Edge, ...]
    """Where the design begins to fail as this key changes, all others as they are, within its bounds."""


def key_answers(problem: Problem, place: Array, at: AtOptimum) -> dict[str, KeyAnswer]:
    """Return the best value of each key, its bound, the range in which the objective stays within 1 %, its failures.

    Args:
        problem: what is wanted.
        place: of the optimum, in the units of the keys, shape (keys,).
        at: what decides there.
    """
    best = float(problem.rows(place[None]).worst[0])

    def good(rows: Rows) -> Mask:
        with np.errstate(invalid="ignore"):
            return np.asarray((rows.violation == 0.0) & (rows.worst <= best + FLAT * abs(best)))

    reached: dict[int, list[float]] = {}
    for border in borders(problem, place, good):
        reached.setdefault(border.key, []).append(border.inside)
    found = {}
    for number, key in enumerate(problem.keys):
        low, high = problem.low[number], problem.high[number]
        value = key.at(place[number : number + 1])[0].item()
        share = (place[number] - low) / (high - low)
        bound = "lower" if share < CLOSE else "upper" if share > 1.0 - CLOSE else ""
        if key.is_continuous:
            reach = tuple(reached[number])
        else:
            places = np.repeat(place[None], int(high) + 1, axis=0)
            places[:, number] = np.arange(low, high + 1.0)
            values = key.at(places[good(problem.rows(places)), number]).tolist()
            reach = (min(values), max(values)) if values and isinstance(values[0], float) else tuple(values)
            bound = bound if isinstance(value, float) else ""
        fails = tuple(edge for edge in at.edges if edge.key == key.name)
        found[key.name] = KeyAnswer(value, bound, at.slopes.get(key.name, np.nan), reach, fails)
    return found
