"""An inclined floor."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from chutecalc.design import Contact
from chutecalc.fields.quantities import Slope
from chutecalc.fields.quantity import in_si
from chutecalc.fields.rules import is_numeric
from chutecalc.fields.table import Violation
from chutecalc.segments.base import Context
from chutecalc.segments.flat import Flat


def downhill(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield a violation where a straight floor rises.

    Args:
        table: of a straight, with documented keys.
    """
    slope: Any = table.get("slope_deg")
    if is_numeric(slope) and np.any(np.less(slope, 0.0)):
        yield Violation(
            ("slope_deg",), "must be at least 0: a straight floor does not rise", "use a curve for a floor that rises"
        )


class Straight(Flat):
    """A straight: an inclined floor."""

    kind: Literal["straight"]
    slope_deg: Slope = Field(description="slope below horizontal, at least 0")

    example: ClassVar = """\
kind = "straight"               # an inclined floor
slope_deg = 50
length_m = 1.5                  # or drop_m, or run_m
"""
    rules: ClassVar = (*Flat.rules, downhill)

    def build(self, context: Context) -> Contact:
        """Return a straight floor.

        Args:
            context: what the numbers follow from, beside this table.
        """
        slope = in_si(self.slope_deg, "angle")
        return self.contact(context, slope, slope, length=self.measured_length(context, slope))
