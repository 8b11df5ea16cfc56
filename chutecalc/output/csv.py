"""Tables as CSV: RFC 4180, names with units, full double precision, empty where a quantity does not exist."""

import csv
from collections.abc import Iterable, Mapping
from typing import IO, Any

import numpy as np

from chutecalc.results.columns import COLUMNS


def write_stations(stream: IO[str], tables: Iterable[tuple[str, dict[str, Any]]]) -> None:
    """Writes the stations of chutes, one after the other.

    Args:
        stream: to write to.
        tables: name of the spec and what :meth:`chutecalc.Solution.stations` gives, for one design each. Stations that
            the stream did not reach are left out.
    """
    writer = csv.writer(stream)
    writer.writerow(COLUMNS)
    for spec, table in tables:
        reached = np.isfinite(table["s_m"][0])
        columns = [cells(table[name][0][reached]) for name in COLUMNS if name != "spec"]
        writer.writerows((spec, *row) for row in zip(*columns, strict=True))


def write_columns(stream: IO[str], columns: Mapping[str, Any]) -> None:
    """Writes arrays of one length as columns under their names."""
    writer = csv.writer(stream)
    writer.writerow(columns)
    writer.writerows(zip(*map(cells, columns.values()), strict=True))


def cells(values: Any) -> list[Any]:
    """A column as CSV writes it; Python's own text of a float is the shortest that reads back as the same number."""
    if values.dtype.kind != "f":
        return list(values.tolist())
    return ["" if value != value else value for value in values.tolist()]
