"""Evaluate the right-hand side of the equation of motion.

Along a segment the independent variable is the share c, 0 at its drawn start and 1 at its drawn end, and the unknown is
y = v². Near rest this form is singular, so there r = √v is the independent variable and c the unknown. What pressure
along the stream adds is in :mod:`chutecalc.core.longitudinal`.
"""

import math

from chutecalc.core import floats, friction, guide_surface, longitudinal, section

FARTHEST_SHARE = 1e6
"""Shares beyond this are not evaluated."""
TAPER_STEP = 1e-6
"""Share over which a change along a segment is differenced; it enters Newton's derivative only."""
NEAR_FULL = 0.1  # of what v² is above that of a full pipe
DIFFERENCE = 2e-5
"""Fraction of v² over which forces with longitudinal pressure are differenced, likewise."""


def rhs_at_node(guide: "guide_surface.Guide", piece: int, share: float, y: float, number: int) -> tuple[float, float]:
    """Return dy/dc of an entry of the loads at a share, and its derivative by c for a constant section."""
    if not (share > -FARTHEST_SHARE and share < FARTHEST_SHARE):  # a diverged iterate
        return floats.NAN, floats.NAN
    slope = guide.entry_slope + guide.turn * share
    resistance = guide.slopes[piece] * (1.0 + guide.facets.loads.excess[number])  # μ_e
    sine, cosine = math.sin(slope), math.cos(slope)
    scale = 2.0 * guide.length * guide.gravity
    normal_share = guide.side * cosine + guide.signed_curvature / guide.gravity * y
    change = scale * (sine - resistance * normal_share - guide.facets.loads.adhesion[number])
    return change, scale * guide.turn * (cosine + resistance * guide.side * sine)


def rhs(guide: "guide_surface.Guide", facet: int, piece: int, share: float, y: float) -> tuple[float, float]:
    """Return dy/dc at a share and a y, and its derivative by c for a constant section, without pressure along it."""
    guide_surface.set_section(guide, share)
    guide.facets.loads.area[0] = guide_surface.flow_area(guide, y)
    friction.set_resistance(guide, facet, piece, 0, 1)
    return rhs_at_node(guide, piece, share, y, 0)


def rhs_and_jacobian(
    guide: "guide_surface.Guide", facet: int, piece: int, share: float, y: float
) -> tuple[float, float]:
    """Return dy/dc at a share and a y, and its derivative by y."""
    if guide.longitudinal > 0.0:
        value, first, _ = pressed_rhs(guide, facet, piece, share, y)
        return value, floats.quotient(first, y)
    change, _ = rhs(guide, facet, piece, share, y)
    drag, pressed = (
        1.0 + guide.facets.loads.excess[0],
        guide_surface.normal_acceleration(guide, share, y) / guide.gravity,
    )
    load_change = guide.slopes[piece] * guide.facets.loads.excess_sensitivity[0] * pressed
    load_change += guide.facets.loads.adhesion_rise[0] - guide.facets.loads.adhesion_fall[0]
    centrifugal = guide.slopes[piece] * drag * guide.signed_curvature / guide.gravity
    return change, 2.0 * guide.length * guide.gravity * (floats.quotient(load_change, y) - centrifugal)


