"""What formulas of columns read besides the stream, and where along a chute a column exists."""

from functools import cached_property

import numpy as np

from chutecalc.design import Contact, Design, Segment
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Polygon


class SegmentContext:
    """What formulas of columns read besides the stream: the segment, its chute, and whether a surface guides it."""

    def __init__(self, segment: Segment, design: Design, guided: bool) -> None:
        """Take what formulas read.

        Args:
            segment: its description.
            design: the chutes.
            guided: whether the stream follows a surface here.
        """
        self.segment, self.design, self.guided = segment, design, guided

    @cached_property
    def start_time(self) -> Array:
        """Time from the inlet to the start, s; NaN, as only a part of a whole trajectory knows it."""
        return np.full(1, np.nan)

    @property
    def surface(self) -> Contact:
        """The description of the guiding surface; there is none of a fall."""
        assert isinstance(self.segment, Contact)
        return self.segment

    @property
    def slip_ratio(self) -> Array:
        """Slip velocity at the wall over mean velocity, dimensionless."""
        return self.surface.slip_ratio


def everywhere(part: SegmentContext) -> bool:
    """Return that a column exists on surfaces and in flight.

    Args:
        part: the part of the trajectory.
    """
    return True


def on_surface(part: SegmentContext) -> bool:
    """Return whether the part follows a guiding surface.

    Args:
        part: the part of the trajectory.
    """
    return part.guided


def on_arc(part: SegmentContext) -> bool:
    """Return whether the part follows an arc.

    Args:
        part: the part of the trajectory.
    """
    return part.guided and part.surface.radius is not None


def on_wearing_liner(part: SegmentContext) -> bool:
    """Return whether the part follows a liner whose life can be told: its thickness and wear rate are known.

    Args:
        part: the part of the trajectory.
    """
    return part.guided and part.surface.thickness is not None and part.surface.wear_rate is not None


def between_facets(part: SegmentContext) -> bool:
    """Return whether the part has a section with drawn facets beside its centre.

    Args:
        part: the part of the trajectory.
    """
    return part.guided and isinstance(part.surface.section, Polygon) and bool(part.surface.section.lengths)
