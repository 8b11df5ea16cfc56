"""The table of the forces on segments and the wear of their liners."""

from collections.abc import Iterable

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.results.loads import LOAD_COLUMNS
from chutecalc.results.segments import SegmentResult


def loads_table(results: Iterable[SegmentResult], units: str) -> Grid:
    """Return a row for each segment that is loaded, with the columns that any of them has.

    Args:
        results: of one design, in order.
        units: ``metric`` or ``us``.
    """
    loaded = [result for result in results if any(np.isfinite(values[0]) for values in result.loads.values())]
    names = [name for name in LOAD_COLUMNS if any(result.loads[name][0] == result.loads[name][0] for result in loaded)]
    names = [name for name in names if name != "relative_wear" or len(loaded) > 1]  # of one segment it says nothing
    table = Grid()
    table.column("loads", left=True, label=True)
    for column in (LOAD_COLUMNS[name] for name in names):
        relative = column.name == "relative_wear"
        table.column(f"wear\n{_unit_of_wear(loaded)}" if relative else f"{column.heading}\n{column.unit_text(units)}")
    for result in loaded if names else ():
        table.row([result.name, *(LOAD_COLUMNS[name].shown(float(result.loads[name][0]), units) for name in names)])
    return table


def _unit_of_wear(loaded: Iterable[SegmentResult]) -> str:
    """Return what wear is relative to: the first segment that is worn."""
    return next((f"{result.name} = 1" for result in loaded if result.loads["relative_wear"][0] >= 1.0), "relative")
