"""Cross-sections: how deep a flow area stands in one, and how hard its walls are pressed.

Every symmetric section of flat walls is one :class:`Polygon`: a centre section, facets from the centre outwards, and
vertical walls above them. A rectangle has no facets, a chamfered section one, a vee one and no base. On each facet
depth, area and wall load are quadratics in the wetted length C of that facet, with constants known at its foot: those
are the :class:`Facets` that the solver works with.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.pressure import pressure_shortfall


class Polygon(NamedTuple):
    """A symmetric section of flat walls. All lengths in m, angles in rad, arrays of length 1 or n."""

    base: Array
    """Width of the centre section, 0 for a vee."""
    lengths: tuple[Array, ...]
    """Of the drawn facets on one side, from the centre outwards; the last may be infinite: it has no top then."""
    inclinations: tuple[Array, ...]
    """Of the same facets to the plane of the centre section, in (0, π/2], never falling."""
    wall_height: Array
    """Above the floor; deeper than that the chute chokes; infinite where none is given."""


class Facets(NamedTuple):
    """What each facet of a polygon starts from at its foot; every field has the shape (facets, designs)."""

    drawn: Array
    """1 for a drawn facet, 0 for the vertical walls that go on above the drawn top."""
    sine: Array
    cosine: Array
    area: Array
    """Flow area when the surface stands at the facet's foot, m²."""
    width: Array
    """Width of the free surface there, m."""
    height: Array
    """Depth there, m."""
    chamfer: Array
    """Length of the drawn facets below, on one side, m."""
    excess: Array
    """Excess wall load X = ∫ K (1 - cos ψ) ζ dl there, m²."""
    excess_rise: Array
    """Its growth with depth from the facets below alone, 2 Σ K (1 - cos ψ) L, m."""
    own_excess: Array
    """K (1 - cos ψ) of this facet."""
    shortfall: Array
    """Unsupported load D = A - ∫ K cos ψ ζ dl at the foot, m²."""
    shortfall_rise: Array
    """Its growth with depth from the facets below alone, 2 Σ (1 - K) cos ψ L, m."""
    own_shortfall: Array
    """(1 - K) cos ψ of this facet."""


class Wetting(NamedTuple):
    """How a flow area lies in its section, shapes as broadcast."""

    depth: Array
    """Normal to the floor, m."""
    chamfer: Array
    """Wetted length of the drawn facets on one side, m."""
    width: Array
    """Of the free surface, m."""
    excess: Array
    """χ = (1/A) ∫ K (1 - cos ψ) ζ dl."""
    missing: Array
    """m = 1 - (1/A) ∫ K cos ψ ζ dl, the share of the weight that hydrostatic wall pressures do not carry."""


def facets(section: Polygon, vertical_ratio: Array) -> Facets:
    """The constants of each facet at its foot, by stacking the facets from the centre outwards.

    Args:
        section: the polygon.
        vertical_ratio: K_v, in (0, 1], length 1 or n.

    Returns:
        Facets of shape (facets, designs), designs being 1 unless something has length n. The last facet has no top:
        vertical walls are added above a drawn top.

    >>> half_open = Polygon(np.array([0.5]), (np.array([0.2]),), (np.radians([30.0]),), np.array([np.inf]))
    >>> facets(half_open, np.array([1 / 3])).height.round(12)  # of the chamfer, and of the wall above it
    array([[0. ],
           [0.1]])
    """
    lengths, inclinations = list(section.lengths), list(section.inclinations)
    drawn = [1.0] * len(lengths)
    if not lengths or np.isfinite(lengths[-1]).all():
        lengths.append(np.array([np.inf]))
        inclinations.append(np.array([np.pi / 2]))
        drawn.append(0.0)
    zero = np.zeros(1)
    area, width, height, chamfer = zero, section.base, zero, zero
    excess, excess_rise, shortfall, shortfall_rise = zero, zero, zero, zero
    rows: list[tuple[Array, ...]] = []
    for number, (length, psi) in enumerate(zip(lengths, inclinations, strict=True)):
        s, c = np.sin(psi), np.cos(psi)
        lacking = pressure_shortfall(psi, vertical_ratio)
        own_excess = (1.0 - lacking) * 2.0 * np.sin(psi / 2) ** 2  # 1 - cos ψ, without its cancellation
        own_shortfall = lacking * c
        foot = (area, width, height, chamfer)
        load = (excess, excess_rise, own_excess, shortfall, shortfall_rise, own_shortfall)
        rows.append((np.array([drawn[number]]), s, c, *foot, *load))
        if number + 1 < len(lengths):
            rise = length * s
            excess = excess + rise * (excess_rise + own_excess * length)
            excess_rise = excess_rise + 2.0 * own_excess * length
            shortfall = shortfall + rise * (shortfall_rise + own_shortfall * length)
            shortfall_rise = shortfall_rise + 2.0 * own_shortfall * length
            area = area + (width + length * c) * rise
            width = width + 2.0 * length * c
            height = height + rise
            chamfer = chamfer + length
    shape = np.broadcast_shapes(*(value.shape for row in rows for value in row))
    fields = zip(*rows, strict=True)
    return Facets(*(np.stack([np.broadcast_to(value, shape) for value in field]) for field in fields))


