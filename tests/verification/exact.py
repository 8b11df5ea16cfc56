"""Exact solutions of the equation of motion along a guiding surface, for the cases that have one.

Symbols and signs are those of :mod:`chutecalc.physics.motion`. Arrays are in SI and radians and broadcast.
"""

import numpy as np

from chutecalc.physics.arrays import Array, Values, real


def normal_acceleration(
    side: float, gravity: Values, slope: Values, curvature: Values, velocity_squared: Values
) -> Array:
    """Compute the acceleration that presses the stream on its surface, n = σ (g cos a + κ y).

    Args:
        side: σ, ``FLOOR`` or ``ROOF``.
        gravity: g, m/s².
        slope: a, rad below horizontal.
        curvature: κ, 1/m, positive where the surface flattens.
        velocity_squared: y = v², m²/s².

    Returns:
        n, m/s². Below 0 the stream has left the surface.

    >>> from chutecalc.physics.motion import FLOOR
    >>> float(normal_acceleration(FLOOR, 9.81, 0.0, 1 / 3.0, 9.0))
    12.81
    """
    return side * (real(gravity) * np.cos(real(slope)) + real(curvature) * real(velocity_squared))


def arc_velocity_squared(
    side: float, gravity: Values, radius: Values, friction: Values, entry: Values, velocity: Values, slope: Values
) -> Array:
    """Compute the exact v² along a circular arc for constant friction: spoon, crest or hood.

    With τ = 1 where the arc flattens (spoon) and -1 where it steepens (crest, hood), m = σ μ_e and D = 1 + 4 m²:
    v² = τ (2 g R/D) [(1 - 2 m²) cos a + 3 m sin a] + k exp(2 m a), with k from the entry. It solves
    dv²/da = 2 m v² - 2 τ g R (sin a - m cos a), the equation of motion over the slope.

    Args:
        side: σ, ``FLOOR`` or ``ROOF``; a roof that flattens carries no stream.
        gravity: g, m/s².
        radius: R, m.
        friction: μ_e, a coefficient.
        entry: Slope at the entry, rad below horizontal.
        velocity: Velocity at the entry, m/s.
        slope: Slopes at which to evaluate v², rad below horizontal, all on the same side of ``entry``.

    Returns:
        v², m²/s²; negative beyond a stall, meaningless beyond a loss of contact.

    >>> from chutecalc.physics.motion import FLOOR
    >>> float(arc_velocity_squared(FLOOR, 9.81, 3.0, 0.0, np.pi / 2, 2.0, 0.0).round(9))  # no friction: 2² + 2 g R
    62.86
    """
    a, start = real(slope), real(entry)
    turn = np.where(np.any(a < start), 1.0, -1.0)
    m = side * real(friction)
    scale = turn * 2.0 * real(gravity) * real(radius) / (1.0 + 4.0 * m**2)

    def particular(at: Array) -> Array:
        return scale * ((1.0 - 2.0 * m**2) * np.cos(at) + 3.0 * m * np.sin(at))

    return particular(a) + (real(velocity) ** 2 - particular(start)) * np.exp(2.0 * m * (a - start))


def straight_velocity_squared(
    gravity: Values, slope: Values, friction: Values, velocity: Values, distance: Values
) -> Array:
    """Compute the exact v² on a straight for constant friction, v² = v0² + 2 g (sin a - μ_e cos a) s.

    Args:
        gravity: g, m/s².
        slope: a, rad below horizontal.
        friction: μ_e, a coefficient.
        velocity: v0, m/s.
        distance: s from there, m.

    Returns:
        v², m²/s²; negative beyond a stall.

    >>> float(straight_velocity_squared(9.81, np.pi / 2, 0.5, 1.0, 2.0).round(9))
    40.24
    """
    drive = np.sin(real(slope)) - real(friction) * np.cos(real(slope))
    return real(velocity) ** 2 + 2.0 * real(gravity) * drive * real(distance)


def rectangular_straight_distance(drive: float, drag: float, entry: float, velocity: Values) -> Array:
    """Compute the exact distance at which a stream on a straight rectangular chute reaches a velocity.

    Friction grows with depth there. The equation of motion is v dv/ds = A - B/v, with A = g (sin a - μ cos a) and
    B = g μ K_v cos a Q/b² for the volume rate Q and the width b. Its solution is the difference of
    v²/(2 A) + B v/A² + (B²/A³) ln|A v - B| between the two velocities.

    Args:
        drive: A, m/s²; |A| > 0.01, where the logarithm keeps its digits.
        drag: B, m²/s³.
        entry: Velocity at s = 0, m/s.
        velocity: Velocity to reach, m/s, on the same side of the critical velocity B/A as ``entry``.

    Returns:
        s, m, in the shape of ``velocity``.

    >>> float(rectangular_straight_distance(2.0, 0.0, 1.0, 3.0))  # no drag: (3² - 1²)/(2 A)
    2.0
    """
    v = real(velocity)
    logarithm = np.log(np.abs((drive * v - drag) / (drive * entry - drag)))
    return (v**2 - entry**2) / (2 * drive) + drag * (v - entry) / drive**2 + drag**2 / drive**3 * logarithm
