"""Compute free flight without drag, and to first order what a small error at its start becomes."""

import math

from chutecalc.core import floats, records

LEAST_COSINE = 1e-15
"""A vertical stream has no forward velocity, although π/2 in doubles has a cosine of 6e-17."""


def launch(flight: "records.Flight", point: "records.Point", gravity: float) -> None:
    """Set the flight of a stream that leaves a point along its slope."""
    ahead = math.cos(point.slope)
    flight.x, flight.z, flight.gravity = point.x, point.z, gravity
    flight.forward = point.velocity * ahead if math.fabs(ahead) > LEAST_COSINE else 0.0
    flight.downward = point.velocity * math.sin(point.slope)


def velocity_at(flight: "records.Flight", time: float) -> float:
    """Return the velocity at a time, m/s."""
    down = flight.downward + flight.gravity * time
    return floats.root(flight.forward * flight.forward + down * down)


def slope_at(flight: "records.Flight", time: float) -> float:
    """Return the slope at a time, rad below horizontal; a stream at rest points straight down."""
    if not velocity_at(flight, time) > 0.0:
        return 0.5 * math.pi
    return math.atan2(flight.downward + flight.gravity * time, flight.forward)


def x_at(flight: "records.Flight", time: float) -> float:
    """Return x at a time, m."""
    return flight.x + flight.forward * time


def z_at(flight: "records.Flight", time: float) -> float:
    """Return z at a time, m."""
    return flight.z - (flight.downward + 0.5 * flight.gravity * time) * time


def time_to_drop(flight: "records.Flight", drop: float) -> float:
    """Return the last time at which the stream is a height h below its start, s; NaN where it never is.

    t = (-w + √(w² + 2 g h))/g with w downward, in the form that does not cancel.
    """
    w = flight.downward
    root = floats.root(w * w + 2.0 * flight.gravity * drop)
    quick = 2.0 * drop / (1.0 if root == 0.0 or w < 0.0 else w + root)
    time = (root - w) / flight.gravity if w < 0.0 else quick
    return time if time >= 0.0 else floats.NAN


def time_to_run(flight: "records.Flight", run: float) -> float:
    """Return the time at which the stream is a horizontal distance from its start, s; NaN where it never is."""
    return run / flight.forward if flight.forward > 0.0 and run >= 0.0 else floats.NAN


def set_point(flight: "records.Flight", time: float, point: "records.Point") -> None:
    """Set position, velocity and slope of a point to those of a flight at a time."""
    point.x, point.z = x_at(flight, time), z_at(flight, time)
    point.velocity, point.slope = velocity_at(flight, time), slope_at(flight, time)


def passage(flight: "records.Flight", x: float, z: float) -> tuple[float, float]:
    """Return when a flight passes a point, and how far from it then: at the same height, below or above it, or now.

    A flight that begins at the point, but for rounding, may have passed it: then only its beginning is near.
    """
    fall = time_to_drop(flight, flight.z - z)
    run = time_to_run(flight, x - flight.x)
    beside = math.fabs(x_at(flight, fall) - x)
    above = math.fabs(z_at(flight, run) - z)
    here = math.hypot(x - flight.x, z - flight.z)
    if not (above <= here or beside <= here):
        return 0.0, here
    return (run, above) if above < beside or beside != beside else (fall, beside)


def delay(flight: "records.Flight") -> float:
    """Return how much later a flight with errors gets to the same height, or distance if it goes rather forward."""
    if flight.downward_now >= flight.forward:
        return safe_quotient(flight.z_error, flight.downward_now)
    return safe_quotient(-flight.x_error, flight.forward)


def path_length(flight: "records.Flight", time: float) -> float:
    """Return the length of the parabola flown in a time, m.

    s = [u w + c² asinh(u/c)]/(2 g) between the ends, with u downward, c forward and w = √(c² + u²); where the stream
    only falls, the differences are written as products so that short flights keep their digits.
    """
    if time != time:
        return floats.NAN
    c, g = flight.forward, flight.gravity
    u0, u1 = flight.downward, flight.downward + g * time
    w0, w1 = math.sqrt(c * c + u0 * u0), math.sqrt(c * c + u1 * u1)
    total, rise = w0 + w1, (u1 - u0) * (u1 + u0)
    product = u1 * rise / (total if total > 0.0 else 1.0) + w0 * (u1 - u0)
    if u0 >= 0.0:
        sine_sum = u1 * w0 + u0 * w1
        bend = math.asinh(rise / (sine_sum if sine_sum > 0.0 else 1.0))
    else:
        scale = c if c > 0.0 else 1.0
        bend = math.asinh(u1 / scale) - math.asinh(u0 / scale)
    return (product + c * c * bend) / (2.0 * g)


def propagate_error(flight: "records.Flight", point: "records.Point", time: float) -> None:
    """Write the errors of the flight at a time, from those of the stream where it began."""
    slope = slope_at(flight, 0.0)
    faster = point.error * velocity_at(flight, 0.0)
    flight.forward_error = faster * math.cos(slope) - flight.downward * point.slope_error
    flight.downward_error = faster * math.sin(slope) + flight.forward * point.slope_error
    flight.x_error = point.x_error + flight.forward_error * time
    flight.z_error = point.z_error - flight.downward_error * time
    flight.downward_now = flight.downward + flight.gravity * time


def shift_error(flight: "records.Flight", later: float, point: "records.Point") -> None:
    """Write the errors of the stream at a time later by a first-order amount, s, to a point."""
    fall = flight.downward_error + flight.gravity * later
    square = flight.forward * flight.forward + flight.downward_now * flight.downward_now
    if not square > 0.0:
        square = floats.INFINITY
    point.error = (flight.forward * flight.forward_error + flight.downward_now * fall) / square
    point.x_error = flight.x_error + flight.forward * later
    point.z_error = flight.z_error - flight.downward_now * later
    point.slope_error = (flight.forward * fall - flight.downward_now * flight.forward_error) / square


def safe_quotient(over: float, under: float) -> float:
    """Return the quotient; 0 where the numerator is 0, whatever the denominator."""
    return 0.0 if over == 0.0 else floats.quotient(over, under)
