"""Many streams on one segment, one after the other: rows of numbers in, rows of results out."""

from typing import Any

from chutecalc.core import march, section, slide, state

HEAD = 11
RESULTS = 9
"""How many numbers of a row come before those of wall and sections; how many results there are."""


def solve_rows(
    stream: "state.Stream", effort: "state.Effort", numbers: Any, results: Any, first: int, last: int
) -> int:
    """Solves rows from the first up to the last, and tells the row it has come to: less than the last for want of room.

    Args:
        stream: of this segment's kind; its panels are those of the rows done.
        effort: how hard to work.
        numbers: a row each: side, gravity, entry slope, turn, length, flow, density, K_v, place, v², its error; the
            pieces of the wall's friction law; the section where it starts, and where it ends.
        results: a row each: status, place, v², error, place, v² and error where it choked, panels tried, panels kept.
        first, last: rows.
    """
    row = first
    while row < last:
        before = stream.panels
        load(stream.way, numbers, row)
        stream.place, stream.y = float(numbers[row, 8]), float(numbers[row, 9])
        stream.error = float(numbers[row, 10])
        march.run(stream, effort)
        if stream.full:
            stream.panels = before
            return row
        results[row, 0], results[row, 1], results[row, 2] = stream.status, stream.place, stream.y
        results[row, 3], results[row, 4], results[row, 5] = stream.error, stream.choke_place, stream.choke_y
        results[row, 6], results[row, 7], results[row, 8] = stream.choke_error, stream.tried, stream.panels - before
        row += 1
    return row


def load(way: "slide.Slide", numbers: Any, row: int) -> None:
    """Reads a segment and the flow on it from a row."""
    way.side, way.gravity = float(numbers[row, 0]), float(numbers[row, 1])
    way.entry_slope, way.turn, way.length = (
        float(numbers[row, 2]),
        float(numbers[row, 3]),
        float(numbers[row, 4]),
    )
    way.flow, way.density, way.vertical_ratio = (
        float(numbers[row, 5]),
        float(numbers[row, 6]),
        float(numbers[row, 7]),
    )
    at = HEAD
    for k in range(way.pieces):
        way.starts[k], way.intercepts[k] = float(numbers[row, at]), float(numbers[row, at + 1])
        way.slopes[k] = float(numbers[row, at + 2])
        at += 3
    at = read(way.first, numbers, row, at)
    if way.taper:
        read(way.last, numbers, row, at)
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
