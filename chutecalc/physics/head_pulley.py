"""How a stream leaves a belt over its head pulley: thrown off, carried round, or sliding round."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask

NEWTON_STEPS = 8
"""Steps of Newton's method for the angle at which a sliding stream lifts off; five reach the last digit."""


class Discharge(NamedTuple):
    """The stream where it leaves a head pulley, arrays of shape (1,) or (designs,)."""

    velocity: Array
    """Velocity, m/s: the belt's where the stream leaves at once, V r/r_b where it turns with the pulley, more where it
    slides."""
    froude: Array
    """Froude number v²/(g r) of the stream before it slides, dimensionless."""
    slope: Array
    """Slope, rad below horizontal: -ε where the stream leaves tangent to the belt, else the discharge angle α_d."""
    x: Array
    """Horizontal distance from the pulley's centre, m, positive in the direction of flow."""
    z: Array
    """Height above the pulley's centre, m."""
    carried: Mask
    """Whether the stream goes round with the pulley before it leaves."""


def discharge(
    velocity: Array,
    incline: Array,
    belt_radius: Array,
    radius: Array,
    gravity: Array,
    friction: Array | None = None,
) -> Discharge:
    """Compute where and how a stream leaves a belt over its head pulley.

    With V²/(g r) ≥ cos ε the stream leaves tangent to the belt, where the belt meets the pulley. Otherwise it turns
    with the pulley at v = V r/r_b and leaves at the angle cos α_d = v²/(g r), where its weight no longer holds it on
    the pulley. Where that ratio would be cos ε or more, it leaves as soon as turning has brought it to cos ε, so the
    velocity is continuous in V. With a friction angle it begins to slide before that, see
    :func:`slide`. It starts at r (sin α, cos α) from the pulley's centre.

    Args:
        velocity: Belt velocity V, m/s, positive, shape (1,) or (designs,), as for all arguments.
        incline: Incline ε of the belt, rad, positive uphill.
        belt_radius: Radius r_b of the belt's surface on the pulley, m.
        radius: Radius r of the line followed, m: r_b, or for the centre line r_b plus half the depth of material.
        gravity: g, m/s².
        friction: Friction angle of the material on the belt, rad; None for a stream that the belt holds to the end.

    Returns:
        The stream at discharge. Adhesion, air drag and the spread of the stream are neglected.

    >>> one = np.ones(1)
    >>> slow = discharge(velocity=one, incline=0 * one, belt_radius=0.4 * one, radius=0.44 * one, gravity=9.81 * one)
    >>> bool(abs(slow.velocity[0] - 1.1) < 1e-15), bool(abs(np.cos(slow.slope[0]) - 1.1**2 / (9.81 * 0.44)) < 1e-15)
    (True, True)
    """
    level = np.cos(incline)
    held, turned = velocity**2 / (gravity * radius) < level, velocity * radius / belt_radius
    carried = turned**2 / (gravity * radius) < level
    own = np.where(held, np.minimum(turned, np.sqrt(gravity * radius * level)), velocity)
    froude = own**2 / (gravity * radius)
    angle, leaves = np.arccos(np.where(carried, froude, 1.0)), own
    if friction is not None:
        angle = slide(np.where(carried, froude, 0.0), incline, friction)
        leaves = np.where(carried, np.sqrt(gravity * radius * np.cos(angle)), own)  # n = 0 there
    slope = np.where(carried, angle, -incline)
    x, z = radius * np.sin(slope), radius * np.cos(slope)
    return Discharge(velocity=leaves, froude=froude, slope=slope, x=x, z=z, carried=carried)


def slide_start(froude: Array, incline: Array, friction: Array) -> Array:
    """Compute the angle at which a stream that a pulley carries begins to slide on the belt.

    Friction holds it up to sin α = μ (cos α - Fr), so α = φ - asin(Fr sin φ); a stream that comes down a steeper belt
    slides at once, α = -ε. That it may also fall behind a belt that comes up an incline, just before the top of the
    pulley, is left out.

    Args:
        froude: Froude number Fr = v²/(g r) of the held stream, below cos ε, dimensionless, shape (1,) or (designs,), as
            for all arguments.
        incline: Incline ε of the belt, rad, positive uphill.
        friction: Friction angle φ of the material on the belt, rad, μ = tan φ.

    Returns:
        The angle from the vertical, rad, from 0 to the held stream's discharge angle.

    >>> one = np.ones(1)
    >>> angle = slide_start(froude=0.5 * one, incline=0 * one, friction=np.arctan(0.4) * one)
    >>> bool(abs(np.sin(angle) - 0.4 * (np.cos(angle) - 0.5)) < 1e-15)
    True
    """
    return np.maximum(friction + np.arccos(froude * np.sin(friction)) - 0.5 * np.pi, -incline)


def slide(froude: Array, incline: Array, friction: Array) -> Array:
    """Compute the angle at which a stream that slides round a pulley leaves it.

    From :func:`slide_start` on it moves as on a crest of the pulley's radius: f = v²/(g r) obeys df/dα = 2 (sin α -
    μ (cos α - f)), whose solution is f = -(2/D) [(1 - 2μ²) cos α + 3μ sin α] + k e^(2μα), D = 1 + 4μ². It leaves where
    the pulley no longer presses on it, f = cos α. The difference f - cos α is convex and rises with α, so Newton's
    method comes down from the held stream's angle, where cos α = Fr, without overshooting.

    Args:
        froude: As for :func:`slide_start`, dimensionless, shape (1,) or (designs,), as for all arguments.
        incline: As there, rad.
        friction: As there, rad; 0 gives the stream that slides without friction, cos α = (Fr + 2 cos α_0)/3 from the
            angle α_0 at which it starts: 0 on a belt that comes uphill, else -ε.

    Returns:
        The discharge angle from the vertical, rad, of shape (1,) or (designs,); the velocity there is √(g r cos α).

    >>> one = np.ones(1)
    >>> np.degrees(slide(froude=4 / (9.80665 * 0.5) * one, incline=0 * one, friction=np.arctan(0.5) * one)).round(1)
    array([22.5])
    """
    coefficient = np.tan(friction)
    scale = 2.0 / (1.0 + 4.0 * coefficient**2)
    along, across = scale * (1.0 - 2.0 * coefficient**2), scale * 3.0 * coefficient
    start = slide_start(froude, incline, friction)
    gain = froude + along * np.cos(start) + across * np.sin(start)
    angle = np.arccos(froude)
    for _ in range(NEWTON_STEPS):
        sine, cosine = np.sin(angle), np.cos(angle)
        ratio = gain * np.exp(2.0 * coefficient * (angle - start)) - along * cosine - across * sine
        rise = 2.0 * (sine - coefficient * (cosine - ratio)) + sine
        angle = angle - (ratio - cosine) / rise
    return angle
