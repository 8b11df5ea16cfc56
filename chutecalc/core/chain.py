"""Carry a stream through a chute, segment by segment.

:func:`solve_from` solves a segment and those after it, and writes a solution for each: how the stream arrived, what
happened where it met the segment, where it left it and in what state. Where a stream fails, the segments that follow
are placed but not solved.
"""

import math

from chutecalc.core import closed, contact, fall, floats, placement, records, state, surface


def start_at_inlet(chute: "records.ChuteState") -> None:
    """Put the stream at the inlet; a stream at rest points straight down."""
    records.copy_point(chute.current, chute.inlet)
    chute.status, chute.airborne, chute.already_landed, chute.strikes = state.OK, False, False, 0
    chute.on_roof, chute.mouth_time = False, floats.NAN
    if not chute.inlet.velocity > 0.0:
        chute.current.slope = 0.5 * math.pi
    records.clear_point(chute.launch)
    chute.drawn_x, chute.drawn_z = chute.current.x, chute.current.z
    chute.drawn_x_error = chute.drawn_z_error = chute.error = 0.0
    # Steel that stands still: a stream from a belt of another velocity comes to it through the air.
    chute.airborne = chute.first.start_x == chute.first.start_x and not chute.first.fall
    chute.saved_status = state.FAULT  # until the stream gets to where designs differ


def solve_from(chute: "records.ChuteState", options: "state.SolverOptions", segment: "records.Segment") -> None:
    """Solve a segment and all that follow it."""
    if segment.number == chute.first_varied.number:
        save_start(chute)
    if segment.fall:
        fall.solve_fall(chute, segment)
    else:
        if not chute.already_landed:
            placement.place_segment(chute, segment, segment.stream.guide)
            closed.choose_surface(chute, segment, 0, 0)
        contact.solve_contact(chute, options, segment, segment.roots)
        contact.solve_restrikes(chute, options, segment)
        chute.strikes = 0
        chute.on_roof = segment.on_roof and not chute.airborne
        if not segment.final:
            chute.drawn_x, chute.drawn_z = surface.point(segment.stream.guide, 1.0)
            chute.drawn_x_error, chute.drawn_z_error = (
                segment.error_sign * segment.arc_x_error,
                segment.error_sign * segment.arc_z_error,
            )
    if not segment.final and chute.status >= state.OK:
        solve_from(chute, options, segment.next)


def save_start(chute: "records.ChuteState") -> None:
    """Save the state of the stream where the designs of a batch begin to differ."""
    records.copy_point(chute.saved, chute.current)
    records.copy_point(chute.saved_launch, chute.launch)
    chute.saved_status, chute.saved_airborne, chute.saved_on_roof = chute.status, chute.airborne, chute.on_roof
    chute.saved_mouth_time = chute.mouth_time
    chute.saved_x, chute.saved_z = chute.drawn_x, chute.drawn_z
    chute.saved_x_error, chute.saved_z_error = chute.drawn_x_error, chute.drawn_z_error
    chute.saved_error = chute.error


def restore_start(chute: "records.ChuteState") -> None:
    """Restore the state of the stream where the designs of a batch begin to differ."""
    records.copy_point(chute.current, chute.saved)
    records.copy_point(chute.launch, chute.saved_launch)
    chute.status, chute.airborne, chute.already_landed, chute.strikes = (
        chute.saved_status,
        chute.saved_airborne,
        False,
        0,
    )
    chute.on_roof, chute.mouth_time = chute.saved_on_roof, chute.saved_mouth_time
    chute.drawn_x, chute.drawn_z = chute.saved_x, chute.saved_z
    chute.drawn_x_error, chute.drawn_z_error = chute.saved_x_error, chute.saved_z_error
    chute.error = chute.saved_error
