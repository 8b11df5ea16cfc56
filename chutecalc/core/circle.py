"""Compute what a stream on the arc of a circle of radius 1 bears, from its area.

The area below the wetted half-angle ψ0 is A = ψ0 - sin ψ0 cos ψ0. Up to half of the circle everything follows from the
series of :mod:`chutecalc.physics.circle`. Above, what is left of the circle, π - A, depends on π - ψ0 as A does on ψ0,
so the same series gives the angle; the loads then follow from it in closed form, which cancels below half only.
"""

import math
from array import array

from chutecalc.core import floats

TERMS = 26
LEAST_DRY = 2e-15
"""Area below which what is left of a circle of radius 1 is the rounding of the stream's area."""
LARGEST_U = 7.082731016000907
"""(6 π)^(2/3), u of the half circle; written out, because compilers round such a power differently."""


def area_of_angle(angle: float) -> float:
    """Return the area below a wetted half-angle of up to π/2, ψ0 - sin ψ0 cos ψ0, by its series."""
    square = 4.0 * angle * angle
    total = 0.0
    for step in range(16):
        k = 16 - step
        total = (1.0 - total) * square / (2 * k * (2 * k + 1))
    return total * angle


def lower_arc(series: "array[float]", deficit: float, area: float) -> tuple[float, float, float, float, float]:
    """Return angle, χ and A dχ/dA, m and A dm/dA of a stream in the lower half.

    Args:
        series: seven times 26 coefficients.
        deficit: 1 - K_v.
        area: of the stream.
    """
    if not area >= 0.0:
        return floats.NAN, floats.NAN, floats.NAN, floats.NAN, floats.NAN
    side = (12.0 * area) ** (1.0 / 3.0)
    u = side * side
    t = 2.0 * u / LARGEST_U - 1.0
    angle, level, bent, lacking, level_slope, bent_slope, lacking_slope = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    before, now = t, 1.0  # T_-1 and T_0
    for k in range(TERMS):
        angle += series[k] * now
        level += series[TERMS + k] * now
        bent += series[2 * TERMS + k] * now
        lacking += series[3 * TERMS + k] * now
        level_slope += series[4 * TERMS + k] * now
        bent_slope += series[5 * TERMS + k] * now
        lacking_slope += series[6 * TERMS + k] * now
        before, now = now, 2.0 * t * now - before
    third = 2.0 / 3.0  # A d/dA = (2/3) u d/du
    excess = u * (level - deficit * u * bent)
    excess_sensitivity = third * u * (level + u * level_slope - deficit * u * (2.0 * bent + u * bent_slope))
    missing = deficit * u * lacking
    return side * angle, excess, excess_sensitivity, missing, third * deficit * u * (lacking + u * lacking_slope)


def upper_arc(series: "array[float]", deficit: float, area: float) -> tuple[float, float, float, float, float]:
    """Return the same of a stream in the upper half; of a full pipe where it is more than full.

    χ A = 2 ∫ K (1 - cos ψ)(cos ψ - cos ψ0) dψ and m A = 2 (1 - K_v) ∫ sin²ψ cos ψ (cos ψ - cos ψ0) dψ, both up to ψ0,
    and dA/dψ0 = 2 sin²ψ0. A full pipe has an infinite dχ/dA; it is taken as 0 there, as beyond.
    """
    left = math.pi - area
    dry = dry_angle(series, left) if left > LEAST_DRY else 0.0
    angle, sine, cosine = math.pi - dry, math.sin(dry), -math.cos(dry)
    cube, product = sine * sine * sine / 3.0, sine * cosine
    square = 0.5 * (angle - product)  # ∫ sin²ψ dψ
    mixed = 0.125 * (angle - product * (1.0 - 2.0 * sine * sine))  # ∫ sin²ψ cos²ψ dψ
    per_area = 1.0 / min(area, math.pi)
    level = sine - cosine * angle - 0.5 * angle + 0.5 * product
    bent = cube * (1.0 + cosine) - cosine * square - mixed
    excess = 2.0 * per_area * (level - deficit * bent)
    missing = 2.0 * per_area * deficit * (mixed - cosine * cube)
    if dry <= 0.0:
        return angle, excess, 0.0, missing, 0.0
    rise = angle - sine - deficit * (square - cube)  # ∫ K (1 - cos ψ) dψ
    return angle, excess, rise / sine - excess, missing, deficit * sine * sine / 3.0 - missing


def dry_angle(series: "array[float]", area: float) -> float:
    """Return the half-angle of an area of up to half a circle, by the first of the series alone."""
    side: float = (12.0 * area) ** (1.0 / 3.0)
    t = 2.0 * side * side / LARGEST_U - 1.0
    angle, before, now = 0.0, t, 1.0
    for k in range(TERMS):
        angle += series[k] * now
        before, now = now, 2.0 * t * now - before
    return side * angle
