"""How deep a flow area stands in a section, and how hard its walls are pressed.

On each flat facet depth, area and wall load are quadratics in the wetted length C of that facet, with constants known
at its foot. On an arc they are series in the area (:mod:`chutecalc.physics.circle`).
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.circle import Arc, angle_area, arc
from chutecalc.physics.intervals import interval_of
from chutecalc.physics.pressure import pressure_factor
from chutecalc.physics.section import Facets, take_facet


class Wetting(NamedTuple):
    """How a flow area lies in its section, shapes as broadcast."""

    depth: Array
    """Normal to the floor, m."""
    chamfer: Array
    """Wetted length of the drawn facets on one side, m."""
    width: Array
    """Of the free surface, m."""
    excess: Array
    """χ of the friction law."""
    missing: Array
    """m = 1 - (1/A) ∫ K cos ψ ζ dl, the share of the weight that hydrostatic wall pressures do not carry."""
    factor: Array
    """f by which the friction law raises hydrostatic pressures (:func:`chutecalc.physics.pressure.pressure_factor`)."""


def wetted_length(facet: Facets, area: Array) -> tuple[Array, Array]:
    """Wetted length of a flat facet and width of the free surface above it.

    C = 2 q / (w + √(w² + 4 q cos β)), q = (A - A_foot)/sin β: the root of Paper Eq 7 in the form that is exact at
    β = 90° and at B = 0.

    Args:
        facet: one facet a design, shape (designs,).
        area: flow area, m², shape (..., designs), in or above that facet.

    Returns:
        C and the surface's width, m, in the shape of ``area``.
    """
    q = (area - facet.area) / facet.sine
    width = np.sqrt(facet.width**2 + (4.0 * facet.cosine) * q)
    return 2.0 * q / (facet.width + width), width


def excess_friction(facet: Facets, area: Array, equilibrium: bool = False) -> tuple[Array, Array]:
    """Excess of the equivalent over the wall friction, χ = μ_e/μ - 1, and its logarithmic growth with area.

    χ A = X_foot + C sin β (E + K (1 - cos β) C), with E = 2 Σ K (1 - cos ψ) L of the facets below. For a chamfer on a
    base this is Paper Eq 11 without its cancellation, χ = K C (1 - cos β)/(B + C cos β); for a rectangle Paper Eq 2.

    Args:
        facet: one facet a design, shape (designs,).
        area: flow area, m², shape (..., designs), positive.
        equilibrium: scale all wall pressures until they carry the weight, χ/(1 - m), instead of laying the missing load
            on the centre section as the paper does.

    Returns:
        χ and A dχ/dA, in the shape of ``area``.

    >>> from chutecalc.physics.section import Polygon, facets
    >>> vee = Polygon(np.array([0.0]), (np.array([np.inf]),), (np.radians([60.0]),), np.array([np.inf]))
    >>> flank, area = take_facet(facets(vee, np.array([0.2])), np.array([0])), np.array([0.1])
    >>> for equilibrium in (False, True):  # K (1 - cos β)/cos β, and 1/cos β - 1, at any depth
    ...     print([(value.round(14) + 0.0).item() for value in excess_friction(flank, area, equilibrium)])
    [0.4, 0.0]
    [1.0, 0.0]
    """
    excess, half_growth = Excess(facet, equilibrium).at(area)
    return excess, 2.0 * half_growth


class Excess:
    """:func:`excess_friction` of one facet a design for many areas: what the area does not change is worked out once.

    Per area there are one square root, two divisions and some seven products and sums, in place where that is possible:
    most of the solver's time is spent here. With W the surface's width and w that at the facet's foot, C = 2 (A -
    A_foot)/(sin β (W + w)). On a facet that stands on no other X/A is then K (1 - cos β) sin β (C/A) C, and its
    logarithmic growth with the area w/W of it.
    """

    def __init__(self, facet: Facets, equilibrium: bool, both: bool = False) -> None:
        """One facet a design; ``both`` loads where more is asked for than the paper's χ."""
        self.facet, self.equilibrium = facet, equilibrium
        self.stacked = bool(facet.area.any())
        """Whether any facet stands on others; what is 0 on the first need not be added."""
        self.arcs = bool(facet.radius.any())
        self.twice = 2.0 / facet.sine
        self.spread = 2.0 * facet.cosine * self.twice
        self.half_width = 0.5 * facet.width
        self.apex = facet.width * facet.width
        """Of the surface's width², where its flanks would meet."""
        if self.stacked:
            self.apex = self.apex - self.spread * facet.area
        self.loads = [self._load(facet.excess, facet.excess_rise, facet.own_excess)]
        """What the friction law takes shares of: X, and for the equilibrium law the shortfall."""
        if equilibrium or both:
            self.loads.append(self._load(facet.shortfall, facet.shortfall_rise, facet.own_shortfall))

    def _load(self, foot: Array, rise: Array, own: Array) -> "_Load":
        sine, width = self.facet.sine, self.half_width
        return _Load(sine * own, foot, sine * rise, rise / np.where(width > 0.0, width, 1.0))

    def at(self, area: Array) -> tuple[Array, Array]:
        """χ and A dχ/dA/2 at areas, shape (..., designs): by the latter χ falls with the logarithm of v²."""
        return self.law(self.shares(area))

    def law(self, shares: list[tuple[Array, Array]]) -> tuple[Array, Array]:
        """χ of the friction law from what :meth:`shares` gives, and its growth."""
        if not self.equilibrium:
            return shares[0]
        (excess, growth), (missing, missing_growth) = shares
        carried = 1.0 - missing
        return excess / carried, (growth + excess * missing_growth / carried) / carried

    def shares(self, area: Array) -> list[tuple[Array, Array]]:
        """The hydrostatic χ, and with both loads the missing m, each with half its logarithmic growth with the area."""
        width = self.spread * area
        width += self.apex
        np.sqrt(width, out=width)
        climb = width + self.facet.width
        np.divide(self.twice, climb, out=climb)  # C/(A - A_foot)
        above = area - self.facet.area if self.stacked else area
        wetted = climb * above if self.stacked else area  # asked for there alone
        climb *= climb
        climb *= above
        narrow = np.divide(self.half_width, width, out=width)
        shares = [self._share(load, area, wetted, climb, narrow) for load in self.loads]
        if self.arcs:
            bend, curved = _arc(self.facet, area), self.facet.radius > 0.0
            (excess, growth), *rest = shares
            shares = [(np.where(curved, bend.excess, excess), np.where(curved, 0.5 * bend.excess_growth, growth))]
            shares += [
                (np.where(curved, bend.missing, missing), np.where(curved, 0.5 * bend.missing_growth, growth))
                for missing, growth in rest
            ]
        return shares

    def _share(self, load: "_Load", area: Array, wetted: Array, climb: Array, narrow: Array) -> tuple[Array, Array]:
        """A load over the area, and half its logarithmic growth with it.

        ``climb`` is C²/(A - A_foot), ``narrow`` w/2W. What other facets below add is 0 to the last digit where there is
        none.
        """
        share = climb * load.bend
        growth = share * narrow
        if self.stacked:
            hollow, below = self.facet.area / area, (load.foot + load.rise * wetted) / area
            growth += 0.5 * (share * hollow + (narrow * load.rise_share - below))
            share *= 1.0 - hollow
            share += below
        return share, growth


