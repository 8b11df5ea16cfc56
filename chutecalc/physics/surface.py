"""The guiding surface of a segment as a line: straight or a circular arc, and where a flight meets it."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.flight import Flight, motion, position, time_to_drop
from chutecalc.physics.roots import falls_through_zero


class Surface(NamedTuple):
    """A straight or an arc, drawn from (x, z). Arrays of length 1 or n, m and rad."""

    side: float
    """1 for a floor, which the stream meets from above; -1 for a roof, met from below."""
    x: Array
    z: Array
    slope: Array
    """Below horizontal, where it starts."""
    turn: Array
    """Slope at its end less slope at its start."""
    length: Array

    @property
    def curvature(self) -> Array:
        """κ = -da/ds, positive where the surface flattens."""
        return -self.turn / self.length


class Landing(NamedTuple):
    """Where a flight meets a surface; NaN where it does not."""

    time: Array
    place: Array
    """Share of the surface's length, 0 to 1."""
    slope: Array
    """Of the surface there."""
    gap: Array
    """How far beyond the surface's end the flight crosses the normal there, m, where it misses; positive on the
    stream's side, NaN where it lands or never crosses."""


def point(surface: Surface, place: Array) -> tuple[Array, Array, Array]:
    """x, z and slope at a share of the surface's length.

    The chord of an arc that turns by b over a length s is s sin(b/2)/(b/2) long and lies halfway between the end
    slopes; unlike (sin a0 - sin a)/κ this holds its digits down to a straight.

    >>> one = np.ones(1)
    >>> quarter = Surface(1.0, 0 * one, 0 * one, np.pi / 2 * one, -np.pi / 2 * one, 3 * np.pi / 2 * one)
    >>> x, z, slope = point(quarter, one)
    >>> float(x[0].round(12)), float(z[0].round(12)), float(slope[0])
    (3.0, -3.0, 0.0)
    """
    turned = surface.turn * place
    half = 0.5 * turned
    middle = surface.slope + half
    half[half == 0.0] = 1e-20  # its sine over itself is 1 there
    chord = surface.length * place * (np.sin(half) / half)
    return surface.x + chord * np.cos(middle), surface.z - chord * np.sin(middle), surface.slope + turned


def landing(surface: Surface, path: Flight, known: Index) -> Landing:
    """Where a flight first meets a surface from the stream's side.

    With D the vector from the surface's start, n its normal there and κ the curvature, σ (D·n - κ |D|²/2) is positive
    on the stream's side and 0 on the full line or circle: a polynomial of degree 4 in time. The first of its falls
    through 0 that lies on the drawn part counts.

    Args:
        surface: of length 1 or n.
        path: the flight.
        known: how many roots at time 0 are known and taken out: 1 where the flight starts on the surface, 2 where it
            starts along it.

    Returns:
        The landing.

    >>> one = np.ones(1)
    >>> level = Surface(1.0, 0 * one, -4.905 * one, 0 * one, 0 * one, 10 * one)
    >>> landing(level, Flight(0 * one, 0 * one, 2 * one, 0 * one, 9.81 * one), np.array([0])).place.round(12)
    array([0.2])
    """
    coefficients = _clearance(surface, path)
    n = max(len(known), coefficients.shape[1])
    coefficients = np.broadcast_to(coefficients, (5, n)).copy()
    for count in (1, 2):
        some = np.broadcast_to(known >= count, (n,))
        coefficients[:, some] = np.concatenate([coefficients[1:, some], np.zeros((1, int(some.sum())))])
    x_end, z_end, end_slope = point(surface, np.ones(1))
    lowest = surface.z - surface.length
    horizon = np.broadcast_to(time_to_drop(path, np.maximum(path.z - lowest, 0.0)), (n,))
    time, place, slope = np.full((3, n), np.nan)
    for candidate in falls_through_zero(coefficients, horizon):
        on_place, on_slope = _foot(surface, path, candidate)
        fits = np.isnan(time) & (on_place >= -1e-12) & (on_place <= 1.0 + 1e-12)
        time, place = np.where(fits, candidate, time), np.where(fits, np.clip(on_place, 0.0, 1.0), place)
        slope = np.where(fits, on_slope, slope)
    return Landing(
        time, place, slope, np.where(np.isnan(time), _gap_at_end(surface, path, x_end, z_end, end_slope), np.nan)
    )


def incidence(surface: Surface, path: Flight, found: Landing) -> tuple[Array, Array, Array]:
    """Velocity and slope of the stream where it lands, and the angle at which it strikes, rad."""
    velocity, slope = motion(path, found.time)
    return velocity, slope, surface.side * (slope - found.slope)


def _clearance(surface: Surface, path: Flight) -> Array:
    """Coefficients of σ (D·n - κ |D|²/2) in rising powers of time, shape (5, n)."""
    sine, cosine = np.sin(surface.slope), np.cos(surface.slope)
    dx, dz, half_g = path.x - surface.x, path.z - surface.z, 0.5 * path.gravity
    u, w = path.forward, -path.downward
    linear = (dx * sine + dz * cosine, u * sine + w * cosine, -half_g * cosine)
    square = (
        dx**2 + dz**2,
        2.0 * (dx * u + dz * w),
        u**2 + w**2 - 2.0 * dz * half_g,
        -2.0 * w * half_g,
        half_g**2,
    )
    bend = 0.5 * surface.curvature
    terms = [-bend * term for term in square]
    for power in range(3):
        terms[power] = terms[power] + linear[power]
    return surface.side * np.stack(np.broadcast_arrays(*terms))


def _foot(surface: Surface, path: Flight, time: Array) -> tuple[Array, Array]:
    """Share of the length and slope of the full line or circle at the point that the flight reaches at a time."""
    x, z = position(path, time)
    dx, dz = x - surface.x, z - surface.z
    sine, cosine = np.sin(surface.slope), np.cos(surface.slope)
    bend = surface.curvature
    slope = np.arctan2(sine - bend * dx, cosine - bend * dz)
    along = (dx * cosine - dz * sine) / surface.length
    turned = (slope - surface.slope) / np.where(surface.turn != 0.0, surface.turn, 1.0)
    return np.where(surface.turn != 0.0, turned, along), np.where(surface.turn != 0.0, slope, surface.slope)


def _gap_at_end(surface: Surface, path: Flight, x_end: Array, z_end: Array, slope: Array) -> Array:
    """How far from the surface's end the flight crosses the normal through it, m, positive on the stream's side."""
    sine, cosine = np.sin(slope), np.cos(slope)
    start = (path.x - x_end) * cosine - (path.z - z_end) * sine  # along the surface, from its end
    speed = path.forward * cosine + path.downward * sine
    pull = 0.5 * path.gravity * sine
    root = np.sqrt(speed**2 - 4.0 * pull * start)
    time = -2.0 * start / (speed + root)
    x, z = position(path, time)
    return np.where(time >= 0.0, surface.side * ((x - x_end) * sine + (z - z_end) * cosine), np.nan)
