"""Closed sections of the second solver: a drawn wall, the wall opposite to it, and flights between the two."""

from dataclasses import dataclass
from math import cos, hypot, inf, sin, sqrt
from typing import Any

from tests.verification.second_flights import Flight, Landing, Surface, distance, horizon, length_at, roots
from tests.verification.second_sections import atan_slope

NEAR = 1e-12
"""Of a tube's size: what a place may be off by rounding."""


def height_of(table: dict[str, Any]) -> float | None:
    """Return D of a closed section, None of an open one."""
    return {"pipe": lambda: 2 * table["radius_m"], "box": lambda: table["height_m"]}.get(table["shape"], lambda: None)()


@dataclass
class Mouth:
    """The normal at one end of the drawn wall, from that wall to the one opposite."""

    x: float
    z: float
    slope: float
    side: int
    height: float

    def along(self, x: float, z: float) -> float:
        return (x - self.x) * cos(self.slope) - (z - self.z) * sin(self.slope)

    def across(self, x: float, z: float) -> float:
        return self.side * ((x - self.x) * sin(self.slope) + (z - self.z) * cos(self.slope))

    def crossed(self, flight: Flight, until: float) -> list[tuple[float, bool, float]]:
        """Return when a flight crosses the normal's whole line, whether forwards, and how far from the drawn wall."""
        powers = [
            self.along(flight.x, flight.z),
            flight.vx * cos(self.slope) - flight.vz * sin(self.slope),
            flight.g * sin(self.slope) / 2,
        ]
        found = []
        for t in roots(powers, 0.0, until):
            x, z = flight.at(t)
            found.append((t, powers[1] + 2 * powers[2] * t > 0, self.across(x, z)))
        return found


class Tube:
    """What encloses the stream: the drawn wall and the one opposite, and the mouths at both ends."""

    def __init__(self, drawn: Surface, heights: tuple[float, float]) -> None:
        first, last = heights
        x, z = drawn.at(drawn.length)
        self.mouth = Mouth(drawn.x, drawn.z, drawn.slope, drawn.side, first)
        end = drawn.slope_at(drawn.length)
        self.exit = Mouth(x, z, end, drawn.side, last)
        begin, to = _off(self.mouth), _off(self.exit)
        run, rise = to[0] - begin[0], to[1] - begin[1]
        slope, chord = atan_slope(run, rise), hypot(run, rise)
        if drawn.kappa:  # the arc through both that turns as much
            turn = drawn.kappa * drawn.length
            bend = 2 * sin(turn / 2) / chord
            other = Surface(*begin, slope + turn / 2, bend, turn / bend, -drawn.side)
        else:
            other = Surface(*begin, slope, 0.0, chord, -drawn.side)
        self.walls = (drawn, other)
        self.size = drawn.length + other.length + first + last

    def continues(self, x: float, z: float, side: int) -> bool:
        """Return whether the wall opposite begins at the end of another such wall."""
        other = self.walls[1]
        return side == other.side and hypot(x - other.x, z - other.z) <= 1e-7 * self.mouth.height

    def between(self, x: float, z: float) -> bool:
        """Return whether a point is on the stream's side of both walls' lines or circles."""
        return all(_inside(wall, x, z) >= -NEAR * self.size for wall in self.walls)

    def entered(self, flight: Flight, since: float, joined: bool) -> float | None:
        """Return from when on the flight is inside; None if it does not come in through the mouth.

        Where it comes out of another tube that this one is joined to, at `since`, it may be beyond the mouth: the two
        overlap in their mitre.
        """
        if joined and self.between(*flight.at(since)):
            return since
        tolerance = NEAR * self.size
        for t, forwards, across in self.mouth.crossed(flight, horizon(flight, self.walls[0])):
            if forwards and (joined or t >= since):
                return t if -tolerance <= across <= self.mouth.height + tolerance else None
        return None

    def next(self, flight: Flight, left: int | None, since: float, joined: bool) -> tuple[int, Landing | None, float]:
        """Return the wall that a flight inside meets first and how; without a landing it leaves through the exit, 2,
        or back through its mouth, -1.

        `left` is the wall that it took off from, with the flight's touch; None if it comes from elsewhere. Walls of
        joined tubes go on to their mitre.
        """
        tolerance = NEAR * self.size
        until = max(horizon(flight, wall) for wall in self.walls)
        events: list[tuple[float, int]] = []
        if self.exit.along(*flight.at(since)) > 0 and self.between(*flight.at(since)):
            return 2, None, since
        for t, forwards, across in self.exit.crossed(flight, until):
            if t >= since and forwards and -tolerance <= across <= self.exit.height + tolerance:
                events.append((t, 2))
        for number, wall in enumerate(self.walls):
            touch, flight.touch = flight.touch, flight.touch if number == left else 0
            powers = distance(flight, wall)
            gone, flight.touch = flight.touch, touch
            for t in roots(powers[gone:], 0.0, until):
                rate = sum(k * power * t ** (k - 1) for k, power in enumerate(powers) if k)
                u = length_at(*flight.at(t), wall)
                if t >= since and rate < 0 and (joined or -tolerance <= u) and u <= wall.length + tolerance:
                    events.append((t, number))
        for t, forwards, across in self.mouth.crossed(flight, until):
            if t > since and not forwards and 0 <= across <= self.mouth.height:
                events.append((t, -1))
        if not events:
            return -1, None, inf
        t, number = min(events)
        if number in (-1, 2):
            return number, None, t
        wall = self.walls[number]
        u = min(length_at(*flight.at(t), wall), wall.length)
        u = u if u < -tolerance else max(u, 0.0)
        vx, vz = flight.velocity(t)
        incidence = wall.side * (atan_slope(vx, vz) - wall.slope_at(u))
        return number, Landing(u, max(incidence, 0.0), sqrt(vx * vx + vz * vz), flight.path(t)), t


def _inside(wall: Surface, x: float, z: float) -> float:
    """Return how far a point is on the stream's side of a wall's line or circle."""
    if wall.kappa == 0:
        return wall.side * ((x - wall.x) * sin(wall.slope) + (z - wall.z) * cos(wall.slope))
    radius = 1 / wall.kappa
    from_centre = hypot(x - wall.x - radius * sin(wall.slope), z - wall.z - radius * cos(wall.slope))
    return (abs(radius) - from_centre) * (1 if wall.kappa * wall.side > 0 else -1)


def _off(mouth: Mouth) -> tuple[float, float]:
    """Return the end of a mouth on the wall opposite."""
    return (
        mouth.x + mouth.side * mouth.height * sin(mouth.slope),
        mouth.z + mouth.side * mouth.height * cos(mouth.slope),
    )
