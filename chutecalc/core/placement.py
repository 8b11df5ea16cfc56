"""Place a segment where it is drawn or where the stream meets it, and put points on it."""

import math

from chutecalc.core import guide_surface, records, state, surface


def place_segment(chute: "records.ChuteState", segment: "records.Segment", guide: "guide_surface.Guide") -> None:
    """Set the segment's position, slope and length.

    A curve tangent to a falling stream takes the stream's slope, and its error.
    """
    tangent, has_start = segment.entry_slope != segment.entry_slope, segment.start_x == segment.start_x
    guide.x = segment.start_x if has_start else chute.drawn_x
    guide.z = segment.start_z if has_start else chute.drawn_z
    guide.entry_slope = chute.current.slope if tangent else segment.entry_slope
    guide.turn = segment.exit_slope - guide.entry_slope
    guide.length = segment.length
    if segment.radius == segment.radius:
        guide.length = segment.radius * math.fabs(guide.turn)
    segment.start_x_error = 0.0 if has_start else chute.drawn_x_error
    segment.start_z_error = 0.0 if has_start else chute.drawn_z_error
    segment.slope_error = chute.current.slope_error if tangent else 0.0
    # Points of equal slope have the error of its start, and that of the arc by which it begins later.
    longer = segment.slope_error * guide.length / -guide.turn if guide.turn != 0.0 else 0.0
    segment.arc_x_error, segment.arc_z_error = segment.start_x_error, segment.start_z_error
    if longer != 0.0:
        segment.arc_x_error += longer * math.cos(guide.entry_slope)
        segment.arc_z_error -= longer * math.sin(guide.entry_slope)
    if chute.status == state.OK:
        if tangent and (guide.turn <= 0.0 if guide.side < 0.0 else guide.turn == 0.0):
            chute.status = state.FAULT
            chute.fault_slope, chute.fault_number = guide.entry_slope, segment.number
        else:
            guide_surface.set_constants(guide)


def set_point(
    point: "records.Point",
    segment: "records.Segment",
    guide: "guide_surface.Guide",
    share: float,
    error: float,
    shift: float,
) -> None:
    """Set a point on a segment: ``error`` is relative, of the velocity; ``shift`` is the error of the share."""
    point.x, point.z = surface.point(guide, share)
    point.slope = guide.entry_slope + guide.turn * share
    point.error, point.slope_error = error, guide.turn * shift
    point.x_error, point.z_error = segment.error_sign * segment.arc_x_error, segment.error_sign * segment.arc_z_error
    if shift != 0.0:
        point.x_error += guide.length * shift * math.cos(point.slope)
        point.z_error -= guide.length * shift * math.sin(point.slope)
