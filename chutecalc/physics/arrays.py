"""The array types that physics and solver speak of."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Floats in SI or radians, broadcastable; one design is a batch of one, an absent limit is infinite."""

Values = Array | float
"""What a formula takes: an array or one number."""

Mask = NDArray[np.bool_]
Index = NDArray[np.intp]


def real(values: Values) -> Array:
    """Numbers as floats, in arrays where they are many."""
    floats: Array = np.multiply(values, 1.0)  # by a function of NumPy, for what only acts like an array too
    return floats


def shared(values: Array) -> Array:
    """One value where it is that of all designs, shape (1,): what follows from it alone is then worked out once."""
    return values[:1] if len(values) > 1 and (values == values[0]).all() else values
