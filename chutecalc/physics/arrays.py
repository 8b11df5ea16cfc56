"""The array types of physics and solver."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Floats in SI or radians that broadcast. One design is a batch of one; an absent limit is infinite."""

Values = Array | float
"""Argument of a formula: an array or one number."""

Numbers = dict[str, Array]
"""Arrays by column name."""

Mask = NDArray[np.bool_]
"""True or false for each design."""

Index = NDArray[np.intp]
"""Row numbers."""


def real(values: Values) -> Array:
    """Convert numbers to floats, and sequences to arrays.

    Args:
        values: Numbers in any unit, of any shape; also objects that take part in NumPy's functions.

    Returns:
        The same numbers as floats.

    >>> real([1, 2])
    array([1., 2.])
    """
    floats: Array = np.multiply(values, 1.0)  # a function of NumPy works for objects that only act like arrays too
    return floats


def shared(values: Array) -> Array:
    """Reduce an array to one value where all designs share it, so that what follows from it is computed once.

    Args:
        values: One number a design, any unit, shape (designs,).

    Returns:
        The array, of shape (1,) where all numbers are equal.

    >>> shared(np.array([2.0, 2.0])), shared(np.array([2.0, 3.0]))
    (array([2.]), array([2., 3.]))
    """
    return values[:1] if len(values) > 1 and (values == values[0]).all() else values
