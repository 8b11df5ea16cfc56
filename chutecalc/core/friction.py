"""The friction law, what walls bear of streams of some flow areas, and the equation of motion that it makes.

Along a segment the independent variable is the place c, 0 at its drawn start and 1 at its drawn end, and the unknown
y = v². Near rest that form is singular, so there r = √v is the independent variable and c the unknown.

Several streams go through it at once: those at the nodes of a panel, on one facet of a section and one piece of the
wall's yield locus. They stand in the section's :class:`chutecalc.core.section.Loads`.
"""

import math

from chutecalc.core import floats, section, slide

BEYOND = 1e6
"""Segments' lengths: places further off are none."""
TAPER_STEP = 1e-6
"""Of the segment's length: over which a taper's own change is taken, for Newton's derivative alone."""


def loads(facets: "section.Facets", k: int, at: "section.Loads", first: int, last: int) -> None:
    """The hydrostatic χ and the missing m of flow areas, each with half its logarithmic growth with the area.

    On a facet that begins at the area A_k under the width B_k, with its wetted length C: χ A and m A are there what
    they are at its foot, and grow by C sin β (rise + own C), with C = 2 (A - A_k)/(sin β (B + B_k)) and B the width of
    the free surface. The innermost stands on none: all that is 0.
    """
    if facets.circle and k == 0:
        for j in range(first, last):
            _, excess, growth, missing, missing_growth = section.arc(facets, at.area[j])
            at.excess[j], at.growth[j] = excess, 0.5 * growth
            at.missing[j], at.missing_growth[j] = missing, 0.5 * missing_growth
        return
    foot, wide, sine = facets.area[k], facets.width[k], facets.sine[k]
    twice, spread, apex = facets.twice[k], facets.spread[k], facets.apex[k]
    own, own_lack = facets.bend_excess[k], facets.bend_shortfall[k]
    below, rise = facets.excess[k], facets.excess_rise[k]
    lack, lack_rise = facets.shortfall[k], facets.shortfall_rise[k]
    per_width = 2.0 / wide if wide > 0.0 else 1.0
    for j in range(first, last):
        area = at.area[j]
        width = floats.root(spread * area + apex)
        climb = floats.quotient(twice, width + wide)
        narrow = floats.quotient(0.5 * wide, width)
        wetted = climb * (area - foot)
        square = climb * wetted
        thin = floats.quotient(1.0, area)
        hollow = foot * thin
        share, stands = square * own, (below + sine * rise * wetted) * thin
        at.excess[j] = share * (1.0 - hollow) + stands
        at.growth[j] = share * narrow + 0.5 * (share * hollow + (narrow * rise * per_width - stands))
        share, stands = square * own_lack, (lack + sine * lack_rise * wetted) * thin
        at.missing[j] = share * (1.0 - hollow) + stands
        at.missing_growth[j] = share * narrow + 0.5 * (share * hollow + (narrow * lack_rise * per_width - stands))


def loads_at(facets: "section.Facets", k: int, area: float) -> None:
    """The same of one flow area, which then stands first."""
    facets.loads.area[0] = area
    loads(facets, k, facets.loads, 0, 1)


def law(equilibrium: bool, at: "section.Loads", first: int, last: int) -> None:
    """Makes χ, and its growth, those of the friction law."""
    if equilibrium:
        for j in range(first, last):
            carried = 1.0 - at.missing[j]
            at.excess[j] = floats.quotient(at.excess[j], carried)
            at.growth[j] = floats.quotient(at.growth[j] + at.excess[j] * at.missing_growth[j], carried)


def law_and_factor(way: "slide.Slide", facet: int, area: float) -> tuple[float, float]:
    """χ of the friction law, and by how much that raises the hydrostatic pressures of all walls, f."""
    loads_at(way.facets, facet, area)
    return raised(way.equilibrium, way.facets.loads)


def raised(equilibrium: bool, at: "section.Loads") -> tuple[float, float]:
    """The same of the flow area whose hydrostatic loads stand first, and stay there.

    Hydrostatic normal forces add up to (1 + χ - m) N where N = ρ n A is the weight, and the law's friction takes
    (1 + χ) N of them. One factor for all walls closes the books: f = (1 + χ)/(1 + χ - m) with the paper's law, and
    1/(1 - m) with the equilibrium law, whose χ is already divided by 1 - m.
    """
    excess, missing = at.excess[0], at.missing[0]
    if equilibrium:
        return floats.quotient(excess, 1.0 - missing), floats.quotient(1.0, 1.0 - missing)
    return excess, floats.quotient(1.0 + excess, 1.0 + excess - missing)


