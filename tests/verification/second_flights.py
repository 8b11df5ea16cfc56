"""Drawn surfaces and flights of the second solver: where a parabola meets a line or an arc."""

from dataclasses import dataclass
from itertools import pairwise
from math import cos, inf, pi, sin, sqrt

import numpy as np
from scipy.optimize import brentq

from tests.verification.second_sections import atan_slope

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)


@dataclass
class Surface:
    """A drawn line or arc: where it starts, its slope there, its curvature (signed), its length, its side."""

    x: float
    z: float
    slope: float
    kappa: float
    length: float
    side: int  # 1 floor, −1 roof

    def slope_at(self, u: float) -> float:
        return self.slope - self.kappa * u

    def at(self, u: float) -> tuple[float, float]:
        middle = self.slope - self.kappa * u / 2
        half = self.kappa * u / 2
        chord = u * (sin(half) / half if half else 1.0)
        return self.x + chord * cos(middle), self.z - chord * sin(middle)


@dataclass
class Flight:
    """A parabola from (x, z) with velocity (vx, vz).

    `touch` is 1 where it starts on the surface that it left, 2 where it left it tangentially, 3 where nothing
    pressed it on any more: so many powers of t are known to be missing from its distance to that surface.
    """

    x: float
    z: float
    vx: float
    vz: float
    g: float
    touch: int = 0

    def at(self, t: float) -> tuple[float, float]:
        return self.x + self.vx * t, self.z + self.vz * t - self.g * t * t / 2

    def velocity(self, t: float) -> tuple[float, float]:
        return self.vx, self.vz - self.g * t

    def path(self, t: float) -> float:
        """Length of the parabola up to t, by quadrature, split at its top."""
        top = self.vz / self.g
        total = 0.0
        ends = [0.0, top, t] if 0 < top < t else [0.0, t]
        for one, other in pairwise(ends):
            # the integrand has its kink (of a nearly vertical flight) at the top: w² takes it apart
            near, far = abs(one - top), abs(other - top)
            lo, hi = sorted((near, far))
            times = lo + (hi - lo) * ((1 + NODES) / 2) ** 2
            speeds = np.sqrt(self.vx**2 + (self.g * times) ** 2)
            total += float(np.sum(WEIGHTS * speeds * (1 + NODES) / 2)) * (hi - lo)
        return total

    def fallen_to(self, level: float) -> float | None:
        """When it comes down through a level."""
        inside = self.vz**2 + 2 * self.g * (self.z - level)
        if inside < 0:
            return None
        root = sqrt(inside)
        t = (self.vz + root) / self.g if self.vz >= 0 else 2 * (self.z - level) / (root - self.vz)
        return t if t >= 0 else None

    def carried_to(self, x: float) -> float | None:
        if self.vx <= 0 or x < self.x:
            return None
        return (x - self.x) / self.vx


def distance(flight: Flight, surface: Surface) -> list[float]:
    """Powers of t, from 1 up, of how far the flight is on the stream's side of the line, or in of the circle."""
    sine, cosine = sin(surface.slope), cos(surface.slope)
    dx, dz = flight.x - surface.x, flight.z - surface.z
    g, side = flight.g, surface.side
    if surface.kappa == 0:
        powers = [dx * sine + dz * cosine, flight.vx * sine + flight.vz * cosine, -g * cosine / 2]
        powers = [side * power for power in powers]
    else:
        radius = 1 / surface.kappa  # the centre is this far along (sin a, cos a), which is up
        ex, ez = dx - radius * sine, dz - radius * cosine
        inward = -1 if surface.kappa * side > 0 else 1  # spoons and hoods hold the stream inside
        level = dx * dx + dz * dz - 2 * radius * (dx * sine + dz * cosine)
        powers = [
            level,
            2 * (ex * flight.vx + ez * flight.vz),
            flight.vx**2 + flight.vz**2 - g * ez,
            -g * flight.vz,
            g * g / 4,
        ]
        powers = [inward * power for power in powers]
    for k in range(flight.touch):
        powers[k] = 0.0
    return powers


