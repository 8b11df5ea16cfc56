"""The edges of a stream that comes from a belt: how they leave its pulley, and where they land.

The middle of the stream is solved. Its edges leave the pulley on radii of their own, and fly to the surface on which
the middle lands: the same chute is solved again for each, up to that segment, with the surfaces where the middle found
them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Design, Fall, Status, length, select
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.results.inlet import leaves_belt
from chutecalc.solver.chain import run_chain
from chutecalc.solver.segment_solution import SegmentSolution
from chutecalc.solver.steel import drawn_surface


@dataclass(frozen=True, repr=False, eq=False)
class Edge:
    """A line of the stream, from the pulley to where it lands first; arrays of shape (designs,)."""

    name: str
    """``lower``, ``middle`` or ``upper``."""
    numbers: Numbers
    """How it leaves the pulley: ``x_m``, ``z_m``, ``slope_deg``, ``velocity_m_s``, and how it lands:
    ``landing_x_m``, ``landing_z_m``, ``landing_distance_m`` along the segment from its start,
    ``landing_velocity_m_s`` and ``incidence_deg`` before the impact; ``gap_m`` by which it passes the end of the
    segment that the middle meets, negative behind its surface. NaN for what it does not do."""
    segment: Any
    """Name of the segment on which it lands; empty where there is none."""
    target: Index
    """Number of the segment on which the middle lands from the air, from 0; -1 where there is none."""
    misses: Mask
    """Whether it does not land on the segment on which the middle lands."""

    def __repr__(self) -> str:
        """Return the edge and where it lands, of the first design."""
        return f"<Edge {self.name}: lands on {self.segment[0] or 'nothing'}>"


class Landing(NamedTuple):
    """How a stream first comes down on a surface, arrays of shape (designs,)."""

    number: Index
    """Number of the segment, from 0; -1 where the stream meets none, or starts on it."""
    numbers: Numbers
    """Columns of :attr:`Edge.numbers` on the landing."""
    gap: Array
    """Distance by which the last segment is missed, m; NaN where it is not."""


def stream_edges(design: Design, segment_solutions: Sequence[SegmentSolution], rtol: float, count: int) -> list[Edge]:
    """Return lower edge, middle and upper edge of a stream from a belt; none where it has no depth.

    Args:
        design: the chutes.
        segment_solutions: of the middle of the stream.
        rtol: relative error allowed to the velocity.
        count: number of designs.
    """
    belt = design.belt
    if belt is None or not (belt.middle_radius > belt.lower_radius).any():
        return []
    middle = _first_landing(segment_solutions, count)
    names = np.array([*(segment.name for segment in design.segments), ""])
    edges = []
    for name, radius in belt.edge_radii.items():
        start = leaves_belt(belt, radius, design.gravity, belt.friction)
        position = belt.centre[0] + start.x, belt.centre[1] + start.z
        own = design._replace(
            inlet_position=position, inlet_velocity=start.velocity, inlet_slope=start.slope, belt=None, receiver=None
        )
        landing = middle if name == "middle" else _landing(own, segment_solutions, middle.number, rtol)
        numbers = {
            "x_m": position[0],
            "z_m": position[1],
            "slope_deg": np.degrees(start.slope),
            "velocity_m_s": start.velocity,
            **landing.numbers,
            "gap_m": landing.gap,
        }
        edges.append(
            Edge(
                name=name,
                numbers={key: np.broadcast_to(values, count) for key, values in numbers.items()},
                segment=names[landing.number],
                target=middle.number,
                misses=landing.number != middle.number,
            )
        )
    return edges


def _landing(own: Design, placed: Sequence[SegmentSolution], target: Index, rtol: float) -> Landing:
    """Return how an edge lands, solved up to the segment on which the middle does, for each such segment in turn.

    Args:
        own: the chutes with the edge as their stream.
        placed: the solutions of the middle, whose surfaces stay where they are.
        target: number of the segment on which each design's middle lands; -1 where there is none.
        rtol: relative error allowed to the velocity.
    """
    found = _nowhere(len(target))
    for last in np.unique(target[target >= 0]):
        rows = np.flatnonzero(target == last)
        some = select(own._replace(segments=_surfaces(placed, last)), rows)
        solutions, _ = run_chain(some, rtol, dense_output=False)
        here = _first_landing(solutions, length(some))
        numbers = np.array([-1, -1, *(solved.number for solved in _visited(placed, last))])  # nothing, the fall
        found.number[rows] = numbers[here.number + 1]
        found.gap[rows] = here.gap
        for name, values in here.numbers.items():
            found.numbers[name][rows] = values
    return found


def _surfaces(placed: Sequence[SegmentSolution], last: int) -> tuple[Any, ...]:
    """Return a fall onto the surfaces up to a segment, which stand where they were placed."""
    surfaces = []
    for solved in _visited(placed, last):
        segment, drawn = solved.contact.segment, drawn_surface(solved.contact)
        slope = drawn.slope if segment.entry_slope is None else segment.entry_slope
        surfaces.append(segment._replace(start=(drawn.x, drawn.z), entry_slope=slope))
    return (Fall(name="", kind="", drop=None, run=None), *surfaces)


def _visited(placed: Sequence[SegmentSolution], last: int) -> list[Any]:
    """Return the first solution of each guiding segment up to one of them."""
    first = {solved.number: solved for solved in reversed(placed) if solved.contact and solved.number <= last}
    return [first[number] for number in sorted(first)]


_LANDED = ("landing_x_m", "landing_z_m", "landing_distance_m", "landing_velocity_m_s", "incidence_deg")


def _nowhere(count: int) -> Landing:
    """Return the landing of streams that land nowhere."""
    numbers = {name: np.full(count, np.nan) for name in _LANDED}
    return Landing(number=np.full(count, -1), numbers=numbers, gap=np.full(count, np.nan))


def _first_landing(segment_solutions: Sequence[SegmentSolution], count: int) -> Landing:
    """Return how streams first come down on a surface; one that enters the chute on a surface does not."""
    found, waiting = _nowhere(count), np.ones(count, dtype=bool)
    for solved in segment_solutions:
        if solved.contact is None:
            continue
        arrival, entry = solved.contact.arrival, solved.entry
        meets = waiting & (arrival.status <= Status.STALL)
        lands = meets & (entry.distance > 0.0)
        found.number[lands] = solved.number
        along = arrival.share * solved.contact.surface.length
        landed = (entry.x, entry.z, along, arrival.velocity, np.degrees(arrival.incidence))
        for name, values in zip(_LANDED, landed, strict=True):
            found.numbers[name][lands] = np.broadcast_to(values, count)[lands]
        waiting = waiting & ~meets
        found.gap[waiting] = np.broadcast_to(arrival.gap, count)[waiting]
    found.gap[~waiting] = np.nan
    return found
