"""Compute the impact of a stream on a surface: the velocity it keeps, its pressure and its wear."""

import math

from chutecalc.core import floats, friction, guide_surface, records, section


def compute_impact(
    result: "records.Impact", guide: "guide_surface.Guide", share: float, velocity: float, incidence: float
) -> None:
    """Compute the impact of a stream on a segment.

    The section has its depth and friction at the arriving velocity. The impact presses on its footprint in addition to
    the pressure of the running stream, f ρ n H, and causes the segment's own friction on what it adds: the impulse has
    the coefficient (τ(σ + p) - τ(σ))/p. For a constant wall that is μ; with a yield locus a spoon made of many short
    straights tends to the curve. The normal part of the velocity is lost, and friction acts on its impulse: v (cos i -
    μ_e sin i) is left, nothing from tan i = 1/μ_e on. Friction works along v cos i before and what is left after, so
    slip is their mean; on all walls it takes ½ ṁ ((v cos i)² - after²).

    Args:
        result: the record to write.
        guide: the segment and the flow.
        share: share of the length where it is struck.
        velocity: arriving velocity, m/s.
        incidence: i, rad; 0 where the stream comes along the surface.
    """
    result.footprint = result.pressure = result.stress = result.wall_friction = result.friction = result.wear = 0.0
    result.velocity_after = velocity
    if not incidence > 0.0:
        return
    uniform = guide.momentum_root * velocity
    area = floats.quotient(guide.flow, uniform)
    guide_surface.set_section(guide, share)
    facet = section.facet_of(guide.facets, area)
    excess, factor = friction.friction_law_at(guide, facet, area)
    depth, _ = section.depth_and_width(guide.facets, facet, area)
    sine, tangential_velocity = math.sin(incidence), max(velocity * math.cos(incidence), 0.0)
    result.footprint = min(floats.quotient(depth, sine), guide.length)
    result.pressure = floats.quotient(guide.density * velocity * velocity * sine * depth, result.footprint)
    running_stress = (
        guide.density * max(guide_surface.normal_acceleration(guide, share, uniform * uniform), 0.0) * depth
    )
    result.wall_friction = added_friction(guide, factor * running_stress, factor * result.pressure)
    result.stress = factor * (running_stress + result.pressure)
    result.friction = result.wall_friction * (1.0 + excess)
    result.velocity_after = velocity * max(math.cos(incidence) - result.friction * sine, 0.0)
    impulse = result.friction * velocity * sine  # of which a stall takes no more than there is to stop
    taken = min(floats.quotient(tangential_velocity, impulse), 1.0) if impulse > 0.0 else 0.0
    result.wear = (
        result.wall_friction * factor * result.pressure * 0.5 * (tangential_velocity + result.velocity_after) * taken
    )


def added_friction(guide: "guide_surface.Guide", stress: float, added: float) -> float:
    """Return the shear stress that a normal stress adds to another, over that normal stress: (τ(σ + p) - τ(σ))/p.

    It is the mean of dτ/dσ over what is added, which does not cancel: μ for a constant wall, dτ/dσ where nothing is
    added.
    """
    if guide.pieces == 1:
        return guide.slopes[0]
    width, total = 0.0, 0.0
    for k in range(guide.pieces):
        top = guide.starts[k + 1] if k + 1 < guide.pieces else floats.INFINITY
        overlap = min(stress + added, top) - max(stress, guide.starts[k])
        if overlap > 0.0:
            width += overlap
            total += guide.slopes[k] * overlap
    return total / width if width > 0.0 else guide.slopes[guide_surface.piece_of(guide, stress)]
