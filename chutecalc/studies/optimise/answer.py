"""What binds at an optimum, what each limit costs, and how flat it is."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import nnls

from chutecalc.physics.arrays import Array
from chutecalc.studies.optimise.polish import Slopes
from chutecalc.studies.optimise.problem import FAILURE, Problem

CLOSE = 1e-5
"""Share of a limit, of the bounds or of the objective, within which something binds."""
BESIDE = 1e-4
"""Distance, as a share of the bounds, at which designs beside an optimum are looked at."""
FLAT = 0.01
"""Share of the objective by which it may be worse in the ranges of keys."""
LINE, HALVINGS = 41, 20
"""Designs along each key, and how often the ends of its range are halved."""


class Binding(NamedTuple):
    """A limit that binds in a state."""

    limit: str
    """The limit as it is written."""
    state: str
    price: float
    """Change of the best objective for each unit that the limit is moved up; NaN where it is not known."""


class KeyAnswer(NamedTuple):
    """What an optimum says of a key."""

    value: Any
    """Its best value, a number or a name."""
    bound: str
    """``lower`` or ``upper`` if it lies on that bound of its own, else empty."""
    slope: float
    """Change of the objective in its worst states for each unit of the key, all others as they are; NaN for choices."""
    range: tuple[Any, ...]
    """Least and greatest value within 1 % of the best objective and feasible; of names all such."""


def binding(problem: Problem, place: Array) -> tuple[list[Binding], dict[str, float]]:
    """Return the limits that bind at an optimum, and the slope of the objective over each continuous key.

    The multipliers of the conditions of Karush, Kuhn and Tucker, which say the prices, are those not negative that come
    closest to a balance of all slopes, by least squares.

    Args:
        problem: what is wanted.
        place: of the optimum, in the units of the keys, shape (keys,).
    """
    here = Slopes(problem, place)
    keys = np.flatnonzero(problem.continuous)
    states = np.flatnonzero(here.values >= here.values.max() - CLOSE * np.abs(here.values).max())
    tight = np.flatnonzero(np.abs(here.margins) < CLOSE)
    share = ((place - problem.low) / (problem.high - problem.low))[keys]
    bounds = np.eye(len(keys))
    walls = np.concatenate([-bounds[:, share < CLOSE], bounds[:, share > 1.0 - CLOSE]], axis=1)
    slopes = np.concatenate([here.of_values[states].T, -here.of_margins[tight].T, walls], axis=1)
    ones = np.concatenate([np.ones(len(states)), np.zeros(slopes.shape[1] - len(states))])
    weight = 1.0 + np.abs(slopes).max(initial=0.0)
    known = not here.fails
    target = np.append(np.zeros(len(keys)), weight)
    found, _ = nnls(np.vstack([slopes, weight * ones]), target) if known else (np.full(len(ones), np.nan), 0.0)
    names, count = problem.variants.states, len(problem.variants.states)
    prices = found[len(states) : len(states) + len(tight)] * problem.unit
    edges = _edges(problem, place)
    prices = prices if not edges else np.full_like(prices, np.nan)  # the balance lacks the slope of the edge
    sign = problem.objective.sign
    bound = []
    for number, price in zip(tight, prices, strict=True):
        limit = problem.limits[number // count]
        each = -sign * price * limit.sign / limit.scale
        bound.append(Binding(limit.text, names[number % count], float(each) + 0.0))
    bound += edges
    over = here.of_values[states].T @ found[: len(states)] * problem.unit * sign / (problem.high - problem.low)[keys]
    return bound, {problem.keys[key].name: float(value) + 0.0 for key, value in zip(keys, over, strict=True)}


def _edges(problem: Problem, place: Array) -> list[Binding]:
    """Return the states in which a design beside the optimum fails, or where warnings begin."""
    keys = np.flatnonzero(problem.continuous)
    beside = np.repeat(place[None], 2 * len(keys), axis=0)
    for number, key in enumerate(keys):
        beside[2 * number : 2 * number + 2, key] += np.array([-1, 1]) * BESIDE * (problem.high - problem.low)[key]
    rows = problem.rows(np.concatenate([place[None], problem.clipped(beside)]))
    fails = np.isnan(rows.values[:, 1:]).any(axis=1) & ~np.isnan(rows.values[:, 0])
    found = [Binding("no failure", problem.variants.states[k], np.nan) for k in np.flatnonzero(fails)]
    warned = problem.no_warnings and rows.faults[0] == 0.0 and (rows.faults[1:] % FAILURE > 0.0).any()
    return [*found, *([Binding("no warnings", "", np.nan)] if warned else [])]


def key_answers(problem: Problem, place: Array, slopes: dict[str, float]) -> dict[str, KeyAnswer]:
    """Return the best value of each key, its bound, and the range in which the objective stays within 1 %.

    Args:
        problem: what is wanted.
        place: of the optimum, in the units of the keys, shape (keys,).
        slopes: of the objective over each continuous key.
    """
    found = {}
    best = float(problem.rows(place[None]).worst[0])

    def good(number: int, along: Array) -> Array:
        places = np.repeat(place[None], len(along), axis=0)
        places[:, number] = along
        rows = problem.rows(places)
        with np.errstate(invalid="ignore"):
            return np.asarray((rows.violation == 0.0) & (rows.worst <= best + FLAT * abs(best)))

    for number, key in enumerate(problem.keys):
        low, high = problem.low[number], problem.high[number]
        value = key.at(place[number : number + 1])[0].item()
        at = (place[number] - low) / (high - low)
        bound = "lower" if at < CLOSE else "upper" if at > 1.0 - CLOSE else ""
        if key.is_continuous:
            reach = tuple(_end(partial(good, number), place[number], end) for end in (low, high))
        else:
            every = np.arange(low, high + 1.0)
            values = key.at(every[good(number, every)]).tolist()
            reach = (min(values), max(values)) if values and isinstance(values[0], float) else tuple(values)
            bound = bound if isinstance(value, float) else ""
        found[key.name] = KeyAnswer(value, bound, slopes.get(key.name, np.nan), reach)
    return found


def _end(good: Any, place: float, end: float) -> float:
    """Return how far designs are good from a place towards an end without a break."""
    line = np.linspace(place, end, LINE)
    fine = good(line)
    fine[0] = True
    if fine.all():
        return float(end)
    first = int((~fine).argmax())
    inside, outside = line[first - 1], line[first]
    for _ in range(HALVINGS):
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if good(np.array([middle]))[0] else (inside, middle)
    return float(inside)
