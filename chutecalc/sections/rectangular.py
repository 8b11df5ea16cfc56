"""A rectangular section."""

from typing import ClassVar, Literal

from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import OpenSection


class Rectangular(OpenSection):
    """A rectangle."""

    shape: Literal["rectangular"]
    width_m: Length = Field(description="width between the walls")

    example: ClassVar = """\
shape = "rectangular"
width_m = 0.8                   # between the walls
"""

    def build(self, location: Location, faults: GeometryFaults) -> Polygon:
        """Return a centre section between two vertical walls.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        return Polygon(in_si(self.width_m, "length"), (), (), self.wall_height)
