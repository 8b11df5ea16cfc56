"""One segment as n designs went through it. Arrays are of shape (n,), NaN in designs that did not get that far."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.core import joint, records
from chutecalc.design import Contact, Segment
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.surface import Surface
from chutecalc.solver.panels import Panels, Way


class Point(NamedTuple):
    """The stream at one place."""

    distance: Array
    """From the inlet along the stream, m."""
    x: Array
    z: Array
    slope: Array
    """Below horizontal, rad."""
    velocity: Array
    error: Array
    """Estimated relative error of the velocity; in flight with the sign that goes with those of place and slope."""
    x_error: Array
    z_error: Array
    slope_error: Array


class Impact(NamedTuple):
    """What an impact does, see :class:`chutecalc.core.records.Impact`; 0 where a stream meets the surface along it."""

    footprint: Array
    pressure: Array
    stress: Array
    wall_friction: Array
    friction: Array
    after: Array
    wear: Array


class Arrival(NamedTuple):
    """How streams meet a segment, see :class:`chutecalc.core.records.Arrival`."""

    distance: Array
    place: Array
    velocity: Array
    incidence: Array
    gap: Array
    status: Index
    impact: Impact


class Stretch(NamedTuple):
    """The way along a segment."""

    place: Array
    """Where it ends, as a share of the segment's length."""
    velocity_squared: Array
    beyond: Array
    """After a choke: where the stream would end on the segment between higher walls; NaN else."""
    beyond_status: Index
    """After a choke: how it would end there."""
    tried: Index
    """Panels solved, also such as were refused."""


class ContactLeg:
    """What a leg has along a guiding surface; each is read when it is asked for."""

    def __init__(self, segment: Contact, table: Array, way: Way, panels: Panels) -> None:
        """Of a leg's table; ``panels`` are those taken, as far as they are kept."""
        self.segment, self.table, self.way, self.panels = segment, table, way, panels

    def widened(self, table: Array) -> "ContactLeg":
        """The same of the designs of a table, where one has gone for all of them."""
        count, panels = table.shape[1], self.panels
        way, first = self.way.widened(count), np.repeat(panels.first, count)
        return ContactLeg(self.segment, table, way, Panels(way, panels.kept, first, np.repeat(panels.count, count)))

    @cached_property
    def surface(self) -> Surface:
        """The segment as it stands."""
        return Surface(self.segment.side, *columns(self.table, "surface_x", 5))

    @cached_property
    def arrival(self) -> Arrival:
        """How it is met."""
        impact = Impact._make(columns(self.table, "footprint", 7))
        return Arrival._make((*columns(self.table, "distance", 5), whole(self.table, "met"), impact))

    @cached_property
    def ends(self) -> Array:
        """Where the way begins, as a share of the length, the velocity there, where it ends, and v² there."""
        return self.table.take(_ENDS, axis=0)

    @cached_property
    def stretch(self) -> Stretch:
        """The way along it."""
        counts = whole(self.table, "beyond_status"), whole(self.table, "tried")
        return Stretch._make((*columns(self.table, "end_place", 3), *counts))


class Leg:
    """One segment as n designs went through it; its numbers are read when they are asked for."""

    def __init__(self, number: int, segment: Segment, table: Array, contact: ContactLeg | None) -> None:
        """A leg.

        Args:
            number: of the segment, from 0; one that is left and struck again has a leg for each time.
            segment: the segment.
            table: a row for each of :data:`chutecalc.core.records.FIELDS`, a column for each design.
            contact: what it has of a guiding surface.
        """
        self.number, self.segment, self.table, self.contact = number, segment, table, contact

    @cached_property
    def start(self) -> Point:
        """As the stream comes from the segment before."""
        return self._point("start")

    @cached_property
    def entry(self) -> Point:
        """On the surface, after an impact; for a fall the same as ``exit``."""
        return self._point("entry")

    @cached_property
    def exit(self) -> Point:
        """At the end, or where the design fails."""
        return self._point("exit")

    @cached_property
    def status(self) -> Index:
        """A :class:`~chutecalc.design.Status` each."""
        return whole(self.table, "status")

    @property
    def path(self) -> Array:
        """The flight that begins at ``start``: a fall's, or what leads from an edge to a contact segment.

        Five rows: x and z, velocities forward and downward, gravity.
        """
        return columns(self.table, "path_x", 5)

    @property
    def flight_time(self) -> Array:
        """Of the flight, s; 0 where there is none."""
        time: Array = self.table[AT["flight_time"]]
        return time

    @property
    def flown(self) -> Array:
        """How far it flies, m."""
        flown: Array = self.table[AT["distance"]]
        return flown

    def widened(self, count: int) -> "Leg":
        """The same of so many designs, where one has gone for all of them."""
        table = np.repeat(self.table, count, axis=1)
        return Leg(self.number, self.segment, table, self.contact and self.contact.widened(table))

    def _point(self, at: str) -> Point:
        return Point._make(columns(self.table, f"{at}_distance", 9))


class Ends(NamedTuple):
    """How n designs end; what a design has, or what is left of it, that fails before the end of the chute."""

    status: Index
    """A :class:`~chutecalc.design.Status` each."""
    velocity: Array
    """m/s."""
    error: Array
    """Estimated, relative, of the last velocity there is; after a stall of its place, as a share of the segment."""
    distance: Array
    x: Array
    z: Array
    slope: Array
    lying: Array
    """How the stream lies in the last section, see :func:`chutecalc.core.walls.lie`: tables of shape (1, n), if asked
    for."""
    pressing: Array
    """What the walls bear there, see :func:`chutecalc.core.walls.press`, likewise."""


TANGENT = joint.SAME
"""rad: directions closer than this are one."""
AT = {name: number for number, name in enumerate(records.FIELDS)}
"""Where each number of a leg stands in its row."""
_ENDS = np.array([AT[name] for name in ("place", "after", "end_place", "end_squared")])


def columns(table: Array, first: str, count: int) -> Array:
    """Neighbouring numbers of a leg, from the one of that name on; a table has a row for each number."""
    return table[AT[first] : AT[first] + count]


def whole(table: Array, name: str) -> Index:
    """A whole number."""
    numbers: Index = table[AT[name]].astype(np.intp)
    return numbers
