"""Segment after segment: the stream that leaves one enters the next.

:func:`run` carries a stream through a chute, a segment at a time, and writes a leg for each: how it came, what happened
where it met the segment, where it left it and in what state. Where a stream fails, what follows is laid out and no
more.
"""

import math

from chutecalc.core import flight, floats, friction, joint, march, records, slide, state, surface

STRIKES = 50  # on one segment; a bound, so that no input can hang
FARTHEST = 1e5  # m, as of every length: what falls further has missed what it falls to


def start(course: "records.Course") -> None:
    """The stream where it enters the chute; at rest it points straight down."""
    records.copy(course.here, course.inlet)
    course.status, course.airborne, course.arrived, course.strikes = state.OK, False, False, 0
    if not course.inlet.velocity > 0.0:
        course.here.slope = 0.5 * math.pi
    course.drawn_x, course.drawn_z = course.here.x, course.here.z
    course.drawn_off_x = course.drawn_off_z = course.error = 0.0
    course.saved_status = state.FAULT  # until it has come to where designs differ


def run(course: "records.Course", effort: "state.Effort", segment: "records.Segment") -> None:
    """A segment, and all that follow it."""
    if segment.number == course.again.number:
        save(course)
    if segment.fall:
        fall(course, segment)
    else:
        if not course.arrived:
            lay(course, segment, segment.own.way)
        along(course, effort, segment, segment.own, 0)
        strike_again(course, effort, segment)
        course.strikes = 0
        if not segment.final:
            course.drawn_x, course.drawn_z = surface.point(segment.own.way, 1.0)
            course.drawn_off_x, course.drawn_off_z = segment.sign * segment.aside_x, segment.sign * segment.aside_z
    if not segment.final and course.status >= state.OK:
        run(course, effort, segment.next)


def save(course: "records.Course") -> None:
    """Notes how the stream comes to where the designs of a batch begin to differ."""
    records.copy(course.saved, course.here)
    course.saved_status, course.saved_airborne = course.status, course.airborne
    course.saved_x, course.saved_z = course.drawn_x, course.drawn_z
    course.saved_off_x, course.saved_off_z = course.drawn_off_x, course.drawn_off_z
    course.saved_error = course.error


def restore(course: "records.Course") -> None:
    """Has the stream come there as it did."""
    records.copy(course.here, course.saved)
    course.status, course.airborne, course.arrived, course.strikes = (
        course.saved_status,
        course.saved_airborne,
        False,
        0,
    )
    course.drawn_x, course.drawn_z = course.saved_x, course.saved_z
    course.drawn_off_x, course.drawn_off_z = course.saved_off_x, course.saved_off_z
    course.error = course.saved_error


def lay(course: "records.Course", segment: "records.Segment", way: "slide.Slide") -> None:
    """The segment as it stands: a curve tangent to a falling stream takes its slope, and may be off with it."""
    tangent, placed = segment.entry_slope != segment.entry_slope, segment.start_x == segment.start_x
    way.x = segment.start_x if placed else course.drawn_x
    way.z = segment.start_z if placed else course.drawn_z
    way.entry_slope = course.here.slope if tangent else segment.entry_slope
    way.turn = segment.exit_slope - way.entry_slope
    way.length = segment.length
    if segment.radius == segment.radius:
        way.length = segment.radius * math.fabs(way.turn)
    segment.off_x = 0.0 if placed else course.drawn_off_x
    segment.off_z = 0.0 if placed else course.drawn_off_z
    segment.off_slope = course.here.slope_error if tangent else 0.0
    # Points of the same slope are off as its start, and by the arc that it begins later.
    longer = segment.off_slope * way.length / -way.turn if way.turn != 0.0 else 0.0
    segment.aside_x, segment.aside_z = segment.off_x, segment.off_z
    if longer != 0.0:
        segment.aside_x += longer * math.cos(way.entry_slope)
        segment.aside_z -= longer * math.sin(way.entry_slope)
    if course.status == state.OK:
        if tangent and (way.turn <= 0.0 if way.side < 0.0 else way.turn == 0.0):
            course.status = state.FAULT
            course.fault_slope, course.fault_number = way.entry_slope, segment.number
        else:
            slide.begin(way)


