"""Dimensions: real ones, measured in the drawing, in one style."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from ezdxf.entities.dimstyleoverride import DimStyleOverride

from chutecalc.output.dxf.layers import DIMENSIONS
from chutecalc.output.dxf.points import Point
from chutecalc.output.dxf.sheet import SMALL, STYLE, Sheet
from chutecalc.output.plots.flights import Line
from chutecalc.physics.arrays import Array

LAYER: Any = {"layer": DIMENSIONS.name}
APART = 1.7 * SMALL
"""Least distance between the texts of coordinates in a row, mm on paper."""
TEXT_LENGTH = 14.0
"""Length of the text of a coordinate, mm on paper."""
LEGS = ((0, 1.0), (15, 0.9), (30, 1.0))
"""Points of the arc of an angle that its dimension follows from, and how far out they are as a share of the legs."""
LEG = 14.0
"""Radius of the arcs of angles, mm on paper."""


def length(sheet: Sheet, first: Point, last: Point, away: float) -> None:
    """Dimension the distance of two points along their line.

    Args:
        sheet: to draw on.
        first, last: the points, mm.
        away: distance of the dimension line to the left of the line from the first to the last, mm on paper.
    """
    if np.hypot(last[0] - first[0], last[1] - first[1]) > 0.0:
        distance = sheet.paper(away)
        along = np.array(last) - np.array(first)
        out = distance * np.array([-along[1], along[0]]) / np.hypot(*along)
        sheet.room.keep_clear(np.linspace(np.array(first) + out, np.array(last) + out, 60).T)
        _render(sheet.space.add_aligned_dim(first, last, distance, dimstyle=STYLE, dxfattribs=LAYER))


def radius(sheet: Sheet, centre: Point, size: float, at: Point, text_at: Point) -> None:
    """Dimension a radius.

    Args:
        sheet: to draw on.
        centre: of the circle, mm.
        size: its radius, mm.
        at: point of the circle, mm.
        text_at: where the text stands, mm.
    """
    angle = float(np.degrees(np.arctan2(at[1] - centre[1], at[0] - centre[0])))
    sheet.room.keep_clear(np.linspace(at, 1.5 * np.array(text_at) - 0.5 * np.array(at), 20).T)
    _render(
        sheet.space.add_radius_dim(centre, radius=size, angle=angle, location=text_at, dimstyle=STYLE, dxfattribs=LAYER)
    )


def diameter(sheet: Sheet, centre: Point, size: float, angle: float) -> None:
    """Dimension a diameter.

    Args:
        sheet: to draw on.
        centre: of the circle, mm.
        size: its radius, mm.
        angle: of the dimension line, degrees.
    """
    inside = {"dimtix": 1, "dimtofl": 1} if 2.0 * size > sheet.paper(TEXT_LENGTH + 4.0 * SMALL) else {}
    _render(
        sheet.space.add_diameter_dim(
            centre, radius=size, angle=angle, dimstyle=STYLE, override=inside, dxfattribs=LAYER
        )
    )


def angle(sheet: Sheet, at: Point, start: float, end: float, leg: float = LEG) -> None:
    """Dimension an angle.

    Args:
        sheet: to draw on.
        at: its vertex, mm.
        start, end: directions of its legs, degrees, counterclockwise; nothing is drawn where they are the same.
        leg: length of its legs, mm on paper.
    """
    if abs(end - start) > 1e-9:
        out = sheet.paper(leg)
        arc = on_circle(at, out, np.radians(np.linspace(start, end, 31)))
        sheet.room.keep_clear(arc)
        first, middle, last = (np.array(at) + share * (arc[:, number] - np.array(at)) for number, share in LEGS)
        inner = [np.array(at) + 0.1 * (leg - np.array(at)) for leg in (first, last)]
        lines = (inner[1].tolist(), last.tolist()), (inner[0].tolist(), first.tolist())
        _render(sheet.space.add_angular_dim_2l(middle.tolist(), *lines, dimstyle=STYLE, dxfattribs=LAYER))


def on_circle(centre: Point, radius: float, angle: Array) -> Line:
    """Return points of a circle, mm.

    Args:
        centre: mm.
        radius: mm.
        angle: of the points, rad, counterclockwise from the right.
    """
    return np.stack([centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)])


def coordinates(sheet: Sheet, points: Sequence[Point], box: tuple[Point, Point], away: float) -> None:
    """Dimension x and height of points, on the side of a box that is nearer, none over another.

    Args:
        sheet: to draw on.
        points: mm.
        box: its lower left and its upper right corner, mm.
        away: distance of the texts from the box, mm on paper.
    """
    (left, bottom), (right, top) = box
    out = sheet.paper(away)
    for axis, low, high in ((0, bottom, top), (1, left, right)):
        other = 1 - axis
        seen: dict[float, Point] = {}
        for at in points:
            key = round(at[axis], 1)
            nearer = min(at[other] - low, high - at[other])
            if key not in seen or nearer < min(seen[key][other] - low, high - seen[key][other]):
                seen[key] = at
        sides: dict[bool, list[Point]] = {False: [], True: []}
        for at in seen.values():
            sides[at[other] - low > high - at[other]].append(at)
        for beyond, row in sides.items():
            row.sort(key=lambda at: at[axis])
            level = high + out if beyond else low - out
            for at, shifted in zip(row, spread([at[axis] for at in row], sheet.paper(APART)), strict=True):
                end = level + sheet.paper(TEXT_LENGTH if beyond else -TEXT_LENGTH)
                for beside in (0.0, sheet.paper(0.6 * SMALL), sheet.paper(1.2 * SMALL)):  # the text and its line
                    run = np.linspace((at[axis], at[other]), (shifted + (beside if axis else -beside), end), 60).T
                    sheet.room.keep_clear(run if axis == 0 else run[::-1])
                offset = (shifted - at[axis], level - at[other])
                add = sheet.space.add_ordinate_x_dim if axis == 0 else sheet.space.add_ordinate_y_dim
                text = "<>" if at[axis] > -0.05 else "-<>"  # an ordinate has no sign of its own
                _render(add(at, offset if axis == 0 else offset[::-1], text=text, dimstyle=STYLE, dxfattribs=LAYER))


def _render(dimension: DimStyleOverride) -> None:
    """Make the picture of a dimension, all of it on its layer."""
    dimension.render()
    for entity in dimension.dimension.get_geometry_block() or ():
        if entity.dxf.layer == "0":  # of lines alone; not every reader gives those the layer of their dimension
            entity.dxf.layer = DIMENSIONS.name


def spread(places: Sequence[float], apart: float) -> list[float]:
    """Return places moved apart, by the least squares of how far each moves.

    Args:
        places: ascending, in any unit of length.
        apart: least distance of neighbours, in that unit.

    >>> spread([0.0, 1.0, 10.0], 3.0)
    [-1.0, 2.0, 10.0]
    """
    groups: list[tuple[list[float], float]] = []  # places that touch, and where the first of them goes
    for place in places:
        members, start = [place], place
        while groups and groups[-1][1] + apart * len(groups[-1][0]) > start:
            members = [*groups.pop()[0], *members]
            middle = sum(at - apart * number for number, at in enumerate(members)) / len(members)
            start = middle
        groups.append((members, start))
    return [start + apart * number for members, start in groups for number in range(len(members))]


def distinct(points: Iterable[Point]) -> list[Point]:
    """Return points of which none is within 0.05 mm of one before it.

    Args:
        points: mm.
    """
    found: list[Point] = []
    for at in points:
        if all(np.hypot(at[0] - other[0], at[1] - other[1]) > 0.05 for other in found):
            found.append(at)
    return found
