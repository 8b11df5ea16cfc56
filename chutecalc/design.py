"""The numeric description of a chute, which the solver reads.

Everything is SI and radians. Numbers are arrays of length 1 or n, never 0-dimensional, so one description stands for
one design or for many; a length of 1 is shared by all of them and stays short until a varied number meets it.
"""

from typing import Any, NamedTuple, TypeVar

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.section import Section
from chutecalc.physics.troughed_belt import BeltLoad
from chutecalc.physics.wall import Wall

VERTICAL = np.array([np.pi / 2])
"""Slope of what falls straight down, rad."""


class Status:
    """Numbers that say how a design, or one of its segments, ends.

    Plain numbers: NumPy takes ten microseconds to compare an array with a member of an enumeration.
    """

    OK, STALL, CHOKE, CONTACT_LOST, MISSED, NOT_REACHED, PASSED = range(7)
    """Number of each status. From ``MISSED`` on the stream has not touched the segment; one that it flies past is
    ``PASSED``."""

    LABELS = ("ok", "stall", "choke", "contact_lost", "missed", "not_reached", "passed")
    """Names of the statuses in tables, JSON and CSV, by number."""

    OK_LABEL = LABELS[OK]
    IMPOSSIBLE_LABEL = "impossible"
    """Status in a study of a variant whose section cannot be built, and which is therefore never solved."""


class Contact(NamedTuple):
    """A segment that guides the stream, straight or along an arc."""

    name: str
    kind: str
    side: float
    """σ: 1 for a floor, -1 for a roof."""
    deflects: bool
    """Whether the stream only strikes it, and leaves as the impact sends it."""
    entry_slope: Array | None
    """Drawn slope at its start, rad below horizontal; None if it is tangent to the stream that falls into it."""
    exit_slope: Array
    """Drawn slope at its end, rad below horizontal."""
    radius: Array | None
    """Radius of an arc, m; None for a straight."""
    length: Array | None
    """Length of a straight, m; None for an arc, whose length follows from its slopes."""
    start: tuple[Array, Array] | None
    """x and z of its drawn start, m; None if that is the end of the segment before it. NaN stands for None."""
    may_be_passed: bool
    """Whether a stream may pass it without touching it; otherwise the chute fails there."""
    section: Section
    """Section at its start, and at its end if it does not taper."""
    end_section: Section | None
    """Section at the end of a taper; else None."""
    wall: Wall
    measured: tuple[Array, Array] | None
    """Least and greatest normal stress of the yield locus, Pa; None for a constant friction angle."""
    slip_ratio: Array
    """Slip velocity at the wall over mean velocity."""
    thickness: Array | None
    """Thickness of the liner, m, or None."""
    wear_rate: Array | None
    """Volume that the liner loses per frictional work, m³/J, or None."""

    @property
    def closed(self) -> bool:
        """Whether it has a roof opposite to its surface, along which a stream may run too."""
        return self.section.closed and not self.deflects

    @property
    def may_end_elsewhere(self) -> bool:
        """Whether a stream that gets through may leave the chute otherwise than from the drawn end of this segment."""
        return self.deflects or self.may_be_passed

    def wall_height(self, share: Array) -> Array:
        """Return the wall height above which the segment chokes, m; infinite where none is given.

        Args:
            share: of the segment's length, from 0 to 1, of any shape.
        """
        first = self.section.wall_height
        if self.end_section is None or np.isinf(first).any():
            return first
        return first + share * (self.end_section.wall_height - first)

    def drawn_end(self, before: Array | None) -> Array:
        """Return the slope at which the segment is drawn to end, rad, whatever comes before it.

        Args:
            before: slope at which the segment before it is drawn to end, rad, or None.
        """
        return self.exit_slope


class Fall(NamedTuple):
    """Free flight: onto the segment after it if that has its own start, else to a level or a distance."""

    name: str
    kind: str
    drop: Array | None
    """Height of its drawn start above its end, m, or None."""
    run: Array | None
    """Horizontal distance from its drawn start to its end, m, or None."""
    start: tuple[Array, Array] | None = None
    """x and z of its drawn start, m; None if that is the end of the segment before it, or the inlet."""

    @property
    def deflects(self) -> bool:
        """Whether the stream only strikes it: never, as it has no surface."""
        return False

    @property
    def closed(self) -> bool:
        """Whether it has a roof: never."""
        return False

    @property
    def may_end_elsewhere(self) -> bool:
        """Whether a stream that gets through may leave the chute elsewhere: never, as it has no surface."""
        return False

    def drawn_end(self, before: Array | None) -> Array | None:
        """Return the slope at which a stream that follows the drawing ends, rad; None if its velocity decides.

        Args:
            before: slope at which the segment before it is drawn to end, rad, or None.
        """
        return VERTICAL if before is not None and (before == VERTICAL).all() else None