def pressed_rhs(
    guide: "guide_surface.Guide", facet: int, piece: int, share: float, y: float
) -> tuple[float, float, float]:
    """Return dy/dc with pressure along the stream, and y and y² times its first and second derivative by y.

    Force and bracket are differenced one by one: they are smooth where their quotient is not. There is no solution
    beyond the jump, where the bracket is below 0.
    """
    force, bracket = longitudinal.forces(guide, facet, piece, share, y)
    full = guide_surface.full_velocity(guide)
    step = min(DIFFERENCE, NEAR_FULL * (1.0 - full * full / y))  # there is no stream in more than a full pipe
    more, more_bracket = longitudinal.forces(guide, facet, piece, share, y * (1.0 + step))
    less, less_bracket = longitudinal.forces(guide, facet, piece, share, y * (1.0 - step))
    if not bracket > 0.0:
        return floats.NAN, floats.NAN, floats.NAN
    scale = 2.0 * guide.length * guide.gravity
    value = force / bracket
    bracket_slope = (more_bracket - less_bracket) / (2.0 * step)
    first = ((more - less) / (2.0 * step) - value * bracket_slope) / bracket
    force_bend = (more - 2.0 * force + less) / (step * step)
    bracket_bend = (more_bracket - 2.0 * bracket + less_bracket) / (step * step)
    second = (force_bend - value * bracket_bend - 2.0 * first * bracket_slope) / bracket
    return scale * value, scale * first, scale * second


def branch(guide: "guide_surface.Guide", share: float, y: float) -> tuple[int, int]:
    """Return the facet and the piece of the wall's friction law that hold at a share and a y."""
    guide_surface.set_section(guide, share)
    facet, piece = section.facet_of(guide.facets, guide_surface.flow_area(guide, y)), 0
    if guide.pieces > 1:
        piece = guide_surface.piece_of(guide, friction.wall_stress(guide, facet, share, y))
    return facet, piece


def force_any_branch(guide: "guide_surface.Guide", share: float, y: float) -> float:
    """Return gravity's pull less friction as dy/dc at a share and a y, without pressure along the stream."""
    facet, piece = branch(guide, share, y)
    change, _ = rhs(guide, facet, piece, share, y)
    return change


def rhs_any_branch(guide: "guide_surface.Guide", share: float, y: float) -> float:
    """Return dy/dc at a share and a y, on whatever facet and piece hold there."""
    if guide.longitudinal == 0.0:
        return force_any_branch(guide, share, y)
    facet, piece = branch(guide, share, y)
    force, bracket = longitudinal.forces(guide, facet, piece, share, y)
    return floats.quotient(2.0 * guide.length * guide.gravity * force, bracket)


def rhs_in_r(
    guide: "guide_surface.Guide", facet: int, piece: int, r: float, width: float, share: float
) -> tuple[float, float, float, float]:
    """Return dc over a panel of a given width in r = √v, its derivative by c, dy/dc, and the bracket.

    dc/dr = 4 r³/(dy/dc). It is smooth at the jump, where the bracket of longitudinal pressure is 0.
    """
    if guide.longitudinal > 0.0:
        rate, bracket = rate_in_r(guide, facet, piece, r, width, share)
        ahead, _ = rate_in_r(guide, facet, piece, r, width, share + TAPER_STEP)
        behind, _ = rate_in_r(guide, facet, piece, r, width, share - TAPER_STEP)
        return rate, (ahead - behind) / (2.0 * TAPER_STEP), floats.quotient(4.0 * width * r * r * r, rate), bracket
    y = r * r * r * r
    change, slope_in_share = rhs(guide, facet, piece, share, y)
    if guide.taper:
        ahead, _ = rhs(guide, facet, piece, share + TAPER_STEP, y)
        behind, _ = rhs(guide, facet, piece, share - TAPER_STEP, y)
        slope_in_share = (ahead - behind) / (2.0 * TAPER_STEP)
    rate = floats.quotient(4.0 * width * r * r * r, change)
    return rate, floats.quotient(-rate * slope_in_share, change), change, 1.0


def rate_in_r(
    guide: "guide_surface.Guide", facet: int, piece: int, r: float, width: float, share: float
) -> tuple[float, float]:
    """Return dc over a panel of a given width in r with pressure along the stream, and the bracket."""
    if not (share > -FARTHEST_SHARE and share < FARTHEST_SHARE):  # a diverged iterate
        return floats.NAN, floats.NAN
    force, bracket = longitudinal.forces(guide, facet, piece, share, r * r * r * r)
    return floats.quotient(2.0 * width * r * r * r * bracket, guide.length * guide.gravity * force), bracket
