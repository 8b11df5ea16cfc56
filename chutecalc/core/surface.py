"""The guiding surface of a segment as a line: straight or a circular arc, and where a flight meets it."""

import math

from chutecalc.core import flight, floats, quartic, records, slide

ON_IT = 1e-12  # of its length: so far beyond its ends a flight still meets a segment


def point(way: "slide.Slide", place: float) -> tuple[float, float]:
    """X and z at a share of the length, m.

    The chord of an arc that turns by b over a length s is s sin(b/2)/(b/2) long and lies halfway between the end
    slopes; unlike (sin a0 - sin a)/κ this holds its digits down to a straight.
    """
    if place == 0.0:
        return way.x, way.z
    half = 0.5 * way.turn * place
    chord = way.length * place * (math.sin(half) / half if half != 0.0 else 1.0)
    middle = way.entry_slope + half
    return way.x + chord * math.cos(middle), way.z - chord * math.sin(middle)


def land(
    way: "slide.Slide", path: "records.Flight", curve: "quartic.Quartic", known: int
) -> tuple[float, float, float]:
    """Where a flight first meets a surface from the stream's side: time, share of the length and slope there.

    With D the vector from the surface's start, n its normal there and κ the curvature, σ (D·n - κ |D|²/2) is positive
    on the stream's side and 0 on the full line or circle: a polynomial of degree 4 in time. The first of its falls
    through 0 that lies on the drawn part counts. Not numbers where there is none.

    Args:
        way, path, curve: the segment, the flight, and room to work.
        known: how many roots at time 0 are known and taken out: 1 where the flight starts on the surface, 2 where it
            starts along it.
    """
    clearance(way, path, curve)
    for k in range(5):
        curve.value[k] = curve.value[k + known] if k + known < 5 else 0.0
    lowest = way.z - way.length
    horizon = flight.time_to_drop(path, max(path.z - lowest, 0.0))
    for k in range(quartic.falls_through_zero(curve, horizon)):
        time = curve.falls[k]
        place, slope = foot(way, path, time)
        if place >= -ON_IT and place <= 1.0 + ON_IT:
            return time, min(max(place, 0.0), 1.0), slope
    return floats.NAN, floats.NAN, floats.NAN


def clearance(way: "slide.Slide", path: "records.Flight", curve: "quartic.Quartic") -> None:
    """Coefficients of σ (D·n - κ |D|²/2) in rising powers of time."""
    sine, cosine = math.sin(way.entry_slope), math.cos(way.entry_slope)
    dx, dz, half_g = path.x - way.x, path.z - way.z, 0.5 * path.gravity
    u, w = path.forward, -path.downward
    bend = -0.5 * way.turn / way.length
    curve.value[0] = way.side * (dx * sine + dz * cosine - bend * (dx * dx + dz * dz))
    curve.value[1] = way.side * (u * sine + w * cosine - bend * 2.0 * (dx * u + dz * w))
    curve.value[2] = way.side * (-half_g * cosine - bend * (u * u + w * w - 2.0 * dz * half_g))
    curve.value[3] = way.side * (bend * 2.0 * w * half_g)
    curve.value[4] = way.side * (-bend * half_g * half_g)


def foot(way: "slide.Slide", path: "records.Flight", time: float) -> tuple[float, float]:
    """Share of the length, and slope, of the full line or circle at the point that the flight reaches at a time."""
    dx, dz = flight.x_at(path, time) - way.x, flight.z_at(path, time) - way.z
    sine, cosine = math.sin(way.entry_slope), math.cos(way.entry_slope)
    if way.turn == 0.0:
        return (dx * cosine - dz * sine) / way.length, way.entry_slope
    bend = -way.turn / way.length
    slope = math.atan2(sine - bend * dx, cosine - bend * dz)
    return (slope - way.entry_slope) / way.turn, slope


def gap_at_end(way: "slide.Slide", path: "records.Flight") -> float:
    """How far from the surface's end the flight crosses the normal through it, m, positive on the stream's side."""
    slope = way.entry_slope + way.turn
    x_end, z_end = point(way, 1.0)
    sine, cosine = math.sin(slope), math.cos(slope)
    start = (path.x - x_end) * cosine - (path.z - z_end) * sine  # along the surface, from its end
    speed = path.forward * cosine + path.downward * sine
    pull = 0.5 * path.gravity * sine
    root = floats.root(speed * speed - 4.0 * pull * start)
    time = floats.quotient(-2.0 * start, speed + root)
    if not time >= 0.0:
        return floats.NAN
    return way.side * ((flight.x_at(path, time) - x_end) * sine + (flight.z_at(path, time) - z_end) * cosine)
