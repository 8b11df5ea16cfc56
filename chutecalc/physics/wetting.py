"""Depth of a flow area in a section, and the load on its walls.

On each flat facet depth, area and wall load are quadratics in the wetted length C of that facet, with constants known
at its foot; on an arc they are series in the area. :mod:`chutecalc.core.section` computes them.
"""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from chutecalc.core import floats, section
from chutecalc.core.wetting import WETTING_QUANTITIES, areas_below, tabulate_wetting
from chutecalc.physics.arrays import Array
from chutecalc.physics.circle import series
from chutecalc.physics.section import Circle, Section


class Wetting(NamedTuple):
    """Flow areas in their sections, arrays of shape (designs,)."""

    depth: Array
    """Flow depth H normal to the floor, m."""
    chamfer: Array
    """Wetted length C of the drawn facets on one side, m, without the vertical walls above a drawn top."""
    width: Array
    """Width of the free surface, m."""
    excess: Array
    """Excess friction χ = μ_e/μ - 1 of the friction law, a ratio."""
    excess_sensitivity: Array
    """Sensitivity of χ to the relative change of the flow area, A dχ/dA, a ratio."""
    missing_load: Array
    """Share m = 1 - (1/A) ∫ K cos ψ ζ dl of the weight that hydrostatic wall pressures do not carry."""
    pressure_factor: Array
    """Factor f of the friction law on all hydrostatic wall pressures, a ratio: see
    :func:`chutecalc.physics.pressure.pressure_factor`."""


def wetting(drawn: Section, vertical_ratio: Array, area: Array, equilibrium: bool = False) -> Wetting:
    """Compute depth, width and excess friction of flow areas in sections.

    For a wall element dl at inclination ψ and depth ζ below the free surface, χ = (1/A) ∫ K(ψ) (1 - cos ψ) ζ dl. On a
    facet at β whose foot is w wide, C = 2 q/(w + √(w² + 4 q cos β)) with q = (A - A_foot)/sin β: the root of Paper Eq 7
    in a form that is exact at β = 90° and at B = 0. Then χ A = X_foot + C sin β (E + K (1 - cos β) C), with
    E = 2 Σ K (1 - cos ψ) L over the facets below. For a chamfer on a base this is Paper Eq 11 without its cancellation,
    χ = K C (1 - cos β)/(B + C cos β); for a rectangle it is Paper Eq 2, χ = K_v H/B.

    Args:
        drawn: The sections, arrays of shape (1,) or (designs,).
        vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1], shape (1,) or (designs,).
        area: Flow area A, m², positive, shape (1,) or (designs,).
        equilibrium: Scale all wall pressures until they carry the weight, χ/(1 - m), instead of laying the missing load
            on the centre section as the paper does.

    Returns:
        The flow areas in their sections. Above a drawn top the walls are vertical; wall heights limit nothing here.
        Areas above that of a pipe are taken as a full one.

    >>> from chutecalc.physics.section import Polygon
    >>> endless = np.array([np.inf])
    >>> vee = Polygon(np.array([0.0]), lengths=(endless,), inclinations=(np.radians([60.0]),), wall_height=endless)
    >>> for equilibrium in (False, True):  # K (1 - cos β)/cos β, and 1/cos β - 1, at any depth
    ...     found = wetting(vee, np.array([0.2]), np.array([0.1]), equilibrium)
    ...     print(found.excess.round(14).item(), abs(found.excess_sensitivity.round(14).item()))
    0.4 0.0
    1.0 0.0
    """
    numbers, area = _rows(drawn, vertical_ratio, area)
    out = np.empty((WETTING_QUANTITIES, len(area)))
    own, facets = records_of(kind_of(drawn))
    tabulate_wetting(own, facets, numbers, area, equilibrium, out)
    return Wetting._make(out)


def area_at_depth(drawn: Section, depth: Array) -> Array:
    """Compute the flow area below a depth, the inverse of :func:`wetting`.

    Args:
        drawn: The sections, arrays of shape (1,) or (designs,).
        depth: Depth H normal to the floor, m, 0 or more, shape (1,) or (designs,).

    Returns:
        A, m², shape (designs,); infinite for an infinite depth.

    >>> from chutecalc.physics.section import Polygon
    >>> endless = np.array([np.inf])
    >>> vee = Polygon(np.array([0.0]), lengths=(endless,), inclinations=(np.radians([45.0]),), wall_height=endless)
    >>> float(area_at_depth(vee, np.array([0.3]))[0].round(12))
    0.09
    """
    numbers, depth = _rows(drawn, np.ones(1), depth)
    out = np.empty(len(depth))
    own, facets = records_of(kind_of(drawn))
    areas_below(own, facets, numbers, depth, out)
    return out


class Kind(NamedTuple):
    """The layout of a section's records, whatever its numbers are."""

    circle: bool
    """Whether it is circular."""
    walls: int
    """Number of drawn facets of a polygon on one side."""
    facets: int
    """Number of facets with the vertical walls above a drawn top."""
    closed: bool = False
    """Whether it is a pipe or a box."""


def kind_of(drawn: Section) -> Kind:
    """Return the layout of a section.

    Args:
        drawn: The section.

    >>> from chutecalc.physics.section import Polygon
    >>> length, angle, endless = np.array([0.2]), np.radians([45.0]), np.array([np.inf])
    >>> kind_of(Polygon(np.array([0.5]), lengths=(length,), inclinations=(angle,), wall_height=endless))
    Kind(circle=False, walls=1, facets=2, closed=False)
    """
    if isinstance(drawn, Circle):
        return Kind(True, 0, 1 if drawn.closed else 2, drawn.closed)
    walls = len(drawn.lengths)
    last = drawn.lengths[-1] if walls else np.zeros(1)
    upright = last.item() == np.inf if last.size == 1 else np.isinf(last).any()  # NumPy takes long for one number
    return Kind(False, walls, walls if upright else walls + 1, drawn.closed)


def records_of(kind: Kind) -> tuple[section.Section, section.Facets]:
    """Create the records of the compiled solver for a section.

    Args:
        kind: Its layout, from :func:`kind_of`.

    >>> own, facets = records_of(Kind(circle=False, walls=0, facets=1))
    >>> type(own).__name__, type(facets).__name__
    ('Section', 'Facets')
    """
    series = _series() if kind.circle else floats.zeros(1)
    own = section.Section(kind.walls, kind.circle, kind.closed)
    return own, section.Facets(kind.facets, kind.circle, series)


def numbers_of(drawn: Section) -> list[Array]:
    """List the numbers of a section in the order in which the compiled solver reads them.

    Args:
        drawn: The section.

    Returns:
        Wall height and radius of a circle; wall height, base, and length and inclination of each drawn facet of a
        polygon; m and rad.

    >>> from chutecalc.physics.section import Circle
    >>> numbers_of(Circle(radius=np.array([0.4]), wall_height=np.array([np.inf])))
    [array([inf]), array([0.4])]
    """
    if isinstance(drawn, Circle):
        return [drawn.wall_height, drawn.radius]
    walls = zip(drawn.lengths, drawn.inclinations, strict=True)
    return [drawn.wall_height, drawn.base, *(number for wall in walls for number in wall)]


def _rows(drawn: Section, vertical_ratio: Array, values: Array) -> tuple[Array, Array]:
    """Broadcast a section's numbers, as rows, and values against each other."""
    *columns, values = np.broadcast_arrays(vertical_ratio, *numbers_of(drawn), values)
    return np.ascontiguousarray(np.stack(columns, axis=1)), np.array(values)


@cache
def _series() -> Any:
    return floats.numbers(series().ravel().tolist())
