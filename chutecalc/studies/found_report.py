"""Designs that a study has found, as a table for people and as data."""

from typing import Any

from chutecalc.design import Status
from chutecalc.output.dataset import Dataset
from chutecalc.output.grid import Grid
from chutecalc.output.table import heading
from chutecalc.results.column import Column
from chutecalc.results.described import status_words
from chutecalc.studies.found import Found
from chutecalc.studies.sweep.columns import CODES
from chutecalc.studies.sweep.table import VARIED


def found_table(found: Found, units: str) -> Grid:
    """Return a row for each design in each state.

    Args:
        found: the designs.
        units: ``metric`` or ``us``; a varied quantity stays in the unit in which it was given.
    """
    table, block = Grid(), found.rows()
    single = {"solution": found.count == 1, "state": len(found.states) == 1}
    shown = [name for name in block if not single.get(name)]
    for name in shown:
        column = found.columns.get(name)
        label = column is None or column.meaning == VARIED or name == "status"
        is_text = block[name].dtype.kind != "f"
        text = name if column is None else heading(column, units)
        table.column(text, left=is_text, label=label, words=name in CODES)
    cells = [[cell_text(found.columns.get(name), value, units) for value in block[name].tolist()] for name in shown]
    for row in zip(*cells, strict=True):
        table.row(row)
    return table


def cell_text(column: Column | None, value: Any, units: str) -> str:
    """Return a value as people read it.

    Args:
        column: its column; None for the number of a solution or the name of a state.
        value: the number or text.
        units: ``metric`` or ``us``.
    """
    if isinstance(value, str):
        return outcome_text(value)
    return f"{value:z.6g}" if column is None or column.meaning == VARIED else column.shown(value, units)


def outcome_text(text: str) -> str:
    """Return a text of an outcome as people read it: statuses without underscores.

    Args:
        text: a status, or any other text.
    """
    return status_words(text) if text in (*Status.LABELS, Status.IMPOSSIBLE_LABEL) else text


def found_dataset(command: str, found: Found) -> Dataset:
    """Return designs as a dataset: a row for each in each state, and a document of solutions and their outcome.

    Args:
        command: that found them.
        found: the designs.
    """
    block = found.rows()
    columns = {name: float if values.dtype.kind == "f" else str for name, values in block.items()}
    asked = {"source": found.chute.source, "spec": found.chute.data, "keys": _keys(found)}
    return Dataset(command, columns, [block], asked, lambda: asked | found.document())


def _keys(found: Found) -> dict[str, Any]:
    """Return the bounds or choices of each key, by name."""
    return {
        key.name: {
            "paths": key.parameter.paths,
            "bounds": values if key.is_continuous else None,
            "choices": None if key.is_continuous else values,
        }
        for key in found.keys
        for values in [key.parameter.values.tolist()]
    }
