"""Free flight without drag, and what a small error of the stream that begins it becomes: first order, exact."""

import math

from chutecalc.core import floats, records

LEVEL_AHEAD = 1e-15
"""What is vertical has no forward velocity, though π/2 in doubles has a cosine of 6e-17."""


def launch(flight: "records.Flight", point: "records.Point", gravity: float) -> None:
    """The flight of a stream that leaves a point along its slope."""
    ahead = math.cos(point.slope)
    flight.x, flight.z, flight.gravity = point.x, point.z, gravity
    flight.forward = point.velocity * ahead if ahead > LEVEL_AHEAD else 0.0
    flight.downward = point.velocity * math.sin(point.slope)


def velocity_at(flight: "records.Flight", time: float) -> float:
    """M/s."""
    down = flight.downward + flight.gravity * time
    return floats.root(flight.forward * flight.forward + down * down)


def slope_at(flight: "records.Flight", time: float) -> float:
    """Rad below horizontal. A stream at rest points straight down."""
    if not velocity_at(flight, time) > 0.0:
        return 0.5 * math.pi
    return math.atan2(flight.downward + flight.gravity * time, flight.forward)


def x_at(flight: "records.Flight", time: float) -> float:
    """M."""
    return flight.x + flight.forward * time


def z_at(flight: "records.Flight", time: float) -> float:
    """M."""
    return flight.z - (flight.downward + 0.5 * flight.gravity * time) * time


def time_to_drop(flight: "records.Flight", drop: float) -> float:
    """Time until the stream is a height h below its start, for the last time; not a number where it never is.

    t = (-w + √(w² + 2 g h))/g with w downward, in the form that does not cancel.
    """
    w = flight.downward
    root = floats.root(w * w + 2.0 * flight.gravity * drop)
    quick = 2.0 * drop / (1.0 if root == 0.0 or w < 0.0 else w + root)
    time = (root - w) / flight.gravity if w < 0.0 else quick
    return time if time >= 0.0 else floats.NAN


def time_to_run(flight: "records.Flight", run: float) -> float:
    """Time until the stream is a horizontal distance, m, from its start; not a number where it never is."""
    return run / flight.forward if flight.forward > 0.0 and run >= 0.0 else floats.NAN


def path_length(flight: "records.Flight", time: float) -> float:
    """Length of the parabola flown in a time.

    s = [u w + c² asinh(u/c)]/(2 g) between the ends, with u downward, c forward and w = √(c² + u²); the differences are
    written as products where the stream only falls, so that short flights keep their digits.
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


def spread_error(flight: "records.Flight", point: "records.Point", time: float) -> None:
    """How the flight differs at a time, from the errors of the stream at the point where it began."""
    slope = slope_at(flight, 0.0)
    faster = point.error * velocity_at(flight, 0.0)
    flight.off_forward = faster * math.cos(slope) - flight.downward * point.slope_error
    flight.off_downward = faster * math.sin(slope) + flight.forward * point.slope_error
    flight.off_x = point.x_error + flight.off_forward * time
    flight.off_z = point.z_error - flight.off_downward * time
    flight.down = flight.downward + flight.gravity * time


def error_later(flight: "records.Flight", later: float, point: "records.Point") -> None:
    """The errors of the stream at a time that is later by a first-order amount, s, go to a point."""
    fall = flight.off_downward + flight.gravity * later
    square = flight.forward * flight.forward + flight.down * flight.down
    if not square > 0.0:
        square = floats.INFINITY
    point.error = (flight.forward * flight.off_forward + flight.down * fall) / square
    point.x_error = flight.off_x + flight.forward * later
    point.z_error = flight.off_z - flight.down * later
    point.slope_error = (flight.forward * fall - flight.down * flight.off_forward) / square


def share(over: float, under: float) -> float:
    """0 where there is nothing to divide, also by nothing."""
    return 0.0 if over == 0.0 else floats.quotient(over, under)
