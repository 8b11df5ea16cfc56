"""Cross-sections, and what each of their facets starts from.

Every symmetric section is a stack of facets from the centre outwards: a polygon's flat walls, or a circle's arc, and
vertical walls above what is drawn. A rectangle has no drawn facet, a chamfered section one, a vee one and no base. The
:class:`Facets` hold what is known at each facet's foot; :mod:`chutecalc.physics.wetting` works with those.
"""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.circle import arc
from chutecalc.physics.intervals import interval_of, take_row
from chutecalc.physics.pressure import pressure_shortfall


class Polygon(NamedTuple):
    """A symmetric section of flat walls. All lengths in m, angles in rad, arrays of length 1 or n."""

    base: Array
    """Width of the centre section, 0 for a vee. Level facets widen it."""
    lengths: tuple[Array, ...]
    """Of the drawn facets on one side, from the centre outwards; the last may be infinite: it has no top then."""
    inclinations: tuple[Array, ...]
    """Of the same facets to the plane of the centre section, in [0, π/2], never falling."""
    wall_height: Array
    """Above the floor; deeper than that the chute chokes; infinite where none is given."""


class Circle(NamedTuple):
    """The lower half of a circle, with vertical walls above it."""

    radius: Array
    wall_height: Array
    """As of a polygon."""


Section = Polygon | Circle


class Facets(NamedTuple):
    """What each facet of a section starts from at its foot; the first axis of every field counts the facets.

    The others are those of the section's numbers: (facets, designs), or (facets, places, designs) along a taper.
    """

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
    """Length of the drawn facets below that slope, on one side, m."""
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
    radius: Array
    """Of an arc, m; 0 for a flat facet."""
    lack: Array
    """1 - K_v."""


def blend(first: Section, last: Section, share: Array) -> Section:
    """The section at a share of the length of a taper: each of its numbers goes linearly from first to last.

    Args:
        first, last: sections of the same kind and facets; what has no top, or no wall height, has none in both.
        share: 0 at the first, 1 at the last, shape (..., designs).

    >>> wide, narrow = (Circle(np.array([r]), np.array([np.inf])) for r in (1.0, 0.5))
    >>> blend(wide, narrow, np.array([0.5])).radius
    array([0.75])
    """

    def between(one: Any, other: Any) -> Any:
        if isinstance(one, tuple):
            return tuple(between(*pair) for pair in zip(one, other, strict=True))
        endless = np.isinf(one)
        rise = np.where(endless, 0.0, other) - np.where(endless, 0.0, one)
        return np.where(endless, one, one + share * rise)

    return type(first)(*between(tuple(first), tuple(last)))


def facets(section: Section, vertical_ratio: Array) -> Facets:
    """The constants of each facet at its foot, by stacking the facets from the centre outwards.

    Args:
        section: the section; its numbers of shape (designs,) or (places, designs).
        vertical_ratio: K_v, in (0, 1], length 1 or n.

    Returns:
        Facets, of shape (facets, 1) unless something has length n. The last facet has no top: vertical walls are added
        above a drawn top.

    >>> half_open = Polygon(np.array([0.5]), (np.array([0.2]),), (np.radians([30.0]),), np.array([np.inf]))
    >>> facets(half_open, np.array([1 / 3])).height.round(12)  # of the chamfer, and of the wall above it
    array([[0. ],
           [0.1]])
    """
    rows = _arc_rows(section, vertical_ratio) if isinstance(section, Circle) else _flat_rows(section, vertical_ratio)
    shape = np.broadcast_shapes(*{value.shape for row in rows for value in row})
    table = np.empty((len(Facets._fields), len(rows), *shape))
    for number, row in enumerate(rows):
        for field, value in zip(table, row, strict=True):
            field[number] = value
    return Facets(*table)


def _flat_rows(section: Polygon, vertical_ratio: Array) -> list[Facets]:
    """The facets of a polygon, one by one."""
    lengths, inclinations = list(section.lengths), list(section.inclinations)
    zero, one = np.zeros(1), np.ones(1)
    drawn = [one] * len(lengths)
    if not lengths or not np.isinf(lengths[-1]).any():
        lengths.append(np.array([np.inf]))
        inclinations.append(np.array([np.pi / 2]))
        drawn.append(zero)
    area, width, height, chamfer = zero, section.base, zero, zero
    excess, excess_rise, shortfall, shortfall_rise = zero, zero, zero, zero
    rows = []
    for number, (length, psi) in enumerate(zip(lengths, inclinations, strict=True)):
        s, c = np.sin(psi), np.where(psi == np.pi / 2, 0.0, np.cos(psi))  # 6e-17 there would open a deep stream
        lacking = pressure_shortfall(psi, vertical_ratio)
        own_excess = (1.0 - lacking) * 2.0 * np.sin(psi / 2) ** 2  # 1 - cos ψ, without its cancellation
        own_shortfall = lacking * c
        load = (excess, excess_rise, own_excess, shortfall, shortfall_rise, own_shortfall)
        rows.append(Facets(drawn[number], s, c, area, width, height, chamfer, *load, zero, 1.0 - vertical_ratio))
        if number + 1 < len(lengths):
            rise = length * s
            excess = excess + rise * (excess_rise + own_excess * length)
            excess_rise = excess_rise + 2.0 * own_excess * length
            shortfall = shortfall + rise * (shortfall_rise + own_shortfall * length)
            shortfall_rise = shortfall_rise + 2.0 * own_shortfall * length
            area = area + (width + length * c) * rise
            width = width + 2.0 * length * c
            height = height + rise
            chamfer = chamfer + np.where(psi == 0.0, 0.0, length)
    return rows


def _arc_rows(section: Circle, vertical_ratio: Array) -> list[Facets]:
    """The half circle, and the vertical walls above it."""
    r, lack, zero, one = section.radius, 1.0 - vertical_ratio, np.zeros(1), np.ones(1)
    half = arc(np.array([np.pi / 2]), lack)
    area, length = 0.5 * np.pi * r**2, 0.5 * np.pi * r
    excess_rise = 2.0 * r * (np.pi / 2 - 1.0 - lack * (np.pi / 4 - 1.0 / 3.0))  # 2 r ∫ K (1 - cos ψ) dψ
    shortfall_rise = 2.0 * r * lack / 3.0  # 2 r ∫ (1 - K) cos ψ dψ
    load = (area * half.excess, excess_rise, 1.0 - lack, area * half.missing, shortfall_rise, zero)
    return [
        Facets(one, one, zero, zero, 2.0 * r, zero, zero, zero, zero, zero, zero, zero, zero, r, lack),
        Facets(zero, one, zero, area, 2.0 * r, r, length, *load, zero, lack),
    ]


def wetted_facet(table: Facets, area: Array) -> Index:
    """The facet in which the surface of a flow area lies, 0 for the innermost.

    Args:
        table: the section's facets.
        area: flow area, m², of the shape of one facet's fields, or broadcast against it.

    Returns:
        Numbers of facets, in the broadcast shape. A surface exactly at a joint counts to the facet above, and so no
        facet without height is ever told.
    """
    return interval_of(table.area, area)


def take_facet(table: Facets, rows: Index) -> Facets:
    """One facet for each design, or for each place and design; of a table of one facet, that for all of them."""
    if len(table.area) == 1:
        return Facets(*[field[0] for field in table])
    if rows.ndim == 1 and rows.size and (rows == rows[0]).all():
        return Facets(*[field[rows[0]] for field in table])
    return Facets(*(take_row(field, rows) for field in table))
