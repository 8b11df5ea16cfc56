"""Free flight without drag, and what an impact leaves of a stream's velocity."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Values, real, shared


class Flight(NamedTuple):
    """A parabola: where the mean path of a stream in free flight starts, and how fast. Arrays of length 1 or n."""

    x: Array
    """m along the chute."""
    z: Array
    """m, up."""
    forward: Array
    """Horizontal velocity, m/s, 0 or more; kept."""
    downward: Array
    """Vertical velocity at the start, m/s, negative where the stream rises."""
    gravity: Array


def flight(x: Array, z: Array, velocity: Array, slope: Array, gravity: Array) -> Flight:
    """The flight of a stream that leaves (x, z) with a velocity, m/s, along a slope, rad below horizontal.

    What is vertical has no forward velocity, though π/2 in doubles has a cosine of 6e-17.
    """
    slope = shared(slope)
    ahead = np.cos(slope)
    ahead = np.where(ahead <= 1e-15, 0.0, ahead)
    return Flight(x, z, velocity * ahead, velocity * np.sin(slope), gravity)


def position(path: Flight, time: Array) -> tuple[Array, Array]:
    """Place (x, z), m, after a time, s."""
    return path.x + path.forward * time, path.z - (path.downward + 0.5 * path.gravity * time) * time


def motion(path: Flight, time: Array) -> tuple[Array, Array]:
    """Velocity, m/s, and slope, rad below horizontal, after a time, s. A stream at rest points straight down."""
    down = path.downward + path.gravity * time
    velocity = np.hypot(path.forward, down)
    return velocity, np.where(velocity > 0.0, np.arctan2(down, path.forward), np.pi / 2)


def time_to_drop(path: Flight, drop: Array) -> Array:
    """Time until the stream is a height below its start, for the last time.

    t = (-w + √(w² + 2 g h))/g with w downward, in the form that does not cancel.

    Args:
        path: the flight.
        drop: h, m, negative where it rises.

    Returns:
        t, s; NaN where it never is there.

    >>> one = np.ones(1)
    >>> float(time_to_drop(flight(0 * one, 0 * one, 0 * one, one, 9.81 * one), 4.905 * one)[0])
    1.0
    """
    w = path.downward
    root = np.sqrt(w**2 + 2.0 * path.gravity * drop)
    rising = w < 0.0
    quick = 2.0 * drop / np.where(rising | (root == 0.0), 1.0, w + root)
    time = np.where(rising, (root - w) / path.gravity, quick)
    return np.where(time >= 0.0, time, np.nan)


def time_to_run(path: Flight, run: Array) -> Array:
    """Time until the stream is a horizontal distance, m, from its start; NaN where it never is."""
    ahead = (path.forward > 0.0) & (run >= 0.0)
    return np.where(ahead, run / np.where(ahead, path.forward, 1.0), np.nan)


def path_length(path: Flight, time: Array) -> Array:
    """Length of the parabola flown in a time.

    s = [u w + c² asinh(u/c)]/(2 g) between the ends, with u downward, c forward and w = √(c² + u²); the differences are
    written as products where the stream only falls, so that short flights keep their digits.

    Args:
        path: the flight.
        time: s, 0 or more.

    Returns:
        s, m.

    >>> one = np.ones(1)
    >>> level = flight(0 * one, 0 * one, 2.0 * one, 0 * one, 9.81 * one)
    >>> bool(abs(path_length(level, 1e-6 * one)[0] / 2e-6 - 1) < 1e-11)
    True
    """
    c, g = path.forward, path.gravity
    u0, u1 = path.downward, path.downward + g * time
    w0, w1 = np.hypot(c, u0), np.hypot(c, u1)
    total = w0 + w1
    product = u1 * (u1 - u0) * (u1 + u0) / np.where(total > 0.0, total, 1.0) + w0 * (u1 - u0)
    falling = u0 >= 0.0
    sine_sum = np.where(falling, u1 * w0 + u0 * w1, 0.0)
    close = np.arcsinh((u1 - u0) * (u1 + u0) / np.where(sine_sum > 0.0, sine_sum, 1.0))
    scale = np.where(c > 0.0, c, 1.0)
    bend = np.where(falling, close, np.arcsinh(u1 / scale) - np.arcsinh(u0 / scale))
    return (product + c**2 * bend) / (2.0 * g)


def impact_velocity(velocity: Values, incidence: Values, friction: Values) -> Array:
    """What an impact leaves of a velocity, v (cos i - μ_e sin i), never below 0.

    The normal part is lost, and friction acts on its impulse.

    Args:
        velocity: arriving, m/s.
        incidence: i between stream and surface, rad, 0 to π.
        friction: μ_e of the surface landed on, at the arriving velocity.

    Returns:
        Velocity along the surface, m/s; 0 from tan i = 1/μ_e on: a stall.

    >>> share = impact_velocity(1.0, np.radians([20.0, 30.0, 45.0]), np.tan(np.radians(25.0))) ** 2
    >>> share.round(2)  # of the energy that is kept
    array([0.61, 0.4 , 0.14])
    """
    return real(velocity) * np.maximum(np.cos(real(incidence)) - real(friction) * np.sin(real(incidence)), 0.0)
