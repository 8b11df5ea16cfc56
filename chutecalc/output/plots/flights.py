"""The edges of a stream in flight: each is a parabola, thrown from where the stream leaves a surface or a belt."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Belt
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import Surface, point
from chutecalc.results.inlet import leaves_belt

Line = Array
"""Horizontal position and height along a line, m, of shape (2, stations)."""
STATIONS = 101
"""Number of stations along each segment or flight."""
SHARES = np.linspace(0.0, 1.0, STATIONS)
"""Their shares of the length of a surface."""
LEAVES = ("x_m", "z_m", "slope_deg", "velocity_m_s")
"""Columns that a flight follows from."""
LATEST = 1.5
"""An edge is followed to this multiple of the stream's time of flight, to find where it lands."""


class Throw(NamedTuple):
    """Where and how an edge of a stream begins to fly."""

    x: float
    """Horizontal position, m."""
    z: float
    """Height, m."""
    forward: float
    """Horizontal velocity, m/s."""
    downward: float
    """Velocity downwards, m/s."""
    gravity: float
    """m/s²."""

    def at(self, time: Array) -> Line:
        """Return the positions at some times.

        Args:
            time: since the throw, s, shape (stations,).
        """
        fallen = (self.downward + 0.5 * self.gravity * time) * time
        return np.stack([self.x + self.forward * time, self.z - fallen])

    def velocity(self, time: Array) -> Array:
        """Return the velocities at some times, m/s.

        Args:
            time: since the throw, s, shape (stations,).
        """
        velocity: Array = np.hypot(self.forward, self.downward + self.gravity * time)
        return velocity

    def after(self, time: float) -> "Throw":
        """Return the throw that continues this one.

        Args:
            time: since this throw, s.
        """
        x, z = self.at(np.array(time))
        return Throw(float(x), float(z), self.forward, self.downward + self.gravity * time, self.gravity)

    def time_to(self, level: float) -> float:
        """Return the time until the height is a level below, s.

        Args:
            level: height of at most ``z``, m.
        """
        fallen = self.z - level
        return float((np.sqrt(self.downward**2 + 2.0 * self.gravity * fallen) - self.downward) / self.gravity)

    def time_of_landing(self, landed: Line, usual: float) -> float:
        """Return the time until the edge meets a surface, s; the usual time where it does not.

        Args:
            landed: line of the surface.
            usual: time of flight of the stream, s.
        """
        time = np.linspace(0.0, LATEST * usual, 3 * STATIONS)
        meets = crossings(self.at(time), landed)
        return float(time[-1] * meets[0] / (len(time) - 1)) if meets.size else usual


def crossings(path: Line, other: Line) -> Array:
    """Find where a path of straight pieces crosses another.

    Args:
        path: the path.
        other: the other path.

    Returns:
        For each crossing the number of the path's piece, with the share of it as a fraction, ascending.

    >>> crossings(np.array([[0.0, 1.0, 2.0], [0.0, 0.0, 0.0]]), np.array([[1.5, 1.5], [-1.0, 1.0]]))
    array([1.5])
    """
    start, step = path[:, :-1, None], np.diff(path)[:, :, None]
    corner, side = other[:, None, :-1], np.diff(other)[:, None, :]
    across = step[0] * side[1] - step[1] * side[0]
    x, z = corner - start
    with np.errstate(all="ignore"):
        share, along = (x * side[1] - z * side[0]) / across, (x * step[1] - z * step[0]) / across
    hit = (share >= 0.0) & (share <= 1.0) & (along >= 0.0) & (along <= 1.0)
    return np.sort((np.arange(hit.shape[0])[:, None] + share)[hit])


def belt_throws(belt: Belt, gravity: Array) -> list[Throw]:
    """Return how the edges of a stream leave the belt that it comes from: lower edge, middle, upper edge.

    Args:
        belt: the belt. A stream without depth has one edge only.
        gravity: m/s², shape (1,).
    """
    throws = []
    for radius in belt.edge_radii.values():
        edge = leaves_belt(belt, radius, gravity, belt.friction)
        numbers = (belt.centre[0] + edge.x, belt.centre[1] + edge.z, np.degrees(edge.slope), edge.velocity, gravity)
        throws.append(thrown(*(float(each[0]) for each in numbers)))
    return list(dict.fromkeys(throws))


def thrown(x: float, z: float, slope_deg: float, velocity: float, gravity: float) -> Throw:
    """Return the throw of what leaves a place at a slope.

    Args:
        x, z: the place, m.
        slope_deg: below horizontal, degrees.
        velocity: m/s.
        gravity: m/s².
    """
    slope = np.radians(slope_deg)
    return Throw(x, z, float(velocity * np.cos(slope)), float(velocity * np.sin(slope)), gravity)


def surface_line(surface: Surface, height: Array | float = 0.0) -> Line:
    """Return the line of a surface, or one at a height above it; NaN where it has no place.

    Args:
        surface: of one design.
        height: normal to it, on the side of the stream, m, of shape (stations,) or one for all.
    """
    x, z, slope = (each[:, 0] for each in point(surface, SHARES[:, None]))
    above = surface.side * height
    return np.stack([x + above * np.sin(slope), z + above * np.cos(slope)])


def flown(throws: Sequence[Throw], at: Mapping[str, Array], landed: Line | None) -> tuple[list[Line], list[Throw]]:
    """Return the edges of a flight, and how they would fly on.

    Args:
        throws: of the edges.
        at: columns along the flight, each of shape (stations,).
        landed: line on which the edges land; None if they fly as long as the stream.
    """
    time = at["time_s"] - at["time_s"][0]
    usual = float(time[-1])
    x, z = at["x_m"][0], at["z_m"][0]
    edges = []
    for throw in throws:
        is_path = np.hypot(throw.x - x, throw.z - z) <= 1e-9 * (1.0 + np.hypot(x, z))
        ends = usual if is_path or landed is None else throw.time_of_landing(landed, usual)
        edges.append(throw.at(time * (ends / usual if usual else 1.0)))
    return edges, [throw.after(usual) for throw in throws]
