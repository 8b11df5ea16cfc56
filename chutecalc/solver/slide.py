"""The equation of motion along one contact segment, in the two forms the solver integrates.

Along the segment the independent variable is the place c, 0 at its drawn start and 1 at its drawn end, and the unknown
y = v². Near rest that form is singular, so there r = √v is the independent variable and c the unknown: walls of every
section pull with a force that is smooth in r down to r = 0, which makes a stall an ordinary end of a panel.

The force is smooth as long as the surface stays on one facet of the section and the pressure on one piece of the wall's
friction law: a :class:`Branch`. At the ends of branches it has kinks.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.design import select
from chutecalc.physics.arrays import Array, Index, sine_and_cosine
from chutecalc.physics.intervals import take_row
from chutecalc.physics.motion import ROOF, normal_acceleration
from chutecalc.physics.section import Facets, Section, blend, facets, take_facet, wetted_facet
from chutecalc.physics.wall import Wall, wall_friction
from chutecalc.physics.wetting import Excess, area_at_depth, depth_and_width, excess_friction, wetting


class Slide(NamedTuple):
    """A contact segment and the flow on it; arrays of length 1 or n."""

    side: float
    gravity: Array
    entry_slope: Array
    turn: Array
    """Exit slope less entry slope, rad: negative on a spoon, positive on a crest or hood, 0 on a straight."""
    length: Array
    flow: Array
    """Volume rate Q, m³/s."""
    density: Array
    wall: Wall
    section: Section
    """Where the segment starts."""
    end_section: Section | None
    """Where a taper ends; None where the section stays."""
    vertical_ratio: Array
    """K_v."""
    drawn: Facets
    """Of ``section``."""
    equilibrium: bool
    """The friction law: wall pressures scaled to carry the weight, or the paper's."""
    alike: bool
    """Whether one entry of every field serves all designs."""

    def rows(self, index: Index | slice) -> "Slide":
        """The same for some of the designs."""
        return self if self.alike else select(self, index)

    def section_at(self, place: Array) -> Section:
        """The section at places, shape (..., designs)."""
        if self.end_section is None:
            return self.section
        # What a panel far too long makes of one design must not be infinitely long: it would leave all without a top.
        return blend(self.section, self.end_section, np.minimum(np.maximum(place, -1.0), 2.0))

    def facets_at(self, place: Array) -> Facets:
        """The section's facets at places, shape (facets, ..., designs); without places where it stays the same."""
        return self.drawn if self.end_section is None else facets(self.section_at(place), self.vertical_ratio)

    def choke_area(self, place: Array) -> Array:
        """Flow area at the wall height; infinite where none is given."""
        return area_at_depth(self.facets_at(place), self.section_at(place).wall_height)

    def bend(self) -> Array:
        """σ κ, what v² adds to the normal acceleration, 1/m."""
        return -self.side * self.turn / self.length

    def area(self, velocity_squared: Array) -> Array:
        """Flow area A = Q/v."""
        return self.flow / np.sqrt(velocity_squared)

    def normal(self, place: Array, velocity_squared: Array) -> Array:
        """Normal acceleration n at a place."""
        slope = self.entry_slope + self.turn * place
        return normal_acceleration(self.side, self.gravity, slope, -self.turn / self.length, velocity_squared)

    def stress(self, place: Array, velocity_squared: Array, facet: Facets) -> Array:
        """Pressure on the centre section that decides the wall friction, f ρ n H, Pa."""
        wet = wetting(facet, self.area(velocity_squared), self.equilibrium)
        stress: Array = self.density * self.normal(place, velocity_squared) * wet.factor * wet.depth
        return np.where(velocity_squared > 0.0, stress, np.inf)

    def can_lose_contact(self) -> bool:
        """Whether any design has a crest or a hood here: everything else presses on its floor by weight alone."""
        return self.side == ROOF or bool((self.turn > 0.0).any())


