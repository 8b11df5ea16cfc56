"""The columns that the rows of a sweep can have."""

from dataclasses import replace

from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS, Extremes

WAYS = {"exit": "at the end of the chute", "max": "largest on guiding surfaces", "min": "least on guiding surfaces"}
"""What a sweep's rows tell of a station column, by the first word of their names."""


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
    for way, where in WAYS.items():
        for name, column in COLUMNS.items():
            if column.formula and (way == "exit" or column.extremes is not Extremes.NONE):
                symbol = "" if column.heading == column.symbol else column.symbol
                found[f"{way}_{name}"] = replace(
                    column, name=f"{way}_{name}", heading=f"{way} {column.heading}", symbol=symbol, meaning=where
                )
    return found | {
        f"receiver_{name}": replace(column, name=f"receiver_{name}") for name, column in RECEIVER_COLUMNS.items()
    }
