"""A section with chamfered corners."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Depth, Length
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import OpenSection
from chutecalc.sections.flanked import ChamferAngle, flanked

ROUNDING = 1e-14


class Chamfered(OpenSection):
    """A centre section between two chamfers."""

    shape: Literal["chamfered"]
    base_m: Depth = Field(description="width of the centre section")
    chamfer_deg: ChamferAngle = Field(description="angle of the chamfers from the plane of the centre section")
    chamfer_m: Length = Field(
        None, description="length of a chamfer, with vertical walls above it; without it the chamfer has no top"
    )

    example: ClassVar = """\
shape = "chamfered"
base_m = 0.5                    # flat floor between the chamfers
chamfer_deg = 45
# chamfer_m = 0.15              # length of a chamfer, vertical walls above it; without it the chamfer has no top
"""
    adjustable: ClassVar = ("base_m", "chamfer_m")

    def build(self, location: Location, faults: GeometryFaults) -> Polygon:
        """Return a centre section between two chamfers.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        base = in_si(self.base_m, "length")
        return flanked(base, self.chamfer_deg, self.chamfer_m, self.wall_height, location, faults)

    def adjusted(self, drawn: "Chamfered", keep: str) -> tuple[dict[str, Array], Mask]:
        """Return base and chamfer length that hold the section's overall width, or its depth too, at another angle.

        With angle β, base B and chamfer C, and β₀ that of the spec: C sin β stays for the depth, and B + 2 C cos β for
        both. Written so that nothing changes, to the last digit, at β = β₀.

        Args:
            drawn: the same section at the angle of the spec.
            keep: ``width`` or ``depth``.

        Returns:
            ``base_m`` and ``chamfer_m``, in m, and which designs have a base that is not negative.
        """
        base, chamfer = np.atleast_1d(self.base_m), np.atleast_1d(self.chamfer_m)
        angle, before = np.radians(np.atleast_1d(self.chamfer_deg)), np.radians(drawn.chamfer_deg)
        length = chamfer * (np.sin(before) / np.sin(angle)) if keep == "depth" else chamfer
        width = base + 2.0 * chamfer * np.cos(before)
        left = base + 2.0 * (chamfer * np.cos(before) - length * np.cos(angle))
        left = np.where(np.abs(left) < ROUNDING * width, 0.0, left)  # a vee
        return {"base_m": left, "chamfer_m": length}, left >= 0.0
