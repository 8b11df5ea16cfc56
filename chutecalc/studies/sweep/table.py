"""The rows of a sweep for people."""

from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np

from chutecalc.fields.units import TEXT as UNIT_TEXT
from chutecalc.fields.units import UNITS
from chutecalc.output.dataset import Block
from chutecalc.output.grid import Grid
from chutecalc.output.table import Printer
from chutecalc.results.columns import COLUMNS, Column, row_columns
from chutecalc.studies.sweep.block import IMPOSSIBLE, TEXT, chosen, joined
from chutecalc.studies.sweep.sweep import Sweep

MOST_SHOWN, SHOWN_WITH_FILE = 1000, 40
"""Rows that are printed where nothing, or a file too, has them all."""

ANGLES = {
    "chamfer": ("chamfer angle", "β"),
    "internal_friction": ("internal friction", "δ"),
    "friction": ("wall friction", "φ"),
}
VARIED = "varied"


def column_of(sweep: Sweep, name: str) -> Column:
    """How people read a column of a sweep's rows."""
    known = COLUMNS if sweep.profiles else row_columns()
    if name == "status":
        return row_columns()[name]
    if name in known and name in sweep.columns:
        return known[name]
    units = sorted((unit for table in UNITS.values() for unit in table if unit and name.endswith(f"_{unit}")), key=len)
    unit = units[-1] if units else ""
    *place, key = name.removesuffix(f"_{unit}").split(".")
    words, symbol = ANGLES.get(key, (key.replace("_", " "), ""))
    heading = " ".join([*place[1:], symbol or words])
    return Column(name, heading, symbol, VARIED, words, unit)


def parameter_label(column: Column) -> str:
    """A parameter as an axis is labelled.

    >>> parameter_label(Column("friction_deg", "φ", "φ", VARIED, "wall friction", "deg"))
    'wall friction φ, °'
    """
    words = f"{column.dimension} {column.heading}" if column.symbol else column.heading
    return ", ".join(part for part in (words, UNIT_TEXT.get(column.unit, column.unit)) if part)


class FirstRows:
    """The first rows of a sweep for a table, and the number of designs that end in each way."""

    def __init__(self, sweep: Sweep, most: int) -> None:
        self.sweep, self.most = sweep, most
        self.kept: list[Block] = []
        self.count = self.rows = 0
        self.ends: Counter[str] = Counter()

    def write(self, block: Block) -> None:
        """Takes a block."""
        status = block["status"]
        self.rows += len(status)
        self.ends.update(status.tolist())
        possible = np.flatnonzero(status != IMPOSSIBLE)[: self.most - self.count]
        if possible.size:
            self.kept.append(chosen(block, possible))
            self.count += len(possible)

    def close(self) -> None:
        """Nothing follows."""

    def show(self, printer: Printer, files: list[str]) -> None:
        """Prints them."""
        sweep = self.sweep
        printer.text(sweep.chute.spec.title or sweep.chute.source)
        printer.text(f"{sweep.chute.source}: {_designs(sweep.count)}, {self._kept_text()}")
        printer.text()
        if self.count:
            printer.table(self._table(printer.units))
            printer.text()
        for line in self._notes(files):
            printer.text(line)

    def _kept_text(self) -> str:
        """What is varied, and how."""
        sweep = self.sweep
        lists = [f"{parameter.name} ({len(parameter.values):,})" for parameter in sweep.parameters]
        how = f", {sweep.keep} kept" if sweep.kept.names else ""
        top = (
            sweep.top and f", the {sweep.top.rows} of {'largest' if sweep.top.largest else 'least'} {sweep.top.column}"
        )
        return (" with " if sweep.parallel else " by ").join(lists) + how + (top or "")

    def _table(self, units: str) -> Grid:
        """The rows."""
        table = Grid()
        block = joined(self.kept)
        shown = {name: column_of(self.sweep, name) for name in self.sweep.header}
        for name, column in shown.items():
            unit = UNIT_TEXT.get(column.unit, column.unit) if column.meaning == VARIED else column.unit_text(units)
            table.column(f"{column.heading}\n{unit}", to_left=name in TEXT)
        cells = [_texts(column, block[name], units) for name, column in shown.items()]
        for row in zip(*cells, strict=True):
            table.row(row)
        return table

    def _notes(self, files: list[str]) -> Iterator[str]:
        """How the designs end, and what is not shown."""
        impossible = self.ends[IMPOSSIBLE]
        if not (self.sweep.profiles or self.sweep.top):
            yield f"{_designs(self.rows)}: " + ", ".join(f"{number:,} {end}" for end, number in self.ends.most_common())
        if impossible:
            yield f"left out: {impossible:,} impossible, whose section or chute cannot be"
        rest = self.rows - impossible - self.count
        if rest:
            where = f"all are in {', '.join(files)}" if files else "--csv or --parquet writes all, --top picks the best"
            yield f"{rest:,} more rows are not shown: {where}"


def _designs(count: int) -> str:
    return f"{count:,} design" + ("" if count == 1 else "s")


def _texts(column: Column, values: Any, units: str) -> list[str]:
    """A column's cells."""
    if values.dtype.kind != "f":
        return [str(value).replace("_", " ") if column.name == "status" else str(value) for value in values.tolist()]
    if column.meaning == VARIED:
        return [f"{value:.6g}" for value in values.tolist()]
    if column.name == "error_estimate":
        return ["" if value != value else f"{value:.0e}" for value in values.tolist()]
    return [column.shown(value, units) for value in values.tolist()]
