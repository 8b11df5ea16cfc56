"""The base class of flat segments."""

from typing import ClassVar

import numpy as np
from pydantic import Field

from chutecalc.fields.quantities import LONG, Length, Slope
from chutecalc.fields.quantity import in_si
from chutecalc.fields.rules import one_of
from chutecalc.fields.table import Rules
from chutecalc.fields.units import with_unit
from chutecalc.physics.arrays import Array
from chutecalc.segments.base import Context
from chutecalc.segments.guide import Guide

LONGEST = LONG.most
"""Greatest length of a segment, m, as of every length in a spec."""


class Flat(Guide):
    """A flat segment, given by its slope and one of its measures."""

    slope_deg: Slope = Field(description="slope below horizontal")
    length_m: Length = Field(None, description="length along the segment")
    drop_m: Length = Field(None, description="height of the segment, instead of its length")
    run_m: Length = Field(None, description="horizontal length of the segment, instead of its length")

    rules: ClassVar[Rules] = (one_of("length_m", "drop_m", "run_m"),)

    def measured_length(self, context: Context, slope: Array) -> Array:
        """Return the length, m, shape (1,) or (designs,), from whichever of its three measures is given.

        A drop gives drop/|sin a| and a run gives run/cos a.

        Args:
            context: its faults collect measures that give no length, or too large a one.
            slope: a, rad below horizontal.
        """
        length = self._length(context, slope)
        key = "drop_m" if self.drop_m is not None else "run_m"
        problem = (
            f"makes the segment {with_unit(float(length.max()), 'm')} long, and the limit is {with_unit(LONGEST, 'm')}"
        )
        value, remedy = getattr(self, key), "change it or the slope"
        context.faults.note(length > LONGEST, (*context.location, key), value, problem, remedy)
        return np.minimum(length, LONGEST)

    def _length(self, context: Context, slope: Array) -> Array:
        """Return the length, m, without its upper limit."""
        if self.length_m is not None:
            return in_si(self.length_m, "length")
        faults, location = context.faults, context.location
        if self.drop_m is not None:
            problem = "does not give the length of a level segment"
            faults.note(slope == 0.0, (*location, "drop_m"), self.drop_m, problem, "give length_m or run_m")
            return in_si(self.drop_m, "length") / np.where(slope != 0.0, np.abs(np.sin(slope)), 1.0)
        problem = "does not give the length of a vertical segment"
        faults.note(slope == np.pi / 2, (*location, "run_m"), self.run_m, problem, "give length_m or drop_m")
        return in_si(self.run_m, "length") / np.where(slope != np.pi / 2, np.cos(slope), 1.0)
