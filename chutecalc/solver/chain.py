"""Segment after segment: the stream that leaves one enters the next."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact, Design, Fall, Segment, Status, Stream, length, select, spread, take
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.flight import Flight, flight, motion, path_length, position, time_to_drop
from chutecalc.physics.motion import ROOF
from chutecalc.physics.surface import Surface, point
from chutecalc.solver.front import Effort, effort
from chutecalc.solver.joint import Arrival, arrive
from chutecalc.solver.slide import Slide
from chutecalc.solver.stretch import Stretch, solve_stretch


class Leg(NamedTuple):
    """One segment as n designs went through it. Numbers are NaN in designs that did not get that far."""

    segment: Segment
    start: Stream
    """As it comes from the segment before."""
    path: Flight
    """The flight that begins at ``start``: a fall's, or what leads from an edge to a contact segment."""
    flight_time: Array
    """s, 0 where the stream does not fly."""
    entry: Stream
    """On the surface, after an impact; for a fall the same as ``exit``."""
    exit: Stream
    """At the end, or where the design fails."""
    status: Index
    """A :class:`~chutecalc.design.Status` each."""
    contact: "ContactLeg | None"


class ContactLeg(NamedTuple):
    """What a leg has along a guiding surface."""

    surface: Surface
    slide: Slide
    arrival: Arrival
    stretch: Stretch
    rows: Index
    """The designs in ``stretch``, in its order."""


def run_chain(design: Design, rtol: float, complete: bool = True) -> list[Leg]:
    """Solves a chute, or n of them.

    Args:
        design: the chute.
        rtol: relative error allowed to the velocity.
        complete: keep what it takes to tell the stream at every place; without it only the ends of segments are known.

    Returns:
        A leg per segment. A number that no varied field has met yet stays of length 1.

    Raises:
        SpecError: a hood that is drawn tangent to a falling stream does not steepen from there, or a curve does not
        turn.
    """
    work = effort(rtol, complete)
    legs: list[Leg] = []
    with np.errstate(all="ignore"):  # a panel too long may overflow or pass v = 0: it is refused and shortened
        stream = _inlet(design)
        drawn = (stream.x, stream.z)
        for number, segment in enumerate(design.segments, 1):
            if isinstance(segment, Fall):
                leg = _fall(segment, stream, drawn[1], design)
                drawn = (leg.exit.x, leg.exit.z)
            else:
                leg = _along(segment, number, stream, drawn, design, work)
                drawn = point(leg.contact.surface, np.ones(1))[:2] if leg.contact else drawn
            legs.append(leg)
            stream = _onward(leg, design.segments[number:])
    return legs


def _stream(numbers: Iterable[Array], status: Index, airborne: Mask) -> Stream:
    """A stream from its six numbers, in their order, and its two states."""
    distance, x, z, slope, velocity, error = numbers
    return Stream(distance, x, z, slope, velocity, error, status, airborne)


def _inlet(design: Design) -> Stream:
    """The stream where it enters the chute; at rest it points straight down."""
    zero = np.zeros(1)
    slope = np.where(design.inlet_velocity > 0.0, design.inlet_slope, np.pi / 2)
    velocity = np.broadcast_to(design.inlet_velocity, slope.shape)
    status = np.full(slope.shape, Status.OK)
    return Stream(zero, zero, zero, slope, velocity, zero, status, np.zeros(slope.shape, dtype=bool))


def _onward(leg: Leg, rest: tuple[Segment, ...]) -> Stream:
    """The stream as the next segment gets it: where contact was lost, a fall that follows takes it up in its flight."""
    lost = leg.status == Status.CONTACT_LOST  # here, and not before
    if not (rest and isinstance(rest[0], Fall) and lost.any()):
        return leg.exit
    return leg.exit._replace(status=np.where(lost, Status.OK, leg.exit.status), airborne=lost)


def _fall(fall: Fall, start: Stream, drawn_z: Array, design: Design) -> Leg:
    """Free flight down to a level below the drawn end of the segment before."""
    path = flight(start.x, start.z, start.velocity, start.slope, design.gravity)
    time = time_to_drop(path, start.z - drawn_z + fall.drop)
    x, z = position(path, time)
    velocity, slope = motion(path, time)
    alive = np.broadcast_to(start.status == Status.OK, velocity.shape)
    error = start.error * (start.velocity / np.where(velocity > 0.0, velocity, 1.0)) ** 2
    distance = start.distance + path_length(path, time)
    numbers = (np.where(alive, number, np.nan) for number in (distance, x, z, slope, velocity, error))
    flown = np.where(np.isnan(velocity), Status.MISSED, Status.OK)
    end = _stream(numbers, np.where(alive, flown, start.status), np.zeros(alive.shape, dtype=bool))
    status = np.where(alive, flown, Status.NOT_REACHED)
    return Leg(fall, start, path, np.where(alive, time, np.nan), end, end, status, None)


