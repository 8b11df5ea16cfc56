"""Solve a contact segment: arrival, motion along it and departure."""

import math

from chutecalc.core import (
    closed,
    flight,
    floats,
    guide_surface,
    joint,
    motion,
    placement,
    records,
    solution_rows,
    state,
    stepping,
    surface,
)

MAX_STRIKES = 50  # on one segment; a bound, so that no input can hang


def solve_contact(
    chute: "records.ChuteState", options: "state.SolverOptions", segment: "records.Segment", known_roots: int
) -> None:
    """Solve a contact segment on the surface that is met: arrival, motion along it, and departure."""
    if segment.on_roof:
        solve_surface(chute, options, segment, segment.roof, known_roots)
    else:
        solve_surface(chute, options, segment, segment.stream, known_roots)


def solve_surface(
    chute: "records.ChuteState",
    options: "state.SolverOptions",
    segment: "records.Segment",
    stream: "state.Stream",
    known_roots: int,
) -> None:
    """Solve the stream on one surface of a segment."""
    records.copy_point(chute.start, chute.current)
    chute.segment_status, chute.flight_time = state.NOT_REACHED, floats.NAN
    stream.attempts, stream.choke_share, segment.error_sign = 0, floats.NAN, 1.0
    if chute.status != state.OK:
        solution_rows.skip_segment(chute, segment, stream)
        return
    before = stream.store.count
    if chute.already_landed:  # the fall before has solved the flight
        chute.arrival.time = chute.arrival.distance = 0.0
        if chute.arrival.status > state.STALL:
            chute.arrival.time = chute.arrival.distance = floats.NAN
        chute.already_landed = False
    else:
        joint.meet_segment(chute, segment, stream.guide, known_roots)
    chute.flight_time = chute.arrival.time
    if chute.arrival.status > state.STALL:
        miss_segment(chute, segment)
        return
    chute.segment_status = chute.arrival.status
    records.clear_point(chute.launch)
    enter_surface(chute, segment, stream.guide)
    error = joint.entry_error(chute, stream.guide)
    if error < 0.0:  # errors are positive: change the sign of all others
        segment.error_sign = -1.0
    records.copy_point(chute.end, chute.entry)
    chute.end.error = math.fabs(error)
    stream.share, stream.y, stream.error = (
        chute.arrival.share,
        joint.squared(stream.guide, chute.entry.velocity),
        2.0 * chute.end.error,
    )
    if chute.arrival.status == state.OK:
        if segment.plate:
            stepping.pass_plate(stream, options)
        else:
            stepping.solve_segment(stream, options)
        if stream.status < state.OK:
            chute.status = stream.status
            return
        if slips_off(chute, segment, stream):
            joint.miss_segment(chute, stream.guide)
            miss_segment(chute, segment)
            return
        leave_surface(chute, segment, stream)
    records.copy_point(chute.current, chute.end)
    chute.status, chute.airborne = chute.segment_status, False
    solution_rows.write_solution(chute, segment, stream, stream.store.count - before)
    if chute.segment_status == state.CONTACT_LOST and may_be_caught(chute, segment):
        chute.status = state.OK
        chute.airborne = True
    elif segment.plate and chute.segment_status == state.OK:
        chute.airborne = True


def may_be_caught(chute: "records.ChuteState", segment: "records.Segment") -> bool:
    """Return whether a stream that flies on from a segment may land: on a later one, or on a belt with a place."""
    return not segment.final or chute.belt_x == chute.belt_x


def slips_off(chute: "records.ChuteState", segment: "records.Segment", stream: "state.Stream") -> bool:
    """Return whether a stream that touches a hood, drawn along it, leaves it at once and for good: it is not guided."""
    if (
        stream.status != state.CONTACT_LOST
        or stream.share != chute.arrival.share
        or chute.arrival.incidence != 0.0
        or stream.guide.side > 0.0
        or segment.closed
    ):
        return False
    flight.launch(chute.flight, chute.entry, chute.gravity)
    time, _, _ = surface.land(stream.guide, chute.flight, chute.clearance, 2)
    flight.launch(chute.flight, chute.current, chute.gravity)
    return time != time


