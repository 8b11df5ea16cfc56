"""Write the solutions of segments to the buffer, a row each."""

import math

from chutecalc.core import floats, joint, records, state


def write_solution(
    chute: "records.ChuteState", segment: "records.Segment", stream: "state.Stream", panel_count: int
) -> None:
    """Append the segment's solution to the buffer."""
    if chute.segment_status < state.MISSED and chute.end.error == chute.end.error:
        chute.error = math.fabs(chute.end.error)
    if chute.ends_only:
        return
    if chute.count >= chute.capacity:
        chute.full = True
        return
    at = records.SOLUTION_SIZE * chute.count
    chute.solutions[at], chute.solutions[at + 1] = chute.row, segment.number
    chute.solutions[at + 2], chute.solutions[at + 3] = chute.strikes, chute.segment_status
    records.write_point(chute.solutions, at + 4, chute.start)
    records.write_point(chute.solutions, at + 13, chute.entry)
    records.write_point(chute.solutions, at + 22, chute.end)
    chute.solutions[at + 31], chute.solutions[at + 32] = chute.flight.x, chute.flight.z
    chute.solutions[at + 33], chute.solutions[at + 34] = chute.flight.forward, chute.flight.downward
    chute.solutions[at + 35] = chute.flight.gravity
    chute.solutions[at + 36] = chute.flight_time
    chute.solutions[at + 37], chute.solutions[at + 38] = stream.guide.x, stream.guide.z
    chute.solutions[at + 39], chute.solutions[at + 40] = stream.guide.entry_slope, stream.guide.turn
    chute.solutions[at + 41], chute.solutions[at + 42] = stream.guide.length, stream.guide.side
    chute.solutions[at + 43], chute.solutions[at + 44] = chute.arrival.distance, chute.arrival.share
    chute.solutions[at + 45], chute.solutions[at + 46] = chute.arrival.velocity, chute.arrival.incidence
    chute.solutions[at + 47], chute.solutions[at + 48] = chute.arrival.gap, chute.arrival.status
    chute.solutions[at + 49], chute.solutions[at + 50] = chute.impact.footprint, chute.impact.pressure
    chute.solutions[at + 51], chute.solutions[at + 52] = chute.impact.stress, chute.impact.wall_friction
    chute.solutions[at + 53], chute.solutions[at + 54] = chute.impact.friction, chute.impact.velocity_after
    chute.solutions[at + 55] = chute.impact.wear
    choked = stream.choke_share == stream.choke_share
    chute.solutions[at + 56] = stream.choke_share if choked else stream.share
    chute.solutions[at + 57] = stream.choke_y if choked else stream.y
    chute.solutions[at + 58] = stream.share if choked else floats.NAN
    chute.solutions[at + 59], chute.solutions[at + 60], chute.solutions[at + 61] = (
        stream.status,
        stream.attempts,
        panel_count,
    )
    chute.count += 1


def skip_segment(chute: "records.ChuteState", segment: "records.Segment", stream: "state.Stream") -> None:
    """Write an empty solution for a segment that the stream does not reach."""
    records.clear_point(chute.start)
    records.clear_point(chute.entry)
    records.clear_point(chute.end)
    records.clear_point(chute.current)
    joint.clear_arrival(chute)
    clear_stream(stream)
    write_solution(chute, segment, stream, 0)


def clear_stream(stream: "state.Stream") -> None:
    """Forget a stream that an earlier design had on a segment; on which of its surfaces this one would be is open."""
    stream.share = stream.y = stream.choke_share = floats.NAN
    stream.attempts = 0
