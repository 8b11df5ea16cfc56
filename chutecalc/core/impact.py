"""What happens where a stream strikes a surface: what it keeps, how hard it presses, and what that wears."""

import math

from chutecalc.core import floats, friction, records, section, slide


def strike(hit: "records.Impact", way: "slide.Slide", place: float, velocity: float, incidence: float) -> None:
    """The impact of a stream on a segment.

    The section has its depth and friction at the arriving velocity. The impact presses on the footprint beside what the
    stream presses with as it runs, f ρ n H, and the friction of that is the segment's own: so the impulse has
    (τ(σ + p) - τ(σ))/p. For a constant wall that is μ; with a yield locus a spoon made of many short straights tends to
    the curve with nothing else. The normal part of the velocity is lost, and friction acts on its impulse: it leaves
    v (cos i - μ_e sin i), nothing from tan i = 1/μ_e on. Friction works along v cos i before and what is left after, so
    slip is their mean; on all walls it takes ½ ṁ ((v cos i)² - after²).

    Args:
        hit: what it does.
        way: the segment and the flow.
        place: where it is struck, as a share of its length.
        velocity: arriving, m/s.
        incidence: i, rad; 0 where the stream comes along the surface.
    """
    hit.footprint = hit.pressure = hit.stress = hit.wall_friction = hit.friction = hit.wear = 0.0
    hit.after = velocity
    if not incidence > 0.0:
        return
    area = floats.quotient(way.flow, velocity)
    slide.draw(way, place)
    facet = section.facet_of(way.facets, area)
    excess, factor = friction.law_and_factor(way, facet, area)
    depth, _ = section.depth_and_width(way.facets, facet, area)
    sine, along = math.sin(incidence), max(velocity * math.cos(incidence), 0.0)
    hit.footprint = min(floats.quotient(depth, sine), way.length)
    hit.pressure = floats.quotient(way.density * velocity * velocity * sine * depth, hit.footprint)
    running = way.density * max(slide.normal(way, place, velocity * velocity), 0.0) * depth
    hit.wall_friction = added_friction(way, factor * running, factor * hit.pressure)
    hit.stress = factor * (running + hit.pressure)
    hit.friction = hit.wall_friction * (1.0 + excess)
    hit.after = velocity * max(math.cos(incidence) - hit.friction * sine, 0.0)
    impulse = hit.friction * velocity * sine  # of which a stall takes no more than there is to stop
    taken = min(floats.quotient(along, impulse), 1.0) if impulse > 0.0 else 0.0
    hit.wear = hit.wall_friction * factor * hit.pressure * 0.5 * (along + hit.after) * taken


def added_friction(way: "slide.Slide", stress: float, added: float) -> float:
    """Shear stress that a wall shows more for a normal stress added to another, over that: (τ(σ + p) - τ(σ))/p.

    As the mean of dτ/dσ over what is added, which does not cancel. μ for a constant wall; dτ/dσ where nothing is added.
    """
    if way.pieces == 1:
        return way.slopes[0]
    width, total = 0.0, 0.0
    for k in range(way.pieces):
        top = way.starts[k + 1] if k + 1 < way.pieces else floats.INFINITY
        overlap = min(stress + added, top) - max(stress, way.starts[k])
        if overlap > 0.0:
            width += overlap
            total += way.slopes[k] * overlap
    return total / width if width > 0.0 else way.slopes[slide.piece_of(way, stress)]
