"""A section of any number of flat walls."""

from itertools import pairwise
from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import RISES, Width
from chutecalc.fields.quantity import Number, Quantity, in_si
from chutecalc.fields.table import Table
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import OpenSection, Section
from chutecalc.sections.flanked import STEEPEST_VEE

MOST_FACETS = 100
"""Facets of a side at most: those of half a circle would differ from it by 3e-5 of its radius."""


class Facet(Table):
    """A flat wall."""

    length_m: Width = Field(description="length along the section")
    slope_deg: Annotated[Number, Quantity("angle", RISES, zero=True)] = Field(
        description="slope from the plane of the section"
    )


class Faceted(OpenSection):
    """Flat walls one above the other."""

    shape: Literal["facets"]
    facets: list[Facet] = Field(
        min_length=1,
        max_length=MOST_FACETS,
        description="facets of one side, from the centre outwards, none flatter than the one before",
    )

    example: ClassVar = """\
shape = "facets"                # one side, from the centre outwards, ever steeper
facets = [{ length_m = 0.25, slope_deg = 5 }, { length_m = 0.2, slope_deg = 40 }]
"""

    def build(self, location: Location, faults: GeometryFaults) -> Polygon:
        """Return facets from the centre outwards; those that are level are the centre section.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        lengths = [in_si(facet.length_m, "length") for facet in self.facets]
        slopes = [in_si(facet.slope_deg, "angle") for facet in self.facets]
        location = (*location, "facets")
        for number, (lower, upper) in enumerate(pairwise(slopes), 2):
            value, remedy = self.facets[number - 1].slope_deg, "order the facets from the centre outwards"
            problem = "is flatter than the facet before it"
            faults.note(upper < lower, (*location, number - 1, "slope_deg"), value, problem, remedy)
        faults.note(
            slopes[-1] == 0.0, location, None, "are all level and cannot hold a stream", "add a facet that rises"
        )
        value, problem = self.facets[0].slope_deg, "leaves the section no width"
        remedy = "begin with a facet that is less steep"
        faults.note(slopes[0] > STEEPEST_VEE, (*location, 0, "slope_deg"), value, problem, remedy)
        return Polygon(np.zeros(1), tuple(lengths), tuple(slopes), self.wall_height)

    def is_like(self, other: Section) -> bool:
        """Return whether the section differs from another one in numbers only: it has as many facets.

        Args:
            other: section of any shape.
        """
        return super().is_like(other) and isinstance(other, Faceted) and len(self.facets) == len(other.facets)
