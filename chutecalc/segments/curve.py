"""An arc of a floor."""

from typing import ClassVar, Literal

from chutecalc.design import Contact
from chutecalc.segments.arc import Arc
from chutecalc.segments.base import Context


class Curve(Arc):
    """A curve: a curved floor, a spoon where it flattens and a crest where it steepens."""

    kind: Literal["curve"]

    example: ClassVar = """\
kind = "curve"                  # a curved floor; one that steepens is a crest
radius_m = 3.0
to_slope_deg = 40               # turns from the slope before it to this one
"""

    def build(self, context: Context) -> Contact:
        """Return an arc of a floor.

        Args:
            context: what the numbers follow from, beside this table.
        """
        return self.arc(context)
