"""A pipe."""

from typing import ClassVar, Literal

from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.physics.section import Circle
from chutecalc.sections.base import ClosedSection


class Pipe(ClosedSection):
    """A round pipe."""

    shape: Literal["pipe"]
    radius_m: Length = Field(description="inner radius of the pipe")

    example: ClassVar = """\
shape = "pipe"                  # round and closed; it chokes when full
radius_m = 0.25
"""

    def build(self, location: Location, faults: GeometryFaults) -> Circle:
        """Return an arc that closes.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        radius = in_si(self.radius_m, "length")
        return Circle(radius, 2.0 * radius, closed=True)