def _along(
    contact: Contact, number: int, start: Stream, drawn: tuple[Array, Array], design: Design, work: Effort
) -> Leg:
    """A contact segment: onto it, along it, and where each design leaves it."""
    surface = _surface(contact, number, start, drawn)
    flow = (design.gravity, surface.slope, surface.turn, surface.length, design.volume_rate, contact.wall_friction)
    slide = Slide(contact.side, *flow, contact.facets, contact.choke_area)
    n = max(length(start), length(surface), length(slide), contact.facets.area.shape[1])
    start = _stream(
        (np.broadcast_to(field, n) for field in start[:6]),
        np.broadcast_to(start.status, n),
        np.broadcast_to(start.airborne, n),
    )
    alive = np.flatnonzero(start.status == Status.OK)
    arrival = spread(arrive(_some(start, alive), select(surface, alive), slide.rows(alive)), alive, n)
    entry = _entry(start, surface, arrival)
    rows = np.flatnonzero(arrival.status == Status.OK)
    here, place = _some(entry, rows), arrival.place[rows]
    stretch = solve_stretch(slide.rows(rows), place, here.velocity**2, 2.0 * here.error, work)
    x, z, slope = point(select(surface, rows), stretch.place)
    distance = here.distance + take(surface.length, rows) * (stretch.place - place)
    error = np.where(stretch.status == Status.STALL, stretch.error, 0.5 * stretch.error)
    moved = Stream(distance, x, z, slope, np.sqrt(stretch.velocity_squared), error, stretch.status, here.airborne)
    end = moved if len(rows) == n else _overwrite(entry, moved, rows)
    return Leg(
        contact,
        start,
        arrival.path,
        arrival.time,
        entry,
        end,
        np.where(start.status == Status.OK, end.status, Status.NOT_REACHED),
        ContactLeg(surface, slide, arrival, stretch, rows),
    )


def _entry(start: Stream, surface: Surface, arrival: Arrival) -> Stream:
    """The stream on the surface, where it meets it; designs that failed before keep their status."""
    x, z, slope = point(surface, arrival.place)
    status = np.where(start.status == Status.OK, arrival.status, start.status)
    grounded = np.zeros(status.shape, dtype=bool)
    return Stream(start.distance + arrival.distance, x, z, slope, arrival.after, arrival.error, status, grounded)


def _some(stream: Stream, rows: Index) -> Stream:
    """Some designs of a stream whose fields are all of full length; none of them where there are no rows."""
    return Stream._make(field[rows] for field in stream)


def _overwrite(record: Stream, part: Stream, rows: Index) -> Stream:
    """The record with some of its designs replaced."""
    fields = [field.copy() for field in record]
    for field, new in zip(fields, part, strict=True):
        field[rows] = new
    return Stream._make(fields)


def _surface(contact: Contact, number: int, start: Stream, drawn: tuple[Array, Array]) -> Surface:
    """The segment as it stands: a curve tangent to a falling stream takes its slope."""
    slope = start.slope if contact.entry_slope is None else contact.entry_slope
    turn = contact.exit_slope - slope
    if contact.radius is None:
        assert contact.length is not None
        return Surface(contact.side, *drawn, slope, turn, contact.length)
    if contact.entry_slope is None:
        _check_turn(contact, number, slope, turn)
    return Surface(contact.side, *drawn, slope, turn, contact.radius * np.abs(turn))


def _check_turn(contact: Contact, number: int, slope: Array, turn: Array) -> None:
    """What cannot be told of a curve before the stream that it is tangent to is known."""
    flat = turn <= 0.0 if contact.side == ROOF else turn == 0.0
    if flat.any():
        at = f"{np.degrees(slope[flat][0]):.6g}"
        what = "a hood has to steepen" if contact.side == ROOF else "a curve has to turn"
        problem = f"{what}, and the stream falls into this one at {at}°"
        raise SpecError([Fault(f"segments.{number}.to_slope_deg", problem, "change it, or give from_slope_deg")])
