"""Hold a guiding surface and the flow on it, and compute what follows from their numbers at a share of its length.

The force on a stream is smooth as long as the free surface stays on one facet of the section and the pressure on one
piece of the wall's yield locus: a branch.
"""

import math

from chutecalc.core import floats, section


class Guide:
    """A guiding surface, and the flow on it."""

    def __init__(self, facets: "section.Facets", first: "section.Section", last: "section.Section | None", pieces: int):
        self.facets = facets
        """Facets of the section at ``section_share``, or of the whole segment where the section is constant."""
        self.first = first
        """The section at the segment's start."""
        self.last = first if last is None else last
        self.section_here = section.Section(first.walls, first.circle, first.closed)
        self.taper = last is not None
        self.section_share = 0.0
        self.x = self.z = 0.0
        """Start of the segment, m."""
        self.side = self.gravity = self.entry_slope = self.turn = self.length = 0.0
        self.flow = self.density = self.vertical_ratio = 0.0
        self.momentum_root = 1.0
        """√α_m. The stream is solved as a uniform one of the same flow area and momentum, √α_m as fast: ``flow`` is
        √α_m Q, and y is α_m v² everywhere."""
        self.longitudinal = 0.0
        """K_l, longitudinal pressure over that normal to the centre section; 0 neglects it."""
        self.equilibrium = False
        self.pieces = pieces
        """Pieces of the wall's friction law, τ = intercept + slope σ above a σ each."""
        self.starts, self.intercepts, self.slopes = (floats.zeros(pieces) for _ in range(3))
        self.adhesive = False
        """Whether any piece has an intercept."""
        self.signed_curvature = 0.0
        """σ κ, the coefficient of v² in the normal acceleration, 1/m."""


def set_constants(guide: Guide) -> None:
    """Compute what follows from the numbers."""
    section.stack_facets(guide.first, guide.vertical_ratio, guide.facets)
    section.interpolate_sections(guide.first, guide.last, 0.0, guide.section_here)
    guide.section_share = 0.0
    guide.signed_curvature = -guide.side * guide.turn / guide.length
    guide.adhesive = False
    for k in range(guide.pieces):
        if guide.intercepts[k] != 0.0:
            guide.adhesive = True


def set_section(guide: Guide, share: float) -> None:
    """Set the facets to those of the section at a share of a taper."""
    if guide.taper and share != guide.section_share:
        section.interpolate_sections(guide.first, guide.last, share, guide.section_here)
        section.stack_facets(guide.section_here, guide.vertical_ratio, guide.facets)
        guide.section_share = share


def wall_height(guide: Guide, share: float) -> float:
    """Return the wall height at a share, m."""
    if not guide.taper:
        return guide.first.wall_height
    return section.interpolate_number(guide.first.wall_height, guide.last.wall_height, min(max(share, -1.0), 2.0))


def choke_area(guide: Guide, share: float) -> float:
    """Return the flow area at the wall height, or at which a pipe runs full, m²; infinite where none is given."""
    set_section(guide, share)
    return section.area_at_depth(guide.facets, wall_height(guide, share))


def full_velocity(guide: Guide) -> float:
    """Return the velocity at which the pipe runs full that ``set_section`` has set; 0 in any other section."""
    return guide.flow / guide.facets.full


def flow_area(guide: Guide, y: float) -> float:
    """Return the flow area A = √α_m Q/√y, m²."""
    return floats.quotient(guide.flow, floats.root(y))


def normal_acceleration(guide: Guide, share: float, y: float) -> float:
    """Return the normal acceleration n at a share, m/s²."""
    return guide.side * guide.gravity * math.cos(guide.entry_slope + guide.turn * share) + guide.signed_curvature * y


def piece_of(guide: Guide, pressure: float) -> int:
    """Return the piece of the friction law that holds at a pressure."""
    k = guide.pieces - 1
    while k > 0 and pressure < guide.starts[k]:
        k -= 1
    return k


def wall_friction(guide: Guide, pressure: float) -> float:
    """Return μ = τ/σ at a pressure; its limit where that is 0."""
    piece = piece_of(guide, pressure)
    return guide.slopes[piece] + (guide.intercepts[piece] / pressure if pressure > 0.0 else 0.0)