def roots(powers: list[float], begin: float, end: float) -> list[float]:
    """Return where a polynomial changes sign: its monotone pieces from its derivative's own roots, then brentq."""

    def value(t: float) -> float:
        total = 0.0
        for power in reversed(powers):
            total = total * t + power
        return total

    if len(powers) <= 1 or not any(powers[1:]):
        return []
    turns = roots([k * power for k, power in enumerate(powers)][1:], begin, end)
    found = []
    for one, other in pairwise([begin, *turns, end]):
        low, high = value(one), value(other)
        if low * high < 0:
            found.append(brentq(value, one, other, xtol=1e-300, rtol=1e-15, maxiter=500))
        elif high == 0:
            found.append(other)
    return found


def passing(flight: Flight, surface: Surface) -> float:
    """When the flight passes the surface: it crosses the normal through its end, at any time after it took off."""
    x, z = surface.at(surface.length)
    angle = surface.slope_at(surface.length)
    cosine, sine = cos(angle), sin(angle)
    along = [
        (flight.x - x) * cosine - (flight.z - z) * sine,
        flight.vx * cosine - flight.vz * sine,
        flight.g * sine / 2,
    ]

    def value(t: float) -> float:
        return along[0] + (along[1] + along[2] * t) * t

    if abs(value(0.0)) <= 1e-13 * (abs(flight.x - x) + abs(flight.z - z) + surface.length) and along[1] > 0:
        return 0.0
    for t in roots(along, 0.0, horizon(flight, surface)):
        if along[1] + 2 * along[2] * t > 0:
            return t
    return inf


def horizon(flight: Flight, surface: Surface) -> float:
    """Return a time by which the flight is past all of a surface: far below it, or far beyond its end."""
    size = (
        abs(flight.x - surface.x)
        + abs(flight.z - surface.z)
        + surface.length
        + abs(1 / surface.kappa if surface.kappa else 0.0)
    )
    return 4 * (sqrt(size / flight.g) + abs(flight.vz) / flight.g) + 1e3 * size / flight.g / (1 + abs(flight.vx))


@dataclass
class Landing:
    """Where and how a flight meets a surface: distance along it, incidence, speed, length flown."""

    u: float
    incidence: float
    speed: float
    flown: float


def landing(flight: Flight, surface: Surface) -> tuple[Landing | None, float]:
    """Return the first meeting from the stream's side before the surface is passed, or None; and when it is passed.

    It passes the end on the stream's side, or not at all: a stream that is behind the surface there fell short.
    """
    passed = passing(flight, surface)
    end = min(passed, horizon(flight, surface))
    powers = distance(flight, surface)
    for t in roots(powers[flight.touch :], 0.0, end * (1 + 1e-15)):
        rate = sum(k * power * t ** (k - 1) for k, power in enumerate(powers) if k)
        if rate >= 0:  # from behind
            continue
        x, z = flight.at(t)
        u = length_at(x, z, surface)
        if -1e-13 * surface.length <= u <= surface.length * (1 + 1e-13):
            u = min(max(u, 0.0), surface.length)
            vx, vz = flight.velocity(t)
            speed = sqrt(vx * vx + vz * vz)
            a, b = atan_slope(vx, vz), surface.slope_at(u)
            return Landing(u, max(surface.side * (a - b), 0.0), speed, flight.path(t)), passed
    return None, passed if passed == inf or _height(flight, surface, passed) >= 0 else inf


def _height(flight: Flight, surface: Surface, t: float) -> float:
    """Return how far the flight is on the stream's side of the surface's end."""
    x, z = surface.at(surface.length)
    angle = surface.slope_at(surface.length)
    at = flight.at(t)
    return surface.side * ((at[0] - x) * sin(angle) + (at[1] - z) * cos(angle))


def length_at(x: float, z: float, surface: Surface) -> float:
    """Return the distance along the surface of a point on it, m."""
    if surface.kappa == 0:
        return (x - surface.x) * cos(surface.slope) - (z - surface.z) * sin(surface.slope)
    radius = 1 / surface.kappa
    ex, ez = x - surface.x - radius * sin(surface.slope), z - surface.z - radius * cos(surface.slope)
    if radius > 0:
        ex, ez = -ex, -ez
    angle = np.arctan2(ex, ez)  # the point is at ∓radius (sin a, cos a) from the centre
    turn = (surface.slope - angle + pi) % (2 * pi) - pi
    return turn * radius
