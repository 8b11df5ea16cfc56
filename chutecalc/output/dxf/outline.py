"""The outline of a cross-section, looking along the stream, its floor below."""

from itertools import zip_longest
from typing import NamedTuple

import numpy as np

from chutecalc.physics.section import Circle, Polygon, Section

Corner = tuple[float, float, float]
"""x and height above the floor, m, and bulge of what follows: the tangent of a quarter of the angle of an arc."""


class Facet(NamedTuple):
    """A flat wall of a section, the one on its right-hand side."""

    first: tuple[float, float]
    """x and height of its lower end, m."""
    last: tuple[float, float]
    """x and height of its upper end as drawn, m."""
    inclination: float
    """To the floor, rad."""
    is_whole: bool
    """Whether it is drawn from end to end, rather than cut off."""


class Outline(NamedTuple):
    """A cross-section as it is drawn, its floor at height 0 and its middle at x = 0; lengths in m."""

    corners: tuple[Corner, ...]
    """From the top on the left down and up again, without walls whose height is not given; of a pipe none."""
    radius: float
    """Of a circle; 0 for others."""
    width: float
    """Greatest width."""
    height: float
    """Height at which it is closed, or at which its walls are cut off."""
    has_height: bool
    """Whether that is given, rather than chosen for the picture."""
    closed: bool
    """Whether it has a roof."""
    facets: tuple[Facet, ...] = ()
    """Flat walls, from the floor upwards."""

    @property
    def is_pipe(self) -> bool:
        """Whether it is a whole circle."""
        return self.closed and self.radius > 0.0

    def half_width(self, height: float) -> float:
        """Return half the width at a height, m.

        Args:
            height: above the floor, m.
        """
        if (self.radius and height < self.radius) or self.is_pipe:
            return float(np.sqrt(max(height * (2.0 * self.radius - height), 0.0)))
        right = [corner for corner in self.corners if corner[0] >= 0.0]
        return float(np.interp(height, [corner[1] for corner in right], [corner[0] for corner in right]))


def outline(section: Section, depth: float) -> Outline:
    """Return the outline of a section of one design.

    Args:
        section: the section.
        depth: of the stream in it, m; walls without a top are drawn higher than that.
    """
    given = float(section.wall_height[0])
    if isinstance(section, Circle):
        return _circle(float(section.radius[0]), given, depth, section.closed)
    return _polygon(section, given, depth)


def _circle(radius: float, given: float, depth: float, closed: bool) -> Outline:
    """Return the outline of a pipe, or of a half pipe with its walls."""
    if closed:
        return Outline((), radius, 2.0 * radius, 2.0 * radius, True, True)
    if given <= radius:
        angle = 2.0 * np.arccos((radius - given) / radius)
        half = float(radius * np.sin(0.5 * angle))
        corners = ((-half, given, float(np.tan(0.25 * angle))), (half, given, 0.0))
        return Outline(corners, radius, 2.0 * half, given, True, False)
    arc = ((-radius, radius, 1.0), (radius, radius, 0.0))
    return _walled(Outline(arc, radius, 2.0 * radius, radius, False, False), given, depth)


def _polygon(section: Polygon, given: float, depth: float) -> Outline:
    """Return the outline of flat walls."""
    corner = 0.5 * float(section.base[0]), 0.0
    facets = []
    for length, inclination in zip(section.lengths, section.inclinations, strict=True):
        across, up = float(np.cos(inclination[0])), float(np.sin(inclination[0]))
        whole = run = float(length[0])
        if up > 0.0 and not corner[1] + run * up < given:
            top = given if np.isfinite(given) else _shown(corner[1], depth, 2.0 * corner[0])
            run = (top - corner[1]) / up
        after = corner[0] + run * across, corner[1] + run * up
        facets.append(Facet(corner, after, float(inclination[0]), run == whole))
        corner = after
    right = [(0.5 * float(section.base[0]), 0.0), *(facet.last for facet in facets)]
    right = [corner for corner, after in zip_longest(right, right[1:]) if after is None or after[1] > corner[1]]
    left = [(-x, height) for x, height in reversed(right) if x > 0.0]
    corners = tuple((x, height, 0.0) for x, height in (*left, *right))
    drawn = Outline(corners, 0.0, 2.0 * corner[0], corner[1], False, section.closed, tuple(facets))
    return drawn if facets and not facets[-1].is_whole else _walled(drawn, given, depth)


def _walled(drawn: Outline, given: float, depth: float) -> Outline:
    """Return an outline with vertical walls above it."""
    if not np.isfinite(given):
        return drawn._replace(height=_shown(drawn.height, depth, drawn.width))
    (left, _, _), (right, _, _) = drawn.corners[0], drawn.corners[-1]
    corners = ((left, given, 0.0), *drawn.corners, (right, given, 0.0))
    return drawn._replace(corners=corners, height=given, has_height=True)


def _shown(height: float, depth: float, width: float) -> float:
    """Return how high walls are drawn that have no top, m: clear of the stream and of the facets below."""
    return max(1.3 * height, 1.5 * depth, height + 0.3 * width)
