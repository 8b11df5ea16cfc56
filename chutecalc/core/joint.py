"""How a stream gets onto a contact segment: along it, by an impact, or by a flight that lands further on.

Small errors of the stream go along, to first order: one that leaves an edge a little faster lands further on, at
another slope, and may strike harder or less hard. On the surface they are one, of the velocity at a fixed place.
"""

import math

from chutecalc.core import flight, floats, friction, impact, records, slide, state, surface

TANGENT = SAME = 1e-6 * math.pi / 180.0  # SAME as Python sees it
"""Directions closer than this are one: the state passes on unchanged."""
NEARBY = 1e-6
"""How far off, relative, a stream is tried to see how an impact on it changes."""


def arrive(course: "records.Course", segment: "records.Segment", way: "slide.Slide", known: int) -> None:
    """Meets the segment: at its start, or where a flight comes down on it; ``arrival`` says how, ``impact`` what of it.

    The status is ``STALL`` where the impact leaves no velocity, ``MISSED`` where a flight finds no surface and never
    passes its end either, ``PASSED`` where it does.

    Args:
        course: a stream in motion, airborne or on the segment's drawn start.
        segment, way: the segment as drawn.
        known: how many roots at time 0 of an airborne stream's flight lie on this very surface.
    """
    turn = way.side * (course.here.slope - way.entry_slope)  # > 0: into the surface
    flight.launch(course.flight, course.here, way.gravity)
    records.copy(course.entry, course.here)  # for its errors
    course.arrival.time = course.arrival.distance = course.arrival.place = course.arrival.place_error = 0.0
    course.arrival.gap = floats.NAN
    course.arrival.velocity, course.arrival.incidence = course.here.velocity, max(turn, 0.0)
    if course.airborne or turn < -TANGENT:
        time, place, slope = surface.land(way, course.flight, course.curve, known if course.airborne else 1)
        course.arrival.time, course.arrival.place = time, place
        if time != time:
            lose(course, way)
            return
        course.arrival.distance = flight.path_length(course.flight, time)
        course.arrival.velocity = flight.velocity_at(course.flight, time)
        course.arrival.incidence = way.side * (flight.slope_at(course.flight, time) - slope)
        flight.spread_error(course.flight, course.here, time)
        course.arrival.place_error = landed_error(course, segment, way, slope)
    if course.arrival.incidence <= TANGENT:
        course.arrival.incidence = 0.0
    impact.strike(course.impact, way, course.arrival.place, course.arrival.velocity, course.arrival.incidence)
    strike_error(course, segment, way)
    course.arrival.status = state.OK if course.impact.after > 0.0 else state.STALL


def lose(course: "records.Course", way: "slide.Slide") -> None:
    """The flight does not meet the segment."""
    course.arrival.gap = surface.gap_at_end(way, course.flight)
    course.arrival.status = state.PASSED if course.arrival.gap > 0.0 else state.MISSED
    course.arrival.distance = course.arrival.velocity = course.arrival.incidence = floats.NAN
    course.arrival.error = course.arrival.place_error = floats.NAN
    impact.strike(course.impact, way, 0.0, floats.NAN, 0.0)


def nothing(course: "records.Course") -> None:
    """There is no stream that could arrive."""
    course.arrival.status = state.NOT_REACHED
    course.arrival.time = course.arrival.distance = course.arrival.place = course.arrival.velocity = floats.NAN
    course.arrival.incidence = course.arrival.gap = course.impact.after = floats.NAN
    course.impact.footprint = course.impact.pressure = course.impact.stress = course.impact.wear = floats.NAN
    course.impact.wall_friction = course.impact.friction = floats.NAN
    course.flight.x = course.flight.z = course.flight.forward = course.flight.downward = floats.NAN
    course.flight.gravity = course.gravity


def landed_error(course: "records.Course", segment: "records.Segment", way: "slide.Slide", slope: float) -> float:
    """The errors of a stream where it lands go to ``entry``; that of the place, as a share of the surface's length."""
    sine, cosine = math.sin(slope), math.cos(slope)
    beside = (course.flight.off_x - segment.off_x) * sine + (course.flight.off_z - segment.off_z) * cosine
    closing = course.flight.forward * sine - course.flight.down * cosine
    flight.error_later(course.flight, flight.share(-beside, closing), course.entry)
    along = (course.entry.x_error - segment.off_x) * cosine - (course.entry.z_error - segment.off_z) * sine
    return along / way.length


def strike_error(course: "records.Course", segment: "records.Segment", way: "slide.Slide") -> None:
    """Errors of the velocity left and of the place, from those of the stream that arrives.

    Friction changes with depth, pressure and place: the impact of a stream that is off a little tells how. A tangent
    arc that begins at another slope is the same arc begun elsewhere.
    """
    off, steeper, shift = course.entry.error, course.entry.slope_error - segment.off_slope, course.arrival.place_error
    course.arrival.error = off
    if way.turn != 0.0:
        course.arrival.place_error += segment.off_slope / way.turn
        shift = course.arrival.place_error
    hit = course.arrival.incidence > 0.0 and (off != 0.0 or course.entry.slope_error != 0.0 or shift != 0.0)
    if not hit:
        return
    steeper = way.side * (steeper - way.turn * shift)
    size = max(math.fabs(off), math.fabs(steeper) / max(course.arrival.incidence, NEARBY), math.fabs(shift))
    if not size > 0.0:
        course.arrival.error = 0.0
        return
    scale = NEARBY / size
    impact.strike(
        course.beside,
        way,
        course.arrival.place + scale * shift,
        course.arrival.velocity * (1.0 + scale * off),
        course.arrival.incidence + scale * steeper,
    )
    after = course.impact.after if course.impact.after > 0.0 else floats.INFINITY
    course.arrival.error = (course.beside.after - course.impact.after) / scale / after


def entry_error(course: "records.Course", way: "slide.Slide") -> float:
    """Relative error of the velocity at the place where a stream enters; where the impact stops it, of that place.

    With the sign that goes with those of the segment's own place.
    """
    if course.impact.after == 0.0:
        return course.arrival.place_error
    if course.arrival.place_error == 0.0:
        return course.arrival.error
    y = course.impact.after * course.impact.after
    rise = 0.5 * friction.pull_at(way, course.arrival.place, y) / y
    return course.arrival.error - rise * course.arrival.place_error
