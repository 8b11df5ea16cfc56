"""Many chutes, one after the other: rows of numbers in, legs out."""

from typing import Any

from chutecalc.core import chain, floats, records, section, slide, state, walls

HEAD = 8
"""How many numbers of a row come before those of the segments."""


def solve_rows(course: "records.Course", effort: "state.Effort", numbers: Any, first: int, last: int) -> int:
    """Solves rows from the first up to the last, and tells the row it has come to: less than the last for want of room.

    Or because there it gave up. Legs, and panels where they are
    kept, are those of the rows done.

    Args:
        course: of this chute's kind; the numbers of what comes before its segment ``again`` are those of all rows.
        effort: how hard to work.
        numbers: a row each: density, gravity, volume rate, K_v; place, velocity and slope of the stream at the inlet;
            and the segments: of a fall its drop and run; else where it starts, entry and exit slope, radius, length,
            the pieces of the wall's friction law, the section where it starts, and where it ends.
        first, last: rows.
    """
    row = first
    while row < last:
        legs, panels = course.count, course.first.own.log.count
        course.row = row
        load(course, course.first, numbers, row, HEAD)
        if row == first or course.again.number == 0:
            chain.start(course)
            chain.run(course, effort, course.first)
        else:
            chain.restore(course)
            chain.run(course, effort, course.again)
        if course.full or course.first.own.log.full:
            course.count, course.first.own.log.count = legs, panels
            return row
        tell(course, course.last, course.last.own)
        if course.status == state.UNSOLVED:
            return row
        row += 1
    return row


def tell(course: "records.Course", last: "records.Segment", own: "state.Stream") -> None:
    """Writes down how a design ends."""
    row = course.row
    course.ends[0, row], course.ends[1, row], course.ends[2, row] = course.status, course.here.velocity, course.error
    course.ends[3, row], course.ends[4, row] = course.here.distance, course.here.x
    course.ends[5, row], course.ends[6, row] = course.here.z, course.here.slope
    if course.status == state.FAULT:
        course.faults += 1
        course.ends[4, row], course.ends[6, row] = course.fault_number, course.fault_slope
    y = floats.NAN if course.status != state.OK or last.fall else own.y
    if course.tells_lying:
        walls.lie(own.way, own.place, y, 0, row, course.lying)
    if course.tells_pressing:
        walls.press(own.way, own.place, y, 0, row, course.pressing)


def load(course: "records.Course", segment: "records.Segment", numbers: Any, row: int, at: int) -> None:
    """Reads a segment, and all that follow it, from a row; with the first of them the inlet."""
    if at == HEAD:
        course.gravity = float(numbers[row, 1])
        course.inlet.x, course.inlet.z = float(numbers[row, 4]), float(numbers[row, 5])
        course.inlet.velocity, course.inlet.slope = float(numbers[row, 6]), float(numbers[row, 7])
    if segment.fall:
        segment.drop, segment.run = float(numbers[row, at]), float(numbers[row, at + 1])
        at += 2
    else:
        segment.start_x, segment.start_z = float(numbers[row, at]), float(numbers[row, at + 1])
        segment.entry_slope, segment.exit_slope = float(numbers[row, at + 2]), float(numbers[row, at + 3])
        segment.radius, segment.length = float(numbers[row, at + 4]), float(numbers[row, at + 5])
        at = load_way(segment.own.way, numbers, row, at + 6)
    if not segment.final:
        load(course, segment.next, numbers, row, at)


def load_way(way: "slide.Slide", numbers: Any, row: int, at: int) -> int:
    """Reads the flow, the wall and the sections, and tells where the next number stands."""
    way.density, way.gravity = float(numbers[row, 0]), float(numbers[row, 1])
    way.flow, way.vertical_ratio = float(numbers[row, 2]), float(numbers[row, 3])
    for k in range(way.pieces):
        way.starts[k], way.intercepts[k] = float(numbers[row, at]), float(numbers[row, at + 1])
        way.slopes[k] = float(numbers[row, at + 2])
        at += 3
    at = read(way.first, numbers, row, at)
    return read(way.last, numbers, row, at) if way.taper else at


def put_back(way: "slide.Slide", numbers: Any, row: int, at: int, slope: float, turn: float, length: float) -> None:
    """Makes a segment what it was when it was solved."""
    load_way(way, numbers, row, at)
    way.entry_slope, way.turn, way.length = slope, turn, length
    slide.begin(way)


def read(own: "section.Section", numbers: Any, row: int, at: int) -> int:
    """Reads a section from a row, and tells where the next number stands."""
    own.wall_height = float(numbers[row, at])
    if own.circle:
        own.radius = float(numbers[row, at + 1])
        return at + 2
    own.base = float(numbers[row, at + 1])
    at += 2
    for k in range(own.walls):
        own.lengths[k], own.inclinations[k] = float(numbers[row, at]), float(numbers[row, at + 1])
        at += 2
    return at
