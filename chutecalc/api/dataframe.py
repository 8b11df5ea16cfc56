"""Results as data frames of pandas or Polars, which are imported only here."""

from collections.abc import Iterable
from importlib import import_module
from typing import Any

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.extras import PANDAS, POLARS, require_extra
from chutecalc.results.column_names import column_names
from chutecalc.results.solved import SolvedChute

LIBRARIES = {"pandas": PANDAS, "polars": POLARS}


def stations_frame(
    solution: SolvedChute, points: int | None, spacing: float | None, columns: Iterable[str], library: str
) -> Any:
    """Return stations as a data frame; see :meth:`chutecalc.Solution.to_dataframe`.

    Args:
        solution: of one or several designs.
        points: number of stations on each segment.
        spacing: instead, distance between stations, m.
        columns: names of the columns; all by default.
        library: ``pandas`` or ``polars``.
    """
    make = _data_frame(library, "to_dataframe")
    names = column_names(columns)
    table = solution.stations(points, spacing, [*dict.fromkeys([*names, "s_m"])] if names else ())
    reached = np.isfinite(table["s_m"])
    rows: dict[str, Any] = {"design": np.nonzero(reached)[0]} if solution.count > 1 else {}
    return make(rows | {name: table[name][reached] for name in names or table})


def designs_frame(solution: SolvedChute, columns: Iterable[str], library: str) -> Any:
    """Return designs as a data frame; see :meth:`chutecalc.Solution.designs_dataframe`.

    Args:
        solution: of one or several designs.
        columns: names of columns at the exit.
        library: ``pandas`` or ``polars``.
    """
    make, names = _data_frame(library, "designs_dataframe"), column_names(columns)
    numbers = solution.exit_columns(names)
    rows = {"design": np.arange(solution.count), "status": np.broadcast_to(solution.status, solution.count)}
    return make(rows | {f"exit_{name}": np.broadcast_to(numbers[name], solution.count) for name in names})


def _data_frame(library: str, caller: str) -> Any:
    """Import a library and return its ``DataFrame``, for a method named in messages."""
    if library not in LIBRARIES:
        raise UsageError(f"library must be {' or '.join(LIBRARIES)}, not {library!r}")
    require_extra(caller, LIBRARIES[library])
    return import_module(library).DataFrame
