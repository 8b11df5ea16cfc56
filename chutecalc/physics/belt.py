"""How a stream loads the belt that receives it."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array

ROUNDING = 4e-16
"""Share of a velocity below which a component of it is rounding."""


class Loading(NamedTuple):
    """The load of a stream on the belt that receives it, arrays of shape (designs,)."""

    velocity_along: Array
    """V_ex, velocity component along the belt, m/s."""
    velocity_into: Array
    """V_ey, velocity component normal to the belt, m/s, 0 or more."""
    velocity_across: Array
    """V_ez, velocity component across the belt, m/s, with the sign of the plan angle."""
    velocity_ratio: Array
    """V_ex/V_b, a ratio."""
    impact_pressure: Array
    """Impact pressure ρ V_ey², Pa."""
    wear: Array
    """Belt wear μ_b ρ V_ey² √((V_b - V_ex)² + V_ez²), W/m²."""
    acceleration_length: Array
    """Distance along the belt from the impact to where the stream has the belt's velocity, m. Negative where the stream
    runs back and gets there behind the impact; infinite where it never gets there."""
    velocity_after_impact: Array
    """Velocity along the belt after the friction of the impact, m/s."""
    wear_after_impact: Array
    """Belt wear with that velocity along the belt, W/m²."""
    length_after_impact: Array
    """Acceleration length from that velocity on, m."""
    acceleration_power: Array
    """Power that the belt's drive puts into the stream, ṁ V_b (V_b - V_ex), W."""


def components(velocity: Array, slope: Array, belt_slope: Array, plan_angle: Array) -> tuple[Array, Array, Array]:
    """Return the components of a stream's velocity along, into and across a belt.

    With the stream's slope a, the belt's a_b, and the plan angle ψ between their headings they are
    v (cos a cos a_b cos ψ + sin a sin a_b), v |sin a cos a_b - cos a sin a_b cos ψ| and v cos a sin ψ; their squares
    add up to v².

    Args:
        velocity: Stream velocity v, m/s, shape (1,) or (designs,), as for all arguments.
        slope: Slope a of the stream, rad below horizontal.
        belt_slope: a_b, rad below horizontal.
        plan_angle: ψ, rad.

    >>> level, one = np.zeros(1), np.ones(1)
    >>> [float(part[0].round(3)) for part in components(5 * one, level, level, np.pi / 2 * one)]
    [0.0, 0.0, 5.0]
    """
    # With cos ψ = 1 - 2 sin²(ψ/2) what is left at ψ = 0 keeps its digits.
    turned = 2.0 * np.sin(0.5 * plan_angle) ** 2 * np.cos(slope)
    along = np.cos(slope - belt_slope) - turned * np.cos(belt_slope)
    into = np.sin(slope - belt_slope) + turned * np.sin(belt_slope)
    along, into = (np.where(np.abs(part) > ROUNDING, part, 0.0) for part in (along, into))
    return velocity * along, np.abs(velocity * into), velocity * np.cos(slope) * np.sin(plan_angle)