def stress(way: "slide.Slide", facet: int, place: float, y: float) -> float:
    """Pressure on the centre section that decides the wall friction, f ρ n H, Pa."""
    if y <= 0.0:
        return floats.INFINITY
    slide.draw(way, place)
    area = slide.flow_area(way, y)
    _, factor = law_and_factor(way, facet, area)
    depth, _ = section.depth_and_width(way.facets, facet, area)
    return way.density * slide.normal(way, place, y) * factor * depth


def resist(way: "slide.Slide", facet: int, piece: int, first: int, last: int) -> None:
    """χ of the friction law and what adhesion adds, of the flow areas that stand there."""
    loads(way.facets, facet, way.facets.loads, first, last)
    stick(way, facet, piece, way.facets.loads, first, last)
    law(way.equilibrium, way.facets.loads, first, last)


def stick(way: "slide.Slide", facet: int, piece: int, at: "section.Loads", first: int, last: int) -> None:
    """What adhesion adds to friction, over g, and half of its fall and of its rise with the logarithm of the area.

    As friction is (slope + τ(0)/σ)(1 + χ) n with σ = f ρ n H, adhesion holds the stream by (1 + χ)/f τ(0)/(ρ H), where
    (1 + χ)/f = 1 + χ - m, hydrostatic, is what the walls bear.
    """
    if not way.sticky:
        for j in range(first, last):
            at.stuck[j] = at.fall[j] = at.climb[j] = 0.0
        return
    for j in range(first, last):
        depth, width = section.depth_and_width(way.facets, facet, at.area[j])
        stuck = floats.quotient(way.intercepts[piece], way.density * way.gravity * depth)
        at.stuck[j] = stuck * (1.0 + at.excess[j] - at.missing[j])
        at.fall[j] = floats.quotient(0.5 * at.stuck[j] * at.area[j], width * depth)
        at.climb[j] = (at.growth[j] - at.missing_growth[j]) * stuck


def pull(way: "slide.Slide", piece: int, place: float, y: float, number: int) -> tuple[float, float]:
    """dy/dc of the stream of that number at a place, and its derivative to c where the section stays the same."""
    if not (place > -BEYOND and place < BEYOND):  # an iterate that leads nowhere
        return floats.NAN, floats.NAN
    slope = way.entry_slope + way.turn * place
    resistance = way.slopes[piece] * (1.0 + way.facets.loads.excess[number])  # μ_e
    sine, cosine = math.sin(slope), math.cos(slope)
    doubled = 2.0 * way.length * way.gravity
    press = way.side * cosine + way.bend / way.gravity * y
    change = doubled * (sine - resistance * press - way.facets.loads.stuck[number])
    return change, doubled * way.turn * (cosine + resistance * way.side * sine)


def pull_there(way: "slide.Slide", facet: int, piece: int, place: float, y: float) -> tuple[float, float]:
    """The same of a stream of that y."""
    slide.draw(way, place)
    way.facets.loads.area[0] = slide.flow_area(way, y)
    resist(way, facet, piece, 0, 1)
    return pull(way, piece, place, y, 0)


def pull_and_growth(way: "slide.Slide", facet: int, piece: int, place: float, y: float) -> tuple[float, float]:
    """dy/dc there, and its derivative to y."""
    change, _ = pull_there(way, facet, piece, place, y)
    drag, pressed = 1.0 + way.facets.loads.excess[0], slide.normal(way, place, y) / way.gravity
    bending = way.slopes[piece] * way.facets.loads.growth[0] * pressed
    bending += way.facets.loads.climb[0] - way.facets.loads.fall[0]
    loosened = way.slopes[piece] * drag * way.bend / way.gravity
    return change, 2.0 * way.length * way.gravity * (floats.quotient(bending, y) - loosened)


def pull_at(way: "slide.Slide", place: float, y: float) -> float:
    """Dy/dc at a place, whatever the facet and the piece there."""
    slide.draw(way, place)
    facet, piece = section.facet_of(way.facets, slide.flow_area(way, y)), 0
    if way.pieces > 1:
        piece = slide.piece_of(way, stress(way, facet, place, y))
    change, _ = pull_there(way, facet, piece, place, y)
    return change


def place_rate(
    way: "slide.Slide", facet: int, piece: int, r: float, width: float, place: float
) -> tuple[float, float, float]:
    """Dc over a panel in r = √v of a width, its derivative to c, and dy/dc: dc/dr = 4 r³/(dy/dc)."""
    y = r * r * r * r
    change, growth = pull_there(way, facet, piece, place, y)
    if way.taper:
        ahead, _ = pull_there(way, facet, piece, place + TAPER_STEP, y)
        behind, _ = pull_there(way, facet, piece, place - TAPER_STEP, y)
        growth = (ahead - behind) / (2.0 * TAPER_STEP)
    rate = floats.quotient(4.0 * width * r * r * r, change)
    return rate, floats.quotient(-rate * growth, change), change