def net_pull(slide: Slide, place: Array, velocity_squared: Array) -> Array:
    """What friction leaves of gravity's pull along the surface, sin a - μ_e n/g, at places, shape (..., designs)."""
    table, area = slide.facets_at(place), slide.area(velocity_squared)
    facet = take_facet(table, np.broadcast_to(wetted_facet(table, area), area.shape))
    excess, _ = excess_friction(facet, area, slide.equilibrium)
    friction = wall_friction(slide.wall, slide.stress(place, velocity_squared, facet)) * (1.0 + excess)
    pull: Array = np.sin(slide.entry_slope + slide.turn * place)
    return pull - friction * slide.normal(place, velocity_squared) / slide.gravity


class Branch(NamedTuple):
    """One smooth branch of the friction law, at places: a facet of the section and a piece of the wall's friction."""

    facet: Facets
    excess: Excess
    """χ on that facet."""
    slope: Array
    """dτ/dσ of the piece."""
    adhesion: Array | None
    """τ(0)/(ρ g) of the piece, m; None where no piece has any.

    As friction is (slope + τ(0)/σ)(1 + χ) n with σ = f ρ n H, adhesion holds the stream by (1 + χ)/f τ(0)/(ρ H), where
    (1 + χ)/f is what the walls bear hydrostatically, 1 + χ - m of the weight in the paper's terms.
    """

    def sticking(self, shares: list[tuple[Array, Array]], area: Array) -> tuple[Array, Array, Array]:
        """What adhesion adds to friction, over g, and half of its fall and of its rise with the logarithm of the area.

        Args:
            shares: of ``excess`` at the area.
            area: m².
        """
        assert self.adhesion is not None
        (excess, growth), (missing, missing_growth) = shares
        depth, width = depth_and_width(self.facet, area)
        stuck = self.adhesion / depth
        total = (1.0 + excess - missing) * stuck
        return total, 0.5 * total * area / (width * depth), (growth - missing_growth) * stuck


class Course:
    """The branches that n designs follow on a panel, at whatever place they are asked for."""

    def __init__(self, slide: Slide, facet: Index, piece: Index) -> None:
        self.slide, self.facet = slide, facet
        self.slope = take_row(slide.wall.slopes, piece)
        sticky = slide.wall.intercepts.any()
        self.adhesion = take_row(slide.wall.intercepts, piece) / (slide.density * slide.gravity) if sticky else None
        self.fixed = self._branch(take_facet(slide.drawn, facet))
        self.arcs = self.fixed.excess.arcs

    def at(self, place: Array) -> Branch:
        """The branches at places, shape (..., designs)."""
        if self.slide.end_section is None:
            return self.fixed
        return self._branch(take_facet(self.slide.facets_at(place), self.facet))

    def _branch(self, facet: Facets) -> Branch:
        excess = Excess(facet, self.slide.equilibrium, self.adhesion is not None)
        return Branch(facet, excess, self.slope, self.adhesion)


class Field(NamedTuple):
    """What the equation needs at given places of a panel, whatever the velocity there.

    Velocities are in the unit √(2 g h), with h the panel's length in m: the equation over the panel is then
    dY/dx = sin a - (1 + χ) (μ σ cos a + 2 h μ σ κ Y), and what designs differ in is in few of its terms.
    """

    branch: Branch
    unit: Array
    """2 g h, m²/s²."""
    flow: Array
    """Q in that unit, m²."""
    sine: Array
    press: Array
    """μ σ cos a."""
    bend: Array
    """2 h μ σ κ."""


def field(course: Course, place: Array, width: Array) -> Field:
    """The field at places, shape (nodes, designs) or (nodes, 1), of panels of a width in c."""
    slide, branch = course.slide, course.at(place)
    sine, cosine = sine_and_cosine(slide.entry_slope + slide.turn * place)
    unit = 2.0 * width * slide.length * slide.gravity
    return Field(
        branch,
        unit,
        slide.flow / np.sqrt(unit),
        sine,
        branch.slope * (slide.side * cosine),
        branch.slope * (-2.0 * slide.side * width * slide.turn),
    )


