"""The chute from the side: steel, stream and belts, with their dimensions and names."""

from collections.abc import Iterator

import numpy as np
from ezdxf.render.arrows import ARROWS

from chutecalc.design import Belt
from chutecalc.output.dxf import dimensions
from chutecalc.output.dxf.layers import BELTS, FLIGHT, LOST, STREAM, Layer
from chutecalc.output.dxf.points import PER_METRE, Point, place
from chutecalc.output.dxf.sheet import NORMAL, Sheet
from chutecalc.output.dxf.steel import draw_steel
from chutecalc.output.plots.belt_lines import SHOWN
from chutecalc.output.plots.traces import Steel, View
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import centre, point
from chutecalc.results.solved import SolvedChute

AWAY = 21.0
"""Distance of the texts of coordinates from the picture, mm on paper."""
NAME_AT, RADIUS_AT = 0.35, 0.65
"""Shares of a segment's length at which its name and its radius stand."""


RADIUS_OF_PULLEY = np.radians(-60.0)
"""Direction in which the radius of the pulley stands."""


def draw_side(sheet: Sheet, solution: SolvedChute, seen: View, box: tuple[Point, Point]) -> None:
    """Draw a chute from the side.

    Args:
        sheet: to draw on.
        solution: solution of one design.
        seen: its lines.
        box: lower left and upper right corner of all lines, mm.
    """
    draw_stream(sheet, seen)
    belt = solution.design.belt
    if belt is not None:
        sheet.lines(seen.feed[1], STREAM)
        _draw_feed(sheet, belt, _pulley_radius(solution))
    for line in seen.received:
        sheet.lines(line, BELTS)
        _arrow(sheet, line[:, 0], line[:, -1])
    for steel in seen.surfaces:
        draw_steel(sheet, steel)
    for before, steel, after in zip([None, *seen.surfaces], seen.surfaces, [*seen.surfaces[1:], None], strict=False):
        _dimension(sheet, before, steel, after)
    dimensions.coordinates(sheet, setting_out(solution, seen), box, AWAY)
    for line in seen.lines:
        sheet.room.keep_clear(line * PER_METRE)
    for steel in seen.surfaces:
        at, beyond = (place(steel.surface, NAME_AT, -height) for height in (0.0, 1.0))
        sheet.note(steel.name, at, (beyond[0] - at[0], beyond[1] - at[1]), NORMAL)
    _write_belts(sheet, solution, seen)


def setting_out(solution: SolvedChute, seen: View) -> list[Point]:
    """Return the points that are dimensioned from the origin: ends of segments, the pulley, a point of the belt.

    Args:
        solution: solution of one design.
        seen: its lines.
    """
    points = [place(steel.surface, share) for steel in seen.surfaces for share in (0.0, 1.0)]
    belt, receiver = solution.design.belt, solution.design.receiver
    centres = [belt.centre if belt is not None else solution.design.inlet_position]
    centres += [receiver.at] if receiver is not None and receiver.at is not None else []
    return dimensions.distinct(points + [(float(x[0]) * PER_METRE, float(z[0]) * PER_METRE) for x, z in centres])


def draw_stream(sheet: Sheet, seen: View, layer: Layer | None = None) -> None:
    """Draw the edges of a stream.

    Args:
        sheet: to draw on.
        seen: lines of a chute.
        layer: for all of them; by default one on surfaces, one in flight and one for what is lost.
    """
    for trace in seen.traces:
        own = LOST if trace is seen.lost else STREAM if trace.side else FLIGHT
        for edge in trace.edges:
            sheet.lines(edge, layer or own)


def _pulley_radius(solution: SolvedChute) -> float:
    """Return the radius of the head pulley, m."""
    belt = solution.spec.inlet.belt
    return 0.0 if belt is None else float(np.ravel(belt.pulley_radius_m)[0])


