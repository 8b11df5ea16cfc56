"""Cross-sections as they are drawn.

Every symmetric section is a stack of facets from the centre outwards: a polygon's flat walls, or a circle's arc, and
vertical walls above what is drawn. A rectangle has no drawn facet, a chamfered section one, a vee one and no base.
"""

from typing import NamedTuple

from chutecalc.physics.arrays import Array


class Polygon(NamedTuple):
    """A symmetric section of flat walls. All lengths in m, angles in rad, arrays of length 1 or n."""

    base: Array
    """Width of the centre section, 0 for a vee. Level facets widen it."""
    lengths: tuple[Array, ...]
    """Of the drawn facets on one side, from the centre outwards; the last may be infinite: it has no top then."""
    inclinations: tuple[Array, ...]
    """Of the same facets to the plane of the centre section, in [0, π/2], never falling."""
    wall_height: Array
    """Above the floor; deeper than that the chute chokes; infinite where none is given."""


class Circle(NamedTuple):
    """The lower half of a circle, with vertical walls above it."""

    radius: Array
    wall_height: Array
    """As of a polygon."""


Section = Polygon | Circle
