"""An arc of a roof."""

from typing import ClassVar, Literal

from pydantic import Field

from chutecalc.design import Contact
from chutecalc.fields.quantities import Slope
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.motion import ROOF
from chutecalc.segments.arc import Arc, degrees
from chutecalc.segments.base import Context


class Hood(Arc):
    """A hood: a curved roof that carries the stream."""

    kind: Literal["hood"]
    to_slope_deg: Slope = Field(description="slope at its end, below horizontal; steeper than at its start")

    side: ClassVar = ROOF
    example: ClassVar = """\
kind = "hood"                   # a curved roof that guides the stream and must steepen
radius_m = 2.0
to_slope_deg = 80
"""

    def build(self, context: Context) -> Contact:
        """Return an arc of a roof.

        Args:
            context: what the numbers follow from, beside this table.
        """
        return self.arc(context)

    def check_turn(self, entry: Array, exit_: Array) -> tuple[Mask, str, str]:
        """Return the mask of designs whose hood does not steepen, with problem and remedy.

        Args:
            entry, exit_: slopes at its start and end, rad below horizontal.
        """
        problem = (
            f"must be steeper than the start of the hood, {degrees(entry)}: only a roof that steepens guides a stream"
        )
        return exit_ <= entry, problem, "give a steeper slope, or use a curve"
