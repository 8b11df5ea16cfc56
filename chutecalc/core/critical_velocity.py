"""Find the velocity at which gravity and friction balance on a straight."""

import math
from typing import Any

from chutecalc.core import batch, floats, guide_surface, motion

SLOWEST, STEP, STEPS = 1e-9, 0.1518, 320
"""Lowest velocity tried, m/s; logarithm of the ratio between neighbours; and how many there are: up to 1e12 m/s."""


def critical_velocities(
    guide: "guide_surface.Guide", numbers: Any, start: int, surfaces: Any, shares: Any, velocities: Any, out: Any
) -> None:
    """Write v_c, where tan a = μ_e(v_c) and friction grows as the stream slows.

    It is the next such equilibrium below a velocity. With constant wall friction, where μ_e grows with depth, there is
    one at most: a stream that enters slower decelerates to a stall. With a yield locus there may be several. v_c is 0
    where the stream accelerates at every smaller velocity; where it decelerates it is the next equilibrium above,
    infinite where there is none.

    Args:
        guide, numbers, start, surfaces, shares: as in :func:`chutecalc.core.profile.tabulate_stream_section`.
        velocities: of the stream there, m/s.
        out: v_c, m/s.
    """
    for design in range(shares.shape[1]):
        batch.restore_guide(guide, numbers, design, start, surfaces[design])
        for row in range(shares.shape[0]):
            uniform = guide.momentum_root * velocities[row, design]
            out[row, design] = critical_velocity(guide, shares[row, design], uniform) / guide.momentum_root


def critical_velocity(guide: "guide_surface.Guide", share: float, velocity: float) -> float:
    """Return √α_m v_c at one share, where √α_m v is ``velocity``."""
    if velocity != velocity:
        return floats.INFINITY
    accelerates = motion.force_any_branch(guide, share, velocity * velocity) > 0.0
    k = 0.0
    if velocity > SLOWEST:
        k = min(math.floor(math.log(velocity / SLOWEST) / STEP), STEPS - 1.0)
    if accelerates:
        high = net_acceleration(guide, share, k + 1)
        while k >= 0.0:
            low = net_acceleration(guide, share, k)
            if low <= 0.0 and high > 0.0:
                return find_root(guide, share, k, low, high)
            high = low
            k -= 1
        return 0.0
    low = net_acceleration(guide, share, k)
    while k < STEPS:
        high = net_acceleration(guide, share, k + 1)
        if low <= 0.0 and high > 0.0:
            return find_root(guide, share, k, low, high)
        low = high
        k += 1
    return floats.INFINITY


def net_acceleration(guide: "guide_surface.Guide", share: float, number: float) -> float:
    """Return the net acceleration, times a positive factor, at one of the velocities tried."""
    velocity = SLOWEST * math.exp(STEP * number)
    return motion.force_any_branch(guide, share, velocity * velocity)


def find_root(guide: "guide_surface.Guide", share: float, number: float, f_low: float, f_high: float) -> float:
    """Return the equilibrium between two neighbouring velocities, by the Illinois rule in the logarithm."""
    low, high, at, last = number, number + 1.0, number + 1.0, 0
    for _ in range(100):
        at = low + (high - low) * (f_low / (f_low - f_high))
        f = net_acceleration(guide, share, at)
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
