"""The belts at both ends of a chute: how a stream leaves the one, and what it does to the other."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class Discharge(NamedTuple):
    """How a stream leaves a head pulley, arrays of length 1 or n."""

    velocity: Array
    """m/s: the belt's, or where the stream is held round the pulley what its radius makes of that."""
    froude: Array
    """v²/(g r) with that velocity."""
    slope: Array
    """Below horizontal, rad: -incline where the stream leaves tangent to the belt, else the angle that it is carried
    round to."""
    x: Array
    """From the pulley's centre, m."""
    z: Array


def discharge(velocity: Array, incline: Array, belt_radius: Array, radius: Array, gravity: Array) -> Discharge:
    """Where and how a stream leaves a belt over its head pulley.

    With V²/(g r) ≥ cos ε it leaves tangent to the belt, where that meets the pulley. Else it is held, turns with the
    pulley, v = V r/r_b, and is carried round to cos α_d = v²/(g r), where its weight is just what holds it on; not at
    all where that is cos ε or more. It starts at r (sin α, cos α) from the centre.

    Args:
        velocity: V of the belt, m/s, positive.
        incline: ε, rad, positive uphill.
        belt_radius: r_b of the belt's surface on the pulley, m.
        radius: r of what is looked at, m: for the centre line half the material's depth more.
        gravity: m/s².

    >>> one = np.ones(1)
    >>> slow = discharge(one, 0 * one, 0.4 * one, 0.44 * one, 9.81 * one)
    >>> bool(abs(slow.velocity[0] - 1.1) < 1e-15), bool(abs(np.cos(slow.slope[0]) - 1.1**2 / (9.81 * 0.44)) < 1e-15)
    (True, True)
    """
    level = np.cos(incline)
    held = velocity**2 / (gravity * radius) < level
    own = np.where(held, velocity * radius / belt_radius, velocity)
    froude = own**2 / (gravity * radius)
    carried = froude < level
    slope = np.where(carried, np.arccos(np.where(carried, froude, 1.0)), -incline)
    return Discharge(own, froude, slope, radius * np.sin(slope), radius * np.cos(slope))


class Loading(NamedTuple):
    """What a stream does to the belt that it falls on, shape (n,)."""

    velocity_along: Array
    """V_ex, velocity along the belt, m/s."""
    velocity_across: Array
    """V_ey, velocity normal to it, m/s."""
    velocity_ratio: Array
    """V_ex/V_b."""
    impact_pressure: Array
    """ρ V_ey², Pa."""
    wear: Array
    """μ_b ρ V_ey² |V_b - V_ex|, W/m²."""
    acceleration_length: Array
    """m along the belt from where the stream falls on it to where it has the belt's velocity; negative where it runs
    back first and gets no further, infinite where it never has."""
    velocity_after_impact: Array
    """Velocity along the belt that friction on the impact leaves, m/s."""
    length_after_impact: Array
    """The acceleration length from that on."""
    acceleration_power: Array
    """ṁ V_b (V_b - V_ex), W."""


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
    """The impact of a stream on a receiving belt, and what it takes to bring it to the belt's velocity.

    The acceleration length is (V_b² - V_ex²)/(2 g (±μ_b cos a_b + sin a_b)), + where the belt is the faster: friction
    drives the material, and slope helps or hinders. A bracket of the wrong sign never brings it there. The impact's own
    friction changes the velocity along by μ_b V_ey, towards the belt's and not past it: the length is told without that
    and with it.

    Args:
        velocity, slope: of the stream at the chute's end, m/s and rad below horizontal.
        belt_velocity, belt_slope: V_b, m/s, and a_b, rad below horizontal.
        friction: μ_b of the material on the belt.
        density, mass_rate, gravity: ρ, kg/m³; ṁ, kg/s; m/s².

    >>> one = np.ones(1)
    >>> level = loading(3 * one, 0 * one, 4 * one, 0 * one, 0.5 * one, 800 * one, 100 * one, 10 * one)
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
    """How far material goes on a belt from a velocity along it until it has the belt's; NaN where there is none."""
    difference = belt_velocity - along
    drive = np.where(difference >= 0.0, friction, -friction) * np.cos(belt_slope) + np.sin(belt_slope)
    reached = difference * drive > 0.0
    length = difference * (belt_velocity + along) / np.where(reached, 2.0 * gravity * drive, 1.0)
    length = np.where(difference == 0.0, 0.0, np.where(reached, length, np.inf))
    return np.where(np.isnan(along), np.nan, length)
