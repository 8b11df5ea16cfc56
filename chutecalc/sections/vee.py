"""A vee-shaped section."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import OpenSection
from chutecalc.sections.flanked import ChamferAngle, flanked


class Vee(OpenSection):
    """Two flanks that meet."""

    shape: Literal["vee"]
    chamfer_deg: ChamferAngle = Field(description="angle of the flanks from the plane of the section")
    chamfer_m: Length = Field(
        None, description="length of a flank, with vertical walls above it; without it the flank has no top"
    )

    example: ClassVar = """\
shape = "vee"                   # two flanks that meet
chamfer_deg = 50
"""

    def build(self, location: Location, faults: GeometryFaults) -> Polygon:
        """Return two chamfers without a centre section between them.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        return flanked(np.zeros(1), self.chamfer_deg, self.chamfer_m, self.wall_height, location, faults)
