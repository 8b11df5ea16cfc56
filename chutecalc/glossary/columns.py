"""Columns of tables and files, explained."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from chutecalc.dem.columns import DEM_COLUMNS
from chutecalc.glossary.entry import Entry, facts, listed
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column, Units
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding_columns import ALL_COLUMNS, FINDING_COLUMNS
from chutecalc.results.findings import CRITERIA
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.loads import LOAD_COLUMNS
from chutecalc.results.segment_columns import segment_columns
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.sweep.columns import PREFIXES, row_columns

ROW_PREFIXES = ("exit_", "max_impact_", "max_", "min_", "receiver_")
"""First words of the columns of a sweep that are made from other columns."""
CATALOGUES: dict[str, Mapping[str, Column]] = {
    "columns along the stream": COLUMNS,
    "columns that only findings read": FINDING_COLUMNS,
    "columns of the receiving belt": RECEIVER_COLUMNS,
    "numbers of an impact": IMPACT_COLUMNS,
    "loads of a segment": LOAD_COLUMNS,
    "columns of a sweep": {name: one for name, one in row_columns().items() if not name.startswith(ROW_PREFIXES)},
    "columns of the friction study": FRICTION_COLUMNS,
    "columns of the discrete-element check": DEM_COLUMNS,
}
"""Every catalogue of columns, by the name of its table."""
OF_SWEEPS, OF_SEGMENTS = "columns made for sweeps", "columns of a segment"


def column_entries() -> Iterator[Entry]:
    """Yield an entry for each column, and for those that sweeps and segments make from them."""
    for group, catalogue in CATALOGUES.items():
        for column in catalogue.values():
            yield _entry(group, column, column.meaning)
    for name, column in row_columns().items():
        prefix = next((each for each in ROW_PREFIXES if name.startswith(each)), "")
        if prefix:
            yield _entry(OF_SWEEPS, column, _made(name, prefix, column))
    for name, column in segment_columns().items():
        if name not in LOAD_COLUMNS:
            yield _entry(OF_SEGMENTS, replace(column, name=name), column.meaning)


def _made(name: str, prefix: str, column: Column) -> str:
    """Return the meaning of a column of a sweep that is made from another."""
    if prefix == "receiver_":
        return column.meaning
    own = name.removeprefix(prefix)
    of = IMPACT_COLUMNS[own] if prefix == "max_impact_" else COLUMNS[own]
    return f"{of.meaning}: {PREFIXES.get(prefix[:-1], column.meaning)}"


def _entry(group: str, column: Column, meaning: str) -> Entry:
    """Return the entry of a column."""
    metric, us = column.unit_text(Units.METRIC), column.unit_text(Units.US)
    in_segments = group in (OF_SEGMENTS, "loads of a segment")
    read_by = [each.code for each in CRITERIA if column.name in {name for name, _ in each.needs}]
    known = facts(
        name=column.words,
        symbol=column.symbol,
        unit=f"{metric} ({us} with --units us)" if us != metric else metric,
        formula=column.equation,
        source=column.source,
        in_sweeps=f"segments.SEGMENT.{column.name}" if in_segments else "",
        read_by=listed(read_by) if column in ALL_COLUMNS.values() else "",
        docs=f"docs/physics.md#{column.page}" if column.page else "docs/nomenclature.md#columns",
    )
    places = ("segments",) if in_segments else ()
    return Entry(group, column.name, meaning, known, places, derived=group in (OF_SEGMENTS, OF_SWEEPS))