def enter_surface(chute: "records.ChuteState", segment: "records.Segment", guide: "guide_surface.Guide") -> None:
    """Put the stream on the surface where it meets it."""
    chute.entry.distance = chute.start.distance + chute.arrival.distance
    chute.entry.velocity = chute.impact.velocity_after
    placement.set_point(
        chute.entry, segment, guide, chute.arrival.share, chute.arrival.error, chute.arrival.share_error
    )


def leave_surface(chute: "records.ChuteState", segment: "records.Segment", stream: "state.Stream") -> None:
    """Put the stream where it ends on the surface.

    On the surface an error is that of the velocity at a fixed position. Where the stream leaves the surface its
    position has an error too: on a plate where it strikes, on a crest or under a hood where it loses contact.
    """
    choked = stream.choke_share == stream.choke_share
    share = stream.choke_share if choked else stream.share
    y = stream.choke_y if choked else stream.y
    error = stream.choke_error if choked else stream.error
    chute.segment_status = state.CHOKED if choked else stream.status
    if chute.segment_status != state.STALL:
        error *= 0.5
    shift = 0.0
    if share == chute.arrival.share and chute.segment_status != state.STALL:
        error, shift = chute.arrival.error, chute.arrival.share_error
    elif chute.segment_status == state.CONTACT_LOST:
        error, shift = contact_loss_error(stream.guide, share, y, error)
    chute.end.distance = chute.entry.distance + stream.guide.length * (share - chute.arrival.share)
    chute.end.velocity = math.sqrt(y) / stream.guide.momentum_root
    placement.set_point(chute.end, segment, stream.guide, share, error, shift)


def contact_loss_error(guide: "guide_surface.Guide", share: float, y: float, error: float) -> tuple[float, float]:
    """Return the relative error of the velocity where contact is lost, n(c, y) = 0, and the error of the share."""
    slope = guide.entry_slope + guide.turn * share
    rise = motion.rhs_any_branch(guide, share, y)
    turned = -guide.side * guide.gravity * math.sin(slope) * guide.turn
    shift = flight.safe_quotient(-2.0 * error * y * guide.signed_curvature, turned + guide.signed_curvature * rise)
    return error + 0.5 * rise / y * shift, shift


def miss_segment(chute: "records.ChuteState", segment: "records.Segment") -> None:
    """Handle a flight that meets no surface of its segment: it continues to the next one, or the chute ends.

    In a closed segment the arrival says already that the stream passes inside it, or that its mouth chokes.
    """
    if chute.arrival.status == state.MISSED and segment.may_be_passed and may_be_caught(chute, segment):
        chute.arrival.status = state.PASSED
    chute.segment_status = chute.arrival.status
    records.clear_point(chute.entry)
    records.clear_point(chute.end)
    chute.impact.velocity_after = floats.NAN
    solution_rows.clear_stream(segment.stream)
    solution_rows.write_solution(chute, segment, segment.stream, 0)
    if chute.arrival.status == state.PASSED:
        chute.airborne = True
    else:
        chute.status = chute.arrival.status
        records.clear_point(chute.current)


def solve_restrikes(chute: "records.ChuteState", options: "state.SolverOptions", segment: "records.Segment") -> None:
    """Solve again where a stream that lost contact meets the same segment further on.

    It may have dropped off a hood, or been thrown off a rising crest.
    """
    for _ in range(MAX_STRIKES):
        if segment.plate or chute.segment_status != state.CONTACT_LOST:
            return
        status, airborne, before, sign = chute.status, chute.airborne, chute.count, segment.error_sign
        on_roof = segment.on_roof
        share, y = segment.stream.share, segment.stream.y
        chute.status, chute.airborne = state.OK, True
        chute.strikes += 1
        if segment.on_roof:
            closed.choose_surface(chute, segment, 0, 2)
        else:
            closed.choose_surface(chute, segment, 2, 0)
        solve_contact(chute, options, segment, segment.roots)
        if chute.segment_status >= state.MISSED:  # not caught: undo the attempt
            chute.count = before
            chute.status, chute.airborne = status, airborne
            records.copy_point(chute.current, chute.start)
            chute.segment_status, segment.error_sign = state.NOT_REACHED, sign
            segment.on_roof, segment.stream.share, segment.stream.y = on_roof, share, y
            if chute.mouth_time == chute.mouth_time:  # out of the end of a closed section
                chute.status, chute.airborne = state.OK, True
            elif segment.closed and segment.final:  # out of the mouth that it came in through, belt below or not
                chute.status, chute.airborne = state.CONTACT_LOST, False
