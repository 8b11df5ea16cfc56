"""What sections with two chamfers, or with two flanks, have in common."""

from typing import Annotated, Any

import numpy as np

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantity import Number, Quantity, in_si
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import length_or_unbounded

ChamferAngle = Annotated[Number, Quantity("angle", gt=0, le=90)]


def flanked(
    base: Array, chamfer_deg: Any, chamfer_m: Any, wall_height: Array, location: Location, faults: GeometryFaults
) -> Polygon:
    """Return a centre section between two chamfers.

    Args:
        base: width of the centre section, m, of length 1 or n; 0 where the flanks meet.
        chamfer_deg: angle of the chamfers to the centre section, deg, as the spec has it.
        chamfer_m: length of a chamfer, m, likewise; None for one that has no top.
        wall_height: of the walls above the floor, m.
        location: of the section in the spec's data.
        faults: collects what is wrong: chamfers that rise straight from no base.
    """
    angle = in_si(chamfer_deg, "angle")
    problem, narrow = "leaves the section no width, as it has no base", (base == 0.0) & (angle == np.pi / 2)
    faults.note(narrow, (*location, "chamfer_deg"), chamfer_deg, problem, "give less than 90°, or a base")
    return Polygon(base, (length_or_unbounded(chamfer_m),), (angle,), wall_height)