def along(
    course: "records.Course", effort: "state.Effort", segment: "records.Segment", own: "state.Stream", known: int
) -> None:
    """A contact segment: onto it, along it, and to where the stream leaves it."""
    records.copy(course.start, course.here)
    course.leg_status, course.flight_time = state.NOT_REACHED, floats.NAN
    own.tried, own.choke_place, segment.sign = 0, floats.NAN, 1.0
    if course.status != state.OK:
        leave_out(course, segment, own)
        return
    before = own.log.count
    if course.arrived:  # flown already
        course.arrival.time = course.arrival.distance = 0.0
        if course.arrival.status > state.STALL:
            course.arrival.time = course.arrival.distance = floats.NAN
        course.arrived = False
    else:
        joint.arrive(course, segment, own.way, known)
    course.flight_time = course.arrival.time
    if segment.final and course.arrival.status == state.PASSED:  # none that could catch what flies past
        course.arrival.status = state.MISSED
    course.leg_status = course.arrival.status
    if course.arrival.status > state.STALL:
        lose(course, segment)
        return
    enter(course, segment, own.way)
    error = joint.entry_error(course, own.way)
    if error < 0.0:  # with an error of the other sign
        segment.sign = -1.0
    records.copy(course.end, course.entry)
    course.end.error = math.fabs(error)
    own.place, own.y, own.error = (
        course.arrival.place,
        course.entry.velocity * course.entry.velocity,
        2.0 * course.end.error,
    )
    if course.arrival.status == state.OK:
        if segment.plate:
            own.status = state.OK
        else:
            march.run(own, effort)
        if own.status < state.OK:
            course.status = own.status
            return
        leave(course, segment, own)
    records.copy(course.here, course.end)
    course.status, course.airborne = course.leg_status, False
    write(course, segment, own, own.log.count - before)
    if not segment.final and course.leg_status == state.CONTACT_LOST:
        course.status = state.OK
        course.airborne = True
    elif segment.plate and course.leg_status == state.OK:
        course.airborne = True


def enter(course: "records.Course", segment: "records.Segment", way: "slide.Slide") -> None:
    """The stream on the surface, where it meets it."""
    course.entry.distance = course.start.distance + course.arrival.distance
    course.entry.velocity = course.impact.after
    settle(course.entry, segment, way, course.arrival.place, course.arrival.error, course.arrival.place_error)


def settle(
    point: "records.Point", segment: "records.Segment", way: "slide.Slide", place: float, error: float, shift: float
) -> None:
    """Puts a point on a segment: errors are of the velocity, and of the place as a share of the length."""
    point.x, point.z = surface.point(way, place)
    point.slope = way.entry_slope + way.turn * place
    point.error, point.slope_error = error, way.turn * shift
    point.x_error, point.z_error = segment.sign * segment.aside_x, segment.sign * segment.aside_z
    if shift != 0.0:
        point.x_error += way.length * shift * math.cos(point.slope)
        point.z_error -= way.length * shift * math.sin(point.slope)


def leave(course: "records.Course", segment: "records.Segment", own: "state.Stream") -> None:
    """The stream where it has come to.

    On the surface an error is that of the velocity at a fixed place. Where the stream leaves the surface its place is
    off too: a plate where it was struck, a crest or hood where contact is lost.
    """
    choked = own.choke_place == own.choke_place
    place = own.choke_place if choked else own.place
    y = own.choke_y if choked else own.y
    error = own.choke_error if choked else own.error
    course.leg_status = state.CHOKED if choked else own.status
    if course.leg_status != state.STALL:
        error *= 0.5
    shift = 0.0
    if place == course.arrival.place and course.leg_status != state.STALL:
        error, shift = course.arrival.error, course.arrival.place_error
    elif course.leg_status == state.CONTACT_LOST:
        error, shift = loss_error(own.way, place, y, error)
    course.end.distance = course.entry.distance + own.way.length * (place - course.arrival.place)
    course.end.velocity = math.sqrt(y)
    settle(course.end, segment, own.way, place, error, shift)


