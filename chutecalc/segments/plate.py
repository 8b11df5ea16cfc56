"""A flat impact plate."""

from typing import ClassVar, Literal

from chutecalc.design import Contact
from chutecalc.fields.quantity import in_si
from chutecalc.physics.motion import ROOF
from chutecalc.segments.base import Context
from chutecalc.segments.flat import Flat


class Plate(Flat):
    """An impact plate: a flat roof that the stream strikes and leaves."""

    kind: Literal["plate"]

    side: ClassVar = ROOF
    example: ClassVar = """\
kind = "plate"                  # a flat roof that the stream strikes and leaves
slope_deg = 70
length_m = 0.8
"""

    def build(self, context: Context) -> Contact:
        """Return a flat roof that deflects the stream.

        Args:
            context: what the numbers follow from, beside this table.
        """
        slope = in_si(self.slope_deg, "angle")
        length = self.measured_length(context, slope)
        return self.contact(context, slope, slope, length=length, deflects=True)
