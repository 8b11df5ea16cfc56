"""Points of a drawing, in millimetres."""

import math

import numpy as np

from chutecalc.physics.surface import Surface, point

PER_METRE = 1000.0
"""Drawing units in a metre: steel is drawn in millimetres."""
Point = tuple[float, float]
"""x and y, mm."""


def place(surface: Surface, share: float, height: float = 0.0) -> Point:
    """Return a point at a height above a surface of one design, as a drawing has it, mm.

    Args:
        surface: the surface.
        share: of its length, dimensionless.
        height: normal to it on the side of the stream, m.
    """
    x, z, slope = (float(each[0]) for each in point(surface, np.full(1, share)))
    above = float(np.ravel(surface.side)[0]) * height
    return PER_METRE * (x + above * math.sin(slope)), PER_METRE * (z + above * math.cos(slope))
