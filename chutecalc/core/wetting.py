"""Tabulate the wetting of sections, one after the other, without a segment."""

from typing import Any

from chutecalc.core import batch, friction, section

WETTING_ROWS = 7
WETTING_QUANTITIES = WETTING_ROWS  # for Python; the other is a C constant if compiled


def tabulate_wetting(
    cross_section: "section.Section", facets: "section.Facets", numbers: Any, areas: Any, equilibrium: bool, out: Any
) -> None:
    """Write depth, wetted length of the drawn facets on one side, width; χ of the friction law, A dχ/dA, m, and f.

    Args:
        cross_section, facets: records of the sections' layout.
        numbers: a row each: K_v, and the section as in :func:`chutecalc.core.batch.solve_rows`.
        areas: m².
        equilibrium: which friction law.
        out: seven rows.
    """
    for row in range(len(areas)):
        batch.read_section(cross_section, numbers, row, 1)
        section.stack_facets(cross_section, float(numbers[row, 0]), facets)
        area = float(areas[row])
        k = section.facet_of(facets, area)
        depth, width = section.depth_and_width(facets, k, area)
        friction.hydrostatic_loads_at(facets, k, area)
        excess, factor = friction.friction_law(equilibrium, facets.loads)
        friction.apply_friction_law(equilibrium, facets.loads, 0, 1)
        out[0, row], out[1, row], out[2, row] = depth, section.wetted_below(cross_section, facets, k, area), width
        out[3, row], out[4, row], out[5, row] = (
            excess,
            2.0 * facets.loads.excess_sensitivity[0],
            facets.loads.missing[0],
        )
        out[6, row] = factor


def areas_below(
    cross_section: "section.Section", facets: "section.Facets", numbers: Any, depths: Any, out: Any
) -> None:
    """Write the flow areas below depths, m², with arguments as in :func:`tabulate_wetting`."""
    for row in range(len(depths)):
        batch.read_section(cross_section, numbers, row, 1)
        section.stack_facets(cross_section, float(numbers[row, 0]), facets)
        out[row] = section.area_at_depth(facets, float(depths[row]))
