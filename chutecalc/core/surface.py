"""Describe a guiding surface as a line, straight or circular, and find where a flight meets it."""

import math

from chutecalc.core import flight, floats, guide_surface, quartic, records

END_TOLERANCE = 1e-12  # of its length and of the way to it: a flight meets a segment this far beyond its ends
REFINEMENT = 1e-6  # of a time: the polynomial's root is off by less


def point(guide: "guide_surface.Guide", share: float) -> tuple[float, float]:
    """Return x and z at a share of the length, m.

    The chord of an arc that turns by b over a length s is s sin(b/2)/(b/2) long and lies halfway between the end
    slopes; unlike (sin a0 - sin a)/κ this keeps its digits down to a straight.
    """
    if share == 0.0:
        return guide.x, guide.z
    half = 0.5 * guide.turn * share
    chord = guide.length * share * (math.sin(half) / half if half != 0.0 else 1.0)
    middle = guide.entry_slope + half
    return guide.x + chord * math.cos(middle), guide.z - chord * math.sin(middle)


def least_height(guide: "guide_surface.Guide", x: float, z: float, slope: float) -> float:
    """Return the least height of a surface above a line through a point, m, normal to the line; negative below it.

    Along the surface the height changes by sin(b - a), b the slope of the line: least at an end, or where an arc is
    parallel to the line.
    """
    sine, cosine = math.sin(slope), math.cos(slope)
    least = (guide.x - x) * sine + (guide.z - z) * cosine
    end_x, end_z = point(guide, 1.0)
    least = min(least, (end_x - x) * sine + (end_z - z) * cosine)
    if guide.turn != 0.0:
        share = (slope - guide.entry_slope) / guide.turn
        if 0.0 < share < 1.0:
            end_x, end_z = point(guide, share)
            least = min(least, (end_x - x) * sine + (end_z - z) * cosine)
    return least


def land(
    guide: "guide_surface.Guide", path: "records.Flight", curve: "quartic.Quartic", known_roots: int
) -> tuple[float, float, float]:
    """Return where a flight first meets a surface from the stream's side: time, share of the length and slope there.

    With D the vector from the surface's start, n its normal there and κ the curvature, σ (D·n - κ |D|²/2) is positive
    on the stream's side and 0 on the full line or circle: a polynomial of degree 4 in time. The first time at which it
    falls through 0 on the drawn part counts; NaN where there is none. A flight out of a closed segment before it may
    meet it before its drawn start, in the mitre of both.

    Args:
        guide, path, curve: the segment, the flight, and a work record.
        known_roots: how many roots at time 0 are known and divided out: 1 where the flight starts on the surface, 2
            where it starts along it.
    """
    clearance(guide, path, curve)
    for k in range(5):
        curve.value[k] = curve.value[k + known_roots] if k + known_roots < 5 else 0.0
    lowest = guide.z - guide.length
    horizon = flight.time_to_drop(path, max(path.z - lowest, 0.0))
    beyond = END_TOLERANCE * (1.0 + (math.fabs(guide.x - path.x) + math.fabs(guide.z - path.z)) / guide.length)
    for k in range(quartic.falls_through_zero(curve, horizon)):
        time = refined(guide, path, curve.falls[k])
        share, slope = foot(guide, path, time)
        if share > 1.0 + beyond or time < path.since:
            continue
        if share >= -beyond:
            return time, min(max(share, 0.0), 1.0), slope
        if path.since == path.since:
            return time, share, slope
    return floats.NAN, floats.NAN, floats.NAN


def refined(guide: "guide_surface.Guide", path: "records.Flight", time: float) -> float:
    """Return the time at which a flight meets the full line or circle, as well as its place is known then.

    The polynomial holds squares of the whole way, whose rounding is large beside a small arc far below. Near the
    surface they are small, and Newton's method starts from the polynomial's root.
    """
    sine, cosine = math.sin(guide.entry_slope), math.cos(guide.entry_slope)
    bend = -0.5 * guide.turn / guide.length
    for _ in range(2):
        dx, dz = flight.x_at(path, time) - guide.x, flight.z_at(path, time) - guide.z
        u, w = path.forward, -path.downward - path.gravity * time
        off = dx * sine + dz * cosine - bend * (dx * dx + dz * dz)
        step = floats.quotient(off, u * sine + w * cosine - 2.0 * bend * (dx * u + dz * w))
        if not math.fabs(step) < REFINEMENT * time:  # it grazes the surface
            break
        time -= step
    return time


def clearance(guide: "guide_surface.Guide", path: "records.Flight", curve: "quartic.Quartic") -> None:
    """Write the coefficients of σ (D·n - κ |D|²/2) in rising powers of time."""
    sine, cosine = math.sin(guide.entry_slope), math.cos(guide.entry_slope)
    dx, dz, half_g = path.x - guide.x, path.z - guide.z, 0.5 * path.gravity
    u, w = path.forward, -path.downward
    bend = -0.5 * guide.turn / guide.length
    curve.value[0] = guide.side * (dx * sine + dz * cosine - bend * (dx * dx + dz * dz))
    curve.value[1] = guide.side * (u * sine + w * cosine - bend * 2.0 * (dx * u + dz * w))
    curve.value[2] = guide.side * (-half_g * cosine - bend * (u * u + w * w - 2.0 * dz * half_g))
    curve.value[3] = guide.side * (bend * 2.0 * w * half_g)
    curve.value[4] = guide.side * (-bend * half_g * half_g)


def foot(guide: "guide_surface.Guide", path: "records.Flight", time: float) -> tuple[float, float]:
    """Return share and slope of the full line or circle at the point that the flight reaches at a time."""
    dx, dz = flight.x_at(path, time) - guide.x, flight.z_at(path, time) - guide.z
    sine, cosine = math.sin(guide.entry_slope), math.cos(guide.entry_slope)
    if guide.turn == 0.0:
        return (dx * cosine - dz * sine) / guide.length, guide.entry_slope
    bend = -guide.turn / guide.length
    slope = math.atan2(sine - bend * dx, cosine - bend * dz)
    return (slope - guide.entry_slope) / guide.turn, slope


def crossing_time(guide: "guide_surface.Guide", path: "records.Flight", share: float) -> float:
    """Return when a flight crosses the normal of a surface at a share of its length, s; NaN if it does not.

    A flight that begins on the normal, but for rounding, crosses it there.
    """
    slope = guide.entry_slope + guide.turn * share
    x, z = point(guide, share)
    sine, cosine = math.sin(slope), math.cos(slope)
    start = (path.x - x) * cosine - (path.z - z) * sine  # along the surface
    if math.fabs(start) <= END_TOLERANCE * guide.length:
        start = 0.0
    speed = path.forward * cosine + path.downward * sine
    pull = 0.5 * path.gravity * sine
    root = floats.root(speed * speed - 4.0 * pull * start)
    time = floats.quotient(-2.0 * start, speed + root)
    return time if time >= 0.0 else floats.NAN


def gap_at(guide: "guide_surface.Guide", path: "records.Flight", share: float) -> float:
    """Return how far from the surface a flight crosses the normal at a share of its length, m; NaN if it does not.

    It is positive on the stream's side.
    """
    time = crossing_time(guide, path, share)
    slope = guide.entry_slope + guide.turn * share
    x, z = point(guide, share)
    sine, cosine = math.sin(slope), math.cos(slope)
    return guide.side * ((flight.x_at(path, time) - x) * sine + (flight.z_at(path, time) - z) * cosine)