def loss_error(way: "slide.Slide", place: float, y: float, error: float) -> tuple[float, float]:
    """Where contact is lost, n(c, y) = 0: relative error of the velocity there, and that of the place."""
    slope = way.entry_slope + way.turn * place
    rise = friction.pull_at(way, place, y)
    turned = -way.side * way.gravity * math.sin(slope) * way.turn
    shift = flight.share(-2.0 * error * y * way.bend, turned + way.bend * rise)
    return error + 0.5 * rise / y * shift, shift


def lose(course: "records.Course", segment: "records.Segment") -> None:
    """A flight that does not meet its segment: past it to the next, or the end."""
    records.nowhere(course.entry)
    records.nowhere(course.end)
    course.impact.after = segment.own.place = segment.own.y = floats.NAN
    write(course, segment, segment.own, 0)
    if course.arrival.status == state.PASSED:
        course.airborne = True
    else:
        course.status = state.MISSED
        records.nowhere(course.here)


def leave_out(course: "records.Course", segment: "records.Segment", own: "state.Stream") -> None:
    """A segment that the stream does not come to."""
    records.nowhere(course.start)
    records.nowhere(course.entry)
    records.nowhere(course.end)
    records.nowhere(course.here)
    joint.nothing(course)
    own.place = own.y = floats.NAN
    write(course, segment, own, 0)


def strike_again(course: "records.Course", effort: "state.Effort", segment: "records.Segment") -> None:
    """A stream that dropped off a hood, or was thrown off a crest that rises, may meet it again further on."""
    for _ in range(STRIKES):
        if segment.plate or course.leg_status != state.CONTACT_LOST:
            return
        status, airborne, before, sign = course.status, course.airborne, course.count, segment.sign
        course.status, course.airborne = state.OK, True
        course.strikes += 1
        along(course, effort, segment, segment.own, 2)
        if course.leg_status >= state.MISSED:  # not caught: as if it had not been tried
            course.count = before
            course.status, course.airborne = status, airborne
            records.copy(course.here, course.start)
            course.leg_status, segment.sign = state.NOT_REACHED, sign


def fall(course: "records.Course", segment: "records.Segment") -> None:
    """Free flight: to a level below, or to a distance from, the drawn end of the segment before; or to the next."""
    records.copy(course.start, course.here)
    course.leg_status, course.flight_time = state.NOT_REACHED, floats.NAN
    joint.nothing(course)
    if course.status != state.OK:
        leave_out(course, segment, segment.own)
    elif segment.drop == segment.drop or segment.run == segment.run:
        drop(course, segment)
    else:
        onto_next(course, segment, segment.next, segment.next.own.way)
    if segment.drop == segment.drop or segment.run == segment.run:
        course.drawn_x, course.drawn_z = course.here.x, course.here.z
        course.drawn_off_x, course.drawn_off_z = course.here.x_error, course.here.z_error


def drop(course: "records.Course", segment: "records.Segment") -> None:
    """To a level, or a distance."""
    flight.launch(course.flight, course.here, course.gravity)
    if segment.drop == segment.drop:
        time = flight.time_to_drop(course.flight, course.here.z - course.drawn_z + segment.drop)
    else:
        time = flight.time_to_run(course.flight, course.drawn_x + segment.run - course.here.x)
    course.leg_status = state.OK
    if not course.flight.z - flight.z_at(course.flight, time) <= FARTHEST:
        course.leg_status = course.status = state.MISSED
        records.nowhere(course.end)
    else:
        course.flight_time = time
        fly(course, time)
        flight.spread_error(course.flight, course.start, time)
        if segment.drop == segment.drop:
            later = flight.share(course.flight.off_z - course.drawn_off_z, course.flight.down)
        else:
            later = flight.share(course.drawn_off_x - course.flight.off_x, course.flight.forward)
        flight.error_later(course.flight, later, course.end)
    records.copy(course.entry, course.end)
    records.copy(course.here, course.end)
    course.airborne = False
    write(course, segment, segment.own, 0)


