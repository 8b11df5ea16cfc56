"""One segment as designs went through it, and what becomes of their streams on the way."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from chutecalc.design import Design, Fall, Record, Segment, Status, Stream, select, spread, stretched
from chutecalc.physics.arrays import Array, Index, Mask, shared
from chutecalc.physics.flight import Flight, flight, motion, path_length, position, time_to_drop, time_to_run
from chutecalc.physics.surface import Surface, point
from chutecalc.solver.deviation import Deviation, after_drop, after_run, at_loss, deviation, none
from chutecalc.solver.joint import Arrival, Met, arrive
from chutecalc.solver.slide import Slide
from chutecalc.solver.stretch import Stretch

FARTHEST = 1e5  # m, as of every length: what falls further has missed what it falls to


class Drawn(NamedTuple):
    """The drawn end of a segment."""

    x: Array
    z: Array
    off: Deviation
    """By how much it may be off, where it follows from a stream; its slope is nobody's."""


class Leg(NamedTuple):
    """One segment as n designs went through it. Numbers are NaN in designs that did not get that far."""

    number: int
    """Of the segment, from 0; a hood that is left and struck again has a leg for each time."""
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
    off: Deviation
    """By how much the surface may be off where its slope is the same."""


def stream_of(numbers: Iterable[Array], status: Index, airborne: Mask) -> Stream:
    """A stream from its numbers, in their order, and its two states."""
    distance, x, z, slope, velocity, error, x_error, z_error, slope_error = numbers
    return Stream(distance, x, z, slope, velocity, error, x_error, z_error, slope_error, status, airborne)


def inlet(design: Design) -> Stream:
    """The stream where it enters the chute; at rest it points straight down."""
    zero = np.zeros(1)
    slope = np.where(design.inlet_velocity > 0.0, design.inlet_slope, np.pi / 2)
    velocity = np.broadcast_to(design.inlet_velocity, slope.shape)
    status = np.full(slope.shape, Status.OK)
    numbers = (zero, *design.inlet_place, slope, velocity, *none((1,)))
    return stream_of(numbers, status, np.zeros(slope.shape, dtype=bool))


def onward(leg: Leg, more: bool) -> Stream:
    """The stream as the next segment gets it: in flight where it lost contact, left a plate or flew past."""
    thrown = leg.segment.kind == "plate"
    if thrown:
        leg = leg._replace(exit=leg.exit._replace(airborne=leg.status == Status.OK))
    lost, passed = leg.status == Status.CONTACT_LOST, leg.status == Status.PASSED
    if not (more and (lost.any() or passed.any())):
        return leg.exit
    flying = leg.exit._replace(status=np.where(lost, Status.OK, leg.exit.status), airborne=leg.exit.airborne | lost)
    return merged(passed, leg.start._replace(airborne=np.ones(1, dtype=bool)), flying) if passed.any() else flying


def fall_leg(number: int, fall: Fall, start: Stream, drawn: Drawn, design: Design) -> Leg:
    """Free flight to a level below, or to a distance from, the drawn end of the segment before."""
    path = flight(start.x, start.z, start.velocity, start.slope, design.gravity)
    if fall.drop is not None:
        time = time_to_drop(path, start.z - drawn.z + fall.drop)
        off = after_drop(deviation(start), path, time, drawn.off.z)
    else:
        assert fall.run is not None
        time = time_to_run(path, drawn.x + fall.run - start.x)
        off = after_run(deviation(start), path, time, drawn.off.x)
    x, z = position(path, time)
    velocity, slope = motion(path, time)
    flown = np.where(path.z - z <= FARTHEST, Status.OK, Status.MISSED)
    alive = np.broadcast_to(start.status == Status.OK, velocity.shape)
    distance = start.distance + path_length(path, time)
    there = alive & (flown == Status.OK)
    numbers = (np.where(there, number, np.nan) for number in (distance, x, z, slope, velocity, *off))
    end = stream_of(numbers, np.where(alive, flown, start.status), np.zeros(alive.shape, dtype=bool))
    status = np.where(alive, flown, Status.NOT_REACHED)
    return Leg(number, fall, start, path, np.where(there, time, np.nan), end, end, status, None)


