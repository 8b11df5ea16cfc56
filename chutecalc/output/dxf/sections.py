"""The sections at both ends of each segment, to scale beside the side view, with the depth of the stream in them."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from ezdxf.enums import TextEntityAlignment as Align

from chutecalc.output.dxf import dimensions
from chutecalc.output.dxf.layers import SECTIONS, STREAM
from chutecalc.output.dxf.outline import Outline, outline
from chutecalc.output.dxf.points import PER_METRE, Point
from chutecalc.output.dxf.sheet import NORMAL, WIDE, Sheet
from chutecalc.output.plots.traces import DEEPEST, Steel
from chutecalc.results.solved import SolvedChute

ROOM = (30.0, 32.0)
"""Room around a section for its dimensions and its name, in width and in height, mm on paper."""
DIAGONAL = float(np.sqrt(0.5))
ENDS = ("inlet", "outlet")
SAME = 1e-9
"""Share of a segment's length below which the stream is at its end."""
STEEPEST = np.radians(89.0)
"""Slope from which on a facet is a wall, whose angle is not dimensioned."""


class End(NamedTuple):
    """The section at an end of a segment."""

    name: str
    """What it is called on the drawing."""
    drawn: Outline
    upside_down: bool
    """Whether it is under a roof: the stream hangs from its upper side."""
    depth: float
    """Depth of the stream in it, m; NaN where there is none."""
    on_roof: bool
    """Whether the stream runs on the wall opposite to its surface."""

    def size(self, scale: float) -> tuple[float, float]:
        """Return width and height with the room around it, mm.

        Args:
            scale: of the drawing, as in 1:scale.
        """
        across, up = self.drawn.width * PER_METRE, self.drawn.height * PER_METRE
        words = (len(self.name) + 4) * WIDE * NORMAL
        return max(across + ROOM[0] * scale, words * scale), up + ROOM[1] * scale


def ends(solution: SolvedChute, steel: Steel, size: float) -> tuple[End, End]:
    """Return the sections at the inlet and the outlet of a segment.

    Args:
        solution: solution of one design.
        steel: the segment at its place.
        size: greater side of the chute, m; no stream is drawn deeper than a quarter of that.
    """
    segment, result = steel.segment, solution.segments[steel.name]
    visits = [each.contact for each in solution.trajectory.segment_solutions if each.segment is segment]
    contacts = [contact for contact in visits if contact is not None]
    first, last = contacts[0], contacts[-1]
    reached = bool(first.arrival.share[0] <= SAME), bool(last.end.share[0] >= 1.0 - SAME)
    depths = [float(at["depth_m"][0]) for at in (result.entry, result.exit, result.maximum)]
    known = [min(depth, DEEPEST * size) for depth in depths if depth > 0.0]
    sections = segment.section, segment.end_section or segment.section
    found = []
    for words, section, depth, there, contact in zip(ENDS, sections, depths, reached, (first, last), strict=False):
        drawn = outline(section, max(known, default=0.2 * DEEPEST * size))
        inside = there and depth < drawn.height
        on_roof = segment.closed and contact.side[0] != steel.side
        found.append(End(f"{steel.name}, {words}", drawn, steel.side < 0.0, depth if inside else np.nan, bool(on_roof)))
    return found[0], found[1]


def arranged(
    pairs: Sequence[tuple[End, End]], scale: float, corner: Point, height: float
) -> tuple[list[tuple[End, Point]], Point]:
    """Return where sections go in pairs, one below the other, in as many columns as they need.

    Args:
        pairs: of each segment.
        scale: of the drawing, as in 1:scale.
        corner: upper left corner of the place for them, mm.
        height: of that place, mm.

    Returns:
        Each with the middle of its upper edge, mm, and the lower right corner of all of them, mm.
    """
    (left, y), lowest, column = corner, corner[1], 0.0
    found = []
    for pair in pairs:
        sizes = [end.size(scale) for end in pair]
        high = max(size[1] for size in sizes)
        if y < corner[1] and y - high < corner[1] - height:
            left, y, column = left + column, corner[1], 0.0
        x = left
        for end, (wide, _) in zip(pair, sizes, strict=True):
            found.append((end, (x + 0.5 * wide, y)))
            x += wide
        y -= high
        column, lowest = max(column, x - left), min(lowest, y)
    return found, (left + column, lowest)


def draw_end(sheet: Sheet, end: End, top: Point) -> None:
    """Draw a section.

    Args:
        sheet: to draw on.
        end: the section.
        top: middle of the upper edge of its place, mm.
    """
    sheet.text(end.name, (top[0], top[1] - sheet.paper(NORMAL)), NORMAL, Align.TOP_CENTER)
    drawn, high = end.drawn, end.drawn.height * PER_METRE
    upper = top[1] - sheet.paper(18.0)
    sign = -1.0 if end.upside_down else 1.0
    floor = upper if end.upside_down else upper - high

    def at(x: float, y: float) -> Point:
        return top[0] + x * PER_METRE, floor + sign * y * PER_METRE

    if drawn.is_pipe:
        look = {"layer": SECTIONS.name}
        sheet.space.add_circle(at(0.0, drawn.radius), drawn.radius * PER_METRE, dxfattribs=look)
    else:
        sheet.polyline([(*at(x, y), sign * bulge) for x, y, bulge in drawn.corners], SECTIONS, drawn.closed)
        for x, start, _ in (drawn.corners[0], drawn.corners[-1]):
            if start < drawn.height:  # walls without a top
                sheet.polyline(((*at(x, start), 0.0), (*at(x, drawn.height), 0.0)), SECTIONS, linetype="HIDDEN")
    if np.isfinite(end.depth):
        level = drawn.height - end.depth if end.on_roof else end.depth
        half = drawn.half_width(level)
        sheet.line(at(-half, level), at(half, level), STREAM)
    _dimension(sheet, end, at)


def _dimension(sheet: Sheet, end: End, at: Callable[[float, float], Point]) -> None:
    """Dimension a section: its width, its base, its height where that is given, and its facets."""
    drawn, sign = end.drawn, -1.0 if end.upside_down else 1.0
    middle = at(0.0, drawn.radius)
    if drawn.is_pipe:
        dimensions.diameter(sheet, middle, drawn.radius * PER_METRE, 45.0)
        return
    half, top = 0.5 * drawn.width, drawn.height
    dimensions.length(sheet, at(-half, top), at(half, top), 5.0 * sign)
    if drawn.radius:
        out = sheet.paper(6.0) / PER_METRE + drawn.radius
        on_arc, beyond = (at(size * DIAGONAL, drawn.radius - size * DIAGONAL) for size in (drawn.radius, out))
        dimensions.radius(sheet, middle, drawn.radius * PER_METRE, on_arc, beyond)
    for facet in drawn.facets:
        if facet.inclination < STEEPEST and facet.last[1] > facet.first[1]:
            if facet.is_whole:
                dimensions.length(sheet, at(*facet.first), at(*facet.last), -5.0 * sign)
            low, high = sorted((180.0, 180.0 - sign * float(np.degrees(facet.inclination))))
            dimensions.angle(sheet, at(-facet.first[0], facet.first[1]), low, high, leg=9.0)
    base = max((x for x, height, _ in drawn.corners if height == 0.0), default=0.0)
    if 0.0 < base < half:
        dimensions.length(sheet, at(-base, 0.0), at(base, 0.0), -5.0 * sign)
    if drawn.has_height:
        dimensions.length(sheet, at(half, 0.0), at(half, top), -12.0 * sign if drawn.facets else -5.0 * sign)
