"""Polishes a design: sequential quadratic programming on the epigraph of the worst state."""

from contextlib import suppress
from functools import cache

import numpy as np
from scipy.optimize import minimize

from chutecalc.physics.arrays import Array
from chutecalc.studies.optimise.problem import Problem

STEP = 1e-6
"""Half of the distance over which differences are taken, as a share of the bounds."""
TIGHT = 1e-9
"""Share of each limit that is kept free, so that rounding violates none."""
MOST = 80
"""Most designs that a polish looks at: where slopes break off, its steps come to no end."""
FAR = 1e3
"""What a design that fails counts as, far from any other."""


class Slopes:
    """The objective and the margins of a design in each state, and how they change with its continuous keys."""

    def __init__(self, problem: Problem, place: Array) -> None:
        """Solve a design and its neighbours in one batch.

        Args:
            problem: what is wanted.
            place: of the design, in the units of the keys, shape (keys,).
        """
        keys = np.flatnonzero(problem.continuous)
        width = problem.high - problem.low
        places = np.repeat(place[None], 1 + 2 * len(keys), axis=0)
        for number, key in enumerate(keys):
            places[1 + 2 * number, key] = max(place[key] - STEP * width[key], problem.low[key])
            places[2 + 2 * number, key] = min(place[key] + STEP * width[key], problem.high[key])
        rows = problem.rows(places)
        values = rows.values / problem.unit
        margins = rows.margins.reshape(-1, len(places))
        fails = np.asarray(np.isnan(values).any(axis=0))
        self.fails = bool(fails[0])
        source = np.where(fails, 0, np.arange(len(places)))  # differences to one side, where the other fails
        places, values, margins = places[source], values[:, source], margins[:, source]
        apart = np.array([places[2 + 2 * n, k] - places[1 + 2 * n, k] for n, k in enumerate(keys)]) / width[keys]
        self.values, self.margins = np.nan_to_num(values[:, 0], nan=FAR), margins[:, 0]
        with np.errstate(invalid="ignore", divide="ignore"):
            self.of_values = np.nan_to_num((values[:, 2::2] - values[:, 1::2]) / apart)
            self.of_margins = np.nan_to_num((margins[:, 2::2] - margins[:, 1::2]) / apart)


def polished(problem: Problem, place: Array) -> Array:
    """Return a design refined in its continuous keys, which may be worse or not feasible: compare it.

    The epigraph form is minimise t, with t not below the objective in any state, and all margins not negative.

    Args:
        problem: what is wanted.
        place: of the design, in the units of the keys, shape (keys,).
    """
    keys, width = problem.continuous, (problem.high - problem.low)[problem.continuous]
    if not keys.any():
        return place

    def at(shares: Array) -> Array:
        changed = place.copy()
        changed[keys] = problem.low[keys] + np.clip(shares, 0.0, 1.0) * width
        return changed

    iterates = [np.append((place[keys] - problem.low[keys]) / width, 0.0)]

    @cache
    def slopes(shares: tuple[float, ...]) -> Slopes:
        if slopes.cache_info().currsize >= MOST:
            raise _EnoughError
        return Slopes(problem, at(np.array(shares)))

    def here(point: Array) -> Slopes:
        return slopes(tuple(point[:-1].tolist()))

    def room(point: Array) -> Array:
        return np.concatenate([point[-1] - here(point).values, here(point).margins - TIGHT])

    def of_room(point: Array) -> Array:
        slope = np.concatenate([-here(point).of_values, here(point).of_margins])
        free = np.concatenate([np.ones(len(here(point).values)), np.zeros(len(here(point).margins))])
        return np.column_stack([slope, free])

    begin = iterates[0][:-1]
    first = slopes(tuple(begin.tolist()))
    if first.fails:
        return place
    with suppress(_EnoughError):
        minimize(
            lambda point: float(point[-1]),
            np.append(begin, first.values.max()),
            jac=lambda point: np.append(np.zeros(len(begin)), 1.0),
            bounds=[*[(0.0, 1.0)] * len(begin), (None, None)],
            constraints={"type": "ineq", "fun": room, "jac": of_room},
            method="SLSQP",
            callback=lambda point: iterates.append(point.copy()),
            options={"maxiter": MOST, "ftol": 1e-13},
        )
    return at(iterates[-1][:-1]) if np.isfinite(iterates[-1]).all() else place


class _EnoughError(Exception):
    """A polish has looked at its most designs."""
