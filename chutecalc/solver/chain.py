"""Segment after segment: the stream that leaves one enters the next."""

import numpy as np

from chutecalc.design import Contact, Design, Fall, Status, Stream, length, select, stretched
from chutecalc.errors import Fault, SpecError
from chutecalc.physics.arrays import Array, shared
from chutecalc.physics.flight import motion, position
from chutecalc.physics.motion import ROOF
from chutecalc.physics.surface import Surface, point
from chutecalc.solver.deviation import Deviation, at_landing, deviation, none, of_arc
from chutecalc.solver.joint import Arrival, entry_error
from chutecalc.solver.leg import (
    ContactLeg,
    Drawn,
    Leg,
    arrivals,
    entry_of,
    fall_leg,
    inlet,
    merged,
    moved_on,
    onward,
    overwritten,
    points,
    some,
    stream_of,
)
from chutecalc.solver.slide import Slide
from chutecalc.solver.stretch import Effort, Stretch, effort, solve_stretch

STRIKES = 50  # on one hood; a bound, so that no input can hang


def run_chain(design: Design, rtol: float, complete: bool = True) -> tuple[list[Leg], Stream]:
    """Solves a chute, or n of them.

    Args:
        design: the chute.
        rtol: relative error allowed to the velocity.
        complete: keep what it takes to tell the stream at every place; without it only the ends of segments are known.

    Returns:
        The legs in order, one or more a segment, and the stream at the end. A number that no varied field has met yet
        stays of length 1.

    Raises:
        SpecError: a hood that is drawn tangent to a falling stream does not steepen from there, or a curve does not
        turn.
    """
    chain = _Chain(design, effort(rtol, complete))
    with np.errstate(all="ignore"):  # designs that have failed are carried along as what is not a number
        for number in range(len(design.segments)):
            chain.run(number)
    return chain.legs, chain.stream


