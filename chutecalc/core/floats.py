"""C's arithmetic, in which nothing raises: what has no value is not a number. ``floats.pxd`` is the compiled form."""

import math
from array import array

NAN, INFINITY = float("nan"), float("inf")


def quotient(over: float, under: float) -> float:
    """Over through under; infinite or not a number where that is 0."""
    if under != 0.0:
        return over / under
    if over > 0.0:
        return INFINITY
    return -INFINITY if over < 0.0 else NAN


def root(x: float) -> float:
    """Square root; not a number below 0."""
    return math.sqrt(x) if x >= 0.0 else NAN


def power(x: float) -> float:
    """e^x; infinite where that overflows."""
    return math.exp(x) if x < 709.0 else (INFINITY if x >= 709.0 else NAN)


def numbers(values: list[float]) -> "array[float]":
    """Room that holds these."""
    return array("d", values)


def zeros(count: int) -> "array[float]":
    """Room for so many numbers."""
    return array("d", bytes(8 * count))
