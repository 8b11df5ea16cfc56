"""How hard the stream presses on a wall at an inclination, relative to the centre section."""

import numpy as np

from chutecalc.physics.arrays import Array, Values, real


def vertical_pressure_ratio(internal_friction: Values) -> Array:
    """Pressure on a vertical wall over the pressure on the centre section, K_v.

    K_v = (1 - sin δ)/(1 + sin δ), Paper Eq 4 at β = 90°; computed as tan²(45° - δ/2), which keeps its digits as
    δ nears 90°.

    Args:
        internal_friction: effective angle of internal friction δ, rad, any shape, 0 to π/2.

    Returns:
        K_v, from 1 (a liquid) down to 0, in the shape given.

    >>> float(vertical_pressure_ratio(np.radians(30.0)).round(12))
    0.333333333333
    """
    return np.tan(np.pi / 4 - real(internal_friction) / 2) ** 2


def pressure_ratio(inclination: Values, vertical_ratio: Values) -> Array:
    """Pressure normal to an inclined wall over the pressure on the centre section, K.

    K(β) = cos²β + K_v sin²β, which is Paper Eq 4 with δ replaced by the K_v that it gives.

    Args:
        inclination: wall angle β from the plane of the centre section, rad, 0 to π/2.
        vertical_ratio: K_v, in (0, 1]; broadcast against ``inclination``.

    Returns:
        K, between K_v and 1, in the broadcast shape.

    >>> float(pressure_ratio(np.radians(45.0), 1 / 3).round(12))
    0.666666666667
    """
    return 1.0 - pressure_shortfall(inclination, vertical_ratio)


def pressure_shortfall(inclination: Values, vertical_ratio: Values) -> Array:
    """What an inclined wall's pressure lacks to that on the centre section, 1 - K = (1 - K_v) sin²β.

    Arguments as in :func:`pressure_ratio`; written out because 1 - K cancels on shallow walls.

    >>> bool(abs(pressure_shortfall(1e-8, 0.75) / 2.5e-17 - 1) < 1e-15)
    True
    """
    shortfall: Array = (1.0 - real(vertical_ratio)) * np.sin(real(inclination)) ** 2
    return shortfall


def pressure_factor(excess: Values, missing_load: Values, equilibrium: bool) -> Array:
    """By how much a friction law raises the hydrostatic pressures of all walls, f.

    Hydrostatic normal forces add up to (1 + χ - m) N where N = ρ n A is the weight, and the law's friction takes
    (1 + χ) N of them. One factor for all walls closes the books: f = (1 + χ)/(1 + χ - m) with the paper's law, and
    1/(1 - m) with the equilibrium law, whose χ is already divided by 1 - m.

    Args:
        excess: χ of the law.
        missing_load: m, the share of the weight that hydrostatic wall pressures do not carry, in [0, 1).
        equilibrium: which law.

    Returns:
        f, 1 for a rectangle, in the broadcast shape.

    >>> float(pressure_factor(0.5, 0.5, False)), float(pressure_factor(1.0, 0.5, True))
    (1.5, 2.0)
    """
    total = 1.0 + real(excess)
    return 1.0 / (1.0 - real(missing_load)) if equilibrium else total / (total - real(missing_load))


def greatest_wall_friction(internal_friction: Values) -> Array:
    """The steepest wall friction angle a material can show, φ_s = atan(sin δ) (Paper, section 6).

    Args:
        internal_friction: δ, rad, any shape.

    Returns:
        φ_s, rad, in the shape given. On a rougher wall the material slides on itself.

    >>> float(np.degrees(greatest_wall_friction(np.radians(30.0))).round(1))
    26.6
    """
    return np.arctan(np.sin(real(internal_friction)))
