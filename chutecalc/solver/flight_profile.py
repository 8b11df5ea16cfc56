"""Evaluate a solved segment in flight at any position, from its parabola.

Positions are arrays of shape (positions, designs), as are all results.
"""

from functools import cached_property

import numpy as np

from chutecalc.core import profile
from chutecalc.physics.arrays import Array
from chutecalc.solver.segment_solution import Ends, SegmentSolution


class FlightProfile:
    """The flight of a segment's solution, at distances flown.

    Args:
        solved: solution of the segment that begins with the flight.
        flow: volume rate Q, m³/s, shape (1,) or (designs,).
        distances: distances flown, m, shape (positions, designs).
    """

    def __init__(self, solved: SegmentSolution, flow: Array, distances: Array) -> None:
        self.solved, self.flow, self.flight_length, self.shape = solved, flow, distances, distances.shape

    @cached_property
    def _table(self) -> tuple[Array, ...]:
        """Time since the segment's solution began, x, z, velocity and slope."""
        out = np.empty((5, *self.flight_length.shape))
        profile.tabulate_flight(self.solved.path, self.solved.flight_time, self.flight_length, out)
        return tuple(out)

    @property
    def time(self) -> Array:
        """Time since the segment's solution began, s."""
        return self._table[0]

    @cached_property
    def distance(self) -> Array:
        """Distance from the inlet along the stream, m."""
        return self.solved.start.distance + self.flight_length

    @property
    def position(self) -> tuple[Array, Array]:
        """Position x and z, m."""
        return self._table[1], self._table[2]

    @property
    def velocity(self) -> Array:
        """Velocity, m/s."""
        return self._table[3]

    @property
    def slope(self) -> Array:
        """Slope below horizontal, rad."""
        return self._table[4]

    @property
    def area(self) -> Array:
        """Flow area Q/v, m²; NaN at rest."""
        return np.where(self.velocity > 0.0, self.flow / np.where(self.velocity > 0.0, self.velocity, 1.0), np.nan)


class EndFlightProfile(FlightProfile):
    """The end of a chute in flight, shape (1, designs).

    Args:
        ends: ends of the designs.
        flow: volume rate Q, m³/s, shape (1,) or (designs,).
    """

    def __init__(self, ends: Ends, flow: Array) -> None:
        self.flow = flow
        self.__dict__["distance"] = ends.distance[None]
        there = (np.nan, ends.x, ends.z, ends.velocity, ends.slope)
        self.__dict__["_table"] = tuple(np.atleast_2d(values) for values in there)
