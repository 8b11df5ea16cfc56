"""A circular section."""

from typing import ClassVar, Literal

from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.physics.section import Circle
from chutecalc.sections.base import OpenSection


class Circular(OpenSection):
    """The lower half of a circle, with vertical walls above it."""

    shape: Literal["circular"]
    radius_m: Length = Field(description="radius of the circle")

    example: ClassVar = """\
shape = "circular"              # lower half of a circle, vertical walls above it
radius_m = 0.4
"""

    def build(self, location: Location, faults: GeometryFaults) -> Circle:
        """Return an arc below vertical walls.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        return Circle(in_si(self.radius_m, "length"), self.wall_height)