class Linear(NamedTuple):
    """The equation over a panel as it is near an iterate: dY/dx = forcing + growth Y."""

    forcing: Array
    growth: Array
    """∂f/∂Y; of shape (designs,) where it is the same at all places."""
    bending: Array
    """Of ``growth``, what comes with the change of friction: by it Newton's method is none that ends at once."""
    held: Array | None = None
    """Of that, what adhesion takes off it."""


NOTHING = np.zeros(1)


def linearised(at: Field, y: Array) -> Linear:
    """The equation at an iterate Y at the field's places.

    With f = sin a - (1 + χ) (p + b Y) the derivative to Y is h/Y - (1 + χ) b, where h = A χ' (p + b Y)/2, and what it
    leaves of f is sin a - (1 + χ) p - h. What adhesion holds back is taken off f too, and changes h by its own change.
    """
    area = np.sqrt(y)
    np.divide(at.flow, area, out=area)
    shares = at.branch.excess.shares(area)
    sticking = None if at.branch.adhesion is None else at.branch.sticking(shares, area)  # before shares are overwritten
    drag, bending = at.branch.excess.law(shares)
    drag += 1.0
    hold, held = at.bend * y, None
    hold += at.press  # μ_w n/g
    bending *= hold
    forcing = np.multiply(drag, at.press, out=hold)
    np.subtract(at.sine, forcing, out=forcing)
    if sticking is not None:
        stuck, fall, rise = sticking
        forcing -= stuck
        bending += rise - fall
        held = (fall - np.minimum(rise, 0.0)) / y
    forcing -= bending
    bending /= y
    growth = np.multiply(drag, at.bend, out=drag)
    np.subtract(bending, growth, out=growth)
    return Linear(forcing, growth, bending, held)


def frozen(at: Field, y0: Array) -> Linear:
    """The same with μ_e as at Y0: near enough for Newton to start from, and right where friction is constant."""
    area = at.flow / np.sqrt(y0)
    shares = at.branch.excess.shares(area)
    drag = 1.0 + at.branch.excess.law(shares)[0]
    forcing = at.sine - drag * at.press
    if at.branch.adhesion is not None:
        forcing -= at.branch.sticking(shares, area)[0]
    return Linear(forcing, -drag * at.bend, NOTHING)


TAPER_STEP = 1e-6
"""Of the segment's length: over which a taper's own change is taken, for Newton's derivative alone."""


def place_rates(course: Course, root: Array, width: Array, place: Array) -> tuple[Array, Array]:
    """Dc over a panel in r = √v of a width, and its derivative to c: dc/dr = 4 r³/(dy/dc)."""
    y = root**4
    change, growth = _pull(course, place, y)
    if course.slide.end_section is not None:
        ahead, behind = (_pull(course, place + step, y)[0] for step in (TAPER_STEP, -TAPER_STEP))
        growth = (ahead - behind) / (2.0 * TAPER_STEP)
    rate = 4.0 * width * root**3 / change
    return rate, -rate * growth / change


def _pull(course: Course, place: Array, y: Array) -> tuple[Array, Array]:
    """dy/dc at places, and its derivative to c where the section stays the same."""
    slide, branch = course.slide, course.at(place)
    slope = slide.entry_slope + slide.turn * place
    area = slide.area(y)
    shares = branch.excess.shares(area)
    drag = branch.slope * (1.0 + branch.excess.law(shares)[0])
    sine, cosine = sine_and_cosine(slope)
    doubled = 2.0 * slide.length * slide.gravity
    press = slide.side * cosine + slide.bend() / slide.gravity * y
    pull = sine - drag * press
    if branch.adhesion is not None:
        pull = pull - branch.sticking(shares, area)[0]
    return doubled * pull, doubled * slide.turn * (cosine + drag * slide.side * sine)
