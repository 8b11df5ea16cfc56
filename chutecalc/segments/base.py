"""What all kinds of segment have in common."""

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
    """Its friction law."""
    measured: tuple[Array, Array] | None
    """Least and greatest normal stress of the yield locus's rows, Pa; None for other liners."""
    slip_ratio: Array
    """Slip velocity at the wall over mean velocity."""


class Context(NamedTuple):
    """What a segment is built from beside its own table."""

    location: Location
    """Of the segment in the spec's data."""
    name: str
    slope: Array | None
    """At which the segment before it is drawn to end, rad; None where only the stream itself tells."""
    tangent: Array | None
    """At which a curve begins that is tangent to what comes before it, rad; None where only the stream itself tells."""
    sections: Mapping[str, Section]
    """Of the spec, by name."""
    drawn_sections: Mapping[str, DrawnSection]
    """The same in numbers."""
    linings: Mapping[str, Lining]
    """Of the spec, by the name of the liner."""
    faults: GeometryFaults
    """Collects what is wrong."""


class Segment(Table):
    """A segment."""

    kind: str
    name: Name | None = Field(None, description="how paths, tables and findings call it; its kind without it")

    example: ClassVar[str] = ""
    """TOML of such a segment, below its header; the starter shows it."""
    guides: ClassVar[bool] = True
    """Whether it guides the stream, and so has a section and a liner."""
    placed: ClassVar[dict[str, str]] = {}
    """Keys that it needs after a fall that goes ``onto_next``, each with what to add."""

    def build(self, context: Context) -> design.Segment:
        """Return the segment in numbers."""
        raise NotImplementedError
