"""The section of a chute at the end of a segment as a trough, with the area of the stream there."""

import math

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.dem.request import Beds
from chutecalc.dem.trough import Trough
from chutecalc.design import Contact
from chutecalc.errors import UsageError
from chutecalc.physics.section import Polygon


def section_of(chute: Chute, name: str | None) -> Beds:
    """Return the section at the end of a segment, with the area and wall friction of the stream there.

    Args:
        chute: A chute of one design.
        name: Name of the segment; None where only one segment guides the stream.

    Raises:
        UsageError: There is no such segment, its section has a curved wall, or the stream does not reach its end.

    >>> import chutecalc
    >>> found = section_of(chutecalc.parse(chutecalc.STARTER), "spoon")
    >>> [wall.name for wall in found.troughs[0].walls[::2]], round(found.areas[0], 4)
    (['floor', 'chamfer'], 0.0558)
    """
    design = chute.design
    guides = [segment for segment in design.segments if isinstance(segment, Contact)]
    chosen = [segment for segment in guides if name in (None, segment.name)]
    if len(chosen) != 1:
        problem = f"has no segment {name!r} that guides the stream" if name else "has several segments"
        names = ", ".join(segment.name for segment in guides)
        raise UsageError(f"{chute.source} {problem}. Use --segment with one of {names}")
    contact = chosen[0]
    section = contact.end_section or contact.section
    if not isinstance(section, Polygon):
        raise UsageError(f"the section of {contact.name} has a curved wall. Choose a segment with flat walls only")
    result = next(result for result in solve(chute).segments if result.name == contact.name)
    area, friction = (float(result.exit[key][0]) for key in ("area_m2", "equivalent_friction"))
    if not math.isfinite(area):
        raise UsageError(f"the stream does not reach the end of {contact.name}: its status is {result.status[0]}")
    trough, vertical_ratio = Trough.of(section), float(design.vertical_ratio[0])
    excess = float(trough.wetting(area, vertical_ratio, design.equilibrium).excess[0])
    return Beds(
        troughs=[trough],
        areas=[area],
        wall_friction=float(np.arctan(friction / (1.0 + excess))),
        vertical_ratio=vertical_ratio,
    )
