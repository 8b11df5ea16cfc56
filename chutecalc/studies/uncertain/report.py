"""The report on an uncertain chute for people."""

from collections.abc import Iterator

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.output.printer import Printer
from chutecalc.results.column import Column
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep.columns import own_columns, row_columns
from chutecalc.studies.uncertain.importance import Indices
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.sampling import REPLICATES
from chutecalc.studies.uncertain.statistics import FAILS, SHARES, STATUSES

AHEAD = tuple(f"{100 * share:g} %" for share in SHARES)
"""Headings of the quantiles."""


def columns_of(result: Outcome) -> dict[str, Column]:
    """Return the columns of a study as people read them, by name.

    Args:
        result: the study.
    """
    known = row_columns()
    own = own_columns([*result.columns], result.chute)
    return {name: own[name].column if name in own else known[name] for name in result.columns}


def print_uncertainty(printer: Printer, result: Outcome) -> None:
    """Print what is uncertain, what comes out, how it may fail, and which keys matter.

    Args:
        printer: where to print, and in which units.
        result: the study.
    """
    chute = result.chute
    printer.text(chute.spec.title or chute.source)
    state = "" if result.case == DESIGN_POINT else f", case {result.case}"
    printer.text(
        f"{chute.source}{state}: {result.count:,} samples, {REPLICATES} scramblings of Sobol points, seed {result.seed}"
    )
    printer.text()
    printer.table(_keys(result))
    for line in _correlations(result):
        printer.text(line)
    printer.text()
    printer.table(_summaries(result, printer.units))
    printer.text()
    printer.table(_chances(result))
    for name, column in columns_of(result).items():
        if np.isnan(result.tornado.columns[name]).all():
            continue
        printer.text()
        printer.table(_importance(result, name, column, printer.units))
    if FAILS in result.indices:
        printer.text()
        printer.table(_failure(result))
    elif result.no_indices:
        printer.text()
        printer.text(f"no Sobol indices: {result.no_indices}")


def _keys(result: Outcome) -> Grid:
    """Return a row for each key: its value in the spec, how it scatters, its quantiles."""
    table = Grid()
    for heading in ("key", "in the spec"):
        table.column(heading, left=heading == "key", label=heading == "key")
    table.column("uncertainty", left=True, words=True)
    for heading in AHEAD:
        table.column(heading)
    for key in result.keys.keys:
        quantiles = np.quantile(result.values[key.path], SHARES)
        spec = f"{key.parameter.value_in_unit:.6g}"
        table.row([key.path, spec, key.scatter.text, *(f"{value:z.5g}" for value in quantiles)])
    return table


def _correlations(result: Outcome) -> Iterator[str]:
    """Yield a line for each pair of keys that are correlated."""
    for one, other in zip(*np.nonzero(np.triu(result.keys.correlation, 1)), strict=True):
        paths = result.keys.paths
        yield f"correlation of {paths[one]} and {paths[other]}: {result.keys.correlation[one, other]:g}"


def _summaries(result: Outcome, units: str) -> Grid:
    """Return a row for each column."""
    fails = "" if result.ok.all() else ", over the samples that do not fail"
    table = Grid(f"what comes out{fails}")
    table.column("column", left=True, label=True)
    for heading in ("mean", "standard\nerror", "standard\ndeviation", *AHEAD):
        table.column(heading)
    for name, column in columns_of(result).items():
        own = result.summaries[name]
        mean, deviation, *quantiles = (
            _shown(column, value, units) for value in (own.mean, own.deviation, *own.quantiles)
        )
        error = "" if own.error != own.error else f"{column.converted(own.error, units):.1e}"
        table.row([_label(column, units), mean, error, deviation, *quantiles])
    return table


def _shown(column: Column, value: float, units: str) -> str:
    """Return a number of a column, empty for NaN."""
    if column.name == "error_estimate":
        return "" if value != value else f"{value:.0e}"
    return column.shown(float(value), units)


def _status(status: str) -> str:
    """Return a status as people read it."""
    return status.replace("_", " ")


def _label(column: Column, units: str) -> str:
    """Return the name of a column with its unit."""
    return ", ".join(part for part in (column.heading, column.unit_text(units)) if part)


def _chances(result: Outcome) -> Grid:
    """Return a row for each way to end."""
    table = Grid("how it ends")
    table.column("status", left=True, label=True)
    for heading in ("chance", "standard\nerror", "at most\n(95 %)"):
        table.column(heading)
    for status, own in result.chances.items():
        if own.share or status == FAILS:
            most = "" if status == STATUSES[0] else f"{100 * own.at_most:.2g} %"
            table.row([_status(status), f"{100 * own.share:.4g} %", f"{100 * own.error:.1g} %", most])
    return table


def _importance(result: Outcome, name: str, column: Column, units: str) -> Grid:
    """Return a row for each key: the column with the key alone at its ends, and its Sobol indices."""
    own = result.indices.get(name)
    spec = _shown(column, result.tornado.spec[name], units) or "none"
    table = Grid(f"{_label(column, units)}, {spec} in the spec: each key alone" + (", Sobol indices" if own else ""))
    table.column("key", left=True, label=True)
    for heading in ("at 5 %", "at 95 %"):
        table.column(heading)
    _index_columns(table, own)
    for k in result.tornado.order(name):
        ends = zip(result.tornado.columns[name][k], result.tornado.ends[k], strict=True)
        alone = [_shown(column, value, units) if code == 0 else _status(STATUSES[code]) for value, code in ends]
        table.row([result.keys.paths[k], *alone, *_index_cells(own, k)])
    return table


def _failure(result: Outcome) -> Grid:
    """Return a row for each key: its Sobol indices of failure."""
    own = result.indices[FAILS]
    table = Grid("which keys decide whether it fails: Sobol indices of failure")
    table.column("key", left=True, label=True)
    _index_columns(table, own)
    for k in np.argsort(-own.total, kind="stable"):
        table.row([result.keys.paths[k], *_index_cells(own, int(k))])
    return table


def _index_columns(table: Grid, own: Indices | None) -> None:
    """Add the columns of Sobol indices, if there are any."""
    for heading in ("first\norder", "±", "total\norder", "±") if own else ():
        table.column(heading)


def _index_cells(own: Indices | None, key: int) -> list[str]:
    """Return the cells of Sobol indices of a key."""
    return [] if own is None else [f"{values[key]:z.3f}" for values in own]
