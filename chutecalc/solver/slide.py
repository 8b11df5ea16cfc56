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
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.motion import normal_acceleration
from chutecalc.physics.section import Facets, Section, blend, facets, take_facet, wetted_facet
from chutecalc.physics.wall import Wall, wall_friction
from chutecalc.physics.wetting import excess_friction, wetting


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


def net_pull(slide: Slide, place: Array, velocity_squared: Array) -> Array:
    """What friction leaves of gravity's pull along the surface, sin a - μ_e n/g, at places, shape (..., designs)."""
    table, area = slide.facets_at(place), slide.area(velocity_squared)
    facet = take_facet(table, np.broadcast_to(wetted_facet(table, area), area.shape))
    excess, _ = excess_friction(facet, area, slide.equilibrium)
    friction = wall_friction(slide.wall, slide.stress(place, velocity_squared, facet)) * (1.0 + excess)
    pull: Array = np.sin(slide.entry_slope + slide.turn * place)
    return pull - friction * slide.normal(place, velocity_squared) / slide.gravity