class _Load(NamedTuple):
    """A load that grows with the wetted length C of a facet as foot + C sin β (rise + own C)."""

    bend: Array
    """own sin β."""
    foot: Array
    rise: Array
    """rise sin β."""
    rise_share: Array
    """rise over w/2."""


def depth_and_width(facet: Facets, area: Array) -> tuple[Array, Array]:
    """Depth and width of the free surface, m; arguments as in :func:`excess_friction`."""
    wetted, width = wetted_length(facet, area)
    depth = facet.height + wetted * facet.sine
    curved = facet.radius > 0.0
    if curved.any():
        angle = _arc(facet, area).angle
        depth = np.where(curved, 2.0 * facet.radius * np.sin(0.5 * angle) ** 2, depth)
        width = np.where(curved, 2.0 * facet.radius * np.sin(angle), width)
    return depth, width


def wetting(facet: Facets, area: Array, equilibrium: bool = False) -> Wetting:
    """Depth, wetted chamfer, surface width, χ, missing load and pressure factor of a flow area.

    Arguments as in :func:`excess_friction`, shapes likewise. The walls above a drawn top do not count as chamfer.
    """
    wetted, _ = wetted_length(facet, area)
    missing, chamfer = _missing(facet, area, wetted), facet.chamfer + facet.drawn * wetted
    curved = facet.radius > 0.0
    if curved.any():
        bend = _arc(facet, area)
        missing, chamfer = np.where(curved, bend.missing, missing), np.where(curved, facet.radius * bend.angle, chamfer)
    depth, width = depth_and_width(facet, area)
    excess, _ = excess_friction(facet, area, equilibrium)
    return Wetting(depth, chamfer, width, excess, missing, pressure_factor(excess, missing, equilibrium))


def area_at_depth(table: Facets, depth: Array) -> Array:
    """Flow area below a depth, the inverse of the depth in :func:`wetting`.

    Args:
        table: the section's facets.
        depth: m, of the shape of one facet's fields, or broadcast against it; 0 or more; infinite gives infinite.

    Returns:
        Area, m², in the broadcast shape.
    """
    facet = take_facet(table, interval_of(table.height, depth))
    wetted = (depth - facet.height) / facet.sine
    area = facet.area + (facet.width + wetted * facet.cosine) * wetted * facet.sine
    curved = facet.radius > 0.0
    if curved.any():
        r = np.where(curved, facet.radius, 1.0)
        angle = 2.0 * np.arcsin(np.sqrt(np.minimum(0.5 * depth / r, 0.5)))
        area = np.where(curved, r**2 * angle_area(angle), area)
    return np.where(np.isinf(depth), np.inf, area)


def _missing(facet: Facets, area: Array, wetted: Array) -> Array:
    """Missing load m on a flat facet of a wetted length."""
    return (facet.shortfall + wetted * facet.sine * (facet.shortfall_rise + facet.own_shortfall * wetted)) / area


def _arc(facet: Facets, area: Array) -> Arc:
    """What stands on an arc; without meaning where the facet is flat."""
    return arc(area / np.where(facet.radius > 0.0, facet.radius, np.inf) ** 2, facet.lack)
