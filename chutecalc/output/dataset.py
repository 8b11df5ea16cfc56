"""The one thing that commands hand over to output formats: rows in blocks and, where there is one, a document."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from chutecalc import __version__
from chutecalc.results.column import Column

Block = dict[str, Any]
"""Some rows: arrays of one length by column name."""
DOCUMENT_FORMAT = 2
"""Version of the layout of JSON documents."""


class Table(NamedTuple):
    """A table beside the rows of a dataset."""

    name: str
    """What it holds, in a word."""
    columns: Mapping[str, type]
    """Type of each column by its heading, in order: ``str``, ``float``, or ``object`` for numbers and text together."""
    block: Block
    """All its rows."""


@dataclass(frozen=True, eq=False)
class Dataset:
    """The results of a command.

    Attributes:
        command: what they are of: the name of the command, or ``friction_study``.
        columns: type of each column by name, in order: ``str``, ``float`` or ``int``.
        blocks: the rows, a block at a time. They are iterated over at most once, and only if a format takes rows.
        asked: what was asked for, the specs among it, for formats that keep it beside the rows.
        name: what the rows are, for formats that name them.
        tables: returns further tables, for formats that hold several.
        document: returns the results as nested mappings and lists, for formats that write those instead of rows.
    """

    command: str
    columns: Mapping[str, type]
    blocks: Iterable[Block]
    asked: Mapping[str, Any] = field(default_factory=dict)
    document: Callable[[], Mapping[str, Any]] | None = None
    name: str = "rows"
    tables: Callable[[], Sequence[Table]] = tuple

    @property
    def head(self) -> dict[str, Any]:
        """The entries that every document begins with."""
        return {"chutecalc": __version__, "format": DOCUMENT_FORMAT, "command": self.command}


def column_types(columns: Iterable[Column]) -> dict[str, type]:
    """Return the types of columns of the catalogue: text where a column has no dimension, else floating-point.

    Args:
        columns: columns of the catalogue.
    """
    return {column.name: float if column.dimension else str for column in columns}


def block_of(rows: Sequence[Mapping[str, Any]], columns: Mapping[str, type]) -> Block:
    """Return rows as a block.

    Args:
        rows: values by column name. A value that is None or left out does not exist: it becomes empty text, NaN or 0.
        columns: types of the columns.

    >>> block_of([{"x_m": 1.5}, {}], {"x_m": float})["x_m"].tolist()
    [1.5, nan]
    """
    import numpy as np  # not before: --help loads this module

    missing = {str: "", float: math.nan, int: 0, object: ""}

    def values(name: str, kind: type) -> list[Any]:
        given = (row.get(name) for row in rows)
        return [missing[kind] if value is None else value for value in given]

    return {name: np.array(values(name, kind), dtype=kind) for name, kind in columns.items()}


def table_of(name: str, rows: Sequence[Mapping[str, Any]], columns: Mapping[str, type]) -> Table:
    """Return rows as a table.

    Args:
        name: what it holds, in a word.
        rows: values by heading, as for :func:`block_of`.
        columns: types of the columns.
    """
    return Table(name, columns, finite_numbers(block_of(rows, columns)))


def finite_numbers(block: Block) -> Block:
    """Return a block as files hold it: NaN for a number that does not exist, infinite ones too; and no zero has a sign.

    Args:
        block: the rows.

    >>> import numpy
    >>> finite_numbers({"x_m": numpy.array([-0.0, -1.0, numpy.inf])})["x_m"].tolist()
    [0.0, -1.0, nan]
    """
    import numpy as np  # not before: --help loads this module

    return {
        name: np.where(np.isfinite(values), values, np.nan) + 0.0 if values.dtype.kind == "f" else values
        for name, values in block.items()
    }


def number(value: float) -> float | None:
    """Return a number as a document holds it: None where it is infinite or does not exist.

    Args:
        value: a number, in any unit.

    >>> number(2), number(-0.0), number(float("nan"))
    (2.0, 0.0, None)
    """
    return float(value) + 0.0 if math.isfinite(value) else None  # + 0: no -0


def numbers(values: Any) -> list[Any]:
    """Return an array as a document holds it: None for numbers that are infinite or do not exist.

    Args:
        values: array of numbers or text, of one dimension.
    """
    if values.dtype.kind != "f":
        return list(values.tolist())
    return [value if math.isfinite(value) else None for value in (values + 0.0).tolist()]  # + 0: no -0


def first(columns: Mapping[str, Any], names: Iterable[str] = ()) -> dict[str, float | None]:
    """Return the numbers of the first design, as a document holds them.

    Args:
        columns: arrays by column name, one entry for each design.
        names: of all columns that there may be: None for those that there are not. Those that there are by default.
    """
    return {name: number(columns[name][0]) if name in columns else None for name in names or columns}
