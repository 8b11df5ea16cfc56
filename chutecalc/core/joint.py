"""Bring a stream onto a contact segment: along it, by an impact, or by a flight that lands further on.

Small errors of the stream are carried along to first order: a stream that leaves an edge a little faster lands further
on, at another slope, and may strike harder or less hard. On the surface they become one error, that of the velocity at
a fixed position.
"""

import math

from chutecalc.core import flight, floats, guide_surface, impact, motion, records, state, surface

TANGENT = TANGENT_ANGLE = 1e-6 * math.pi / 180.0  # the second is for Python
"""Directions closer than this are equal: the stream passes on unchanged."""
START_TOLERANCE, START_ERRORS = 1e-11, 4.0  # m, the rounding of a place; and times the stream's own error
PERTURBATION = 1e-6
"""Relative perturbation by which an impact is differenced."""


def meet_segment(
    chute: "records.ChuteState", segment: "records.Segment", guide: "guide_surface.Guide", known_roots: int
) -> None:
    """Find how the stream meets the segment, at its start or where a flight lands; write ``arrival`` and ``impact``.

    The status is ``STALL`` where the impact leaves no velocity, and ``MISSED`` where a flight finds no surface.

    Args:
        chute: a stream in motion, airborne or at the segment's drawn start.
        segment, guide: the segment as placed.
        known_roots: how many roots at time 0 of an airborne stream's flight lie on this very surface.
    """
    turn = guide.side * (chute.current.slope - guide.entry_slope)  # > 0: into the surface
    flight.launch(chute.flight, chute.current, guide.gravity)
    records.copy_point(chute.entry, chute.current)  # for its errors
    chute.arrival.time = chute.arrival.distance = chute.arrival.share = chute.arrival.share_error = 0.0
    chute.arrival.gap = floats.NAN
    chute.arrival.velocity, chute.arrival.incidence = chute.current.velocity, max(turn, 0.0)
    if chute.airborne or turn < -TANGENT:
        at_start = through_start(chute, guide) if chute.airborne and known_roots == 0 else floats.NAN
        time, share, slope = at_start, 0.0, guide.entry_slope
        if at_start != at_start:
            roots = known_roots if chute.airborne else 1
            time, share, slope = surface.land(guide, chute.flight, chute.clearance, roots)
        chute.arrival.time, chute.arrival.share = time, share
        if time != time:
            miss_segment(chute, guide)
            return
        chute.arrival.distance = flight.path_length(chute.flight, time)
        chute.arrival.velocity = flight.velocity_at(chute.flight, time)
        chute.arrival.incidence = guide.side * (flight.slope_at(chute.flight, time) - slope)
        if at_start != at_start:
            flight.propagate_error(chute.flight, chute.current, time)
            chute.arrival.share_error = landing_error(chute, segment, guide, slope)
    if chute.arrival.incidence <= TANGENT:
        chute.arrival.incidence = 0.0
    impact.compute_impact(chute.impact, guide, chute.arrival.share, chute.arrival.velocity, chute.arrival.incidence)
    impact_error(chute, segment, guide)
    chute.arrival.status = state.OK if chute.impact.velocity_after > 0.0 else state.STALL


def through_start(chute: "records.ChuteState", guide: "guide_surface.Guide") -> float:
    """Return when a flight passes through the drawn start of a segment, into it or along it; NaN where it does not.

    A surface drawn tangent to the stream at its start is a double root of the landing, which rounding may miss. So a
    stream within its own error of the start passes through it.
    """
    time, distance = flight.passage(chute.flight, guide.x, guide.z)
    if not distance < floats.INFINITY:
        return floats.NAN
    flight.propagate_error(chute.flight, chute.current, time)
    flight.shift_error(chute.flight, flight.delay(chute.flight), chute.entry)
    off = START_TOLERANCE + START_ERRORS * (math.fabs(chute.flight.x_error) + math.fabs(chute.flight.z_error))
    turned = TANGENT + START_ERRORS * math.fabs(chute.entry.slope_error)
    outward = guide.side * (guide.entry_slope - flight.slope_at(chute.flight, time))
    return time if distance <= off and outward <= turned else floats.NAN


