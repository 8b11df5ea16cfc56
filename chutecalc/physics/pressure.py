"""Pressure of the stream on an inclined wall, relative to the pressure on the centre section."""

import numpy as np

from chutecalc.physics.arrays import Array, Values, real


def vertical_pressure_ratio(internal_friction: Values) -> Array:
    """Compute the pressure ratio of a vertical wall, K_v = (1 - sin δ)/(1 + sin δ).

    Paper Eq 4 at β = 90°, computed as tan²(45° - δ/2), which keeps its digits as δ approaches 90°. Roberts (2003)
    recommends 0.4 to 0.6 for square corners.

    Args:
        internal_friction: Effective angle of internal friction δ, rad, 0 to π/2, any shape.

    Returns:
        K_v, a ratio, from 1 (a liquid) down to 0, in the shape given.

    >>> float(vertical_pressure_ratio(np.radians(30.0)).round(12))
    0.333333333333
    """
    return np.tan(np.pi / 4 - real(internal_friction) / 2) ** 2


def pressure_ratio(inclination: Values, vertical_ratio: Values) -> Array:
    """Compute the ratio of the pressure normal to an inclined wall to that on the centre section, K(β).

    K(β) = cos²β + K_v sin²β: Paper Eq 4 with δ replaced by the K_v that it gives.

    Args:
        inclination: Wall angle β to the plane of the centre section, rad, 0 to π/2.
        vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].

    Returns:
        K, a ratio between K_v and 1, in the broadcast shape.

    >>> float(pressure_ratio(np.radians(45.0), 1 / 3).round(12))
    0.666666666667
    """
    return 1.0 - pressure_shortfall(inclination, vertical_ratio)


def pressure_shortfall(inclination: Values, vertical_ratio: Values) -> Array:
    """Compute the shortfall of an inclined wall's pressure ratio from 1, 1 - K = (1 - K_v) sin²β.

    Written out because 1 - K, computed from :func:`pressure_ratio`, cancels on shallow walls.

    Args:
        inclination: Wall angle β to the plane of the centre section, rad, 0 to π/2.
        vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].

    Returns:
        1 - K, a ratio between 0 and 1 - K_v, in the broadcast shape.

    >>> bool(abs(pressure_shortfall(1e-8, 0.75) / 2.5e-17 - 1) < 1e-15)
    True
    """
    shortfall: Array = (1.0 - real(vertical_ratio)) * np.sin(real(inclination)) ** 2
    return shortfall


def pressure_factor(excess: Values, missing_load: Values, equilibrium: bool) -> Array:
    """Compute the factor by which a friction law raises the hydrostatic pressures of all walls, f.

    Hydrostatic normal forces add up to (1 + χ - m) N, where N = ρ n A is the normal load (Paper Eq 8); the friction of
    the law needs (1 + χ) N. One factor for all walls balances the two: f = (1 + χ)/(1 + χ - m) with the paper's law,
    and f = 1/(1 - m) with the equilibrium law, whose χ is already divided by 1 - m.

    Args:
        excess: Excess friction χ of the law, a ratio, 0 or more.
        missing_load: Share m of the weight that hydrostatic wall pressures do not carry, in [0, 1).
        equilibrium: True for the equilibrium law, False for the paper's.

    Returns:
        f, a ratio of 1 or more (1 for a rectangle), in the broadcast shape.

    >>> float(pressure_factor(0.5, 0.5, False)), float(pressure_factor(1.0, 0.5, True))
    (1.5, 2.0)
    """
    total = 1.0 + real(excess)
    return 1.0 / (1.0 - real(missing_load)) if equilibrium else total / (total - real(missing_load))


def greatest_wall_friction(internal_friction: Values) -> Array:
    """Compute the largest wall friction angle that a material can show, φ_s = atan(sin δ).

    Paper, section 6. On a rougher wall the material slides on itself.

    Args:
        internal_friction: Effective angle of internal friction δ, rad, 0 to π/2, any shape.

    Returns:
        φ_s, rad, in the shape given.

    >>> float(np.degrees(greatest_wall_friction(np.radians(30.0))).round(1))
    26.6
    """
    return np.arctan(np.sin(real(internal_friction)))
