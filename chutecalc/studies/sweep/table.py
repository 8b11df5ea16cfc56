"""The rows of a sweep as a table for people."""

from collections import Counter
from collections.abc import Iterator
from itertools import takewhile
from typing import Any

import numpy as np

from chutecalc.design import Status
from chutecalc.fields.units import TEXT as UNIT_TEXT
from chutecalc.fields.units import UNITS
from chutecalc.output.dataset import Block
from chutecalc.output.grid import Grid
from chutecalc.output.printer import Printer
from chutecalc.output.table import heading
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import status_words
from chutecalc.spec.paths import is_number
from chutecalc.studies.sweep.block import joined, select_rows
from chutecalc.studies.sweep.columns import CODES, row_columns
from chutecalc.studies.sweep.sweep import Sweep

MOST_SHOWN, SHOWN_WITH_FILE = 1000, 40
"""Most rows of a table, without a data file and with one."""

ANGLES = {
    "chamfer": ("chamfer angle", "β"),
    "internal_friction": ("internal friction", "δ"),
    "friction": ("wall friction", "φ"),
}
AXES = {"1": "x", "2": "z"}
"""Names of the items of a point, the only list of lengths."""
VARIED = "varied"
LABELS = ("status", "segment", "s_m")
"""Columns that say what a row is, beside the parameters."""


def column_of(sweep: Sweep, name: str) -> Column:
    """Return how people read a column of the rows of a sweep.

    Args:
        sweep: the sweep.
        name: name of the column: of a parameter, or of the catalogue.

    >>> import chutecalc
    >>> from chutecalc.studies.sweep.parameters import read_parameters
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> sweep = Sweep(chute, read_parameters(["radius=1,2"], chute))
    >>> column_of(sweep, "segments.spoon.start_m.2").label("metric")
    'spoon start z, m'
    """
    known = COLUMNS if sweep.profiles else row_columns()
    if name == "status":
        return row_columns()[name]
    if name in sweep.own:
        return sweep.own[name].column
    if name in known and name in sweep.columns:
        return known[name]
    path = name.split(".")
    items = [path.pop() for _ in takewhile(is_number, reversed(name.split(".")))][::-1]
    key = path.pop()
    units = sorted((unit for table in UNITS.values() for unit in table if unit and key.endswith(f"_{unit}")), key=len)
    unit = units[-1] if units else ""
    if len(items) == 1 and unit in UNITS["length"]:
        items = [AXES[items[0]]]
    stem = key.removesuffix(f"_{unit}")
    words, symbol = ANGLES.get(stem, (stem.replace("_", " "), ""))
    heading = " ".join([*path[1:], symbol or words, *items])
    return Column(name, heading, symbol, VARIED, words, unit)


def parameter_label(column: Column) -> str:
    """Return the label of an axis for a parameter.

    Args:
        column: column of the parameter, from :func:`column_of`.

    >>> parameter_label(Column("friction_deg", "φ", "φ", VARIED, "wall friction", "deg"))
    'wall friction φ, °'
    """
    words = f"{column.dimension} {column.heading}" if column.symbol else column.heading
    return ", ".join(part for part in (words, UNIT_TEXT.get(column.unit, column.unit)) if part)


class FirstRows:
    """The first rows of a sweep for a table, and the number of designs that end in each way.

    Args:
        sweep: the sweep.
        most: largest number of rows to keep.
    """

    def __init__(self, sweep: Sweep, most: int) -> None:
        self.sweep, self.most = sweep, most
        self.blocks: list[Block] = []
        self.count = self.rows = 0
        self.ends: Counter[str] = Counter()

    def write(self, block: Block) -> None:
        """Count a block, and keep its first rows while there is room.

        Args:
            block: the block.
        """
        status = block["status"]
        self.rows += len(status)
        self.ends.update(status.tolist())
        possible = np.flatnonzero(status != Status.IMPOSSIBLE_LABEL)[: self.most - self.count]
        if possible.size:
            self.blocks.append(select_rows(block, possible))
            self.count += len(possible)

    def close(self) -> None:
        """Do nothing."""

    def show(self, printer: Printer, files: list[str]) -> None:
        """Print the title, the rows, and how the designs end.

        Args:
            printer: where to print, and in which units.
            files: data files that have all rows.
        """
        sweep = self.sweep
        printer.text(sweep.chute.spec.title or sweep.chute.source)
        printer.text(f"{sweep.chute.source}: {_counted(sweep.count, 'design')}, {self._parameters_text()}")
        if sweep.chute.spec.model.steel == "follows_stream":
            printer.text("the steel follows the stream of each design")
        printer.text()
        if self.count:
            printer.table(self._table(printer.units))
            printer.text()
        for line in self._notes(files):
            printer.text(line)

    def _parameters_text(self) -> str:
        """Return the parameters, what stays constant, and which rows are chosen, as text."""
        sweep = self.sweep
        lists = [f"{parameter.name} ({len(parameter.values):,})" for parameter in sweep.parameters]
        how = f", constant {sweep.keep}" if sweep.is_adjusted else ""
        top = sweep.top
        best = f", the {top.rows} with the {'largest' if top.largest else 'smallest'} {top.column}" if top else ""
        return (" with " if sweep.parallel else " by ").join(lists) + how + best

    def _table(self, units: str) -> Grid:
        """Return the table of the rows."""
        table = Grid()
        block = joined(self.blocks)
        shown = {name: column_of(self.sweep, name) for name in self.sweep.header}
        for name, column in shown.items():
            label = column.meaning == VARIED or name in LABELS
            table.column(heading(column, units), left=name in self.sweep.texts, label=label, words=name in CODES)
        cells = [_texts(column, block[name], units) for name, column in shown.items()]
        for row in zip(*cells, strict=True):
            table.row(row)
        return table

    def _notes(self, files: list[str]) -> Iterator[str]:
        """Yield lines on how the designs end, and on rows that are not shown."""
        impossible = self.ends[Status.IMPOSSIBLE_LABEL]
        if not (self.sweep.profiles or self.sweep.top):
            ends = ", ".join(f"{number:,} {end}" for end, number in self.ends.most_common())
            yield f"{_counted(self.rows, 'design')}: {ends}"
        if impossible:
            yield f"left out: {_counted(impossible, 'impossible design')}, whose geometry does not fit together"
        rest = self.rows - impossible - self.count
        if rest:
            where = f"all are in {', '.join(files)}" if files else "write all with --csv, or pick the best with --top"
            yield f"not shown: {_counted(rest, 'more row')}; {where}"


def _counted(count: int, noun: str) -> str:
    return f"{count:,} {noun}" + ("" if count == 1 else "s")


def _texts(column: Column, values: Any, units: str) -> list[str]:
    """Return the cells of a column."""
    if values.dtype.kind != "f":
        is_status = column.name.rpartition(".")[2] == "status"
        return [status_words(value) if is_status else str(value) for value in values.tolist()]
    if column.meaning == VARIED:
        return [f"{value:z.6g}" for value in values.tolist()]
    if column.name == "error_estimate":
        return ["" if value != value else f"{value:.0e}" for value in values.tolist()]
    return [column.shown(value, units) for value in values.tolist()]
