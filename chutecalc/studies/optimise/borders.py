"""How far each key can go, all others as they are, until something no longer holds: a failure, or a worse objective."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.studies.optimise.problem import OK, Problem, Rows

LINE = np.unique(np.concatenate([[0.0], np.geomspace(1e-4, 1e-2, 9), np.linspace(0.0, 1.0, 41)]))
"""Designs from a place to a bound, closer together near the place."""
HALVINGS = 20
"""How often the interval between the last design that is good and the first that is not is halved."""

Good = Callable[[Rows], Mask]
"""Says of rows of designs which are good, shape (designs,)."""


class Border(NamedTuple):
    """Where a key reaches what is not good, in one direction."""

    key: int
    """Number of the key."""
    inside: float
    """Last value that is good without a break: the bound, if all are."""
    outside: float | None
    """First value that is not, if there is any."""


def borders(problem: Problem, place: Array, is_good: Good) -> list[Border]:
    """Return how far each continuous key can go towards its lower and towards its upper bound.

    Args:
        problem: what is wanted.
        place: of a design that is good, in the units of the keys, shape (keys,).
        is_good: what is good.
    """
    keys = np.flatnonzero(problem.continuous).repeat(2)
    if not keys.size:
        return []
    ends = np.where(np.arange(len(keys)) % 2 == 0, problem.low[keys], problem.high[keys])

    def good(lines: Index, shares: Array) -> Mask:
        """Shares from the place to the end of each line, shape (lines, designs)."""
        places = np.repeat(place[None], shares.size, axis=0)
        along = place[keys[lines], None] + shares * (ends[lines] - place[keys[lines]])[:, None]
        places[np.arange(shares.size), keys[lines].repeat(shares.shape[1])] = along.ravel()
        return is_good(problem.rows(places)).reshape(shares.shape)

    every = np.arange(len(keys))
    fine = good(every, np.tile(LINE, (len(keys), 1)))
    fine[:, 0] = True
    broken = np.flatnonzero(~fine.all(axis=1))
    first = (~fine[broken]).argmax(axis=1)
    inside, outside = LINE[first - 1], LINE[first]
    for _ in range(HALVINGS if broken.size else 0):
        middle = 0.5 * (inside + outside)
        here = good(broken, middle[:, None])[:, 0]
        inside, outside = np.where(here, middle, inside), np.where(here, outside, middle)
    reach = np.ones(len(keys)), np.full(len(keys), np.nan)
    reach[0][broken], reach[1][broken] = inside, outside
    inside, outside = (place[keys] + share * (ends - place[keys]) for share in reach)
    return [
        Border(int(key), float(one), None if np.isnan(other) else float(other))
        for key, one, other in zip(keys, inside, outside, strict=True)
    ]


class Edge(NamedTuple):
    """Where a design begins to fail as one key changes, all others as they are."""

    key: str
    value: float
    """Value of the key from which on it fails."""
    status: str
    """How it ends there."""
    states: tuple[str, ...]
    """The states in which it does."""
    distance: float
    """From the best value of the key, as a share of its bounds."""


def failure_edges(problem: Problem, place: Array) -> list[Edge]:
    """Return where each continuous key makes a design fail, the nearest first.

    Args:
        problem: what is wanted.
        place: of a design that does not fail, in the units of the keys, shape (keys,).
    """
    found = []
    for border in borders(problem, place, lambda rows: np.asarray(rows.stands.all(axis=0))):
        if border.outside is None:
            continue
        beside = place.copy()
        beside[border.key] = border.outside
        rows = problem.rows(beside[None])
        fails = np.flatnonzero(~rows.stands[:, 0])
        status = str(rows.block["status"][fails[0], 0])
        states = tuple(problem.variants.states[k] for k in fails)
        width = problem.high[border.key] - problem.low[border.key]
        distance = float(abs(border.outside - place[border.key]) / width)
        name = "no value" if status == OK else status
        found.append(Edge(problem.keys[border.key].name, border.outside, name, states, distance))
    return sorted(found, key=lambda edge: edge.distance)
