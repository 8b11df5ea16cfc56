"""The steel of a chute from the side: surfaces, roofs, tops of walls and edges of facets, as true arcs and lines."""

from collections.abc import Iterator

import numpy as np

from chutecalc.output.dxf.layers import FOLDS, ROOFS, STEEL, WALLS, Layer
from chutecalc.output.dxf.points import place
from chutecalc.output.dxf.sheet import Sheet
from chutecalc.output.plots.flights import SHARES, surface_line
from chutecalc.output.plots.traces import Steel
from chutecalc.physics.section import Section
from chutecalc.physics.surface import Surface, parallel


def draw_steel(sheet: Sheet, steel: Steel) -> None:
    """Draw a segment from the side.

    Args:
        sheet: to draw on.
        steel: the segment at its place.
    """
    sheet.surface(steel.surface, STEEL)
    section = steel.segment.section
    end = steel.segment.end_section or section
    for folds in zip(_folds(section), _folds(end), strict=False):
        _draw_above(sheet, steel.surface, folds, FOLDS)
    heights = float(section.wall_height[0]), float(end.wall_height[0])
    if np.isfinite(heights).all():
        layer = ROOFS if section.closed else WALLS
        _draw_above(sheet, steel.surface, heights, layer)
        for share, height in zip((0.0, 1.0), heights, strict=True):
            sheet.line(place(steel.surface, share), place(steel.surface, share, height), layer)


def _draw_above(sheet: Sheet, surface: Surface, heights: tuple[float, float], layer: Layer) -> None:
    """Draw what runs along a surface at a height above it, which is linear where the segment tapers."""
    first, last = heights
    if first == last:
        sheet.surface(parallel(surface, np.full(1, first)), layer)
    elif surface.turn[0] == 0.0:
        sheet.line(place(surface, 0.0, first), place(surface, 1.0, last), layer)
    else:  # a spiral
        sheet.lines(surface_line(surface, first + SHARES * (last - first)), layer)


def _folds(section: Section) -> Iterator[float]:
    """Yield the heights above the floor, m, at which facets of a section end below the top of its walls."""
    height = 0.0
    for length, inclination in zip(getattr(section, "lengths", ()), getattr(section, "inclinations", ()), strict=True):
        height += float(length[0] * np.sin(inclination[0]))
        if 0.0 < height < section.wall_height[0]:
            yield height
