"""The sizes of a quantity: those that a chute can have, and those beyond which a unit is probably mistaken."""

import math
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask


class Plausible(NamedTuple):
    """Sizes in the first unit of a dimension: bounds of what can be meant, and the plausible ones between.

    What lies outside the bounds is refused, what lies outside the range is told. 0 is 0 in any unit, and so never a
    mistaken one. The size of a number counts, not its sign.
    """

    least: float
    """Smallest size that is taken, in the first unit of its dimension; 0 for any."""
    low: float
    """Smallest size of a plausible value, in that unit."""
    high: float
    """Largest size of a plausible value, in that unit."""
    most: float
    """Largest size that is taken, in that unit."""
    below: str
    """What a value below the range is like, as the end of a sentence: ``thinner than a coin``."""
    above: str
    """What a value above the range is like."""
    too_small: str = ""
    """Why nothing smaller is taken, as the end of a sentence: ``lets no grain pass``; empty where 0 is the bound."""
    too_large: str = ""
    """Why nothing larger than the bound is taken; empty where what is larger would be no such quantity."""
    coefficient: bool = False
    """Whether the number may be meant as the tangent of the angle that the key takes."""

    @property
    def middle(self) -> float:
        """Middle of the range on a logarithmic scale, in the first unit of the dimension."""
        return math.sqrt(self.low * self.high)

    @property
    def reasons(self) -> dict[str, str]:
        """Why the bounds are what they are: of ``less`` and ``more``, where there is a reason to give."""
        return {side: why for side, why in (("less", self.too_small), ("more", self.too_large)) if why}

    def mistaken(self, values: Array) -> Mask:
        """Return which values lie outside the range.

        Args:
            values: in the first unit of the dimension, of any shape.

        >>> Plausible(1.0, 100.0, 7000.0, 1e5, "light", "dense").mistaken(np.array([0.85, 0.0, 850.0])).tolist()
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

        >>> Plausible(0.001, 0.1, 10.0, 1e3, "short", "long").distance(np.array([1.0, 20.0])).tolist()
        [0.0, inf]
        """
        with np.errstate(divide="ignore"):
            away = np.abs(np.log(np.abs(values) / self.middle))
        return np.where(self.mistaken(values), np.inf, away)
