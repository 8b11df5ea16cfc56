"""A column along the stream: its formula, where it exists, and what it needs to be known."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, Flag
from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.results.column import Column
from chutecalc.results.segment_context import SegmentContext, everywhere


class Extremes(Enum):
    """Where the least and largest values of a column are reported."""

    NONE = 0
    ON_REQUEST = 1
    """Reported in sweeps, as ``max_`` and ``min_`` columns."""
    REPORTED = 2
    """There, and for each segment in tables, JSON and baselines."""


class Needs(Flag):
    """What the solver must work out at the end of a chute for the value of a column there."""

    NOTHING = 0
    DEPTH = 1
    """How the stream fills the section: depth, width, wetted lengths."""
    WALLS = 2
    """What the walls carry: pressures and friction."""
    WHOLE_PATH = 4
    """All that comes before, so that there is no such column at an exit alone."""


@dataclass(frozen=True, eq=False, kw_only=True)
class StreamColumn(Column):
    """A column along the stream, with its formula."""

    formula: Callable[[SegmentContext, Any], Array] | None = None
    """Function of the part and the profile that returns the values; None for text."""
    exists: Callable[[SegmentContext], bool] = everywhere
    needs: Needs = Needs.DEPTH | Needs.WALLS
    extremes: Extremes = Extremes.ON_REQUEST
    in_tables: bool = False
    """Whether the tables for people show it."""
    infinite_at_lift_off: bool = False
    """Whether it grows without bound where a stream leaves its surface."""

    def values(self, part: SegmentContext, profile: Any) -> Array:
        """Return the column along a part of the trajectory.

        Args:
            part: the part.
            profile: the stream there.

        Returns:
            Values of the profile's shape or broadcastable to it; one NaN where the column does not exist.
        """
        if self.formula is None or not self.exists(part):
            return np.full((1, 1), np.nan)
        return self.formula(part, profile)
