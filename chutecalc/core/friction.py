"""Evaluate the friction law, and the loads that it reads.

Several streams are evaluated at once: those at the nodes of a panel, on one facet of a section and one piece of the
wall's yield locus. They are held in the section's :class:`chutecalc.core.section.Loads`.
"""

import math

from chutecalc.core import floats, guide_surface, section


def hydrostatic_loads(facets: "section.Facets", k: int, at: "section.Loads", first: int, last: int) -> None:
    """Write the hydrostatic χ and missing load m of flow areas, and half the logarithmic derivatives by the area.

    On a facet that begins at the area A_k below the width B_k, with wetted length C, χ A and m A are what they are at
    its foot plus C sin β (rise + own C), where C = 2 (A - A_k)/(sin β (B + B_k)) and B is the width of the free
    surface. At the innermost facet's foot all of this is 0.
    """
    if facets.circle and k == 0:
        for j in range(first, last):
            _, excess, excess_sensitivity, missing, missing_sensitivity = section.arc(facets, at.area[j])
            at.excess[j], at.excess_sensitivity[j] = excess, 0.5 * excess_sensitivity
            at.missing[j], at.missing_sensitivity[j] = missing, 0.5 * missing_sensitivity
            at.bend[j] = floats.quotient(1.0, math.fabs(1.0 - at.area[j] / facets.full))
        return
    foot, foot_width, sine = facets.area[k], facets.width[k], facets.sine[k]
    two_over_sine, four_cot, apex_width_squared = (
        facets.two_over_sine[k],
        facets.four_cot[k],
        facets.apex_width_squared[k],
    )
    own_excess, own_shortfall = facets.sine_own_excess[k], facets.sine_own_shortfall[k]
    below, rise = facets.excess[k], facets.excess_rise[k]
    shortfall, shortfall_rise = facets.shortfall[k], facets.shortfall_rise[k]
    per_width = 2.0 / foot_width if foot_width > 0.0 else 1.0
    for j in range(first, last):
        area = at.area[j]
        width = floats.root(four_cot * area + apex_width_squared)
        wetted_per_area = floats.quotient(two_over_sine, width + foot_width)
        width_ratio = floats.quotient(0.5 * foot_width, width)
        wetted = wetted_per_area * (area - foot)
        square = wetted_per_area * wetted
        per_area = floats.quotient(1.0, area)
        foot_ratio = foot * per_area
        own_part, foot_part = square * own_excess, (below + sine * rise * wetted) * per_area
        at.excess[j] = own_part * (1.0 - foot_ratio) + foot_part
        at.excess_sensitivity[j] = own_part * width_ratio + 0.5 * (
            own_part * foot_ratio + (width_ratio * rise * per_width - foot_part)
        )
        own_part, foot_part = square * own_shortfall, (shortfall + sine * shortfall_rise * wetted) * per_area
        at.missing[j] = own_part * (1.0 - foot_ratio) + foot_part
        at.missing_sensitivity[j] = own_part * width_ratio + 0.5 * (
            own_part * foot_ratio + (width_ratio * shortfall_rise * per_width - foot_part)
        )


def hydrostatic_loads_at(facets: "section.Facets", k: int, area: float) -> None:
    """Write the hydrostatic loads of one flow area, as the first entry."""
    facets.loads.area[0] = area
    hydrostatic_loads(facets, k, facets.loads, 0, 1)


def apply_friction_law(equilibrium: bool, at: "section.Loads", first: int, last: int) -> None:
    """Replace the hydrostatic χ and its derivative by those of the friction law."""
    if equilibrium:
        for j in range(first, last):
            carried = 1.0 - at.missing[j]
            at.excess[j] = floats.quotient(at.excess[j], carried)
            at.excess_sensitivity[j] = floats.quotient(
                at.excess_sensitivity[j] + at.excess[j] * at.missing_sensitivity[j], carried
            )


def friction_law_at(guide: "guide_surface.Guide", facet: int, area: float) -> tuple[float, float]:
    """Return χ of the friction law, and the factor f by which it raises the hydrostatic pressures of all walls."""
    hydrostatic_loads_at(guide.facets, facet, area)
    return friction_law(guide.equilibrium, guide.facets.loads)


def friction_law(equilibrium: bool, at: "section.Loads") -> tuple[float, float]:
    """Return χ and f of the first entry, whose hydrostatic loads stay as they are.

    Hydrostatic normal forces add up to (1 + χ - m) N, where N = ρ n A is the weight, and the law's friction takes (1 +
    χ) N of them. One factor for all walls balances the two: f = (1 + χ)/(1 + χ - m) with the paper's law, and 1/(1 - m)
    with the equilibrium law, whose χ is already divided by 1 - m.
    """
    excess, missing = at.excess[0], at.missing[0]
    if equilibrium:
        return floats.quotient(excess, 1.0 - missing), floats.quotient(1.0, 1.0 - missing)
    return excess, floats.quotient(1.0 + excess, 1.0 + excess - missing)


def wall_stress(guide: "guide_surface.Guide", facet: int, share: float, y: float) -> float:
    """Return the pressure on the centre section at which wall friction is read, f ρ n H, Pa; infinite at rest."""
    if y <= 0.0:
        return floats.INFINITY
    guide_surface.set_section(guide, share)
    area = guide_surface.flow_area(guide, y)
    _, factor = friction_law_at(guide, facet, area)
    depth, _ = section.depth_and_width(guide.facets, facet, area)
    return guide.density * guide_surface.normal_acceleration(guide, share, y) * factor * depth


def set_resistance(guide: "guide_surface.Guide", facet: int, piece: int, first: int, last: int) -> None:
    """Write χ of the friction law and the adhesion of the flow areas in the section's loads."""
    hydrostatic_loads(guide.facets, facet, guide.facets.loads, first, last)
    set_adhesion(guide, facet, piece, guide.facets.loads, first, last)
    apply_friction_law(guide.equilibrium, guide.facets.loads, first, last)


def set_adhesion(
    guide: "guide_surface.Guide", facet: int, piece: int, at: "section.Loads", first: int, last: int
) -> None:
    """Write what adhesion adds to friction, over g, and half of its fall and rise with the logarithm of the area.

    As friction is (slope + τ(0)/σ)(1 + χ) n with σ = f ρ n H, adhesion holds the stream by (1 + χ)/f τ(0)/(ρ H), where
    (1 + χ)/f = 1 + χ - m, hydrostatic, is what the walls bear.
    """
    if not guide.adhesive:
        for j in range(first, last):
            at.adhesion[j] = at.adhesion_fall[j] = at.adhesion_rise[j] = 0.0
        return
    for j in range(first, last):
        depth, width = section.depth_and_width(guide.facets, facet, at.area[j])
        adhesion = floats.quotient(guide.intercepts[piece], guide.density * guide.gravity * depth)
        at.adhesion[j] = adhesion * (1.0 + at.excess[j] - at.missing[j])
        at.adhesion_fall[j] = 0.0
        if at.area[j] < guide.facets.full:  # beyond, depth is that of a full pipe
            at.adhesion_fall[j] = floats.quotient(0.5 * at.adhesion[j] * at.area[j], width * depth)
        at.adhesion_rise[j] = (at.excess_sensitivity[j] - at.missing_sensitivity[j]) * adhesion