def loading(
    velocity: Array,
    slope: Array,
    belt_velocity: Array,
    belt_slope: Array,
    friction: Array,
    plan_angle: Array,
    density: Array,
    mass_rate: Array,
    gravity: Array,
) -> Loading:
    """Compute the impact of a stream on a receiving belt and the length on which the belt accelerates it.

    The components of the velocity are those of :func:`components`. Friction acts against the slip of the stream over
    the belt, s = (V_ex - V_b, V_ez), along the belt and across it. For a stream without a component across it the
    acceleration length is (V_b² - V_ex²)/(2 g (±μ_b cos a_b + sin a_b)), + where the belt is faster than the stream;
    :func:`_acceleration_length` has the general one. Friction drives the material; the slope of the belt helps or
    hinders. A bracket of the wrong sign never brings the stream to the belt's velocity. The friction of the impact
    itself takes μ_b V_ey off the slip, and not more than it; wear and length are given without and with that change.

    Args:
        velocity: Stream velocity v where it lands, m/s, shape (1,) or (designs,), as for all arguments.
        slope: Slope a of the stream there, rad below horizontal.
        belt_velocity: V_b, m/s, positive.
        belt_slope: a_b, rad below horizontal.
        friction: Coefficient of friction μ_b of the material on the belt.
        plan_angle: ψ between the headings of stream and belt, rad.
        density: Bulk density ρ, kg/m³.
        mass_rate: ṁ, kg/s.
        gravity: g, m/s².

    Returns:
        The load on the belt. The stream is a point mass: its spread over the belt and air are neglected.

    >>> one = np.ones(1)
    >>> level = loading(
    ...     velocity=3 * one, slope=0 * one, belt_velocity=4 * one, belt_slope=0 * one, friction=0.5 * one,
    ...     plan_angle=0 * one, density=800 * one, mass_rate=100 * one, gravity=10 * one,
    ... )
    >>> float(level.acceleration_length[0]), float(level.acceleration_power[0])
    (0.7, 400.0)
    """
    along, into, across = components(velocity, slope, belt_slope, plan_angle)
    pressure = density * into**2
    difference = belt_velocity - along
    slip = np.hypot(difference, across)
    left = np.maximum(slip - friction * into, 0.0) / np.where(slip > 0.0, slip, 1.0)
    after_impact = belt_velocity - difference * left
    lengths, wears = zip(
        *(
            (
                _acceleration_length(start, crossing, belt_velocity, belt_slope, friction, gravity),
                friction * pressure * np.hypot(belt_velocity - start, crossing),
            )
            for start, crossing in ((along, across), (after_impact, across * left))
        ),
        strict=True,
    )
    return Loading(
        velocity_along=along,
        velocity_into=into,
        velocity_across=across,
        velocity_ratio=along / belt_velocity,
        impact_pressure=pressure,
        wear=wears[0],
        acceleration_length=lengths[0],
        velocity_after_impact=after_impact,
        wear_after_impact=wears[1],
        length_after_impact=lengths[1],
        acceleration_power=mass_rate * belt_velocity * difference,
    )


def _acceleration_length(
    along: Array, across: Array, belt_velocity: Array, belt_slope: Array, friction: Array, gravity: Array
) -> Array:
    """Compute the distance on a belt until the stream no longer slips on it; NaN where there is no stream.

    With f = μ_b g cos a_b, γ = g sin a_b and the slip s = (V_ex - V_b, V_ez), ds/dt = -f s/|s| + (γ, 0). So
    f |s| + γ s_x falls at the rate f² - γ², and the slip ends after T = (f |s| + γ s_x)/(f² - γ²). The rates of
    |s| s_x, |s|² and s_x² give ∫ s_x dt = (f |s| s_x + γ (|s|² + s_x²)/2)/(2 (f² - γ²)); the length is that and V_b T.
    """
    difference = belt_velocity - along
    drive = np.where(difference >= 0.0, friction, -friction) * np.cos(belt_slope) + np.sin(belt_slope)
    reached = difference * drive > 0.0
    straight = difference * (belt_velocity + along) / np.where(reached, 2.0 * gravity * drive, 1.0)
    straight = np.where(difference == 0.0, 0.0, np.where(reached, straight, np.inf))
    brake, pull = friction * gravity * np.cos(belt_slope), gravity * np.sin(belt_slope)
    slip, holds = np.hypot(difference, across), brake > np.abs(pull)
    margin = np.where(holds, (brake - pull) * (brake + pull), 1.0)
    time = (brake * slip - pull * difference) / margin
    drift = (0.5 * pull * (slip**2 + difference**2) - brake * slip * difference) / (2.0 * margin)
    curved = np.where(holds, belt_velocity * time + drift, np.inf)
    return np.where(np.isnan(along), np.nan, np.where(across == 0.0, straight, curved))
