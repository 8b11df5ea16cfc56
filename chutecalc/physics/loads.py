"""What a stream does to a segment: its force, the weight of what fills it, and the life of the liner."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Section, interpolate_sections
from chutecalc.physics.wetting import area_at_depth

NODES = 12
"""Gauss nodes on a taper; two are exact if its angles do not change."""


class Force(NamedTuple):
    """A force on a segment, each of shape (designs,)."""

    x: Array
    """Horizontal component along the chute, N."""
    z: Array
    """Vertical component, N, positive upwards."""


def force_on_segment(
    mass_rate: Array,
    gravity: Array,
    duration: Array,
    velocity_in: Array,
    slope_in: Array,
    velocity_out: Array,
    slope_out: Array,
) -> Force:
    """Compute the force of a steady stream on a segment from its momentum balance, F = ṁ (v_in - v_out) + m g.

    The mass on the segment is m = ∫ ρ A ds = ṁ t. With v_in before an impact, the force includes that of the impact. It
    is the sum of all pressures and friction on the walls, without those on the drawn ends of the stream.

    Args:
        mass_rate: ṁ, kg/s, shape (1,) or (designs,), as for all arguments.
        gravity: g, m/s².
        duration: Time t that the stream takes along the segment, s.
        velocity_in: Velocity before the segment, m/s.
        slope_in: Slope there, rad below horizontal.
        velocity_out: Velocity where the stream leaves it, m/s.
        slope_out: Slope there, rad below horizontal.

    Returns:
        The force on the segment.

    >>> one = np.ones(1)
    >>> stopped = force_on_segment(100 * one, 10 * one, 0 * one, 3 * one, 0 * one, 0 * one, 0 * one)
    >>> stopped.x.tolist(), abs(stopped.z).tolist()
    ([300.0], [0.0])
    """
    x = mass_rate * (velocity_in * np.cos(slope_in) - velocity_out * np.cos(slope_out))
    z = mass_rate * (velocity_out * np.sin(slope_out) - velocity_in * np.sin(slope_in) - gravity * duration)
    return Force(x, z)


def filled_volume(first: Section, last: Section | None, length: Array) -> Array:
    """Compute the volume of a segment full to its wall height, the integral of the area at the wall height.

    Args:
        first: Section at its start, lengths in m.
        last: Section at its end, likewise; None where the section does not change.
        length: Length of the segment, m, shape (1,) or (designs,).

    Returns:
        The volume, m³, shape (designs,); NaN where there is no wall height.

    >>> from chutecalc.physics.section import Polygon
    >>> box = Polygon(np.array([0.5]), lengths=(), inclinations=(), wall_height=np.array([0.4]))
    >>> filled_volume(box, None, np.array([3.0])).round(12).tolist()
    [0.6]
    """
    if last is None:
        area = area_at_depth(first, first.wall_height)
    else:
        from numpy.polynomial.legendre import leggauss  # which a run without tapers does not need

        nodes, weights = leggauss(NODES)
        sections = (interpolate_sections(first, last, 0.5 * (1.0 + node)) for node in nodes)
        areas = (area_at_depth(one, one.wall_height) for one in sections)
        area = np.asarray(sum(0.5 * weight * one for weight, one in zip(weights, areas, strict=True)))
    return np.where(np.isfinite(area), area, np.nan) * length


def liner_life(thickness: Array, wear_rate: Array, wear: Array) -> Array:
    """Compute the time until a liner is worn through, thickness/(k w).

    A liner loses the volume k for each frictional work, so its depth falls by k w a second, with the frictional power
    per area w = μ p v_s.

    Args:
        thickness: Of the liner, m, shape (1,) or (designs,).
        wear_rate: k, m³/J, likewise.
        wear: w, W/m², of any shape that broadcasts.

    Returns:
        The time, s, in the broadcast shape; infinite where nothing wears the liner.

    >>> liner_life(np.array([0.02]), np.array([1e-12]), np.array([2000.0])).round().tolist()
    [10000000.0]
    """
    with np.errstate(divide="ignore"):
        return np.asarray(thickness / (wear_rate * wear))
