"""The load on a belt with up to three rolls across: its area, and how much of the belt's width it covers.

ISO 5048 (1989) adds two areas: a trapezium in the trough, up to the level at which the load ends at both sides, and a
segment of a parabola above it that meets that level at the surcharge angle. Of chord W and angle θ it has the area
W² tan θ / 6. A flat belt is a trough of 0.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class BeltLoad(NamedTuple):
    """The load on a belt, arrays of shape (1,) or (designs,)."""

    area: Array
    """Cross-section A_b of the load, m²."""
    fill: Array
    """A_b over the area S that the belt can carry, a ratio."""
    width: Array
    """Width of belt that the load covers, measured along the belt across the trough, m."""
    depth: Array
    """Mean depth h = A_b/width where the belt is flat over its head pulley, m."""
    roll: Array
    """Length of the middle roll, m."""


def usable_width(width: Array) -> Array:
    """Compute the width of a belt that may carry material: 0.9 B - 0.05 m, above B = 2 m B - 0.25 m.

    ISO 5048. The second line is the steeper one, and both meet at 2 m.

    Args:
        width: Width B of the belt, m, any shape.

    Returns:
        The usable width, m, of the same shape.

    >>> usable_width(np.array([1.0, 2.0, 3.0])).tolist()
    [0.85, 1.75, 2.75]
    """
    return np.maximum(0.9 * width - 0.05, width - 0.25)


def load_area(covered: Array, roll: Array, trough: Array, surcharge: Array) -> Array:
    """Compute the cross-section of the load that covers a width of belt.

    S = [l + (b - l) cos λ]² tan θ / 6 + [l + (b - l)/2 · cos λ] (b - l)/2 · sin λ, ISO 5048. It describes a load that
    covers the middle roll, b ≥ l. A narrower one lies on that roll alone, which is flat: there l is replaced by b, and
    S = b² tan θ / 6.

    Args:
        covered: Width b of belt that is covered, m, shape (1,) or (designs,), as for all arguments.
        roll: Length l of the middle roll, m.
        trough: Trough angle λ of the side rolls, rad.
        surcharge: Surcharge angle θ, rad.

    Returns:
        The area S, m².

    >>> one = np.ones(1)
    >>> load_area(0.85 * one, 0.38 * one, np.radians(35) * one, np.radians(15) * one).round(4)
    array([0.1033])
    """
    flat = np.minimum(roll, covered)
    side = 0.5 * (covered - flat)
    reach, rise = side * np.cos(trough), side * np.sin(trough)
    area: Array = (flat + 2.0 * reach) ** 2 * np.tan(surcharge) / 6.0 + (flat + reach) * rise
    return area


def loaded_width(area: Array, roll: Array, trough: Array, surcharge: Array) -> Array:
    """Compute the width of belt that a load covers: the inverse of :func:`load_area`.

    With u = (b - l)/2 the area is k (l u + u² cos λ) + l² tan θ / 6, k = sin λ + (2/3) tan θ cos λ: a quadratic in u,
    solved in the form that does not cancel. A load too small to cover the middle roll lies on a flat belt, λ = 0, where
    with l = 0 the same form gives b = √(6 A/tan θ).

    Args:
        area: Cross-section A of the load, m², shape (1,) or (designs,), as for all arguments.
        roll: Length of the middle roll, m.
        trough: Trough angle of the side rolls, rad; trough and surcharge must not both be 0.
        surcharge: Surcharge angle of the load, rad.

    Returns:
        The width b, m.

    >>> one = np.ones(1)
    >>> trough = dict(roll=0.38 * one, trough=np.radians(35) * one, surcharge=np.radians(15) * one)
    >>> loaded_width(load_area(0.85 * one, **trough), **trough).round(12)
    array([0.85])
    """
    steepness = np.tan(surcharge)
    on_roll = area < roll**2 * steepness / 6.0
    flat = np.where(on_roll, 0.0, roll)
    cosine, sine = np.where(on_roll, 1.0, np.cos(trough)), np.where(on_roll, 0.0, np.sin(trough))
    rest = (area - flat**2 * steepness / 6.0) / (sine + 2.0 / 3.0 * steepness * cosine)
    covered: Array = flat + 4.0 * rest / (flat + np.sqrt(flat**2 + 4.0 * cosine * rest))
    return covered


def belt_load(
    volume_rate: Array, velocity: Array, width: Array, roll: Array, trough: Array, surcharge: Array
) -> BeltLoad:
    """Compute the load that a stream is on the belt that brings it.

    A_b = Q/V. Over the head pulley the belt is flat: the load stays as wide as the belt that it covers, and its area
    stays, so its mean depth is A_b over that width. The fill leaves out that a belt carries less on an incline.

    Args:
        volume_rate: Q, m³/s, shape (1,) or (designs,), as for all arguments.
        velocity: Belt velocity V, m/s, positive.
        width: Width of the belt, m.
        roll: Length of the middle roll, m.
        trough: Trough angle of the side rolls, rad; trough and surcharge must not both be 0.
        surcharge: Surcharge angle of the load, rad.

    Returns:
        The load.

    >>> one = np.ones(1)
    >>> load = belt_load(
    ...     volume_rate=0.3 * one, velocity=3 * one, width=one,
    ...     roll=0.38 * one, trough=np.radians(35) * one, surcharge=np.radians(15) * one,
    ... )
    >>> load.fill.round(3), load.width.round(3), load.depth.round(3)
    (array([0.968]), array([0.838]), array([0.119]))
    """
    area = volume_rate / velocity
    covered = loaded_width(area, roll, trough, surcharge)
    fill = area / load_area(usable_width(width), roll, trough, surcharge)
    return BeltLoad(area=area, fill=fill, width=covered, depth=area / covered, roll=roll)