def fly(course: "records.Course", time: float) -> None:
    """The stream after a time of its flight goes to ``end``, without its errors."""
    course.arrival.distance = flight.path_length(course.flight, time)
    course.end.distance = course.start.distance + course.arrival.distance
    course.end.x, course.end.z = flight.x_at(course.flight, time), flight.z_at(course.flight, time)
    course.end.velocity, course.end.slope = (
        flight.velocity_at(course.flight, time),
        flight.slope_at(course.flight, time),
    )


def onto_next(
    course: "records.Course", segment: "records.Segment", following: "records.Segment", way: "slide.Slide"
) -> None:
    """To where the flight meets the next segment; what misses that flies on from where this flight began."""
    course.airborne = True
    lay(course, following, way)
    if course.status != state.OK:
        return
    joint.arrive(course, following, way, 0)
    course.arrived = True
    records.nowhere(course.end)
    if course.arrival.status <= state.STALL:
        course.leg_status, course.flight_time = state.OK, course.arrival.time
        records.copy(course.end, course.entry)  # its errors
        fly(course, course.arrival.time)
        records.copy(course.here, course.end)
    records.copy(course.entry, course.end)
    write(course, segment, segment.own, 0)


def write(course: "records.Course", segment: "records.Segment", own: "state.Stream", panels: int) -> None:
    """Writes down a leg."""
    if course.leg_status < state.MISSED:
        course.error = math.fabs(course.end.error)
    if course.ends_only:
        return
    if course.count >= course.room:
        course.full = True
        return
    at = records.LEG * course.count
    course.legs[at], course.legs[at + 1] = course.row, segment.number
    course.legs[at + 2], course.legs[at + 3] = course.strikes, course.leg_status
    records.put(course.legs, at + 4, course.start)
    records.put(course.legs, at + 13, course.entry)
    records.put(course.legs, at + 22, course.end)
    course.legs[at + 31], course.legs[at + 32] = course.flight.x, course.flight.z
    course.legs[at + 33], course.legs[at + 34] = course.flight.forward, course.flight.downward
    course.legs[at + 35] = course.flight.gravity
    course.legs[at + 36] = course.flight_time
    course.legs[at + 37], course.legs[at + 38] = own.way.x, own.way.z
    course.legs[at + 39], course.legs[at + 40] = own.way.entry_slope, own.way.turn
    course.legs[at + 41] = own.way.length
    course.legs[at + 42], course.legs[at + 43] = course.arrival.distance, course.arrival.place
    course.legs[at + 44], course.legs[at + 45] = course.arrival.velocity, course.arrival.incidence
    course.legs[at + 46], course.legs[at + 47] = course.arrival.gap, course.arrival.status
    course.legs[at + 48], course.legs[at + 49] = course.impact.footprint, course.impact.pressure
    course.legs[at + 50], course.legs[at + 51] = course.impact.stress, course.impact.wall_friction
    course.legs[at + 52], course.legs[at + 53] = course.impact.friction, course.impact.after
    course.legs[at + 54] = course.impact.wear
    choked = own.choke_place == own.choke_place
    course.legs[at + 55] = own.choke_place if choked else own.place
    course.legs[at + 56] = own.choke_y if choked else own.y
    course.legs[at + 57] = own.place if choked else floats.NAN
    course.legs[at + 58], course.legs[at + 59], course.legs[at + 60] = own.status, own.tried, panels
    course.count += 1
