"""The equation of motion of one stream along one segment, in the two forms that the solver integrates.

Along the segment the independent variable is the place c, 0 at its drawn start and 1 at its drawn end, and the unknown
y = v². Near rest that form is singular, so there r = √v is the independent variable and c the unknown.

The force is smooth as long as the surface stays on one facet of the section and the pressure on one piece of the wall's
yield locus: a branch.
"""

import math

from chutecalc.core import floats, section

BEYOND = 1e6
"""Segments' lengths: places further off are none."""
TAPER_STEP = 1e-6
"""Of the segment's length: over which a taper's own change is taken, for Newton's derivative alone."""


class Slide:
    """A segment, and the flow on it."""

    def __init__(self, facets: "section.Facets", first: "section.Section", last: "section.Section | None", pieces: int):
        self.facets = facets
        """Of the section at ``drawn_at``, or of all of it where it stays the same."""
        self.first = first
        """The section where the segment starts."""
        self.last = first if last is None else last
        self.here = section.Section(first.walls, first.circle)
        self.taper = last is not None
        self.drawn_at = 0.0
        self.x = self.z = 0.0
        """Where it starts, m."""
        self.side = self.gravity = self.entry_slope = self.turn = self.length = 0.0
        self.flow = self.density = self.vertical_ratio = 0.0
        self.equilibrium = False
        self.pieces = pieces
        """Of the wall's friction law, τ = intercept + slope σ from a σ on."""
        self.starts, self.intercepts, self.slopes = (floats.zeros(pieces) for _ in range(3))
        self.sticky = False
        """Whether any piece has an intercept."""
        self.bend = 0.0
        """σ κ, what v² adds to the normal acceleration, 1/m."""


def begin(slide: Slide) -> None:
    """Works out what follows from the numbers."""
    section.stack(slide.first, slide.vertical_ratio, slide.facets)
    section.blend(slide.first, slide.last, 0.0, slide.here)
    slide.drawn_at = 0.0
    slide.bend = -slide.side * slide.turn / slide.length
    slide.sticky = False
    for k in range(slide.pieces):
        if slide.intercepts[k] != 0.0:
            slide.sticky = True


def draw(slide: Slide, place: float) -> None:
    """Has the facets be those of the section at a place; of a taper alone."""
    if slide.taper and place != slide.drawn_at:
        section.blend(slide.first, slide.last, place, slide.here)
        section.stack(slide.here, slide.vertical_ratio, slide.facets)
        slide.drawn_at = place


def wall_height(slide: Slide, place: float) -> float:
    """Of the section at a place."""
    if not slide.taper:
        return slide.first.wall_height
    return section.between(slide.first.wall_height, slide.last.wall_height, min(max(place, -1.0), 2.0))


def choke_area(slide: Slide, place: float) -> float:
    """Flow area at the wall height; infinite where none is given."""
    draw(slide, place)
    return section.area_at_depth(slide.facets, wall_height(slide, place))


def flow_area(slide: Slide, y: float) -> float:
    """A = Q/v."""
    return floats.quotient(slide.flow, floats.root(y))


def normal(slide: Slide, place: float, y: float) -> float:
    """Normal acceleration n at a place."""
    return slide.side * slide.gravity * math.cos(slide.entry_slope + slide.turn * place) + slide.bend * y


def stress(slide: Slide, facet: int, place: float, y: float) -> float:
    """Pressure on the centre section that decides the wall friction, f ρ n H, Pa."""
    if y <= 0.0:
        return floats.INFINITY
    draw(slide, place)
    area = flow_area(slide, y)
    _, factor = law_and_factor(slide, facet, area)
    depth, _ = section.depth_and_width(slide.facets, facet, area)
    return slide.density * normal(slide, place, y) * factor * depth


def law_and_factor(slide: Slide, facet: int, area: float) -> tuple[float, float]:
    """χ of the friction law, and by how much that raises the hydrostatic pressures of all walls, f.

    Hydrostatic normal forces add up to (1 + χ - m) N where N = ρ n A is the weight, and the law's friction takes
    (1 + χ) N of them. One factor for all walls closes the books: f = (1 + χ)/(1 + χ - m) with the paper's law, and
    1/(1 - m) with the equilibrium law, whose χ is already divided by 1 - m.
    """
    excess, growth, missing, _ = section.loads(slide.facets, facet, area)
    excess, _ = section.law(slide.equilibrium, excess, growth, missing, 0.0)
    carried = 1.0 if slide.equilibrium else 1.0 + excess
    return excess, floats.quotient(carried, carried - missing)


def piece_of(slide: Slide, pressure: float) -> int:
    """The piece of the friction law that holds at a pressure."""
    k = slide.pieces - 1
    while k > 0 and pressure < slide.starts[k]:
        k -= 1
    return k


def wall_friction(slide: Slide, pressure: float) -> float:
    """μ = τ/σ at a pressure; its limit where that is 0."""
    piece = piece_of(slide, pressure)
    return slide.slopes[piece] + (slide.intercepts[piece] / pressure if pressure > 0.0 else 0.0)


