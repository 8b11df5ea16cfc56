"""Free flight."""

from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from chutecalc import design
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.fields.rules import one_of
from chutecalc.physics.arrays import Array
from chutecalc.segments.base import Context, Segment


class Fall(Segment):
    """Free flight."""

    kind: Literal["fall"]
    drop_m: Length = Field(
        None, description="height from its drawn start, the end of the segment before it or the inlet, to its end"
    )
    run_m: Length = Field(None, description="horizontal length of the fall, instead of its height")
    onto_next: Literal[True] | None = Field(
        None, description="true for a fall to where the stream meets the next segment, which has start_m"
    )

    example: ClassVar = """\
kind = "fall"                   # free flight
drop_m = 2.0                    # or run_m, or onto_next = true where the next segment has its own start_m
"""
    guides: ClassVar = False
    rules: ClassVar = (one_of("drop_m", "run_m", "onto_next"),)

    def build(self, context: Context) -> design.Fall:
        """Return free flight to a level, to a distance or onto the next segment.

        Args:
            context: what the numbers follow from, beside this table.
        """
        if self.run_m is not None and context.slope is not None:
            problem, location = "is never reached, as the stream falls straight down", (*context.location, "run_m")
            context.faults.note(context.slope == np.pi / 2, location, self.run_m, problem, "give drop_m")
        return design.Fall(context.name, self.kind, _optional(self.drop_m), _optional(self.run_m))


def _optional(length: Any) -> Array | None:
    """Return a length in m, or None."""
    return None if length is None else in_si(length, "length")
