"""Land the stream on the receiving belt."""

import math

from chutecalc.core import fall, flight, floats, joint, records, state, surface


def land_on_belt(chute: "records.ChuteState") -> None:
    """Write the stream where it lands on the receiving belt; a stream that never meets its line has missed it.

    A belt without a place is where the last segment ends.
    """
    records.copy_point(chute.landing, chute.current)
    if chute.status != state.OK:
        records.clear_point(chute.landing)
    elif chute.belt_x == chute.belt_x:
        flight.launch(chute.flight, chute.current, chute.gravity)
        time = time_to_line(chute.flight, chute.belt_x, chute.belt_z, chute.belt_slope)
        if chute.flight.z - flight.z_at(chute.flight, time) <= fall.MAX_FALL:
            flight.set_point(chute.flight, time, chute.landing)
        else:
            records.clear_point(chute.landing)
            chute.status = state.MISSED


def belt_clearance(chute: "records.ChuteState") -> float:
    """Return the least height of the drawn surfaces above the receiving belt, m; NaN without a belt that has a place.

    For a stream that gets through: then all segments are placed.
    """
    if chute.status != state.OK or chute.belt_x != chute.belt_x:
        return floats.NAN
    return least_from(chute, chute.first, floats.INFINITY)


def least_from(chute: "records.ChuteState", segment: "records.Segment", least: float) -> float:
    """Return the least height of a segment and all that follow it; infinite where none has a surface."""
    if not segment.fall:
        height = surface.least_height(segment.stream.guide, chute.belt_x, chute.belt_z, chute.belt_slope)
        least = min(least, height)
    return least if segment.final else least_from(chute, segment.next, least)


def time_to_line(path: "records.Flight", x: float, z: float, slope: float) -> float:
    """Return when a flight meets a line from above, s; NaN for one that begins below it.

    The height above the line is h + w t - (g/2) cos b t², and the root is taken in the form that does not cancel. A
    stream that begins on the line, but for rounding, lands there.
    """
    sine, cosine = math.sin(slope), math.cos(slope)
    height = (path.x - x) * sine + (path.z - z) * cosine
    rise = path.forward * sine - path.downward * cosine
    if math.fabs(height) <= joint.START_TOLERANCE:
        height = 0.0
    root = floats.root(rise * rise + 2.0 * path.gravity * cosine * height)
    if height < 0.0:
        return floats.NAN
    if rise < 0.0:
        return 2.0 * height / (root - rise)
    return (rise + root) / (path.gravity * cosine)