class _Chain:
    """The stream on its way, and the drawn end of the segment before it."""

    def __init__(self, design: Design, work: Effort) -> None:
        self.design, self.work = design, work
        self.single = length(design) == 1
        self.legs: list[Leg] = []
        self.stream = inlet(design)
        self.drawn = Drawn(self.stream.x, self.stream.z, none((1,)))
        self.arrival: Arrival | None = None
        """On the next segment, where the fall before it has found that."""

    def run(self, number: int) -> None:
        """One segment."""
        segment = self.design.segments[number]
        more = number + 1 < len(self.design.segments)
        if isinstance(segment, Contact):
            leg = self.along(number, segment)
            self.legs.append(leg)
            self.stream = onward(leg, more)
            if segment.kind != "plate":
                self.strike_again(number, segment, leg)
            assert leg.contact is not None
            x, z, _ = point(leg.contact.surface, np.ones(1))
            self.drawn = Drawn(x, z, leg.contact.off)
        elif segment.onto_next:
            self.legs.append(self.onto_next(number, segment))
        else:
            leg = fall_leg(number, segment, self.stream, self.drawn, self.design)
            self.legs.append(leg)
            self.stream, self.drawn = leg.exit, Drawn(leg.exit.x, leg.exit.z, deviation(leg.exit))

    def strike_again(self, number: int, contact: Contact, leg: Leg) -> None:
        """A stream that dropped off a hood, or was thrown off a crest that rises, may meet it again further on."""
        for _ in range(STRIKES):
            lost = leg.status == Status.CONTACT_LOST
            if not lost.any():
                return
            status = np.where(lost, Status.OK, Status.NOT_REACHED)
            start = leg.exit._replace(status=status, airborne=lost)
            again = self.along(number, contact, start, known=2)
            caught = again.status < Status.MISSED
            if not caught.any():
                return
            leg = again._replace(status=np.where(caught, again.status, Status.NOT_REACHED))
            self.legs.append(leg)
            self.stream = merged(caught, onward(leg, number + 1 < len(self.design.segments)), self.stream)

    def onto_next(self, number: int, fall: Fall) -> Leg:
        """A flight to where it meets the next segment; what misses that flies on from where this one began."""
        contact = self.design.segments[number + 1]
        assert isinstance(contact, Contact)  # a rule of the spec
        start, surface, slide, drawn = self.meet(
            number + 1, contact, self.stream._replace(airborne=np.ones(1, dtype=bool))
        )
        arrival = arrivals(start, surface, slide, drawn, 0)
        landed = (arrival.status == Status.OK) | (arrival.status == Status.STALL)
        time = np.where(landed, arrival.time, np.nan)
        x, z = position(arrival.path, time)
        velocity, slope = motion(arrival.path, time)
        distance = start.distance + arrival.distance
        slope_met = points(surface, arrival.place)[2]
        off, _ = at_landing(deviation(start), drawn, arrival.path, time, surface, slope_met)
        end = stream_of((distance, x, z, slope, velocity, *off), start.status, landed)
        self.stream = merged(landed, end, start)
        self.arrival = arrival._replace(  # flown already
            time=np.where(landed, 0.0, arrival.time), distance=np.where(landed, 0.0, arrival.distance)
        )
        status = np.where((start.status == Status.OK) & landed, Status.OK, Status.NOT_REACHED)
        return Leg(number, fall, start, arrival.path, time, end, end, status, None)

    def meet(self, number: int, contact: Contact, stream: Stream) -> tuple[Stream, Surface, Slide, Deviation]:
        """A stream, the segment that it comes to, and by how much that may be drawn wrongly, all of one length."""
        design = self.design
        surface = _surface(contact, number, stream, contact.start or (self.drawn.x, self.drawn.z))
        off = none((1,)) if contact.start else self.drawn.off
        off = off._replace(slope=stream.slope_error if contact.entry_slope is None else np.zeros(1))
        slide = Slide(
            contact.side,
            design.gravity,
            surface.slope,
            surface.turn,
            surface.length,
            design.volume_rate,
            design.density,
            contact.wall,
            contact.section,
            contact.end_section,
            design.vertical_ratio,
            contact.facets,
            design.equilibrium,
            self.single,
        )
        if self.single:
            return stream, surface, slide, off
        own = length(slide)
        n = max(length(stream), length(surface), own)
        slide = slide._replace(alike=own == 1)
        return (
            Stream._make(stretched(field, (n,)) for field in stream),
            surface,
            slide,
            Deviation._make(stretched(field, (n,)) for field in off),
        )

    def along(self, number: int, contact: Contact, start: Stream | None = None, known: int = 0) -> Leg:
        """A contact segment: onto it, along it, and where each design leaves it."""
        start, surface, slide, drawn = self.meet(number, contact, self.stream if start is None else start)
        arrival, self.arrival = self.arrival, None
        if arrival is None:
            arrival = arrivals(start, surface, slide, drawn, known)
        if number + 1 == len(self.design.segments):  # none that could catch what flies past
            arrival = arrival._replace(status=np.where(arrival.status == Status.PASSED, Status.MISSED, arrival.status))
        off = of_arc(drawn, surface)
        entry = entry_of(start, surface, arrival, off)
        error = entry_error(slide, arrival.met())
        off = Deviation._make(np.where(error < 0.0, -field, field) for field in off)  # with an error of the other sign
        rows = np.flatnonzero(arrival.status == Status.OK)
        entered = entry._replace(error=np.abs(error))
        here, met, flow, line, aside = entered, arrival.met(), slide, surface, off
        if len(rows) < len(met.place):
            here, met, flow = some(entered, rows), arrival.met(rows), slide.rows(rows)
            line, aside = select(surface, rows), some(off, rows)
        if contact.kind == "plate":
            stretch = Stretch.standing(met.place, here.velocity**2, 2.0 * here.error)
        else:
            stretch = solve_stretch(flow, met.place, here.velocity**2, 2.0 * here.error, self.work)
        end = moved_on(here, stretch, met, flow, line, aside)
        if len(rows) < len(start.status):
            end = overwritten(entered, end, rows)
        status = np.where(start.status == Status.OK, end.status, Status.NOT_REACHED)
        contact_leg = ContactLeg(surface, slide, arrival, stretch, rows, off)
        return Leg(number, contact, start, arrival.path, arrival.time, entry, end, status, contact_leg)


def _surface(contact: Contact, number: int, start: Stream, drawn: tuple[Array, Array]) -> Surface:
    """The segment as it stands: a curve tangent to a falling stream takes its slope."""
    slope = shared(start.slope) if contact.entry_slope is None else contact.entry_slope
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
        raise SpecError([Fault(f"segments.{number + 1}.to_slope_deg", problem, "change it, or give from_slope_deg")])