def wetted_facet(table: Facets, area: Array) -> Index:
    """The facet in which the surface of a flow area lies, 0 for the innermost.

    Args:
        table: of shape (facets, designs).
        area: flow area, m², shape (designs,) or (1,).

    Returns:
        Row numbers into ``table``, shape (designs,). A surface exactly at a joint counts to the facet above.
    """
    rows: Index = (area >= table.area[1:]).sum(axis=0)
    return rows


def take_facet(table: Facets, rows: Index) -> Facets:
    """One facet a design: fields of shape (designs,), or (1,) where the table holds one facet for all designs."""
    columns = np.arange(len(rows))
    return Facets(*(take_row(field, rows, columns) for field in table))


def take_row(field: Array, rows: Index, columns: Index) -> Array:
    """Entry ``rows[i]`` of column ``columns[i]`` of a facet field; a field of one row or column serves all."""
    own_rows = rows if len(field) > 1 else 0
    own_columns = columns if field.shape[1] > 1 else 0
    return np.atleast_1d(field[own_rows, own_columns])


def wetted_length(facet: Facets, area: Array) -> tuple[Array, Array]:
    """Wetted length of a facet and width of the free surface above it.

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


def excess_friction(facet: Facets, area: Array) -> tuple[Array, Array]:
    """Excess of the equivalent over the wall friction, χ = μ_e/μ - 1, and its logarithmic growth with area.

    χ A = X_foot + C sin β (E + K (1 - cos β) C), with E = 2 Σ K (1 - cos ψ) L of the facets below. For a chamfer on a
    base this is Paper Eq 11 without its cancellation, χ = K C (1 - cos β)/(B + C cos β); for a rectangle Paper Eq 2.

    Args:
        facet: one facet a design, shape (designs,).
        area: flow area, m², shape (..., designs), positive.

    Returns:
        χ and A dχ/dA, in the shape of ``area``.

    >>> vee = Polygon(np.array([0.0]), (np.array([np.inf]),), (np.radians([60.0]),), np.array([np.inf]))
    >>> chi, growth = excess_friction(take_facet(facets(vee, np.array([0.2])), np.array([0])), np.array([0.1]))
    >>> bool(abs(chi[0] - 0.4 * 0.5 / 0.5) < 1e-15), bool(abs(growth[0]) < 1e-15)  # K (1 - cos β)/cos β, any depth
    (True, True)
    """
    wetted, width = wetted_length(facet, area)
    own = facet.own_excess * wetted
    chi = (facet.excess + wetted * facet.sine * (facet.excess_rise + own)) / area
    return chi, (facet.excess_rise + 2.0 * own) / width - chi


def wetting(facet: Facets, area: Array) -> Wetting:
    """Depth, wetted chamfer, surface width, χ and missing load of a flow area.

    Arguments as in :func:`excess_friction`, shapes likewise. The walls above a drawn top do not count as chamfer.
    """
    wetted, width = wetted_length(facet, area)
    rise = wetted * facet.sine
    chi = (facet.excess + rise * (facet.excess_rise + facet.own_excess * wetted)) / area
    missing = (facet.shortfall + rise * (facet.shortfall_rise + facet.own_shortfall * wetted)) / area
    return Wetting(facet.height + rise, facet.chamfer + facet.drawn * wetted, width, chi, missing)


def area_at_depth(table: Facets, depth: Array) -> Array:
    """Flow area below a depth, the inverse of the depth in :func:`wetting`.

    Args:
        table: of shape (facets, designs).
        depth: m, shape (designs,) or (1,), 0 or more; infinite gives infinite.

    Returns:
        Area, m², shape (designs,).
    """
    facet = take_facet(table, (np.asarray(depth) >= table.height[1:]).sum(axis=0))
    wetted = (depth - facet.height) / facet.sine
    return facet.area + (facet.width + wetted * facet.cosine) * wetted * facet.sine
