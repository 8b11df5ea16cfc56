"""The base class of all kinds of segment."""

from collections.abc import Mapping
from typing import ClassVar, NamedTuple

from pydantic import Field

from chutecalc import design
from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Name
from chutecalc.fields.table import Table
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Section as DrawnSection
from chutecalc.physics.wall import Wall
from chutecalc.sections.base import Section


class Lining(NamedTuple):
    """A liner in numbers."""

    wall: Wall
    """Friction law."""
    measured: tuple[Array, Array] | None
    """Least and greatest normal stress of the yield locus, Pa; None for other liners."""
    own_material: bool
    """Whether the stream slides on a bed of itself."""
    slip_ratio: Array
    """Slip velocity at the wall over mean velocity."""
    thickness: Array | None
    """Thickness, m, or None."""
    wear_rate: Array | None
    """Volume lost per frictional work, m³/J, or None."""


class Context(NamedTuple):
    """What the numbers of a segment follow from, beside its own table."""

    location: Location
    """Location of the segment in the spec's data."""
    name: str
    """Name of the segment, also where the spec gives it none."""
    slope: Array | None
    """Slope at which the segment before it is drawn to end, rad below horizontal; None if velocity decides."""
    tangent: Array | None
    """Slope at which an arc begins that is tangent to what comes before it, rad; None if velocity decides."""
    sections: Mapping[str, Section]
    """Tables of the spec's sections, by name."""
    drawn_sections: Mapping[str, DrawnSection]
    """Sections of the spec in numbers, by name."""
    linings: Mapping[str, Lining]
    """Liners of the spec in numbers, by name."""
    faults: GeometryFaults
    """Collector of the faults of geometry."""


class Segment(Table):
    """A segment.

    A kind derives from it, with its value of ``kind`` as a ``Literal``, its keys, :attr:`example` and :meth:`build`.
    """

    kind: str
    name: Name | None = Field(
        None, description="name of the segment in paths, tables and findings; its kind if not given"
    )

    example: ClassVar[str] = ""
    """TOML of such a segment without its header, for the starter."""
    guides: ClassVar[bool] = True
    """Whether it guides the stream, and so has a section and a liner."""
    placed: ClassVar[dict[str, str]] = {}
    """Keys that it needs after a fall with ``onto_next``, each with what to add."""

    def build(self, context: Context) -> design.Segment:
        """Return the segment in numbers, in SI units.

        Args:
            context: what the numbers follow from, beside this table.
        """
        raise NotImplementedError
