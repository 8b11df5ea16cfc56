"""The columns that the rows of a sweep can have."""

from dataclasses import replace

from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS, Extremes

PREFIXES = {"exit": "at the end of the chute", "max": "largest on guiding surfaces", "min": "least on guiding surfaces"}
"""Prefixes of the names of station columns in a sweep's rows, each with its meaning."""


def row_columns() -> dict[str, Column]:
    """Return all columns that a sweep's rows can have, by name.

    >>> row_columns()["max_depth_m"].label("metric")
    'max depth H, m'
    """
    found = {
        "status": Column("status", "status", "", "how the design ends; impossible: a section that cannot exist"),
        "findings": Column("findings", "findings", "", "codes of the findings, see docs/findings.md"),
        "error_estimate": Column("error_estimate", "error", "", "of the exit velocity, relative", "number", "", 14),
    }
    for prefix, where in PREFIXES.items():
        for name, column in COLUMNS.items():
            if column.formula and (prefix == "exit" or column.extremes is not Extremes.NONE):
                symbol = "" if column.heading == column.symbol else column.symbol
                found[f"{prefix}_{name}"] = replace(
                    column, name=f"{prefix}_{name}", heading=f"{prefix} {column.heading}", symbol=symbol, meaning=where
                )
    return found | {
        f"receiver_{name}": replace(column, name=f"receiver_{name}") for name, column in RECEIVER_COLUMNS.items()
    }
