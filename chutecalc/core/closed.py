"""Closed sections: a segment with a roof opposite to the surface that is drawn, and which of both a stream meets.

The roof is parallel to the drawn surface at the height of the section, or leads from the height at its start to that at
its end. The stream on it is that on a hood, with the section turned over.
"""

import math

from chutecalc.core import events, flight, floats, guide_surface, joint, quartic, records, state, surface


def choose_surface(chute: "records.ChuteState", segment: "records.Segment", own_roots: int, roof_roots: int) -> None:
    """Choose the surface of a segment that the stream meets first, and set ``on_roof`` and ``roots``.

    A stream that does not come in through the mouth has missed the segment; one that touches neither surface flies
    through it.

    Args:
        chute: a stream in motion.
        segment: as placed.
        own_roots, roof_roots: how many roots at time 0 of the flight lie on the drawn surface, and on the roof.
    """
    inside = own_roots > 0 or roof_roots > 0
    since = chute.mouth_time
    chute.mouth_time = chute.flight.since = floats.NAN
    segment.on_roof, segment.roots = False, own_roots
    if not segment.closed or chute.status != state.OK:
        chute.airborne = chute.airborne or chute.on_roof  # what ran on a roof falls onto an open chute
        return
    if not inside:
        place_roof(segment, segment.stream.guide, segment.roof.guide)
    if not chute.airborne and chute.on_roof:
        chute.airborne = not meets_roof(chute, segment.roof.guide)
        segment.on_roof, since = not chute.airborne, 0.0
        if segment.on_roof and runs_on(chute, segment.roof.guide):
            return
        roof_roots = 1 if segment.on_roof else 0
    elif not chute.airborne:
        if runs_on(chute, segment.stream.guide):
            return
        own_roots = 1
    flight.launch(chute.flight, chute.current, chute.gravity)
    if chute.airborne and not inside and joint.through_start(chute, segment.stream.guide) >= 0.0:
        return
    chute.airborne, segment.on_roof = True, False
    if not inside and not enters(chute, segment, segment.stream.guide, since):
        leave_out(chute, segment, state.MISSED)
        return
    if not inside and overfills(chute, segment.stream.guide, 0.0):
        leave_out(chute, segment, state.CHOKED)
        return
    own, _, _ = surface.land(segment.stream.guide, chute.flight, chute.clearance, own_roots)
    roof, _, _ = surface.land(segment.roof.guide, chute.flight, chute.clearance, roof_roots)
    segment.on_roof = roof < own or own != own
    segment.roots = roof_roots if segment.on_roof else own_roots
    if own != own and roof != roof:
        fly_out(chute, segment, segment.stream.guide)


def place_roof(segment: "records.Segment", own: "guide_surface.Guide", roof: "guide_surface.Guide") -> None:
    """Place the roof opposite to the drawn surface: the line or the arc of the same turn between the two mouths.

    For a section that does not taper this is the arc about the same centre.
    """
    height, last = own.side * own.first.wall_height, own.side * own.last.wall_height
    roof.x = own.x + height * math.sin(own.entry_slope)
    roof.z = own.z + height * math.cos(own.entry_slope)
    half = 0.5 * own.turn
    chord = math.sin(half) / half if half != 0.0 else 1.0  # over the length
    along = chord * (own.length + half * (height + last))  # from mouth to mouth, in the direction of the drawn chord
    across = (last - height) * math.cos(half)
    roof.entry_slope, roof.turn = own.entry_slope - math.atan2(across, along), own.turn
    roof.length = math.hypot(along, across) / chord
    guide_surface.set_constants(roof)


def runs_on(chute: "records.ChuteState", guide: "guide_surface.Guide") -> bool:
    """Return whether a stream at the start of a surface goes along it or into it."""
    return guide.side * (chute.current.slope - guide.entry_slope) >= -joint.TANGENT


def meets_roof(chute: "records.ChuteState", roof: "guide_surface.Guide") -> bool:
    """Return whether a stream that ends on a roof is where this one begins."""
    return math.hypot(chute.current.x - roof.x, chute.current.z - roof.z) <= MOUTH_TOLERANCE


def enters(chute: "records.ChuteState", segment: "records.Segment", own: "guide_surface.Guide", since: float) -> bool:
    """Return whether a flight comes in through the mouth, between the drawn surface and the roof.

    Two closed segments that meet at a kink are mitred: a stream that comes out of the first between the walls of the
    other, drawn on backwards, is in it.

    Args:
        chute: a stream in flight; ``flight.since`` is set.
        segment, own: as placed.
        since: when the flight comes out of the closed segment before, s; NaN if it does not.
    """
    mitred = math.hypot(chute.drawn_x - own.x, chute.drawn_z - own.z) <= MOUTH_TOLERANCE
    if mitred and is_above(chute, own, since) and is_above(chute, segment.roof.guide, since):
        chute.flight.since = since
        return True
    gap = surface.gap_at(own, chute.flight, 0.0)
    return gap >= -MOUTH_TOLERANCE and gap <= own.first.wall_height + MOUTH_TOLERANCE


def is_above(chute: "records.ChuteState", guide: "guide_surface.Guide", time: float) -> bool:
    """Return whether a flight is on the stream's side of a surface at a time; not at NaN."""
    surface.clearance(guide, chute.flight, chute.clearance)
    return quartic.value_at(chute.clearance.value, 4, time) >= -MOUTH_TOLERANCE


def fly_out(chute: "records.ChuteState", segment: "records.Segment", own: "guide_surface.Guide") -> None:
    """Write the arrival of a flight that touches neither wall: it comes out at the end, or falls back out of the mouth.

    It may have come out of the closed segment before when it was beyond the end of this one, if that is short.
    """
    share, _ = surface.foot(own, chute.flight, chute.flight.since)
    gap = surface.gap_at(own, chute.flight, 1.0)
    if overfills(chute, own, 1.0):
        leave_out(chute, segment, state.CHOKED)
    elif share > 1.0 or (gap >= -MOUTH_TOLERANCE and gap <= own.last.wall_height + MOUTH_TOLERANCE):
        leave_out(chute, segment, state.PASSED)
        chute.mouth_time = chute.flight.since if share > 1.0 else surface.crossing_time(own, chute.flight, 1.0)
    else:
        leave_out(chute, segment, state.MISSED)


def overfills(chute: "records.ChuteState", own: "guide_surface.Guide", share: float) -> bool:
    """Return whether a flight needs more than the whole closed section where it passes a share of a segment."""
    velocity = flight.velocity_at(chute.flight, surface.crossing_time(own, chute.flight, share))
    return own.momentum_root * velocity * guide_surface.choke_area(own, share) < own.flow * (
        1.0 - events.EVENT_TOLERANCE
    )


def leave_out(chute: "records.ChuteState", segment: "records.Segment", status: int) -> None:
    """Write the arrival of a flight that touches neither surface."""
    joint.miss_segment(chute, segment.stream.guide)
    chute.arrival.status = status
    chute.arrival.time = floats.NAN
    chute.already_landed = True


def fly_to_mouth(chute: "records.ChuteState") -> None:
    """Carry a stream that flies inside the last segment on to the mouth at its end."""
    flight.launch(chute.flight, chute.current, chute.gravity)
    time = chute.mouth_time
    chute.current.distance += flight.path_length(chute.flight, time)
    flight.set_point(chute.flight, time, chute.current)


MOUTH_TOLERANCE = 1e-9
"""Distance by which a stream may be off the edge of a mouth, m: that of joints which have been rounded."""
