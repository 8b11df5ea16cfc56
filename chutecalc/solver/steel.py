"""Steel that stands still: a chute is drawn where its stream goes at the design point, and other streams meet it there.

What follows the stream when it is drawn is laid down once: where a segment after a fall begins, the slope of a curve
that is tangent to a falling stream, and what a belt of another velocity would move.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact, Design, Fall, Segment
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import Surface
from chutecalc.solver.chain import run_chain
from chutecalc.solver.segment_solution import ContactSolution

RTOL = 1e-12
"""Relative tolerance of the velocity with which a chute is drawn."""


class Place(NamedTuple):
    """Where a segment is drawn, arrays of shape (designs,); NaN where no stream of the design point gets there."""

    start: tuple[Array, Array] | None
    """x and z of its start, m; None if it goes on following what comes before."""
    slope: Array | None
    """Slope at the start of an arc, rad below horizontal, which may be tangent to a falling stream; else None."""


Steel = Mapping[int, Place]
"""Places of the segments that follow the stream when drawn, by number from 0."""


def follows_stream(design: Design, vertical: bool) -> list[int]:
    """Return the numbers of the segments whose place depends on the stream.

    Args:
        design: the chute.
        vertical: whether the stream enters straight down in all its states: then it takes the same line at any
            velocity, down to the first surface.
    """
    found = []
    for number, segment in enumerate(design.segments):
        if _may_follow(design, number) and not vertical:
            found.append(number)
        vertical = vertical and isinstance(segment, Fall)
    return found


def _may_follow(design: Design, number: int) -> bool:
    """Return whether a segment has no place of its own, and comes after a fall or a belt whose stream moves."""
    segment, before = design.segments[number], design.segments[number - 1] if number else None
    own = isinstance(segment, Contact) and segment.start is not None
    return not own and (design.belt is not None if before is None else isinstance(before, Fall))


def enters_vertically(design: Design) -> bool:
    """Return whether the stream of all designs enters straight down, at a place that does not depend on it.

    Args:
        design: the chutes.
    """
    downward = (design.inlet_slope == np.pi / 2) | (design.inlet_velocity == 0.0)
    return design.belt is None and bool(np.all(downward))


def drawn_steel(design: Design, places: bool = True) -> dict[int, Place]:
    """Return where the segments are drawn that may follow the stream.

    Args:
        design: the chute at its design point.
        places: whether to fix places; without, only slopes.

    Raises:
        SpecError: see :func:`chutecalc.solver.chain.run_chain`.
    """
    numbers = [number for number in range(len(design.segments)) if _may_follow(design, number)]
    solutions, _ = run_chain(design, RTOL, dense_output=False)
    first = {solved.number: solved for solved in reversed(solutions)}
    found = {}
    for number in numbers:
        segment, contact = design.segments[number], first[number].contact
        if contact is not None:
            arc = isinstance(segment, Contact) and segment.radius is not None
            drawn = drawn_surface(contact)
            found[number] = Place((drawn.x, drawn.z), drawn.slope if arc else None)
        else:
            start = first[number].start if number else None
            found[number] = Place(design.inlet_position if start is None else (start.x, start.z), None)
    return found if places else {number: Place(None, place.slope) for number, place in found.items()}


def drawn_surface(contact: ContactSolution) -> Surface:
    """Return the surface as which a segment is drawn, also where the stream struck the roof opposite to it.

    The roof is parallel to an arc, and goes from one end to the other of a straight.

    Args:
        contact: a contact with the segment.
    """
    segment, met = contact.segment, contact.surface
    if not segment.closed:
        return met
    slope = met.slope if segment.entry_slope is None else segment.entry_slope
    height = np.where(met.side == segment.side, 0.0, segment.side * segment.section.wall_height)
    length = met.length - met.turn * height if segment.length is None else segment.length
    x, z = met.x - height * np.sin(slope), met.z - height * np.cos(slope)
    return Surface(segment.side, x, z, slope, met.turn, length)


def with_steel(design: Design, steel: Steel) -> Design:
    """Return a design on steel that is drawn already.

    Args:
        design: the chute.
        steel: places of its segments.
    """
    if not steel:
        return design
    placed = [_placed(segment, steel[k]) if k in steel else segment for k, segment in enumerate(design.segments)]
    return design._replace(segments=tuple(placed))


def _placed(segment: Segment, place: Place) -> Segment:
    """Return a segment at its place."""
    start = segment.start if place.start is None else place.start
    if isinstance(segment, Fall):
        return segment._replace(start=start)
    return segment._replace(start=start, entry_slope=segment.entry_slope if place.slope is None else place.slope)
