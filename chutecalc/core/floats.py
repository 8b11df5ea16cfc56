"""C arithmetic, in which nothing raises: undefined results are NaN. ``floats.pxd`` is the compiled form."""

import math
from array import array

NAN, INFINITY = float("nan"), float("inf")


def quotient(over: float, under: float) -> float:
    """Return over divided by under; infinite or NaN where that is 0."""
    if under != 0.0:
        return over / under
    if over > 0.0:
        return INFINITY
    return -INFINITY if over < 0.0 else NAN


def root(x: float) -> float:
    """Return the square root; NaN below 0."""
    return math.sqrt(x) if x >= 0.0 else NAN


def power(x: float) -> float:
    """Return e^x; infinite where it overflows."""
    return math.exp(x) if x < 709.0 else (INFINITY if x >= 709.0 else NAN)


def numbers(values: list[float]) -> "array[float]":
    """Return an array that holds these values."""
    return array("d", values)


def zeros(count: int) -> "array[float]":
    """Return an array of zeros."""
    return array("d", bytes(8 * count))
