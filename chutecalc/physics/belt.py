"""How a stream loads the belt that receives it."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class Loading(NamedTuple):
    """The load of a stream on the belt that receives it, arrays of shape (designs,)."""

    velocity_along: Array
    """V_ex, velocity component along the belt, m/s."""
    velocity_across: Array
    """V_ey, velocity component normal to the belt, m/s, 0 or more."""
    velocity_ratio: Array
    """V_ex/V_b, a ratio."""
    impact_pressure: Array
    """Impact pressure ρ V_ey², Pa."""
    wear: Array
    """Belt wear μ_b ρ V_ey² |V_b - V_ex|, W/m²."""
    acceleration_length: Array
    """Distance along the belt from the impact to where the stream has the belt's velocity, m. Negative where the stream
    runs back and gets there behind the impact; infinite where it never gets there."""
    velocity_after_impact: Array
    """Velocity along the belt after the friction of the impact, m/s."""
    length_after_impact: Array
    """Acceleration length from that velocity on, m."""
    acceleration_power: Array
    """Power that the belt's drive puts into the stream, ṁ V_b (V_b - V_ex), W."""


def loading(
    velocity: Array,
    slope: Array,
    belt_velocity: Array,
    belt_slope: Array,
    friction: Array,
    density: Array,
    mass_rate: Array,
    gravity: Array,
) -> Loading:
    """Compute the impact of a stream on a receiving belt and the length on which the belt accelerates it.

    With V_ex = v cos(a - a_b) and V_ey = |v sin(a - a_b)| the acceleration length is
    (V_b² - V_ex²)/(2 g (±μ_b cos a_b + sin a_b)), + where the belt is faster than the stream. Friction drives the
    material; the slope of the belt helps or hinders. A bracket of the wrong sign never brings the stream to the belt's
    velocity. The friction of the impact itself changes V_ex by μ_b V_ey towards V_b, and not past it; the length is
    given without and with that change.

    Args:
        velocity: Stream velocity v at the end of the chute, m/s, shape (1,) or (designs,), as for all arguments.
        slope: Slope a of the stream there, rad below horizontal.
        belt_velocity: V_b, m/s, positive.
        belt_slope: a_b, rad below horizontal.
        friction: Coefficient of friction μ_b of the material on the belt.
        density: Bulk density ρ, kg/m³.
        mass_rate: ṁ, kg/s.
        gravity: g, m/s².

    Returns:
        The load on the belt. The stream is a point mass: its spread over the belt and air are neglected.

    >>> one = np.ones(1)
    >>> level = loading(
    ...     velocity=3 * one, slope=0 * one, belt_velocity=4 * one, belt_slope=0 * one,
    ...     friction=0.5 * one, density=800 * one, mass_rate=100 * one, gravity=10 * one,
    ... )
    >>> float(level.acceleration_length[0]), float(level.acceleration_power[0])
    (0.7, 400.0)
    """
    along, across = velocity * np.cos(slope - belt_slope), np.abs(velocity * np.sin(slope - belt_slope))
    pressure = density * across**2
    difference = belt_velocity - along
    after_impact = belt_velocity - np.sign(difference) * np.maximum(np.abs(difference) - friction * across, 0.0)
    starts = (along, after_impact)
    lengths = [_acceleration_length(start, belt_velocity, belt_slope, friction, gravity) for start in starts]
    return Loading(
        velocity_along=along,
        velocity_across=across,
        velocity_ratio=along / belt_velocity,
        impact_pressure=pressure,
        wear=friction * pressure * np.abs(difference),
        acceleration_length=lengths[0],
        velocity_after_impact=after_impact,
        length_after_impact=lengths[1],
        acceleration_power=mass_rate * belt_velocity * difference,
    )


def _acceleration_length(
    along: Array, belt_velocity: Array, belt_slope: Array, friction: Array, gravity: Array
) -> Array:
    """Compute the distance on a belt from a velocity along it to the belt's own; NaN where there is no stream."""
    difference = belt_velocity - along
    drive = np.where(difference >= 0.0, friction, -friction) * np.cos(belt_slope) + np.sin(belt_slope)
    reached = difference * drive > 0.0
    length = difference * (belt_velocity + along) / np.where(reached, 2.0 * gravity * drive, 1.0)
    length = np.where(difference == 0.0, 0.0, np.where(reached, length, np.inf))
    return np.where(np.isnan(along), np.nan, length)
