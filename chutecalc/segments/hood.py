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
    to_slope_deg: Slope = Field(description="slope at its end, below horizontal; it has to steepen")

    example: ClassVar = """\
kind = "hood"                   # a curved roof that carries the stream; has to steepen
radius_m = 2.0
to_slope_deg = 80
"""

    def build(self, context: Context) -> Contact:
        """Return an arc of a roof."""
        return self.arc(context, ROOF)

    def check_turn(self, entry: Array, exit_: Array) -> tuple[Mask, str, str]:
        """Return which designs do not steepen between two slopes, rad, the problem and the remedy."""
        problem = (
            f"has to be steeper than the start of the hood, {degrees(entry)}: only a roof that steepens guides a stream"
        )
        return exit_ <= entry, problem, "give a steeper slope, or use a curve"
