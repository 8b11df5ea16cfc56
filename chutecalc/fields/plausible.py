"""The range of a quantity outside which a person has probably mistaken its unit."""

import math
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask


class Plausible(NamedTuple):
    """A range in the first unit of a dimension, and what values beyond it are like.

    0 is 0 in any unit, and so never a mistaken one. The size of a number counts, not its sign.
    """

    low: float
    """Smallest size of a plausible value, in the first unit of its dimension."""
    high: float
    """Largest size of a plausible value, in that unit."""
    below: str
    """What a smaller value is like, as the end of a sentence: ``thinner than a coin``."""
    above: str
    """What a larger value is like."""
    coefficient: bool = False
    """Whether the number may be meant as the tangent of the angle that the key takes."""

    @property
    def middle(self) -> float:
        """Middle of the range on a logarithmic scale, in the first unit of the dimension."""
        return math.sqrt(self.low * self.high)

    def mistaken(self, values: Array) -> Mask:
        """Return which values lie outside the range.

        Args:
            values: in the first unit of the dimension, of any shape.

        >>> Plausible(100.0, 7000.0, "light", "dense").mistaken(np.array([0.85, 0.0, 850.0])).tolist()
        [True, False, False]
        """
        size = np.abs(values)
        mistaken: Mask = (size > 0.0) & ((size < self.low) | (size > self.high))
        return mistaken

    def distance(self, values: Array) -> Array:
        """Return how far values are from the middle of the range, as factors on a logarithmic scale.

        Args:
            values: in the first unit of the dimension, of any shape.

        Returns:
            The logarithms of the ratios, 0 or more; infinite for values outside the range.

        >>> Plausible(0.1, 10.0, "short", "long").distance(np.array([1.0, 20.0])).tolist()
        [0.0, inf]
        """
        with np.errstate(divide="ignore"):
            away = np.abs(np.log(np.abs(values) / self.middle))
        return np.where(self.mistaken(values), np.inf, away)
