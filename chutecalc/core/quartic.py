"""Find where a polynomial of degree 4 falls through zero.

Between the roots of its derivative a polynomial is monotone. Those of the second derivative are in closed form, those
of the first lie between them, and its own between those.
"""

import math
from array import array

from chutecalc.core import floats


class Quartic:
    """Coefficients in rising powers, and work arrays."""

    def __init__(self) -> None:
        self.value, self.slope, self.knots, self.falls = (floats.zeros(6) for _ in range(4))


def falls_through_zero(curve: Quartic, horizon: float) -> int:
    """Write the points in (0, horizon) where it falls through zero to ``falls``, in order; return their number."""
    for k in range(4):
        curve.slope[k] = (k + 1.0) * curve.value[k + 1]
    c, b, a = curve.slope[1], 2.0 * curve.slope[2], 3.0 * curve.slope[3]
    half = -0.5 * (b + math.copysign(math.sqrt(max(b * b - 4.0 * a * c, 0.0)), b))
    root = c / half if half != 0.0 else 0.0
    other_root = half / a if a != 0.0 else root
    low = min(max(min(root, other_root), 0.0), horizon)
    high = min(max(max(root, other_root), 0.0), horizon)
    curve.knots[0] = 0.0
    curve.knots[1] = root_between(curve.slope, 3, 0.0, low)
    curve.knots[2] = root_between(curve.slope, 3, low, high)
    curve.knots[3] = root_between(curve.slope, 3, high, horizon)
    curve.knots[4] = horizon
    count = 0
    for k in range(4):
        low, high = curve.knots[k], curve.knots[k + 1]
        if value_at(curve.value, 4, low) > 0.0 and value_at(curve.value, 4, high) <= 0.0:
            curve.falls[count] = root_between(curve.value, 4, low, high)
            count += 1
    return count


def value_at(coefficients: "array[float]", degree: int, at: float) -> float:
    """Return the polynomial's value by Horner's rule."""
    value = coefficients[degree]
    for k in range(degree):
        value = value * at + coefficients[degree - 1 - k]
    return value


def root_between(coefficients: "array[float]", degree: int, low: float, high: float) -> float:
    """Return the root between two points by the Illinois rule; the upper point where the sign does not change."""
    f_low, f_high = value_at(coefficients, degree, low), value_at(coefficients, degree, high)
    if f_low == 0.0:
        return low
    if not f_low * f_high < 0.0:
        return high
    at, last = high, 0
    for _ in range(100):
        at = low + (high - low) * (f_low / (f_low - f_high))
        f = value_at(coefficients, degree, at)
        if (f > 0.0) == (f_low > 0.0):
            gap = at - low
            low, f_low = at, f
            if last == 1:
                f_high *= 0.5
            last = 1
        else:
            gap = high - at
            high, f_high = at, f
            if last == 2:
                f_low *= 0.5
            last = 2
        if f == 0.0 or min(gap, high - low) <= 4e-16 * math.fabs(at):
            break
    return at
