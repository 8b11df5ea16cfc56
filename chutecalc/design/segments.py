"""Segments in numbers: those that guide the stream or are struck by it, and free flight."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Section
from chutecalc.physics.wall import Wall

VERTICAL = np.array([np.pi / 2])
"""Slope of what falls straight down, rad."""


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
    own_material: bool
    """Whether the stream slides on a bed of itself, as in a rock box, and not on a liner."""
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


Segment = Contact | Fall