def arrivals(start: Stream, surface: Surface, slide: Slide, drawn: Deviation, known: int) -> Arrival:
    """How the streams that are still on their way meet a segment."""
    alive = np.flatnonzero(start.status == Status.OK)
    if len(alive) == len(start.status):
        return arrive(start, surface, slide, drawn, known)
    met = arrive(some(start, alive), select(surface, alive), slide.rows(alive), select(drawn, alive), known)
    return spread(met, alive, len(start.status))


def entry_of(start: Stream, surface: Surface, arrival: Arrival, aside: Deviation) -> Stream:
    """The stream on the surface, where it meets it; designs that failed before keep their status."""
    off = moved(aside, surface, arrival.place, arrival.error, arrival.place_error)
    x, z, slope = points(surface, arrival.place)
    status = np.where(start.status == Status.OK, arrival.status, start.status)
    grounded = np.zeros(status.shape, dtype=bool)
    numbers = (start.distance + arrival.distance, x, z, slope, arrival.impact.after, *off)
    return stream_of(numbers, status, grounded)


def moved(aside: Deviation, surface: Surface, place: Array, velocity: Array, shift: Array) -> Deviation:
    """The deviation of a stream further on along a surface by a share of its length, which itself is ``aside``."""
    _, _, slope = points(surface, place)
    way = surface.length * shift
    off = (velocity, aside.x + way * np.cos(slope), aside.z - way * np.sin(slope), surface.turn * shift)
    return Deviation._make(stretched(values, place.shape) for values in off)


def moved_on(here: Stream, stretch: Stretch, met: Met, slide: Slide, surface: Surface, aside: Deviation) -> Stream:
    """The stream where a stretch ends. All arguments are of the designs that went along it.

    On the surface an error is that of the velocity at a fixed place. Where the stream leaves the surface its place is
    off too: a plate where it was struck, a crest or hood where contact is lost.
    """
    x, z, slope = points(surface, stretch.place)
    distance = here.distance + surface.length * (stretch.place - met.place)
    error = np.where(stretch.status == Status.STALL, stretch.error, 0.5 * stretch.error)
    stood = (stretch.place == met.place) & (stretch.status != Status.STALL)
    lost = (stretch.status == Status.CONTACT_LOST) & ~stood
    shift = np.where(stood, met.place_error, 0.0)
    error = np.where(stood, met.error, error)
    if lost.any():
        faster, further = at_loss(slide, stretch.place, stretch.velocity_squared, error)
        error, shift = np.where(lost, faster, error), np.where(lost, further, shift)
    off = moved(aside, surface, stretch.place, error, shift)
    numbers = (distance, x, z, slope, np.sqrt(stretch.velocity_squared), *off)
    return stream_of(numbers, stretch.status, here.airborne)


def points(surface: Surface, place: Array) -> list[Array]:
    """:func:`~chutecalc.physics.surface.point` at a place for each design."""
    return [stretched(values, place.shape) for values in point(surface, shared(place))]


def some(record: Record, rows: Index) -> Record:
    """Some designs of a record of arrays all of full length; none of them where there are no rows."""
    return type(record)(*(field[rows] for field in record))


def merged(chosen: Mask, one: Stream, other: Stream) -> Stream:
    """The one stream in the designs chosen, the other in the rest."""
    return Stream._make(np.where(chosen, *pair) for pair in zip(one, other, strict=True))


def overwritten(record: Stream, part: Stream, rows: Index) -> Stream:
    """The record with some of its designs replaced."""
    fields = [field.copy() for field in record]
    for field, new in zip(fields, part, strict=True):
        field[rows] = new
    return Stream._make(fields)
