"""The units in which a number was probably meant."""

import math

import numpy as np

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.units import UNITS, convert, first_unit
from chutecalc.physics.arrays import Array, Mask

PERCENT = 100.0
SLACK = math.log(4.0)
"""Logarithm of the factor within which two units suit a number alike, so that the more common one is offered."""


def likely_units(quantity: Quantity, numbers: Array, unit: str) -> dict[str, Mask]:
    """Return which numbers each other unit suits, the more common units first.

    Args:
        quantity: that the numbers are of.
        numbers: as written, of any shape.
        unit: in which they are written.

    Returns:
        By suffix of each other unit of the dimension, and by ``%`` where there is none, whether the number would be
        plausible in that unit, and about as plausible as in any. Without sizes there are none.

    >>> from chutecalc.fields.quantities import WIDE
    >>> [unit for unit, suits in likely_units(Quantity("length", WIDE), np.array([800.0]), "m").items() if suits]
    ['mm']
    """
    if quantity.plausible is None:
        return {}
    dimension = quantity.dimension
    others = [other for other in UNITS[dimension] if other != unit]
    meant = {other: convert(numbers, dimension, other, first_unit(dimension)) for other in others}
    distances = {
        other: quantity.plausible.distance(value) for other, value in (meant or {"%": numbers / PERCENT}).items()
    }
    best = np.minimum.reduce(list(distances.values()))
    return {other: np.isfinite(away) & (away <= best + SLACK) for other, away in distances.items()}
