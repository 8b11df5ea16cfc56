"""The belts at both ends of a chute: how a stream leaves the one, and what it does to the other."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class Discharge(NamedTuple):
    """How a stream leaves a head pulley, arrays of length 1 or n."""

    froude: Array
    """V²/(g r)."""
    slope: Array
    """Below horizontal, rad: -incline where the stream leaves tangent to the belt, else the angle that it is carried
    round to."""
    x: Array
    """From the pulley's centre, m."""
    z: Array


def discharge(velocity: Array, incline: Array, radius: Array, gravity: Array) -> Discharge:
    """Where and how a stream leaves a belt over its head pulley.

    With Fr = V²/(g r) ≥ cos ε it leaves tangent to the belt, where that meets the pulley; else it is carried round to
    cos α_d = Fr, where its weight is just what holds it on. It starts at r (sin α, cos α) from the centre.

    Args:
        velocity: V of the belt, m/s, positive.
        incline: ε, rad, positive uphill.
        radius: r of the pulley, belt and, for the centre line, half the material's depth, m.
        gravity: m/s².

    >>> slow = discharge(np.array([1.0]), np.zeros(1), np.array([0.4]), np.array([9.81]))
    >>> bool(abs(np.cos(slow.slope[0]) - 1.0 / (9.81 * 0.4)) < 1e-15)
    True
    """
    froude = velocity**2 / (gravity * radius)
    carried = froude < np.cos(incline)
    slope = np.where(carried, np.arccos(np.where(carried, froude, 1.0)), -incline)
    return Discharge(froude, slope, radius * np.sin(slope), radius * np.cos(slope))


class Loading(NamedTuple):
    """What a stream does to the belt that it falls on, shape (n,)."""

    along: Array
    """V_ex, velocity along the belt, m/s."""
    across: Array
    """V_ey, velocity normal to it, m/s."""
    velocity_ratio: Array
    """V_ex/V_b."""
    impact_pressure: Array
    """ρ V_ey², Pa."""
    wear: Array
    """μ_b ρ V_ey² |V_b - V_ex|, W/m²."""
    acceleration_length: Array
    """m of belt until the material has its velocity; infinite where it never has."""
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
    drives the material, and slope helps or hinders.

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
    lack = belt_velocity - along
    push = np.where(lack >= 0.0, friction, -friction) * np.cos(belt_slope) + np.sin(belt_slope)
    gain = lack * (belt_velocity + along)
    reachable = (gain * push > 0.0) | (gain == 0.0)
    length = np.where(reachable, gain / np.where(reachable & (gain != 0.0), 2.0 * gravity * push, 1.0), np.inf)
    length = np.where(np.isnan(along), np.nan, length)
    ratio = along / belt_velocity
    power = mass_rate * belt_velocity * lack
    return Loading(along, across, ratio, pressure, friction * pressure * np.abs(lack), length, power)
