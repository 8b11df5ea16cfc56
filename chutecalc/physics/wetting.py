"""How deep a flow area stands in a section, and how hard its walls are pressed.

On each flat facet depth, area and wall load are quadratics in the wetted length C of that facet, with constants known
at its foot. On an arc they are series in the area (:mod:`chutecalc.physics.circle`).
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.circle import Arc, angle_area, arc
from chutecalc.physics.intervals import interval_of
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
    ...     print([(value + 0.0).round(14).item() for value in excess_friction(flank, area, equilibrium)])
    [0.4, 0.0]
    [1.0, 0.0]
    """
    wetted, width = wetted_length(facet, area)
    own = facet.own_excess * wetted
    excess = (facet.excess + wetted * facet.sine * (facet.excess_rise + own)) / area
    growth = (facet.excess_rise + 2.0 * own) / width - excess
    curved = facet.radius > 0.0
    bend = _arc(facet, area) if curved.any() else None
    if bend:
        excess, growth = np.where(curved, bend.excess, excess), np.where(curved, bend.excess_growth, growth)
    if not equilibrium:
        return excess, growth
    missing = _missing(facet, area, wetted)
    missing_growth = (facet.shortfall_rise + 2.0 * facet.own_shortfall * wetted) / width - missing
    if bend:
        missing = np.where(curved, bend.missing, missing)
        missing_growth = np.where(curved, bend.missing_growth, missing_growth)
    carried = 1.0 - missing
    return excess / carried, (growth + excess * missing_growth / carried) / carried


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
    """Depth, wetted chamfer, surface width, χ and missing load of a flow area.

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
    return Wetting(depth, chamfer, width, excess, missing)


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
    flat = facet.area + (facet.width + wetted * facet.cosine) * wetted * facet.sine
    r = np.where(facet.radius > 0.0, facet.radius, 1.0)
    angle = 2.0 * np.arcsin(np.sqrt(np.minimum(0.5 * depth / r, 0.5)))
    area = np.where(facet.radius > 0.0, r**2 * angle_area(angle), flat)
    return np.where(np.isinf(depth), np.inf, area)


def _missing(facet: Facets, area: Array, wetted: Array) -> Array:
    """Missing load m on a flat facet of a wetted length."""
    return (facet.shortfall + wetted * facet.sine * (facet.shortfall_rise + facet.own_shortfall * wetted)) / area


def _arc(facet: Facets, area: Array) -> Arc:
    """What stands on an arc; without meaning where the facet is flat."""
    return arc(area / np.where(facet.radius > 0.0, facet.radius, np.inf) ** 2, facet.lack)
