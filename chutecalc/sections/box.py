"""A closed rectangular section."""

from typing import ClassVar, Literal

from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import ClosedSection


class Box(ClosedSection):
    """A rectangle with a roof."""

    shape: Literal["box"]
    width_m: Length = Field(description="inner width between the walls")
    height_m: Length = Field(description="inner height between floor and roof")

    example: ClassVar = """\
shape = "box"                   # rectangular and closed; it chokes when full
width_m = 0.6                   # between the walls
height_m = 0.4                  # between floor and roof
"""

    def build(self, location: Location, faults: GeometryFaults) -> Polygon:
        """Return a centre section between two vertical walls, below a roof.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        return Polygon(in_si(self.width_m, "length"), (), (), in_si(self.height_m, "length"), closed=True)
