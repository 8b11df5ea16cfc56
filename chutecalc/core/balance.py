"""The velocity at which a stream on a straight keeps its speed."""

import math
from typing import Any

from chutecalc.core import batch, floats, friction, slide

SLOWEST, STEP, LAST = 1e-9, 0.1518, 320
"""m/s; logarithm of the ratio between velocities that are tried, and how many there are: up to 1e12 m/s."""


def balances(
    way: "slide.Slide", numbers: Any, start: int, surfaces: Any, places: Any, velocities: Any, out: Any
) -> None:
    """v_c, where tan a = μ_e(v_c) and friction grows as the stream slows: the next such balance below a velocity.

    With constant wall friction, which grows with depth, there is one at most: entered slower, the stream decelerates to
    a stall. With a yield locus there may be several. 0 where the stream accelerates at every smaller velocity; where it
    decelerates the next balance above, infinite where it does so at any.

    Args:
        way, numbers, start, surfaces, places: as of :func:`chutecalc.core.profile.lying`, of a straight.
        velocities: of the stream there, m/s.
        out: v_c, m/s.
    """
    for design in range(places.shape[1]):
        batch.put_back(way, numbers, design, start, surfaces[design, 0], surfaces[design, 1], surfaces[design, 2])
        for row in range(places.shape[0]):
            out[row, design] = balance(way, places[row, design], velocities[row, design])


def balance(way: "slide.Slide", place: float, velocity: float) -> float:
    """The same at one place."""
    if velocity != velocity:
        return floats.INFINITY
    faster = friction.pull_at(way, place, velocity * velocity) > 0.0
    k = 0.0
    if velocity > SLOWEST:
        k = min(math.floor(math.log(velocity / SLOWEST) / STEP), LAST - 1.0)
    if faster:
        high = surplus(way, place, k + 1)
        while k >= 0.0:
            low = surplus(way, place, k)
            if low <= 0.0 and high > 0.0:
                return between(way, place, k, low, high)
            high = low
            k -= 1
        return 0.0
    low = surplus(way, place, k)
    while k < LAST:
        high = surplus(way, place, k + 1)
        if low <= 0.0 and high > 0.0:
            return between(way, place, k, low, high)
        low = high
        k += 1
    return floats.INFINITY


def surplus(way: "slide.Slide", place: float, number: float) -> float:
    """What friction leaves of gravity's pull, times something positive, at one of the velocities tried."""
    velocity = SLOWEST * math.exp(STEP * number)
    return friction.pull_at(way, place, velocity * velocity)


def between(way: "slide.Slide", place: float, number: float, f_low: float, f_high: float) -> float:
    """The balance between one of the velocities tried and the next, by the Illinois rule in the logarithm."""
    low, high, at, last = number, number + 1.0, number + 1.0, 0
    for _ in range(100):
        at = low + (high - low) * (f_low / (f_low - f_high))
        f = surplus(way, place, at)
        if f > 0.0:
            gap = high - at
            high, f_high = at, f
            if last == 2:
                f_low *= 0.5
            last = 2
        else:
            gap = at - low
            low, f_low = at, f
            if last == 1:
                f_high *= 0.5
            last = 1
        if f == 0.0 or min(gap, high - low) <= 4e-16 * math.fabs(at):
            break
    return SLOWEST * math.exp(STEP * at)
