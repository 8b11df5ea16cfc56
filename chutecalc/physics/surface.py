"""The guiding surface of a segment as a line in the plane of the chute: straight or a circular arc."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class Surface(NamedTuple):
    """A straight or an arc that starts at (x, z), arrays of shape (1,) or (designs,)."""

    side: Array | float
    """σ: 1 for a floor, which the stream meets from above, -1 for a roof, which it meets from below."""
    x: Array
    """Horizontal position of the start, m."""
    z: Array
    """Height of the start, m."""
    slope: Array
    """Slope at the start, rad below horizontal."""
    turn: Array
    """Slope at the end minus slope at the start, rad."""
    length: Array
    """Length along the surface, m."""

    @property
    def curvature(self) -> Array:
        """Curvature κ = -da/ds, 1/m, positive where the surface flattens."""
        return -self.turn / self.length


def point(surface: Surface, share: Array) -> tuple[Array, Array, Array]:
    """Compute the position and slope at a share of a surface's length.

    The chord of an arc that turns by b over a length s is s sin(b/2)/(b/2) long, and its slope is the mean of the
    slopes at its ends. Unlike (sin a0 - sin a)/κ this keeps its digits down to a straight.

    Args:
        surface: The surface.
        share: Share of its length from the start, 0 to 1, shape (designs,) or (stations, designs).

    Returns:
        x and z, m, and slope, rad below horizontal, in the broadcast shape.

    >>> one = np.ones(1)
    >>> down, turn = np.pi / 2 * one, -np.pi / 2 * one
    >>> quarter = Surface(side=1.0, x=0 * one, z=0 * one, slope=down, turn=turn, length=3 * np.pi / 2 * one)
    >>> x, z, slope = point(quarter, one)
    >>> float(x[0].round(12)), float(z[0].round(12)), float(slope[0])
    (3.0, -3.0, 0.0)
    """
    turned = surface.turn * share
    half = 0.5 * turned
    middle = surface.slope + half
    half[half == 0.0] = 1e-20  # its sine over itself is 1 there
    chord = surface.length * share * (np.sin(half) / half)
    return surface.x + chord * np.cos(middle), surface.z - chord * np.sin(middle), surface.slope + turned


def parallel(surface: Surface, height: Array) -> Surface:
    """Return the surface parallel to another on the side of the stream, as a roof or the top of walls is to a floor.

    Args:
        surface: The surface. An arc has the same centre; its length changes by the height times its turn.
        height: Distance between the two, m, shape (1,) or (designs,).

    >>> one = np.ones(1)
    >>> spoon = Surface(side=1.0, x=0 * one, z=0 * one, slope=np.pi / 2 * one, turn=-np.pi / 2 * one, length=3 * one)
    >>> top = parallel(spoon, 0.5 * one)
    >>> float(top.x[0]), float(top.length[0].round(3))
    (0.5, 2.215)
    """
    above = surface.side * height
    x, z = surface.x + above * np.sin(surface.slope), surface.z + above * np.cos(surface.slope)
    return surface._replace(x=x, z=z, length=surface.length + above * surface.turn)


def centre(surface: Surface) -> tuple[Array, Array, Array]:
    """Return the centre and the radius of an arc.

    The centre is on the normal at the start, above an arc that flattens and below one that steepens.

    Args:
        surface: an arc.

    Returns:
        x and z of the centre, m, and radius, m, each of shape (designs,); infinite or NaN for a straight.

    >>> one = np.ones(1)
    >>> down, turn, length = np.pi / 2 * one, -np.pi / 2 * one, 1.5 * np.pi * one
    >>> [float(each[0].round(12)) for each in centre(Surface(1.0, 0 * one, -2 * one, down, turn, length))]
    [3.0, -2.0, 3.0]
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = -surface.length / surface.turn
        x, z = surface.x + reach * np.sin(surface.slope), surface.z + reach * np.cos(surface.slope)
    return x, z, np.abs(reach)


def least_height(surface: Surface, x: Array, z: Array, slope: Array) -> tuple[Array, Array]:
    """Return the least height of a surface above a line, normal to the line, and where on the surface that is.

    Along the surface the height changes by sin(b - a), b the slope of the line: it is least at an end, or where an arc
    is parallel to the line.

    Args:
        surface: the surface.
        x: horizontal position of a point of the line, m.
        z: its height, m.
        slope: of the line, rad below horizontal.

    Returns:
        Height, m, negative below the line, and share of the surface's length, of shape (designs,).

    >>> one = np.ones(1)
    >>> level = Surface(side=1.0, x=0 * one, z=2 * one, slope=0 * one, turn=0 * one, length=3 * one)
    >>> least_height(level, 0.0 * one, 0.5 * one, 0.0 * one)[0].tolist()
    [1.5]
    """
    with np.errstate(all="ignore"):
        parallel = (slope - surface.slope) / surface.turn
    parallel = np.where((parallel > 0.0) & (parallel < 1.0), parallel, 0.0)
    shares = np.stack(np.broadcast_arrays(np.zeros(1), np.ones(1), parallel, surface.x)[:3])
    there_x, there_z, _ = point(surface, shares)
    heights = (there_x - x) * np.sin(slope) + (there_z - z) * np.cos(slope)
    lowest = heights.argmin(axis=0)[None]
    height, share = (np.take_along_axis(values, lowest, axis=0)[0] for values in np.broadcast_arrays(heights, shares))
    return height, share