def sticking(
    slide: Slide, facet: int, piece: int, area: float, total: float, rise: float
) -> tuple[float, float, float]:
    """What adhesion adds to friction, over g, and half of its fall and of its rise with the logarithm of the area.

    As friction is (slope + τ(0)/σ)(1 + χ) n with σ = f ρ n H, adhesion holds the stream by (1 + χ)/f τ(0)/(ρ H), where
    (1 + χ)/f is what the walls bear hydrostatically.

    Args:
        slide, facet, piece: where the stream is.
        area: m².
        total: 1 + χ - m, hydrostatic.
        rise: half the growth of that.
    """
    if not slide.sticky:
        return 0.0, 0.0, 0.0
    depth, width = section.depth_and_width(slide.facets, facet, area)
    stuck = floats.quotient(slide.intercepts[piece], slide.density * slide.gravity * depth)
    total *= stuck
    return total, floats.quotient(0.5 * total * area, width * depth), rise * stuck


def linearised(
    slide: Slide, facet: int, piece: int, area: float, y: float, sine: float, press: float, bend: float
) -> tuple[float, float, float, float]:
    """The equation over a panel near an iterate, dY/dx = forcing + growth Y, in the unit 2 g h of v².

    With f = sin a - (1 + χ) (p + b Y) the derivative to Y is h/Y - (1 + χ) b, where h = A χ' (p + b Y)/2, and what it
    leaves of f is sin a - (1 + χ) p - h. What adhesion holds back is taken off f too, and changes h by its own change.

    Args:
        slide, facet, piece: where the stream is.
        area: m².
        y: Y.
        sine: sin a.
        press: μ σ cos a.
        bend: 2 h μ σ κ.

    Returns:
        Forcing; growth; of growth what comes with the change of friction; and of that what adhesion takes off it.
    """
    excess, rise, missing, missing_rise = section.loads(slide.facets, facet, area)
    stuck, fall, climb = sticking(slide, facet, piece, area, 1.0 + excess - missing, rise - missing_rise)
    excess, rise = section.law(slide.equilibrium, excess, rise, missing, missing_rise)
    drag = 1.0 + excess
    bending = rise * (press + bend * y) + (climb - fall)
    forcing = sine - drag * press - stuck - bending
    bending = floats.quotient(bending, y)
    held = floats.quotient(fall - min(climb, 0.0), y) if slide.sticky else 0.0
    return forcing, bending - drag * bend, bending, held


def drag_of(slide: Slide, facet: int, piece: int, area: float) -> tuple[float, float]:
    """1 + χ, and what adhesion adds to friction, over g, at a flow area."""
    excess, rise, missing, missing_rise = section.loads(slide.facets, facet, area)
    stuck, _, _ = sticking(slide, facet, piece, area, 1.0 + excess - missing, 0.0)
    excess, _ = section.law(slide.equilibrium, excess, rise, missing, missing_rise)
    return 1.0 + excess, stuck


def pull(slide: Slide, facet: int, piece: int, place: float, y: float) -> tuple[float, float]:
    """dy/dc at a place, and its derivative to c where the section stays the same."""
    if not (place > -BEYOND and place < BEYOND):  # an iterate that leads nowhere
        return floats.NAN, floats.NAN
    draw(slide, place)
    slope = slide.entry_slope + slide.turn * place
    area = flow_area(slide, y)
    drag, stuck = drag_of(slide, facet, piece, area)
    drag *= slide.slopes[piece]
    sine, cosine = math.sin(slope), math.cos(slope)
    doubled = 2.0 * slide.length * slide.gravity
    press = slide.side * cosine + slide.bend / slide.gravity * y
    return doubled * (sine - drag * press - stuck), doubled * slide.turn * (cosine + drag * slide.side * sine)


def pull_at(slide: Slide, place: float, y: float) -> float:
    """Dy/dc at a place, whatever the facet and the piece there."""
    draw(slide, place)
    facet, piece = section.facet_of(slide.facets, flow_area(slide, y)), 0
    if slide.pieces > 1:
        piece = piece_of(slide, stress(slide, facet, place, y))
    change, _ = pull(slide, facet, piece, place, y)
    return change


def place_rate(
    slide: Slide, facet: int, piece: int, r: float, width: float, place: float
) -> tuple[float, float, float]:
    """Dc over a panel in r = √v of a width, its derivative to c, and dy/dc: dc/dr = 4 r³/(dy/dc)."""
    y = r * r * r * r
    change, growth = pull(slide, facet, piece, place, y)
    if slide.taper:
        ahead, _ = pull(slide, facet, piece, place + TAPER_STEP, y)
        behind, _ = pull(slide, facet, piece, place - TAPER_STEP, y)
        growth = (ahead - behind) / (2.0 * TAPER_STEP)
    rate = floats.quotient(4.0 * width * r * r * r, change)
    return rate, floats.quotient(-rate * growth, change), change
