"""Where lines of a stream come down on surfaces that stand already."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Design, Fall, Status, length, select
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.solver.chain import run_chain
from chutecalc.solver.segment_solution import SegmentSolution
from chutecalc.solver.steel import drawn_surface

LANDED = ("landing_x_m", "landing_z_m", "landing_distance_m", "landing_velocity_m_s", "incidence_deg")
"""Numbers of a landing: where it is, how far along the segment from its start, and how the stream arrives there."""


class Landing(NamedTuple):
    """How a stream first comes down on a surface, arrays of shape (designs,)."""

    number: Index
    """Number of the segment, from 0; -1 where the stream meets none, or is on it without a flight."""
    numbers: Numbers
    """By the names of :data:`LANDED`."""
    gap: Array
    """Distance by which the last segment is missed, m; NaN where it is not."""
    before: Array
    """Distance by which it falls short of the start of the last segment, m; NaN where that is not missed."""
    distance: Array
    """Distance from the inlet along the stream, m."""


Placed = Mapping[int, SegmentSolution]
"""The first solution of each segment that guides the stream, by its number: its surface stays where that placed it."""


def first_landing(segment_solutions: Iterable[SegmentSolution], flies: Mask, left: Array) -> Landing:
    """Return how streams first come down on a surface; those that go on without a flight do not.

    Args:
        segment_solutions: that may follow, in order.
        flies: designs whose stream leaves what comes before them, shape (designs,).
        left: distance from the inlet at which it does, m, shape (designs,).
    """
    count = len(flies)
    found, waiting = _nowhere(count), flies
    for solved in segment_solutions:
        if not waiting.any():
            break
        if solved.contact is None:
            continue
        arrival, entry = solved.contact.arrival, solved.entry
        meets = waiting & (arrival.status <= Status.STALL)
        lands = meets & (entry.distance > left)
        found.number[lands] = solved.number
        along = arrival.share * solved.contact.surface.length
        landed = (entry.x, entry.z, along, arrival.velocity, np.degrees(arrival.incidence))
        for name, values in zip(LANDED, landed, strict=True):
            found.numbers[name][lands] = np.broadcast_to(values, count)[lands]
        found.distance[lands] = np.broadcast_to(entry.distance, count)[lands]
        waiting = waiting & ~meets
        flies_past = waiting & (arrival.status != Status.NOT_REACHED)  # not where others strike a segment again
        found.gap[flies_past] = np.broadcast_to(arrival.gap, count)[flies_past]
        found.before[flies_past] = np.broadcast_to(before_start(solved), count)[flies_past]
    found.gap[~waiting] = found.before[~waiting] = np.nan
    return found


def before_start(solved: SegmentSolution) -> Array:
    """Return how far before the drawn start of a segment the stream falls through its height, m; NaN if it does not.

    Args:
        solved: solution of a segment that guides the stream.
    """
    assert solved.contact is not None
    x, z, forward, downward, gravity = solved.path
    surface = solved.contact.surface
    drop = z - surface.z
    time = (np.sqrt(np.where(drop >= 0.0, downward**2 + 2.0 * gravity * drop, np.nan)) - downward) / gravity
    before: Array = surface.x - (x + forward * time)
    return before


def landing_of_line(line: Design, placed: Placed, first: int, target: Index, rtol: float) -> Landing:
    """Return how a line of the stream lands that flies on its own.

    It is solved up to the segment on which the stream itself lands, for each such segment in turn.

    Args:
        line: the chutes with this line as the stream that enters them.
        placed: the solutions of the stream.
        first: number of the first segment that is in its way.
        target: number of the segment on which each design's stream lands; -1 where there is none.
        rtol: relative error allowed to the velocity.
    """
    found = _nowhere(len(target))
    for last in np.unique(target[target >= 0]):
        rows = np.flatnonzero(target == last)
        visited = [placed[number] for number in range(first, last + 1) if number in placed]
        some = select(line._replace(segments=_surfaces(visited)), rows)
        solutions, _ = run_chain(some, rtol, dense_output=False)
        here = first_landing(solutions, np.ones(length(some), dtype=bool), np.zeros(1))
        numbers = np.array([-1, -1, *(solved.number for solved in visited)])  # nothing, the fall
        found.number[rows] = numbers[here.number + 1]
        found.gap[rows], found.before[rows] = here.gap, here.before
        for name, values in here.numbers.items():
            found.numbers[name][rows] = values
    return found


def _surfaces(visited: Sequence[Any]) -> tuple[Any, ...]:
    """Return a fall onto surfaces, which stand where they were placed."""
    surfaces = []
    for solved in visited:
        segment, drawn = solved.contact.segment, drawn_surface(solved.contact)
        slope = drawn.slope if segment.entry_slope is None else segment.entry_slope
        surfaces.append(segment._replace(start=(drawn.x, drawn.z), entry_slope=slope))
    return (Fall(name="", kind="", drop=None, run=None), *surfaces)


def _nowhere(count: int) -> Landing:
    """Return the landing of streams that land nowhere."""
    numbers = {name: np.full(count, np.nan) for name in LANDED}
    gap, before, distance = (np.full(count, np.nan) for _ in range(3))
    return Landing(number=np.full(count, -1), numbers=numbers, gap=gap, before=before, distance=distance)
