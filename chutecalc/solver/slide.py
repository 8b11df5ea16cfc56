"""The equation of motion along one contact segment, in the two forms the solver integrates.

Along the segment the independent variable is the place c, 0 at its drawn start and 1 at its drawn end, and the unknown
y = v². Near rest that form is singular, so there r = √v is the independent variable and c the unknown: walls of every
section pull with a force that is smooth in r down to r = 0, which makes a stall an ordinary end of a panel.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.design import take
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.motion import ROOF
from chutecalc.physics.section import Facets, excess_friction


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
    friction: Array
    """Wall friction μ."""
    facets: Facets
    choke_area: Array

    def rows(self, index: Index) -> "Slide":
        """The same for some of the designs."""
        table = self.facets
        if table.area.shape[1] > 1:
            table = Facets(*(np.ascontiguousarray(field[:, index]) for field in table))
        return Slide(
            self.side,
            take(self.gravity, index),
            take(self.entry_slope, index),
            take(self.turn, index),
            take(self.length, index),
            take(self.flow, index),
            take(self.friction, index),
            table,
            take(self.choke_area, index),
        )

    def bend(self) -> Array:
        """σ κ, what v² adds to the normal acceleration, 1/m."""
        return -self.side * self.turn / self.length

    def area(self, velocity_squared: Array) -> Array:
        """Flow area A = Q/v."""
        return self.flow / np.sqrt(velocity_squared)

    def normal(self, place: Array, velocity_squared: Array) -> Array:
        """Normal acceleration n at a place."""
        slope = self.entry_slope + self.turn * place
        return self.side * self.gravity * np.cos(slope) + self.bend() * velocity_squared

    def can_lose_contact(self) -> bool:
        """Whether any design has a crest or a hood here: everything else presses on its floor by weight alone."""
        return self.side == ROOF or bool((self.turn > 0.0).any())


class Field(NamedTuple):
    """What the equation needs at given places of a panel, whatever the velocity there."""

    drive: Array
    """2 h g sin a, with h the panel's length in m."""
    press: Array
    """σ g cos a."""
    scale: Array
    """2 h μ."""
    bend: Array


def field(slide: Slide, place: Array, width: Array) -> Field:
    """The field at places, shape (nodes, designs) or (nodes, 1), of panels of a width in c."""
    slope = slide.entry_slope + slide.turn * place
    doubled = 2.0 * width * slide.length
    return Field(
        doubled * slide.gravity * np.sin(slope),
        slide.side * slide.gravity * np.cos(slope),
        doubled * slide.friction,
        slide.bend(),
    )


def rates(slide: Slide, facet: Facets, at: Field, y: Array) -> tuple[Array, Array]:
    """Dy over the panel's width and its derivative to y: dy/ds = 2 [g sin a - μ (1 + χ) n]."""
    chi, growth = excess_friction(facet, slide.area(y))
    n = at.press + at.bend * y
    load = 1.0 + chi
    drag = at.scale * load
    return at.drive - drag * n, at.scale * growth * n / (2.0 * y) - drag * at.bend


def frozen_rates(slide: Slide, facet: Facets, at: Field, y0: Array, y: Array) -> tuple[Array, Array]:
    """The same with μ_e kept at its value for y0: linear in y, solved exactly by one Newton step from anywhere.

    Close enough to start Newton from; exact where friction is constant.
    """
    chi, _ = excess_friction(facet, slide.area(y0))
    drag = at.scale * (1.0 + chi)
    return at.drive - drag * (at.press + at.bend * y), np.broadcast_to(-drag * at.bend, y.shape)


def place_rates(slide: Slide, facet: Facets, root: Array, width: Array, place: Array) -> tuple[Array, Array]:
    """Dc over a panel in r = √v of a width, and its derivative to c: dc/dr = 4 r³/(dy/dc)."""
    slope = slide.entry_slope + slide.turn * place
    y = root**4
    chi, _ = excess_friction(facet, slide.area(y))
    drag = slide.friction * (1.0 + chi)
    sine, cosine = np.sin(slope), np.cos(slope)
    pull = 2.0 * slide.length * slide.gravity
    press = slide.side * cosine + slide.bend() / slide.gravity * y
    change = pull * (sine - drag * press)  # dy/dc
    rate = 4.0 * width * root**3 / change
    return rate, -rate * pull * slide.turn * (cosine + drag * slide.side * sine) / change
