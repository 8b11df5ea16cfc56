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
    """Numbers as an array of floats."""
    return np.asarray(values, dtype=np.float64)


def shared(values: Array) -> Array:
    """One value where it is that of all designs, shape (1,): what follows from it alone is then worked out once."""
    return values[:1] if len(values) > 1 and (values == values[0]).all() else values


def sine_and_cosine(angle: Array) -> tuple[Array, Array]:
    """Both from t = tan(angle/2), 2 t/(1 + t²) and (1 - t²)/(1 + t²): a third of the time, and right to 4e-16.

    Args:
        angle: rad, from -π/2 to π/2: beyond that t grows and digits go.

    >>> sine, cosine = sine_and_cosine(np.array([np.pi / 6]))
    >>> bool(abs(sine[0] - 0.5) < 2e-16), bool(abs(cosine[0] ** 2 - 0.75) < 4e-16)
    (True, True)
    """
    t = np.tan(0.5 * angle)
    square = t * t
    share = 1.0 / (1.0 + square)
    t *= share
    t += t
    share *= 1.0 - square
    return t, share


def product(matrix: Array, columns: Array, out: Array | None = None) -> Array:
    """A small matrix times many columns, each column's digits the same whatever its neighbours are.

    BLAS orders its sums by the shape of the whole product and splits large ones by core: widths are padded to a
    multiple of 8, and products kept below 2^18 multiply-adds.
    """
    count = columns.shape[1]
    out = np.empty((len(matrix), count)) if out is None else out
    block = max(8, 2**18 // matrix.size // 8 * 8)
    for first in range(0, count, block):
        part, there = columns[:, first : first + block], out[:, first : first + block]
        width = part.shape[1]
        if width % 8:
            padded = np.empty((len(part), -(-width // 8) * 8))
            padded[:, :width], padded[:, width:] = part, part[:, -1:]
            there[...] = (matrix @ padded)[:, :width]
        else:
            np.matmul(matrix, part, out=there)
    return out
