"""Hold the solution of one segment for n designs.

Arrays have shape (n,), with NaN in designs that did not get that far.
"""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.core import joint, records
from chutecalc.design import Contact, Segment
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.surface import Surface
from chutecalc.solver.panels import GuideRows, Panels


class Point(NamedTuple):
    """The stream at one point, each of shape (designs,)."""

    distance: Array
    """Distance from the inlet along the stream, m."""
    x: Array
    z: Array
    slope: Array
    """Slope below horizontal, rad."""
    velocity: Array
    error: Array
    """Estimated relative error of the velocity; in flight its sign goes with those of the errors of position and
    slope."""
    x_error: Array
    z_error: Array
    slope_error: Array


class Impact(NamedTuple):
    """Effects of an impact, see :class:`chutecalc.core.records.Impact`; 0 where a stream meets the surface along it."""

    footprint: Array
    pressure: Array
    stress: Array
    wall_friction: Array
    friction: Array
    velocity_after: Array
    wear: Array


class Arrival(NamedTuple):
    """How streams meet a segment, see :class:`chutecalc.core.records.Arrival`."""

    distance: Array
    share: Array
    velocity: Array
    incidence: Array
    gap: Array
    status: Index
    impact: Impact


class ContactEnd(NamedTuple):
    """Where contact with a segment ends."""

    share: Array
    """Share of the segment's length."""
    momentum_velocity_squared: Array
    """α_m v², m²/s²."""
    beyond_share: Array
    """After a choke, the share at which the stream would end between higher walls; else NaN."""
    beyond_status: Index
    """After a choke, the status with which it would end there."""
    attempts: Index
    """Panels solved, rejected ones included."""


class ContactSolution:
    """Contact with a guiding surface in a segment's solution; quantities are read from its table on demand."""

    def __init__(self, segment: Contact, table: Array, guide_rows: GuideRows, panels: Panels) -> None:
        """Hold the contact of a segment's solution.

        Args:
            segment: the segment.
            table: of the segment's solution, see :class:`SegmentSolution`.
            guide_rows: the segment as the compiled solver reads it.
            panels: accepted panels, as far as they are stored.
        """
        self.segment, self.table, self.guide_rows, self.panels = segment, table, guide_rows, panels

    def broadcast(self, table: Array) -> "ContactSolution":
        """Return the contact of all designs of a table, where one stands for all of them.

        Args:
            table: of the segment's solution, shape (numbers, designs).
        """
        count, panels = table.shape[1], self.panels
        guide_rows, first = self.guide_rows.broadcast(count), np.repeat(panels.first, count)
        return ContactSolution(
            self.segment, table, guide_rows, Panels(guide_rows, panels.store, first, np.repeat(panels.count, count))
        )

    @cached_property
    def surface(self) -> Surface:
        """The guiding surface as placed."""
        return Surface(self.side, *field_rows(self.table, "surface_x", 5))

    @property
    def side(self) -> Array:
        """Sign σ of the surface that is met: 1 a floor, -1 a roof; a closed section has both. Shape (designs,)."""
        side: Array = self.table[FIELD["surface_side"]]
        return side

    @cached_property
    def arrival(self) -> Arrival:
        """How the segment is met."""
        impact = Impact._make(field_rows(self.table, "footprint", 7))
        return Arrival._make(
            (*field_rows(self.table, "distance", 5), field_indices(self.table, "arrival_status"), impact)
        )

    @cached_property
    def bounds(self) -> Array:
        """Share and √α_m v, m/s, where contact begins; share and α_m v², m²/s², where it ends; shape (4, designs)."""
        bounds: Array = self.table.take(_BOUNDS, axis=0)
        bounds[1] *= self.guide_rows.momentum_root
        return bounds

    @cached_property
    def end(self) -> ContactEnd:
        """Where contact ends."""
        counts = field_indices(self.table, "beyond_status"), field_indices(self.table, "attempts")
        return ContactEnd._make((*field_rows(self.table, "end_share", 3), *counts))