class Belt(NamedTuple):
    """The belt that the stream comes from; see :func:`chutecalc.physics.head_pulley.discharge`."""

    centre: tuple[Array, Array]
    """x and z of the centre of its head pulley, m."""
    velocity: Array
    """Belt velocity, m/s."""
    incline: Array
    """Incline of the belt, rad, positive uphill."""
    lower_radius: Array
    """Radius of the stream's lower edge on the pulley, m."""
    middle_radius: Array
    """Radius of the stream's centre line on the pulley, m."""
    friction: Array | None
    """Friction angle of the material on the belt, rad; None where none is given, and the belt holds the stream."""
    load: BeltLoad | None
    """The load on a belt whose width is given; else None."""

    @property
    def edge_radii(self) -> dict[str, Array]:
        """Radius on the pulley of the stream's lower edge, centre line and upper edge, m, by their names."""
        upper = 2.0 * self.middle_radius - self.lower_radius
        return {"lower": self.lower_radius, "middle": self.middle_radius, "upper": upper}


class Receiver(NamedTuple):
    """The belt that the stream goes to."""

    velocity: Array
    """Belt velocity, m/s."""
    slope: Array
    """Slope of the belt, rad below horizontal."""
    friction: Array
    """Friction coefficient of the material on the belt."""
    plan_angle: Array
    """Plan angle ψ between the headings of stream and belt, rad, seen from above."""
    at: tuple[Array, Array] | None
    """x and z of a point of its surface, m; None if that is where the last segment ends."""

    @property
    def slope_of_trace(self) -> Array:
        """Slope of the line in which its surface cuts the plane of the chute, rad: tan b = tan a_b cos ψ."""
        trace: Array = np.arctan2(np.sin(self.slope) * np.cos(self.plan_angle), np.cos(self.slope))
        return trace


Segment = Contact | Fall


class Design(NamedTuple):
    """A chute, or n of them in parallel arrays."""

    mass_rate: Array
    density: Array
    lump: Array | None
    """Size of the largest lump, m, or None."""
    gravity: Array
    internal_friction: Array | None
    """δ, rad; None where the spec gives a pressure ratio alone."""
    vertical_ratio: Array
    """Pressure ratio K_v at vertical walls."""
    momentum_factor: Array
    """Momentum factor α_m."""
    longitudinal_ratio: Array
    """Longitudinal pressure ratio K_l."""
    equilibrium: bool
    """Whether wall pressures are scaled until they carry the weight, instead of the paper's friction law."""
    inlet_position: tuple[Array, Array]
    inlet_velocity: Array
    inlet_slope: Array
    belt: Belt | None
    receiver: Receiver | None
    limits: tuple[Array, ...]
    """Limits of findings, in the order of :data:`chutecalc.spec.limits.LIMITS`; infinite where there is none."""
    segments: tuple[Segment, ...]

    @property
    def volume_rate(self) -> Array:
        """Volume rate Q = ṁ/ρ, m³/s."""
        return self.mass_rate / self.density

    def __repr__(self) -> str:
        """Return how many designs there are, and their segments.

        >>> import chutecalc
        >>> chutecalc.parse(chutecalc.STARTER).design
        <Design of 1: fall, spoon>
        """
        return f"<Design of {length(self)}: {', '.join(segment.name for segment in self.segments)}>"


Record = TypeVar("Record", bound=tuple[Any, ...])
"""A named tuple whose fields are arrays, such tuples, or values that all designs share."""


def stretched(array: Any, shape: tuple[int, ...]) -> Any:
    """Return an array broadcast to a shape; the array itself if it has that shape, as NumPy is slow even then.

    Args:
        array: any NumPy array.
        shape: of the result.
    """
    return array if array.shape == shape else np.broadcast_to(array, shape)


def select(record: Record, rows: Index | slice) -> Record:
    """Return the record of some of the designs; values that all designs share stay as they are.

    Args:
        record: named tuple whose arrays have designs along their last axis, of length 1 or n.
        rows: numbers of the designs from 0; a slice is faster for neighbours.
    """
    chosen: list[Any] = []
    for field in record:
        if isinstance(field, np.ndarray):
            if field.shape[-1] != 1:
                field = field[..., rows] if isinstance(rows, slice) else field.take(rows, axis=-1)
        elif isinstance(field, tuple) and field:
            field = select(field, rows)
        chosen.append(field)
    return type(record)(*chosen) if hasattr(record, "_fields") else type(record)(chosen)


def length(record: tuple[Any, ...]) -> int:
    """Return how many designs a record describes.

    Args:
        record: named tuple whose arrays have designs along their last axis, of length 1 or n.
    """
    longest = 1
    for field in record:
        if isinstance(field, np.ndarray):
            longest = max(longest, field.shape[-1])
        elif isinstance(field, tuple) and field:
            longest = max(longest, length(field))
    return longest
