"""Stretches of a part on which a column is negative."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.results.part import Part

SHARES = np.linspace(0.0, 1.0, 33)
"""Shares between which a column changes its sign once at most."""
ROUNDING = 1e-14
MOST_ROUNDS = 60


class Stretches(NamedTuple):
    """Where a column is negative, as shares of the length travelled; each of shape (stretches, designs).

    A stretch that a design does not have begins where it ends.
    """

    begin: Array
    end: Array

    def total(self, begins: Array, ends: Array) -> Array:
        """Return how much lies on all stretches together, shape (designs,), row by row whatever the batch.

        Args:
            begins, ends: a quantity that grows along the part, at both ends of each stretch, in any unit.
        """
        each = np.where(self.end > self.begin, ends - begins, 0.0)
        return np.asarray(sum(each))


def negative_stretches(part: Part, column: str) -> Stretches:
    """Find where a column is negative along a part.

    Args:
        part: of the trajectory.
        column: name of the column, which is continuous.

    Returns:
        The stretches, in order; neighbours touch.
    """
    values = part.at(SHARES, [column])[column]
    before, after = values[:-1], values[1:]
    low, high = (np.broadcast_to(shares[:, None], before.shape) for shares in (SHARES[:-1], SHARES[1:]))
    crossing = np.array(low)
    rows = np.flatnonzero((before * after < 0.0).any(axis=1))
    if rows.size:
        crossing[rows] = _root(part, column, (low[rows], high[rows]), (before[rows], after[rows]))
    begin = np.where(before < 0.0, low, crossing)
    end = np.where(after < 0.0, high, crossing)
    some = (before < 0.0) | (after < 0.0)
    return Stretches(begin, np.where(some, end, begin))


def _root(part: Part, column: str, shares: tuple[Array, Array], values: tuple[Array, Array]) -> Array:
    """Return where a column is 0 between shares at which it has different signs, by the Illinois method."""
    low, high = shares
    at_low, at_high = values
    root, found = high, np.zeros(high.shape, dtype=bool)
    for _ in range(MOST_ROUNDS):
        with np.errstate(all="ignore"):
            secant = high - at_high * (high - low) / (at_high - at_low)
        inside = np.isfinite(secant) & (secant >= np.minimum(low, high)) & (secant <= np.maximum(low, high))
        new = np.where(inside, secant, 0.5 * (low + high))
        value = part.at(new, [column])[column]
        turned = value * at_high < 0.0
        low, at_low = np.where(turned, high, low), np.where(turned, at_high, 0.5 * at_low)
        high, at_high = new, value
        moved, root = np.abs(new - root), np.where(found, root, new)  # a design's digits do not depend on the others
        found = found | (moved <= ROUNDING)
        if found.all():
            break
    return root
