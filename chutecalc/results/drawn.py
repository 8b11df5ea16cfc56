"""The steel as it is drawn: where each segment begins and ends, and the arc or the straight between."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact
from chutecalc.physics.surface import Surface, centre, point
from chutecalc.results.solved import SolvedChute
from chutecalc.solver.steel import drawn_surface

SAME = 1e-6
"""Distance below which two ends are one point of the drawing, m."""
Position = tuple[float, float]
"""x and z, m."""


class DrawnSegment(NamedTuple):
    """The guiding surface of a segment of one design, a straight or an arc; a plate is a straight."""

    name: str
    kind: str
    side: float
    """1 for a floor, -1 for a roof."""
    start: Position
    end: Position
    slopes: tuple[float, float]
    """At its start and its end, rad below horizontal."""
    length: float
    """Along the surface, m."""
    radius: float | None
    """Of an arc, m; None for a straight."""
    centre: Position | None
    """Of an arc; None for a straight."""


def drawn_surfaces(solution: SolvedChute) -> Iterator[tuple[Contact, Surface]]:
    """Yield the segments that have a place, in the order of the spec, whether the stream reaches them or not.

    Args:
        solution: solution of one design.
    """
    visits = {solved.number: solved for solved in reversed(solution.trajectory.segment_solutions)}
    for _, solved in sorted(visits.items()):
        if solved.contact is not None:
            surface = drawn_surface(solved.contact)
            if all(np.isfinite(each).all() for each in (surface.x, surface.z, surface.slope, surface.length)):
                yield solved.contact.segment, surface


def drawn_segment(segment: Contact, surface: Surface) -> DrawnSegment:
    """Return where a segment begins and ends, and what is between.

    Args:
        segment: the segment.
        surface: its surface where it is drawn, of one design.
    """
    x, z, slope = (values[:, 0].tolist() for values in point(surface, np.array([[0.0], [1.0]])))
    cx, cz, radius = (float(each[0]) for each in centre(surface))
    bent = bool(np.isfinite(radius))
    return DrawnSegment(
        segment.name,
        segment.kind,
        segment.side,
        (x[0], z[0]),
        (x[1], z[1]),
        (slope[0], slope[1]),
        float(surface.length[0]),
        radius if bent else None,
        (cx, cz) if bent else None,
    )


def points_of(segments: Sequence[DrawnSegment]) -> dict[str, Position]:
    """Return the ends of segments by letters; an end and a start at the same place are one point.

    Args:
        segments: in order.
    """
    found: dict[str, Position] = {}
    for segment in segments:
        for place in (segment.start, segment.end):
            if not any(np.hypot(place[0] - x, place[1] - z) < SAME for x, z in found.values()):
                found[letter(len(found))] = place
    return found


def letter(number: int) -> str:
    """Return a number in letters, as columns of a spreadsheet have them.

    Args:
        number: from 0.

    >>> letter(0), letter(25), letter(26)
    ('A', 'Z', 'AA')
    """
    return (letter(number // 26 - 1) if number > 25 else "") + chr(ord("A") + number % 26)


def letter_of(points: Mapping[str, Position], place: Position) -> str:
    """Return the letter of a point.

    Args:
        points: from :func:`points_of`.
        place: the end of one of their segments.
    """
    return next(name for name, (x, z) in points.items() if np.hypot(place[0] - x, place[1] - z) < SAME)
