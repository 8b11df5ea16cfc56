"""What the numbers of a spec make together where the stream enters, and how far the chute reaches from there."""

import numpy as np

from chutecalc.design import Contact, Segment
from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import LONG, WIDE
from chutecalc.fields.quantity import in_si
from chutecalc.fields.units import with_unit
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import width_of
from chutecalc.spec.chute_spec import ChuteSpec

LARGEST_AREA = WIDE.most**2
"""Flow area that a stream may enter with at most, m²: that of the largest section."""
DEEPEST = WIDE.most
"""Mean depth that a stream may enter with at most, m."""
ENDLESS = 1e9
"""Length that a flank without a top counts as, m."""


def check_entry(spec: ChuteSpec, velocity: Array, first: Segment, faults: GeometryFaults) -> None:
    """Note a stream that enters at rest on a segment that guides it, or larger or deeper than any chute.

    Args:
        spec: the checked spec.
        velocity: of the stream where it enters, m/s.
        first: the first segment.
        faults: collects what is wrong.
    """
    at, written = ("inlet", "velocity_m_s"), spec.inlet.velocity_m_s
    rest = "give a velocity above 0, or begin with a fall"
    if isinstance(first, Contact):
        faults.note(velocity == 0.0, at, written, "leaves the stream at rest on the first segment", rest)
    if faults.found:  # a section that is none makes any stream deep
        return
    rate = in_si(spec.flow.rate_t_h, "mass rate") / in_si(spec.material.density_kg_m3, "density")
    location, given = ("flow", "rate_t_h"), spec.flow.rate_t_h
    remedy = "check the rate, the density, and the velocity and the width where it enters: is one in another unit?"
    large = (rate > LARGEST_AREA * velocity) & (velocity > 0.0)
    problem = f"makes the stream larger than {with_unit(LARGEST_AREA, 'm2')} where it enters"
    faults.note(large, location, given, problem, remedy)
    if not isinstance(first, Contact):
        return
    deep = (rate > DEEPEST * velocity * width_of(first.section, ENDLESS)) & (velocity > 0.0)
    problem = f"makes the stream deeper than {with_unit(DEEPEST, 'm')} where it enters"
    faults.note(deep & ~large, location, given, problem, remedy)


def check_reach(spec: ChuteSpec, faults: GeometryFaults) -> None:
    """Note what stands further from the inlet than any chute reaches.

    Args:
        spec: the checked spec.
        faults: collects what is wrong.
    """
    places: list[tuple[Location, object]] = [
        (("segments", number, "start_m"), getattr(segment, "start_m", None))
        for number, segment in enumerate(spec.segments)
    ]
    places.append((("receiver", "at_m"), None if spec.receiver is None else spec.receiver.at_m))
    for location, place in places:
        if not isinstance(place, list):
            continue
        away = [
            np.abs(in_si(there, "length") - in_si(here, "length"))
            for there, here in zip(place, spec.inlet.at_m, strict=True)
        ]
        problem = f"stands further than {with_unit(LONG.most, 'm')} from the inlet"
        faults.note(np.maximum(*away) > LONG.most, location, None, problem, "check it and inlet.at_m, and their units")
