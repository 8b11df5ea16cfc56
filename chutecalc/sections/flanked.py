"""Geometry that chamfered and vee sections share."""

from typing import Any

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Rise
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Polygon
from chutecalc.sections.base import length_or_unbounded

ChamferAngle = Rise
STEEPEST_VEE = in_si(89.0, "angle")
"""Angle of flanks that meet at most, rad: steeper ones leave a stream a slit."""


def flanked(
    base: Array, chamfer_deg: Any, chamfer_m: Any, wall_height: Array, location: Location, faults: GeometryFaults
) -> Polygon:
    """Return a centre section between two chamfers.

    Args:
        base: width of the centre section, m, shape (1,) or (designs,); 0 if the flanks meet.
        chamfer_deg: angle of the chamfers to the centre section, deg, as the spec has it.
        chamfer_m: length of a chamfer, m, or None if it has no top.
        wall_height: of the walls above the floor, m.
        location: of the section in the spec's data.
        faults: collects upright chamfers without a base between them.
    """
    angle = in_si(chamfer_deg, "angle")
    problem, narrow = "leaves the section no width, as it has no base", (base == 0.0) & (angle > STEEPEST_VEE)
    faults.note(narrow, (*location, "chamfer_deg"), chamfer_deg, problem, "give 89° or less, or a base")
    return Polygon(base, (length_or_unbounded(chamfer_m),), (angle,), wall_height)