class SegmentSolution:
    """Solution of one segment for n designs; quantities are read from its table on demand."""

    def __init__(self, number: int, segment: Segment, table: Array, contact: ContactSolution | None) -> None:
        """Hold the solution of a segment.

        Args:
            number: number of the segment, from 0; one that is left and struck again has a solution for each time.
            segment: the segment.
            table: a row for each of :data:`chutecalc.core.records.FIELDS`, a column for each design.
            contact: its contact with a guiding surface, if it has one.
        """
        self.number, self.segment, self.table, self.contact = number, segment, table, contact

    @cached_property
    def start(self) -> Point:
        """The stream as it comes from the segment before."""
        return self._point("start")

    @cached_property
    def entry(self) -> Point:
        """The stream on the surface after an impact; for a fall the same as ``exit``."""
        return self._point("entry")

    @cached_property
    def exit(self) -> Point:
        """The stream at the end, or where the design fails."""
        return self._point("exit")

    @cached_property
    def status(self) -> Index:
        """A :class:`~chutecalc.design.Status` for each design."""
        return field_indices(self.table, "status")

    @property
    def path(self) -> Array:
        """Flight that begins at ``start``, of a fall or from an edge to a contact segment, shape (5, designs).

        Its rows are x and z, m, forward and downward velocity, m/s, and gravity, m/s².
        """
        return field_rows(self.table, "path_x", 5)

    @property
    def flight_time(self) -> Array:
        """Duration of the flight, s; 0 where there is none."""
        time: Array = self.table[FIELD["flight_time"]]
        return time

    @property
    def flight_length(self) -> Array:
        """Length of the flight, m."""
        flight_length: Array = self.table[FIELD["distance"]]
        return flight_length

    def broadcast(self, count: int) -> "SegmentSolution":
        """Return the solution of ``count`` designs, where one stands for all of them.

        Args:
            count: number of designs.
        """
        table = np.repeat(self.table, count, axis=1)
        return SegmentSolution(self.number, self.segment, table, self.contact and self.contact.broadcast(table))

    def _point(self, at: str) -> Point:
        return Point._make(field_rows(self.table, f"{at}_distance", 9))


class Ends(NamedTuple):
    """How n designs end: the stream at the exit, or what is left of it where a design fails before.

    Arrays have shape (n,).
    """

    status: Index
    """A :class:`~chutecalc.design.Status` for each design."""
    velocity: Array
    """Velocity, m/s."""
    error: Array
    """Estimated relative error of the last known velocity; after a stall the error of its share."""
    distance: Array
    x: Array
    z: Array
    slope: Array
    landing_x: Array
    landing_z: Array
    landing_velocity: Array
    landing_slope: Array
    """The stream where it lands on the receiving belt, m, m/s and rad; at the exit if that belt has no place."""
    clearance: Array
    """Least height of the drawn surfaces above the receiving belt, normal to it, m; NaN without a belt that has a
    place, and where a design fails."""
    stream_section: Array
    """Tables of the stream in the last section, shape (7, 1, n), see
    :func:`chutecalc.core.wall_loads.write_stream_section`; empty unless asked for."""
    wall_loads: Array
    """Tables of the loads on the walls there, shape (8, 1, n), see :func:`chutecalc.core.wall_loads.write_wall_loads`;
    likewise."""


TANGENT = joint.TANGENT_ANGLE
"""Directions closer than this are equal, rad."""
FIELD = {name: number for number, name in enumerate(records.FIELDS)}
"""Row of each number of :data:`chutecalc.core.records.FIELDS` in a solution's table."""
_BOUNDS = np.array([FIELD[name] for name in ("share", "velocity_after", "end_share", "end_velocity_squared")])


def field_rows(table: Array, first: str, count: int) -> Array:
    """Return neighbouring rows of a solution's table.

    Args:
        table: a row for each of :data:`chutecalc.core.records.FIELDS`.
        first: name of the first.
        count: how many.
    """
    return table[FIELD[first] : FIELD[first] + count]


def field_indices(table: Array, name: str) -> Index:
    """Return a row of a solution's table as integers.

    Args:
        table: a row for each of :data:`chutecalc.core.records.FIELDS`.
        name: of the row.
    """
    numbers: Index = table[FIELD[name]].astype(np.intp)
    return numbers
