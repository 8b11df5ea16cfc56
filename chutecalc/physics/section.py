"""Cross-sections as they are drawn.

Every symmetric section is a row of facets from the centre outwards: flat walls of a polygon or the arc of a circle,
with vertical walls above the drawn top. A rectangle has no drawn facet, a chamfered section one, a vee one and no base.
A closed section ends in a roof: a box at the height of its walls, a pipe where its arc closes.
"""

from typing import Any, NamedTuple, TypeVar

import numpy as np

from chutecalc.physics.arrays import Array


class Polygon(NamedTuple):
    """A symmetric section of flat walls, arrays of shape (1,) or (designs,)."""

    base: Array
    """Width B of the centre section, m; 0 for a vee. Level facets widen it."""
    lengths: tuple[Array, ...]
    """Lengths of the drawn facets on one side, m, from the centre outwards. The last may be infinite: it has no top."""
    inclinations: tuple[Array, ...]
    """Inclinations of these facets to the plane of the centre section, rad, in [0, π/2], not falling."""
    wall_height: Array
    """Height of the walls above the floor, m. A deeper stream chokes the chute. Infinite where none is given."""
    closed: bool = False
    """Whether it has a roof at that height, parallel to the floor."""


class Circle(NamedTuple):
    """The lower half of a circle with vertical walls above it, or a pipe, arrays of shape (1,) or (designs,)."""

    radius: Array
    """Radius r, m."""
    wall_height: Array
    """Height of the walls above the floor, m, as in :class:`Polygon`; of a pipe its diameter."""
    closed: bool = False
    """Whether it is a whole pipe."""


Section = Polygon | Circle
"""Any cross-section."""
Drawn = TypeVar("Drawn", bound=tuple[Any, ...])
"""A cross-section of one shape."""


def width_of(section: Section, endless: float) -> Array:
    """Return the width of a section between the tops of its drawn walls, m, shape (1,) or (designs,).

    Args:
        section: in numbers.
        endless: length that a flank without a top counts as, m.

    >>> float(width_of(Circle(np.array([0.4]), np.array([np.inf])), 0.0)[0])
    0.8
    """
    if isinstance(section, Circle):
        return 2.0 * section.radius
    width = section.base
    for length, inclination in zip(section.lengths, section.inclinations, strict=True):
        width = width + 2.0 * np.where(np.isinf(length), endless, length) * np.cos(inclination)
    return width


def interpolate_sections(first: Drawn, last: Drawn, share: float) -> Drawn:
    """Return the section at a share of a taper: each of its numbers varies linearly from first to last.

    Args:
        first: Section at the start, of the same shape as the last.
        last: Section at the end.
        share: Share of the drawn length, 0 to 1.

    >>> narrow, wide = (Circle(np.array([radius]), np.array([np.inf])) for radius in (0.2, 0.4))
    >>> interpolate_sections(narrow, wide, 0.5)
    Circle(radius=array([0.3]), wall_height=array([inf]), closed=False)
    """

    def between(one: Any, other: Any) -> Any:
        if isinstance(one, tuple):
            return tuple(map(between, one, other))
        if not isinstance(one, np.ndarray):
            return one
        with np.errstate(invalid="ignore"):
            return np.where(np.isinf(one), one, one + share * (other - one))

    return type(first)(*map(between, first, last))
