"""Sensitivity as a table for people, and as part of a document."""

from typing import Any

from chutecalc.output.dataset import number
from chutecalc.output.grid import Grid
from chutecalc.results.columns import COLUMNS
from chutecalc.studies.sensitivity.study import Sensitivity

DIGITS = 4
"""Significant digits of a sensitivity."""
LEAST = 5e-7
"""Per cent below which a sensitivity is shown as 0: the solver has the rest."""


def sensitivity_table(found: Sensitivity, units: str) -> Grid:
    """Return a row for each key, with a mark where slopes to both sides differ.

    Args:
        found: the sensitivities of a column at the exit.
        units: ``metric`` or ``us``.
    """
    column = COLUMNS[found.column.removeprefix("exit_")]
    value = f"{column.shown(found.value, units)} {column.unit_text(units)}".rstrip()
    table = Grid(f"change of the exit {column.words} of {value}, in % of it, where one key rises")
    table.column("key", left=True, label=True)
    for heading in ("value", "by 1 of\nits unit", "by 1 %\nof it"):
        table.column(heading)
    table.column("", left=True, words=True)
    marks = _marks(found)
    numbers = zip(found.paths, found.given, found.per_unit, found.per_percent, marks, strict=True)
    for path, given, unit, percent, mark in numbers:
        table.row([path, f"{given:.6g}", _shown(unit), _shown(percent), mark])
    return table


def _shown(value: float) -> str:
    """Return a number, empty for NaN; one that is nothing but rounding as 0."""
    return "" if value != value else f"{value:z.{DIGITS}g}" if abs(value) >= LEAST else "0"


def _marks(found: Sensitivity) -> list[str]:
    """Return what there is to say of each key."""
    numbers = zip(found.derivative, found.error, found.smooth, strict=True)
    return [_mark(slope, error, smooth) for slope, error, smooth in numbers]


def _mark(slope: float, error: float, smooth: bool) -> str:
    """Return what there is to say of one key."""
    if slope != slope:
        return "fails on both sides"
    if error != error:
        return "fails on one side"
    return "" if smooth else "differs where it falls"


def sensitivity_document(found: Sensitivity) -> dict[str, Any]:
    """Return the sensitivities as part of a document.

    Args:
        found: the sensitivities of a column.
    """
    numbers = zip(
        found.paths,
        found.given,
        found.derivative,
        found.error,
        found.per_unit,
        found.per_percent,
        found.smooth,
        strict=True,
    )
    names = ("value", "derivative", "error", "percent_per_unit", "percent_per_percent")
    keys = [
        {"path": path, **dict(zip(names, map(number, own), strict=True)), "smooth": bool(smooth)}
        for path, *own, smooth in numbers
    ]
    return {"column": found.column, "value": number(found.value), "keys": keys}
