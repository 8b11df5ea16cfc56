"""The report on an uncertain chute for people."""

from collections.abc import Iterator, Mapping

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.output.printer import Printer
from chutecalc.results.column import Column
from chutecalc.results.described import status_words
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep.columns import own_columns, row_columns
from chutecalc.studies.uncertain.beyond import ANY
from chutecalc.studies.uncertain.importance_report import print_importance
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.quantiles import quantiles_of
from chutecalc.studies.uncertain.statistics import FAILS, SHARES, STATUSES, Chance
from chutecalc.studies.uncertain.texts import cell, label, per_cent

AHEAD = tuple(f"{100 * share:g} %" for share in SHARES)
"""Headings of the quantiles."""
LEAST_CUT = 1e-6
"""Share of a distribution below which it is not told that it is cut off."""


def columns_of(result: Outcome) -> dict[str, Column]:
    """Return the columns of a study as people read them, by name.

    Args:
        result: the study.
    """
    known = row_columns()
    own = own_columns([*result.columns], result.chute)
    return {name: own[name].column if name in own else known[name] for name in result.columns}


def print_uncertainty(printer: Printer, result: Outcome) -> None:
    """Print what is uncertain, what comes out, how it may fail or exceed its limits, and which keys matter.

    Args:
        printer: where to print, and in which units.
        result: the study.
    """
    chute = result.chute
    printer.text(chute.spec.title or chute.source)
    state = "" if result.case == DESIGN_POINT else f", case {result.case}"
    printer.text(f"{chute.source}{state}: {result.count:,} samples, seed {result.seed}")
    printer.text()
    printer.table(_keys(result))
    for line in (*_cut_off(result), *_correlations(result)):
        printer.prose(line)
    printer.text()
    _print_summaries(printer, result)
    printer.text()
    printer.table(_chances("how it ends", "status", _ends(result)))
    if result.exceeded:
        printer.text()
        printer.table(_chances(f"how likely limits are exceeded{_over(result)}", "limit", _exceeded(result)))
    if result.warned is not None:
        printer.text()
        if result.warned:
            printer.table(_chances(f"how likely findings warn{_over(result)}", "warning", result.warned))
        else:
            printer.text("no sample has a warning")
    print_importance(printer, result, columns_of(result))


def _keys(result: Outcome) -> Grid:
    """Return a row for each key: its value in the spec, how it scatters, its quantiles."""
    table = Grid()
    for heading in ("key", result.where):
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


def _cut_off(result: Outcome) -> Iterator[str]:
    """Yield a line for each key of whose distribution something is cut off."""
    for key in result.keys.keys:
        outside, bounds = quantiles_of(key).outside, key.parameter.quantity.bounds_text(key.parameter.unit)
        if outside >= LEAST_CUT:
            yield f"{key.path} must be {bounds}: {per_cent(outside)} of its values would not be, and are cut off"


def _over(result: Outcome) -> str:
    """Return over which samples something is, where that is not over all."""
    return "" if result.ok.all() else ", over the samples that do not fail"


def _print_summaries(printer: Printer, result: Outcome) -> None:
    """Print a row for each column that a sample has, and which columns none has."""
    table = Grid(f"what comes out{_over(result)}")
    table.column("column", left=True, label=True)
    for heading in ("mean", "standard\nerror", "standard\ndeviation", *AHEAD):
        table.column(heading)
    without = []
    for name, column in columns_of(result).items():
        own = result.summaries[name]
        if np.isnan(own.mean):
            without.append(column.words)
            continue
        mean, deviation, *quantiles = (
            cell(column, value, printer.units) for value in (own.mean, own.deviation, *own.quantiles)
        )
        error = "" if own.error != own.error else f"{column.converted(own.error, printer.units):.1e}"
        table.row([label(column, printer.units), mean, error, deviation, *quantiles])
    if table.rows:
        printer.table(table)
    if not result.ok.any():
        printer.text("nothing comes out: every sample fails")
    elif without:
        printer.prose(f"no sample has: {', '.join(without)}")


def _ends(result: Outcome) -> dict[str, Chance]:
    """Return the chances of the ways in which samples end, and that of failure."""
    return {status_words(status): own for status, own in result.chances.items() if own.share or status == FAILS}


def _exceeded(result: Outcome) -> dict[str, Chance]:
    """Return the chances that limits are exceeded; all together where that says more."""
    more = len(result.exceeded) > 2 or not result.ok.all()
    given = {text: own for text, own in result.exceeded.items() if text != ANY}
    return given | ({"of all: fails or exceeds any": result.exceeded[ANY]} if more else {})


def _chances(title: str, heading: str, chances: Mapping[str, Chance]) -> Grid:
    """Return a row for each chance."""
    table = Grid(title)
    table.column(heading, left=True, label=True)
    for text in ("chance", "standard\nerror", "at most\n(95 %)"):
        table.column(text)
    for name, own in chances.items():
        if own.share != own.share:
            table.row([name])
            continue
        most = "" if name == STATUSES[0] else per_cent(own.at_most)
        table.row([name, per_cent(own.share, 4), per_cent(own.error, 1), most])
    return table
