"""How flow areas lie in sections, one after the other: for what looks at a section alone."""

from typing import Any

from chutecalc.core import batch, friction, section

WETTING = 7
TABLES = WETTING  # as Python sees it


def wet(
    own: "section.Section", facets: "section.Facets", numbers: Any, areas: Any, equilibrium: bool, out: Any
) -> None:
    """Depth, wetted length of the drawn facets on one side, width; χ of the friction law, A dχ/dA, m, and f.

    Args:
        own, facets: records of the sections' kind.
        numbers: a row each: K_v, and the section as of :func:`chutecalc.core.batch.solve_rows`.
        areas: m².
        equilibrium: which friction law.
        out: seven rows.
    """
    for row in range(len(areas)):
        batch.read(own, numbers, row, 1)
        section.stack(own, float(numbers[row, 0]), facets)
        area = float(areas[row])
        k = section.facet_of(facets, area)
        depth, width = section.depth_and_width(facets, k, area)
        friction.loads_at(facets, k, area)
        excess, factor = friction.raised(equilibrium, facets.loads)
        friction.law(equilibrium, facets.loads, 0, 1)
        out[0, row], out[1, row], out[2, row] = depth, section.wetted_below(own, facets, k, area), width
        out[3, row], out[4, row], out[5, row] = excess, 2.0 * facets.loads.growth[0], facets.loads.missing[0]
        out[6, row] = factor


def areas_below(own: "section.Section", facets: "section.Facets", numbers: Any, depths: Any, out: Any) -> None:
    """Flow areas below depths, m², arguments likewise."""
    for row in range(len(depths)):
        batch.read(own, numbers, row, 1)
        section.stack(own, float(numbers[row, 0]), facets)
        out[row] = section.area_at_depth(facets, float(depths[row]))
