"""One segment as n designs went through it. Arrays are of shape (n,), NaN in designs that did not get that far."""

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
    panels: Panels | None
    """Those taken, where they are kept."""


class ContactLeg(NamedTuple):
    """What a leg has along a guiding surface."""

    surface: Surface
    way: Way
    arrival: Arrival
    stretch: Stretch


class Leg(NamedTuple):
    """One segment as n designs went through it."""

    number: int
    """Of the segment, from 0; one that is left and struck again has a leg for each time."""
    segment: Segment
    start: Point
    """As it comes from the segment before."""
    path: Array
    """The flight that begins at ``start``: a fall's, or what leads from an edge to a contact segment. Five rows: x and
    z, velocities forward and downward, gravity."""
    flight_time: Array
    """s, 0 where the stream does not fly."""
    flown: Array
    """How far it flies, m."""
    entry: Point
    """On the surface, after an impact; for a fall the same as ``exit``."""
    exit: Point
    """At the end, or where the design fails."""
    status: Index
    """A :class:`~chutecalc.design.Status` each."""
    contact: ContactLeg | None


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


def columns(table: Array, first: str, count: int) -> Array:
    """Neighbouring numbers of a leg, from the one of that name on; a table has a row for each number."""
    return table[AT[first] : AT[first] + count]


def whole(table: Array, name: str) -> Index:
    """A whole number."""
    numbers: Index = table[AT[name]].astype(np.intp)
    return numbers


def surface_of(table: Array, contact: Contact) -> Surface:
    """The segment as it stands."""
    return Surface(contact.side, *columns(table, "surface_x", 5))
