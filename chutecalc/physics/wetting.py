"""How deep a flow area stands in a section, and how hard its walls are pressed.

On each flat facet depth, area and wall load are quadratics in the wetted length C of that facet, with constants known
at its foot; on an arc they are series in the area. :mod:`chutecalc.core.section` has them.
"""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from chutecalc.core import floats, section
from chutecalc.core.wetting import TABLES, areas_below, wet
from chutecalc.physics.arrays import Array
from chutecalc.physics.circle import series
from chutecalc.physics.section import Circle, Section


class Wetting(NamedTuple):
    """How flow areas lie in their sections, arrays of shape (n,)."""

    depth: Array
    """Normal to the floor, m."""
    chamfer: Array
    """Wetted length of the drawn facets on one side, m; the walls above a drawn top do not count."""
    width: Array
    """Of the free surface, m."""
    excess: Array
    """χ = μ_e/μ - 1 of the friction law."""
    excess_sensitivity: Array
    """A dχ/dA."""
    missing_load: Array
    """m = 1 - (1/A) ∫ K cos ψ ζ dl, the share of the weight that hydrostatic wall pressures do not carry."""
    pressure_factor: Array
    """f by which the friction law raises the hydrostatic pressures of all walls."""


def wetting(drawn: Section, vertical_ratio: Array, area: Array, equilibrium: bool = False) -> Wetting:
    """How flow areas lie in sections.

    C = 2 q/(w + √(w² + 4 q cos β)), q = (A - A_foot)/sin β: the root of Paper Eq 7 in the form that is exact at β = 90°
    and at B = 0. χ A = X_foot + C sin β (E + K (1 - cos β) C), with E = 2 Σ K (1 - cos ψ) L of the facets below. For a
    chamfer on a base this is Paper Eq 11 without its cancellation, χ = K C (1 - cos β)/(B + C cos β); for a rectangle
    Paper Eq 2.

    Args:
        drawn: the sections, arrays of length 1 or n.
        vertical_ratio: K_v, likewise.
        area: flow area, m², positive, likewise.
        equilibrium: scale all wall pressures until they carry the weight, χ/(1 - m), instead of laying the missing load
            on the centre section as the paper does.

    >>> from chutecalc.physics.section import Polygon
    >>> vee = Polygon(np.array([0.0]), (np.array([np.inf]),), (np.radians([60.0]),), np.array([np.inf]))
    >>> for equilibrium in (False, True):  # K (1 - cos β)/cos β, and 1/cos β - 1, at any depth
    ...     found = wetting(vee, np.array([0.2]), np.array([0.1]), equilibrium)
    ...     print(found.excess.round(14).item(), abs(found.excess_sensitivity.round(14).item()))
    0.4 0.0
    1.0 0.0
    """
    numbers, area = _rows(drawn, vertical_ratio, area)
    out = np.empty((TABLES, len(area)))
    own, facets = records_of(kind_of(drawn))
    wet(own, facets, numbers, area, equilibrium, out)
    return Wetting._make(out)


def area_at_depth(drawn: Section, depth: Array) -> Array:
    """Flow area below a depth, m, 0 or more: the inverse of the depth in :func:`wetting`; infinite of what is."""
    numbers, depth = _rows(drawn, np.ones(1), depth)
    out = np.empty(len(depth))
    own, facets = records_of(kind_of(drawn))
    areas_below(own, facets, numbers, depth, out)
    return out


class Kind(NamedTuple):
    """What records a section takes, whatever its numbers are."""

    circle: bool
    walls: int
    """Drawn facets of a polygon, on one side."""
    facets: int
    """With the vertical walls above a drawn top."""


def kind_of(drawn: Section) -> Kind:
    """Of a section."""
    if isinstance(drawn, Circle):
        return Kind(True, 0, 2)
    walls = len(drawn.lengths)
    last = drawn.lengths[-1] if walls else np.zeros(1)
    upright = last.item() == np.inf if last.size == 1 else np.isinf(last).any()  # NumPy takes long for one number
    return Kind(False, walls, walls if upright else walls + 1)


def records_of(kind: Kind) -> tuple[section.Section, section.Facets]:
    """The compiled solver's own records."""
    series = _series() if kind.circle else floats.zeros(1)
    return section.Section(kind.walls, kind.circle), section.Facets(kind.facets, kind.circle, series)


def numbers_of(drawn: Section) -> list[Array]:
    """A section's numbers, in the order in which the compiled solver reads them."""
    if isinstance(drawn, Circle):
        return [drawn.wall_height, drawn.radius]
    walls = zip(drawn.lengths, drawn.inclinations, strict=True)
    return [drawn.wall_height, drawn.base, *(number for wall in walls for number in wall)]


def _rows(drawn: Section, vertical_ratio: Array, values: Array) -> tuple[Array, Array]:
    """Rows of numbers, and values as many."""
    *columns, values = np.broadcast_arrays(vertical_ratio, *numbers_of(drawn), values)
    return np.ascontiguousarray(np.stack(columns, axis=1)), np.array(values)


@cache
def _series() -> Any:
    return floats.numbers(series().ravel().tolist())
