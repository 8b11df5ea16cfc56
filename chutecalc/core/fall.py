"""Solve a free fall: to a level, to a distance, or onto the next segment."""

from chutecalc.core import closed, flight, floats, guide_surface, joint, placement, records, solution_rows, state

LONGEST_FALL = 2000.0  # m, as for every length: a longer fall has missed its target
MAX_FALL = 2000.001  # m, the same and rounding; a C constant if compiled, the other is for Python


def solve_fall(chute: "records.ChuteState", segment: "records.Segment") -> None:
    """Solve a free fall to a level, to a distance from the segment before, or onto the next segment."""
    records.copy_point(chute.start, chute.current)
    chute.segment_status, chute.flight_time = state.NOT_REACHED, floats.NAN
    joint.clear_arrival(chute)
    if chute.status != state.OK:
        solution_rows.skip_segment(chute, segment, segment.stream)
    elif lands_on_next(segment, segment.next):
        fall_onto_next(chute, segment, segment.next, segment.next.stream.guide)
        return
    else:
        fall_to_level(chute, segment)
    chute.drawn_x, chute.drawn_z = chute.current.x, chute.current.z
    chute.drawn_x_error, chute.drawn_z_error = chute.current.x_error, chute.current.z_error


def lands_on_next(segment: "records.Segment", next_segment: "records.Segment") -> bool:
    """Return whether a fall ends where the stream meets the next segment: that one stands at its own place."""
    return not segment.final and not next_segment.fall and next_segment.start_x == next_segment.start_x


def fall_to_level(chute: "records.ChuteState", segment: "records.Segment") -> None:
    """Solve a fall to a level or to a horizontal distance."""
    if segment.start_x == segment.start_x:
        chute.drawn_x, chute.drawn_z = segment.start_x, segment.start_z
        chute.drawn_x_error = chute.drawn_z_error = 0.0
    if chute.launch.velocity != chute.launch.velocity:
        records.copy_point(chute.launch, chute.current)
    flight.launch(chute.flight, chute.current, chute.gravity)
    if segment.drop == segment.drop:
        time = flight.time_to_drop(chute.flight, chute.current.z - chute.drawn_z + segment.drop)
    else:
        time = flight.time_to_run(chute.flight, chute.drawn_x + segment.run - chute.current.x)
    chute.segment_status = state.OK
    if not chute.flight.z - flight.z_at(chute.flight, time) <= MAX_FALL:
        chute.segment_status = chute.status = state.MISSED
        records.clear_point(chute.end)
    else:
        chute.flight_time = time
        set_flight_end(chute, time)
        flight.propagate_error(chute.flight, chute.start, time)
        if segment.drop == segment.drop:
            later = flight.safe_quotient(chute.flight.z_error - chute.drawn_z_error, chute.flight.downward_now)
        else:
            later = flight.safe_quotient(chute.drawn_x_error - chute.flight.x_error, chute.flight.forward)
        flight.shift_error(chute.flight, later, chute.end)
    records.copy_point(chute.entry, chute.end)
    records.copy_point(chute.current, chute.end)
    chute.airborne, chute.on_roof, chute.mouth_time = False, False, floats.NAN
    solution_rows.write_solution(chute, segment, segment.stream, 0)


def set_flight_end(chute: "records.ChuteState", time: float) -> None:
    """Set ``end`` to the stream after a time of flight, without its errors."""
    chute.arrival.distance = flight.path_length(chute.flight, time)
    chute.end.distance = chute.start.distance + chute.arrival.distance
    flight.set_point(chute.flight, time, chute.end)


def fall_onto_next(
    chute: "records.ChuteState",
    segment: "records.Segment",
    next_segment: "records.Segment",
    guide: "guide_surface.Guide",
) -> None:
    """Solve a fall onto the next segment; a stream that misses it flies on from where this flight began."""
    chute.airborne = True
    placement.place_segment(chute, next_segment, guide)
    if chute.status != state.OK:
        return
    closed.choose_surface(chute, next_segment, 0, 0)
    if not chute.already_landed:
        if next_segment.on_roof:
            joint.meet_segment(chute, next_segment, next_segment.roof.guide, next_segment.roots)
        else:
            joint.meet_segment(chute, next_segment, guide, next_segment.roots)
    chute.already_landed = True
    records.clear_point(chute.end)
    if chute.arrival.status <= state.STALL:
        chute.segment_status, chute.flight_time = state.OK, chute.arrival.time
        records.copy_point(chute.end, chute.entry)  # its errors
        set_flight_end(chute, chute.arrival.time)
        records.copy_point(chute.current, chute.end)
    records.copy_point(chute.entry, chute.end)
    solution_rows.write_solution(chute, segment, segment.stream, 0)
