"""Compute what pressure along the stream adds to its equation of motion.

At the depth ζ below its free surface a stream bears the pressure K_l ρ n ζ across its section, K_l ρ n T in all, where
T = ∫ b ζ dζ is the first moment of the flow area about the surface. Momentum then gives for a uniform stream

    v dv/ds · [1 - K_l n A/(b_s v²) + 2 K_l σ κ T/A] = g sin a - μ_e n - K_l (σ κ T/A g sin a + n ∂H/∂s)

with b_s the width of the free surface and ∂H/∂s the change of depth along a taper at the same flow area, 0 elsewhere.
The bracket falls to 0 where v² b_s/(n A) falls to about K_l: the stream jumps to a greater depth there.
"""

import math

from chutecalc.core import floats, friction, guide_surface, section

JUMP_ITERATIONS = 12  # to aim by; a panel finds the jump itself
HALVINGS, NEAREST = 36, 1e-16  # in a pipe, of a logarithm; how near to full the jump is looked for, of v²


def mean_depth(facets: "section.Facets", k: int, area: float, depth: float, width: float) -> float:
    """Return the mean depth T/A of a flow area below its free surface, m, on facet k."""
    if facets.circle and k == 0:
        return floats.quotient(width * width * width, 12.0 * area) - (facets.radius - depth)
    moment, first = 0.0, 0
    if facets.circle:
        first, moment = 1, 2.0 * facets.radius * facets.radius * facets.radius / 3.0
    for j in range(first, k + 1):
        top = depth if j == k else facets.height[j + 1]
        rise = top - facets.height[j]
        if rise != 0.0:  # as of a level facet; below 0 too where a panel goes on below the facet, to stay smooth
            moment += (facets.area[j] + (0.5 * facets.width[j] + facets.four_cot[j] * rise / 12.0) * rise) * rise
    return floats.quotient(moment, area)


def depth_change(guide: "guide_surface.Guide", k: int, area: float, depth: float, width: float) -> float:
    """Return by how much the depth of a flow area changes along a taper, over its length, m; set_section has set it."""
    if guide.facets.circle:  # A = r² F(H/r)
        widening = (guide.last.radius - guide.first.radius) / guide.section_here.radius
        return -floats.quotient((2.0 * area - depth * width) * widening, width)
    return -floats.quotient(area_change(guide.first, guide.last, guide.section_here, guide.facets, k, depth), width)


def area_change(
    first: "section.Section",
    last: "section.Section",
    here: "section.Section",
    facets: "section.Facets",
    k: int,
    depth: float,
) -> float:
    """Return by how much the flow area of a polygon below a depth changes along a taper, m².

    The strip on each facet, of width w at its foot, wetted length C and rise h, has the area h (w + C cos ψ), and all
    of w, C, ψ and the height of the foot change.

    Args:
        first, last, here: the section at the start, at the end, and at the place in question.
        facets: of the section at that place.
        k: facet on which the free surface lies.
        depth: H, m.
    """
    change, widening, lifting = 0.0, last.base - first.base, 0.0
    for j in range(k + 1):
        sine, cosine, turning, lengthening = facets.sine[j], facets.cosine[j], 0.0, 0.0
        rise = (depth if j == k else facets.height[j + 1]) - facets.height[j]
        wetted = floats.quotient(rise, sine) if j == k else here.lengths[j]
        if j < here.walls:
            turning = last.inclinations[j] - first.inclinations[j]
            lengthening = last.lengths[j] - first.lengths[j]
        rising = -lifting if j == k else lengthening * sine + wetted * cosine * turning
        slanted = 2.0 * wetted * cosine * rising - wetted * wetted * turning
        change += widening * rise + facets.width[j] * rising + slanted
        if j < k:
            widening += 2.0 * (lengthening * cosine - wetted * sine * turning)
            lifting += rising
    return change


def forces(guide: "guide_surface.Guide", facet: int, piece: int, share: float, y: float) -> tuple[float, float]:
    """Return the force that accelerates the stream, over its weight, and the bracket."""
    guide_surface.set_section(guide, share)
    guide.facets.loads.area[0] = guide_surface.flow_area(guide, y)
    friction.set_resistance(guide, facet, piece, 0, 1)
    area, sine = guide.facets.loads.area[0], math.sin(guide.entry_slope + guide.turn * share)
    pressed = guide_surface.normal_acceleration(guide, share, y) / guide.gravity
    depth, width = section.depth_and_width(guide.facets, facet, area)
    bend = guide.longitudinal * guide.signed_curvature * mean_depth(guide.facets, facet, area, depth, width)
    resistance = guide.slopes[piece] * (1.0 + guide.facets.loads.excess[0])  # μ_e
    force = sine * (1.0 - bend) - resistance * pressed - guide.facets.loads.adhesion[0]
    if guide.taper:
        force -= guide.longitudinal * pressed * depth_change(guide, facet, area, depth, width) / guide.length
    swell = guide.longitudinal * pressed * guide.gravity * floats.quotient(area, width * y)
    return force, 1.0 + 2.0 * bend - swell


def bracket(guide: "guide_surface.Guide", facet: int, share: float, y: float) -> float:
    """Return the bracket alone; 1 without longitudinal pressure."""
    if guide.longitudinal == 0.0:
        return 1.0
    guide_surface.set_section(guide, share)
    area = guide_surface.flow_area(guide, y)
    normal = guide_surface.normal_acceleration(guide, share, y)
    depth, width = section.depth_and_width(guide.facets, facet, area)
    bend = guide.signed_curvature * mean_depth(guide.facets, facet, area, depth, width)
    return 1.0 + guide.longitudinal * (2.0 * bend - normal * floats.quotient(area, width * y))


def jump_ahead(guide: "guide_surface.Guide", facet: int, share: float, y: float) -> float:
    """Return a v² near that at which the bracket falls to 0 at a share; 0 where it does not.

    One less the bracket falls as v^-3 in a wide stream.
    """
    if guide.longitudinal == 0.0:
        return 0.0
    guide_surface.set_section(guide, share)
    full = guide_surface.full_velocity(guide)
    if full > 0.0:
        return jump_above_full(guide, facet, share, y, full * full)
    for _ in range(JUMP_ITERATIONS):
        missing = 1.0 - bracket(guide, facet, share, y)
        if not missing > 0.0:
            return 0.0
        if missing >= 1.0:
            break
        y *= missing ** (2.0 / 3.0)
    return y


def jump_above_full(guide: "guide_surface.Guide", facet: int, share: float, y: float, full: float) -> float:
    """Return the v² at which the bracket falls to 0 in a pipe; 0 where it does not.

    It does before the pipe runs full, where the surface has no width: next to that, or far from it.

    Args:
        guide, facet, share, y: as in :func:`jump_ahead`.
        full: v² at which the pipe runs full.
    """
    if not y > full or not bracket(guide, facet, share, y) > 0.0:
        return y
    low, high = math.log(NEAREST * y), math.log(y - full)
    if bracket(guide, facet, share, full + NEAREST * y) > 0.0:
        return 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if bracket(guide, facet, share, full + math.exp(middle)) > 0.0:
            high = middle
        else:
            low = middle
    return full + math.exp(low)
