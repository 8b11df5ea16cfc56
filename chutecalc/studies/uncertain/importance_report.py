"""Which uncertain keys matter, for people."""

from collections.abc import Mapping

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.output.printer import Printer
from chutecalc.results.column import Column
from chutecalc.results.described import status_words
from chutecalc.studies.uncertain.importance import Indices
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.statistics import FAILS, STATUSES
from chutecalc.studies.uncertain.texts import cell, label

MEANING = (
    "explains alone: share of the variance that would go if only this key were known",
    "with others: that, and its part in what keys do together",
)
"""What the columns of Sobol indices are."""


def print_importance(printer: Printer, result: Outcome, columns: Mapping[str, Column]) -> None:
    """Print for each column what each key does alone, and how much of the variance it explains.

    Args:
        printer: where to print, and in which units.
        result: the study.
        columns: of the study, by name.
    """
    for name, column in columns.items():
        if not np.isfinite(result.tornado.columns[name]).any():
            continue
        printer.text()
        printer.table(_importance(result, name, column, printer.units))
    if FAILS in result.indices:
        printer.text()
        printer.table(_failure(result))
    printer.text()
    for line in MEANING if result.indices else (f"no shares of the variance: {result.no_indices}",):
        printer.prose(line)


def _importance(result: Outcome, name: str, column: Column, units: str) -> Grid:
    """Return a row for each key: the column with the key alone at its ends, and its Sobol indices."""
    own = result.indices.get(name)
    spec = cell(column, result.tornado.spec[name], units) or "none"
    shares = ", share of variance" if own else ""
    table = Grid(f"{label(column, units)}, {spec} {result.where}: each key alone{shares}")
    table.column("key", left=True, label=True)
    for heading in ("at 5 %", "at 95 %"):
        table.column(heading)
    _index_columns(table, own)
    for k in result.tornado.order(name):
        ends = zip(result.tornado.columns[name][k], result.tornado.ends[k], strict=True)
        alone = [cell(column, value, units) if code == 0 else status_words(STATUSES[code]) for value, code in ends]
        table.row([result.keys.paths[k], *alone, *_index_cells(own, k)])
    return table


def _failure(result: Outcome) -> Grid:
    """Return a row for each key: its Sobol indices of failure."""
    own = result.indices[FAILS]
    table = Grid("which keys decide whether it fails: share of the variance")
    table.column("key", left=True, label=True)
    _index_columns(table, own)
    for k in np.argsort(-own.total, kind="stable"):
        table.row([result.keys.paths[k], *_index_cells(own, int(k))])
    return table


def _index_columns(table: Grid, own: Indices | None) -> None:
    """Add the columns of Sobol indices, if there are any."""
    for heading in ("explains\nalone, %", "±", "with\nothers, %", "±") if own else ():
        table.column(heading)


def _index_cells(own: Indices | None, key: int) -> list[str]:
    """Return the cells of Sobol indices of a key."""
    return [] if own is None else [f"{100.0 * values[key]:z.1f}" for values in own]
