"""The edges of a stream in flight: how they begin to fly, and where they land.

One line of the stream is solved: from a belt its middle, from a surface the one along it. Its other edges fly on their
own to the surface on which that line lands: the same chute is solved again for each, up to that segment, with the
surfaces where the stream found them.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from chutecalc.design import Design, Status
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.results.inlet import leaves_belt
from chutecalc.results.landings import Landing, Placed, first_landing, landing_of_line
from chutecalc.results.part import Part
from chutecalc.solver.segment_solution import SegmentSolution

EDGE_NUMBERS = {
    "x_m": "horizontal position where it begins to fly",
    "z_m": "height where it begins to fly",
    "slope_deg": "slope below horizontal where it begins to fly",
    "velocity_m_s": "velocity where it begins to fly",
    "depth_m": "depth of the stream there, of a free edge",
    "landing_x_m": "horizontal position where it lands",
    "landing_z_m": "height where it lands",
    "landing_distance_m": "distance along the segment from its start",
    "landing_velocity_m_s": "velocity before the impact",
    "incidence_deg": "angle to the surface before the impact",
    "gap_m": "distance by which it passes the end of the segment that the stream meets, negative behind its surface",
    "before_m": "distance by which it falls short of the start of that segment",
}
"""All numbers of an edge, with their meanings."""


@dataclass(frozen=True, repr=False, eq=False)
class Edge:
    """A line of the stream in flight, from where it begins to fly to where it lands first; shape (designs,)."""

    name: str
    """``lower``, ``middle`` or ``upper`` of a stream from a belt; ``free`` for the surface of one that leaves a
    segment."""
    leaves: str
    """Name of the segment that the stream leaves; empty for the belt."""
    numbers: Numbers
    """How it begins to fly and how it lands, see :data:`EDGE_NUMBERS`. NaN for what it does not do."""
    segment: Any
    """Name of the segment on which it lands; empty where there is none."""
    number: Index
    """Number of that segment, from 0; -1 where there is none."""
    target: Index
    """Number of the segment on which the line lands that is solved; -1 where there is none."""
    s_m: Array
    """Distance from the inlet at which that line lands, m."""
    misses: Mask
    """Whether it does not land on the segment on which that line lands."""

    def __repr__(self) -> str:
        """Return the edge and where it lands, of the first design."""
        return f"<Edge {self.name}: lands on {self.segment[0] or 'nothing'}>"


def stream_edges(design: Design, parts: Sequence[Part], rtol: float, count: int) -> list[Edge]:
    """Return the edges of each flight of a stream with a depth that ends on a surface, in the order of the flights.

    Args:
        design: the chutes.
        parts: of the trajectory.
        rtol: relative error allowed to the velocity.
        count: number of designs.
    """
    guided = [part for part in parts if part.contact is not None]
    solutions = [part.solved for part in guided]
    placed = {solved.number: solved for solved in reversed(solutions)}
    edges = [*_from_belt(design, solutions, placed, rtol, count)]
    for place, part in enumerate(guided):
        later = map(solutions.__getitem__, range(place + 1, len(solutions)))
        edges += _from_surface(part, placed, later, rtol, count)
    return edges


def _from_belt(
    design: Design, solutions: Sequence[SegmentSolution], placed: Placed, rtol: float, count: int
) -> Iterator[Edge]:
    """Yield lower edge, middle and upper edge of a stream from a belt; none where it has no depth."""
    belt = design.belt
    if belt is None or not (belt.middle_radius > belt.lower_radius).any():
        return
    middle = first_landing(solutions, np.ones(count, dtype=bool), np.zeros(1))
    for name, radius in belt.edge_radii.items():
        start = leaves_belt(belt, radius, design.gravity, belt.friction)
        x, z = belt.centre[0] + start.x, belt.centre[1] + start.z
        leaves = {"x_m": x, "z_m": z, "slope_deg": np.degrees(start.slope), "velocity_m_s": start.velocity}
        landing = middle
        if name != "middle":
            landing = landing_of_line(_line(design, leaves, start.slope), placed, 0, middle.number, rtol)
        yield _edge(design, name, "", leaves, landing, middle)


def _from_surface(
    part: Part, placed: Placed, later: Iterable[SegmentSolution], rtol: float, count: int
) -> Iterator[Edge]:
    """Yield the free surface of a stream that leaves a segment through the air, beside the line that is solved.

    Inside pipes and boxes there is none: what crosses from wall to wall misses nothing.
    """
    solved, contact, exit_ = part.solved, part.contact, part.solved.exit
    assert contact is not None
    flies = np.broadcast_to(np.isin(solved.status, (Status.OK, Status.CONTACT_LOST)), count)
    along = first_landing(later, flies, exit_.distance)
    if contact.segment.closed:
        inside = [number for number in np.unique(along.number[along.number >= 0]) if _is_closed(placed[number])]
        along.number[np.isin(along.number, inside)] = -1
    lands = along.number >= 0
    if not lands.any():
        return
    depth = part.at(np.ones(1), ["depth_m"])["depth_m"][0]
    above = contact.side * depth
    leaves = {
        "x_m": exit_.x + above * np.sin(exit_.slope),
        "z_m": exit_.z + above * np.cos(exit_.slope),
        "slope_deg": np.degrees(exit_.slope),
        "velocity_m_s": exit_.velocity,
        "depth_m": depth,
    }
    again = along.number == solved.number
    line, numbers = _line(part.design, leaves, exit_.slope), along.number
    for some, first in ((again, solved.number), (lands & ~again, solved.number + 1)):
        if some.any():
            target = np.where(some, numbers, -1)
            landing = landing_of_line(line, placed, first, target, rtol)
            known = {name: np.where(some, values, np.nan) for name, values in leaves.items()}
            yield _edge(part.design, "free", part.name, known, landing, along._replace(number=target))


def _is_closed(solved: SegmentSolution) -> bool:
    """Return whether a segment that guides the stream is closed."""
    return solved.contact is not None and solved.contact.segment.closed


def _line(design: Design, leaves: Numbers, slope: Array) -> Design:
    """Return chutes into which a line of the stream enters as it begins to fly, slope in rad."""
    position = leaves["x_m"], leaves["z_m"]
    return design._replace(
        inlet_position=position, inlet_velocity=leaves["velocity_m_s"], inlet_slope=slope, belt=None, receiver=None
    )


def _edge(design: Design, name: str, left: str, leaves: Numbers, landing: Landing, solved: Landing) -> Edge:
    """Return an edge, from how it begins to fly, how it lands, and how the line lands that is solved."""
    names = [design.segments[number].name if number >= 0 else "" for number in landing.number]
    numbers = {**leaves, **landing.numbers, "gap_m": landing.gap, "before_m": landing.before}
    return Edge(
        name=name,
        leaves=left,
        numbers={key: np.broadcast_to(values, len(solved.number)) for key, values in numbers.items()},
        segment=np.array(names),
        number=landing.number,
        target=solved.number,
        s_m=solved.distance,
        misses=landing.number != solved.number,
    )