def _draw_feed(sheet: Sheet, belt: Belt, pulley: float) -> None:
    """Draw the head pulley, and the outer face of the belt that runs round it."""
    incline, radius = float(belt.incline[0]), float(belt.lower_radius[0]) * PER_METRE
    x, z = (float(each[0]) * PER_METRE for each in belt.centre)
    look = {"layer": BELTS.name}
    sheet.space.add_circle((x, z), pulley * PER_METRE, dxfattribs=look)
    up, back = np.array([-np.sin(incline), np.cos(incline)]), -np.array([np.cos(incline), np.sin(incline)])
    for side in (1.0, -1.0):
        foot = np.array([x, z]) + side * radius * up
        away = foot + SHOWN * radius * back
        sheet.line((float(foot[0]), float(foot[1])), (float(away[0]), float(away[1])), BELTS)
    degrees = float(np.degrees(incline))
    sheet.space.add_arc((x, z), radius, (degrees - 90.0) % 360.0, (degrees + 90.0) % 360.0, dxfattribs=look)
    reach = pulley * PER_METRE + sheet.paper(3.0)
    for end in ((reach, 0.0), (0.0, reach)):
        first, last = (x - end[0], z - end[1]), (x + end[0], z + end[1])
        sheet.space.add_line(first, last, dxfattribs=look | {"linetype": "CENTER", "lineweight": 13})
    rim, beyond = pulley * PER_METRE, pulley * PER_METRE + sheet.paper(8.0)
    at, text_at = ((x + out * np.cos(RADIUS_OF_PULLEY), z + out * np.sin(RADIUS_OF_PULLEY)) for out in (rim, beyond))
    dimensions.radius(sheet, (x, z), rim, at, text_at)


def _write_belts(sheet: Sheet, solution: SolvedChute, seen: View) -> None:
    """Write the velocities of the belts."""
    belt, receiver = solution.design.belt, solution.design.receiver
    if belt is not None:
        x, z = (seen.feed[0][:, 0] * PER_METRE).tolist()
        sheet.note(f"feeding belt, {float(belt.velocity[0]):.4g} m/s", (x, z), (0.0, 1.0))
    if receiver is not None and seen.received:
        x, z = (seen.received[0].mean(axis=1) * PER_METRE).tolist()
        words = f"receiving belt, {float(receiver.velocity[0]):.4g} m/s"
        if receiver.plan_angle[0]:
            words += f", at {np.degrees(receiver.plan_angle[0]):.4g}° in plan"
        sheet.note(words, (x, z), (0.0, -1.0))


def _arrow(sheet: Sheet, start: Array, end: Array) -> None:
    """Draw the head of an arrow at the end of a line, m."""
    rotation = float(np.degrees(np.arctan2(end[1] - start[1], end[0] - start[0])))
    look = {"layer": BELTS.name}
    sheet.space.add_arrow(ARROWS.closed_filled, (end * PER_METRE).tolist(), sheet.paper(4.0), rotation, dxfattribs=look)


def _dimension(sheet: Sheet, before: Steel | None, steel: Steel, after: Steel | None) -> None:
    """Dimension a segment, on the side that the stream does not run on, and write its name there."""
    surface, side = steel.surface, steel.side
    if surface.turn[0] == 0.0:
        dimensions.length(sheet, place(surface, 0.0), place(surface, 1.0), -10.0 * side)
    else:
        x, z, radius = (float(each[0]) * PER_METRE for each in centre(surface))
        at, beyond = place(surface, RADIUS_AT), place(surface, RADIUS_AT, -sheet.paper(8.0) / PER_METRE)
        dimensions.radius(sheet, (x, z), radius, at, beyond)
    for share, backwards in _slopes(before, steel, after):
        _, _, slope = (float(each[0]) for each in point(surface, np.full(1, share)))
        down = -float(np.degrees(slope))
        low, high = sorted((0.0, down))
        turn = 180.0 if backwards else 0.0
        dimensions.angle(sheet, place(surface, share), low + turn, high + turn)


def _slopes(before: Steel | None, steel: Steel, after: Steel | None) -> Iterator[tuple[float, bool]]:
    """Yield the shares at which the slope of a segment is dimensioned, and whether the legs go back.

    A slope that the segment before has at the same place is dimensioned there.
    """
    if before is None or _heading(before, 1.0) != _heading(steel, 0.0):
        yield 0.0, True
    if steel.surface.turn[0] != 0.0:
        yield 1.0, False


def _heading(steel: Steel, share: float) -> tuple[float, ...]:
    """Return place and slope of a segment at a share of its length, rounded to what a drawing shows."""
    x, z, slope = (float(each[0]) for each in point(steel.surface, np.full(1, share)))
    return round(x, 5), round(z, 5), round(slope, 5)
