"""What a small error of a stream becomes on a flight, at a landing and where contact is lost: first order, exact.

All that belongs to one error goes with its sign: a stream that leaves an edge a little faster lands further on, at
another slope, and may strike harder or less hard. On a surface the parts are joined to the one error of the velocity at
a fixed place.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Stream
from chutecalc.physics.arrays import Array
from chutecalc.physics.flight import Flight, motion
from chutecalc.physics.surface import Surface
from chutecalc.solver.slide import Slide, net_pull


class Deviation(NamedTuple):
    """The errors of a stream at one place, arrays of shape (n,); each goes with the others' sign."""

    velocity: Array
    """Relative."""
    x: Array
    z: Array
    slope: Array
    """rad."""


def deviation(stream: Stream) -> Deviation:
    """That of a stream."""
    return Deviation(stream.error, stream.x_error, stream.z_error, stream.slope_error)


def none(shape: tuple[int, ...]) -> Deviation:
    """Of what is exact."""
    return Deviation(*np.zeros((4, *shape)))


class FlightDeviation:
    """How a flight differs from the one computed, at a time since it began."""

    def __init__(self, off: Deviation, path: Flight, time: Array) -> None:
        velocity, self.slope = motion(path, np.zeros(1))
        faster = off.velocity * velocity
        self.forward = faster * np.cos(self.slope) - path.downward * off.slope
        self.downward = faster * np.sin(self.slope) + path.forward * off.slope
        self.x, self.z = off.x + self.forward * time, off.z - self.downward * time
        self.path, self.down = path, path.downward + path.gravity * time

    def at(self, later: Array) -> Deviation:
        """At a time that is later by a first-order amount, s."""
        path, down = self.path, self.down
        fall = self.downward + path.gravity * later
        square = path.forward**2 + down**2
        square = np.where(square > 0.0, square, np.inf)
        return Deviation(
            (path.forward * self.forward + down * fall) / square,
            self.x + path.forward * later,
            self.z - down * later,
            (path.forward * fall - down * self.forward) / square,
        )


def after_drop(off: Deviation, path: Flight, time: Array, level: Array) -> Deviation:
    """At a level, whose own error is ``level``, m."""
    flown = FlightDeviation(off, path, time)
    return flown.at(_quotient(flown.z - level, flown.down))


def after_run(off: Deviation, path: Flight, time: Array, line: Array) -> Deviation:
    """At a distance, whose own error is ``line``, m."""
    flown = FlightDeviation(off, path, time)
    return flown.at(_quotient(line - flown.x, path.forward))


def at_landing(
    off: Deviation, drawn: Deviation, path: Flight, time: Array, surface: Surface, slope: Array
) -> tuple[Deviation, Array]:
    """Where a flight meets a surface.

    Args:
        off: of the stream where it left.
        drawn: of the surface's own place.
        path, time: of the flight.
        surface: met.
        slope: of the surface where it is met.

    Returns:
        The stream's deviation there, and that of the place, as a share of the surface's length.
    """
    flown = FlightDeviation(off, path, time)
    sine, cosine = np.sin(slope), np.cos(slope)
    beside = (flown.x - drawn.x) * sine + (flown.z - drawn.z) * cosine
    closing = path.forward * sine - flown.down * cosine
    there = flown.at(_quotient(-beside, closing))
    along = (there.x - drawn.x) * cosine - (there.z - drawn.z) * sine
    return there, along / surface.length


def on_surface(slide: Slide, place: Array, velocity: Array, off: Array, shift: Array) -> Array:
    """Relative error of the velocity at a fixed place, of a stream that is off by so much where it is too far on.

    Args:
        slide: the segment.
        place: where the stream meets it.
        velocity: there, m/s.
        off: its relative error at the place met.
        shift: error of that place.
    """
    rise = slide.length * slide.gravity * net_pull(slide, place, velocity**2) / velocity**2
    return off - np.where(shift == 0.0, 0.0, rise * shift)


def of_arc(drawn: Deviation, surface: Surface) -> Deviation:
    """Where points of a surface are off that have the same slope: as its start, and by the arc that it begins later."""
    bend = np.where(surface.turn != 0.0, surface.curvature, np.inf)
    longer = drawn.slope / bend
    x, z = drawn.x + longer * np.cos(surface.slope), drawn.z - longer * np.sin(surface.slope)
    return Deviation(np.zeros(1), x, z, np.zeros(1))


def at_loss(slide: Slide, place: Array, y: Array, error: Array) -> tuple[Array, Array]:
    """Where contact is lost, n(c, y) = 0: relative error of the velocity there, and that of the place.

    Args:
        slide: the segment.
        place: c.
        y: v² there.
        error: of the velocity at that place, relative.
    """
    slope = slide.entry_slope + slide.turn * place
    rise = 2.0 * slide.length * slide.gravity * net_pull(slide, place, y)
    turned = -slide.side * slide.gravity * np.sin(slope) * slide.turn
    shift = _quotient(-2.0 * error * y * slide.bend(), turned + slide.bend() * rise)
    return error + 0.5 * rise / y * shift, shift


def _quotient(over: Array, under: Array) -> Array:
    """0 where there is nothing to divide, also by nothing."""
    return np.where(over == 0.0, 0.0, over / np.where(over == 0.0, 1.0, under))
