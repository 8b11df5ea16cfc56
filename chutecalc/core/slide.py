"""A segment and the flow on it, and what follows from their numbers at a place of it.

The force on a stream is smooth as long as the surface stays on one facet of the section and the pressure on one piece
of the wall's yield locus: a branch.
"""

import math

from chutecalc.core import floats, section


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