def miss_segment(chute: "records.ChuteState", guide: "guide_surface.Guide") -> None:
    """Write the arrival of a flight that does not meet the segment."""
    chute.arrival.gap = surface.gap_at(guide, chute.flight, 1.0)
    chute.arrival.status = state.MISSED
    chute.arrival.distance = chute.arrival.velocity = chute.arrival.incidence = floats.NAN
    chute.arrival.error = chute.arrival.share_error = floats.NAN
    impact.compute_impact(chute.impact, guide, 0.0, floats.NAN, 0.0)


def clear_arrival(chute: "records.ChuteState") -> None:
    """Write the arrival of a stream that does not exist."""
    chute.arrival.status = state.NOT_REACHED
    chute.arrival.time = chute.arrival.distance = chute.arrival.share = chute.arrival.velocity = floats.NAN
    chute.arrival.incidence = chute.arrival.gap = chute.impact.velocity_after = floats.NAN
    chute.impact.footprint = chute.impact.pressure = chute.impact.stress = chute.impact.wear = floats.NAN
    chute.impact.wall_friction = chute.impact.friction = floats.NAN
    chute.flight.x = chute.flight.z = chute.flight.forward = chute.flight.downward = floats.NAN
    chute.flight.gravity = chute.gravity


def landing_error(
    chute: "records.ChuteState", segment: "records.Segment", guide: "guide_surface.Guide", slope: float
) -> float:
    """Write the errors of the stream where it lands to ``entry``; return that of the share."""
    sine, cosine = math.sin(slope), math.cos(slope)
    normal_error = (chute.flight.x_error - segment.start_x_error) * sine + (
        chute.flight.z_error - segment.start_z_error
    ) * cosine
    closing_velocity = chute.flight.forward * sine - chute.flight.downward_now * cosine
    flight.shift_error(chute.flight, flight.safe_quotient(-normal_error, closing_velocity), chute.entry)
    tangential_error = (chute.entry.x_error - segment.start_x_error) * cosine - (
        chute.entry.z_error - segment.start_z_error
    ) * sine
    return tangential_error / guide.length


def impact_error(chute: "records.ChuteState", segment: "records.Segment", guide: "guide_surface.Guide") -> None:
    """Write the errors of the velocity left and of the share, from those of the arriving stream.

    Friction changes with depth, pressure and position: the impact of a slightly perturbed stream tells how. A tangent
    arc that begins at another slope is the same arc begun elsewhere.
    """
    velocity_error, angle_error, share_shift = (
        chute.entry.error,
        chute.entry.slope_error - segment.slope_error,
        chute.arrival.share_error,
    )
    chute.arrival.error = velocity_error
    if guide.turn != 0.0:
        chute.arrival.share_error += segment.slope_error / guide.turn
        share_shift = chute.arrival.share_error
    strikes = chute.arrival.incidence > 0.0 and (
        velocity_error != 0.0 or chute.entry.slope_error != 0.0 or share_shift != 0.0
    )
    if not strikes:
        return
    angle_error = guide.side * (angle_error - guide.turn * share_shift)
    size = max(
        math.fabs(velocity_error),
        math.fabs(angle_error) / max(chute.arrival.incidence, PERTURBATION),
        math.fabs(share_shift),
    )
    if not size > 0.0:
        chute.arrival.error = 0.0
        return
    scale = PERTURBATION / size
    impact.compute_impact(
        chute.perturbed,
        guide,
        chute.arrival.share + scale * share_shift,
        chute.arrival.velocity * (1.0 + scale * velocity_error),
        chute.arrival.incidence + scale * angle_error,
    )
    after = chute.impact.velocity_after if chute.impact.velocity_after > 0.0 else floats.INFINITY
    chute.arrival.error = (chute.perturbed.velocity_after - chute.impact.velocity_after) / scale / after


def entry_error(chute: "records.ChuteState", guide: "guide_surface.Guide") -> float:
    """Return the relative error of the velocity where a stream enters, or of the share if the impact stops it.

    Its sign is that of the errors of the segment's own position.
    """
    if chute.impact.velocity_after == 0.0:
        return chute.arrival.share_error
    if chute.arrival.share_error == 0.0:
        return chute.arrival.error
    y = squared(guide, chute.impact.velocity_after)
    rise = 0.5 * motion.rhs_any_branch(guide, chute.arrival.share, y) / y
    return chute.arrival.error - rise * chute.arrival.share_error


def squared(guide: "guide_surface.Guide", velocity: float) -> float:
    """Return y = α_m v² of a stream on a surface."""
    scaled = guide.momentum_root * velocity
    return scaled * scaled
