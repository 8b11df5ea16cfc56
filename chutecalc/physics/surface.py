"""The guiding surface of a segment as a line: straight or a circular arc."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array


class Surface(NamedTuple):
    """A straight or an arc, drawn from (x, z). Arrays of length 1 or n, m and rad."""

    side: float
    """1 for a floor, which the stream meets from above; -1 for a roof, met from below."""
    x: Array
    z: Array
    slope: Array
    """Below horizontal, where it starts."""
    turn: Array
    """Slope at its end less slope at its start."""
    length: Array

    @property
    def curvature(self) -> Array:
        """κ = -da/ds, positive where the surface flattens."""
        return -self.turn / self.length


def point(surface: Surface, share: Array) -> tuple[Array, Array, Array]:
    """x, z and slope at a share of the surface's length.

    The chord of an arc that turns by b over a length s is s sin(b/2)/(b/2) long and lies halfway between the end
    slopes; unlike (sin a0 - sin a)/κ this holds its digits down to a straight.

    >>> one = np.ones(1)
    >>> quarter = Surface(1.0, 0 * one, 0 * one, np.pi / 2 * one, -np.pi / 2 * one, 3 * np.pi / 2 * one)
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
