"""Tables of what there is: columns, limits, and the names that sweeps make of columns."""

from collections.abc import Iterable, Sequence

from chutecalc.output.grid import Grid
from chutecalc.results.columns import COLUMNS
from chutecalc.spec.limits import LIMITS


def catalogue(headings: Sequence[str], rows: Iterable[Iterable[str]]) -> Grid:
    """Return a table whose first column says what a row is, and whose last one explains it.

    Args:
        headings: of the columns.
        rows: their cells.
    """
    table = Grid()
    for number, heading in enumerate(headings):
        table.column(heading, left=True, label=number == 0, words=number == len(headings) - 1)
    for row in rows:
        table.row(row)
    return table


def columns_table() -> Grid:
    """Return a row for each column along a stream: its name, unit, symbol and meaning.

    >>> columns_table().rows[8]
    ('velocity_m_s', 'm/s', 'v', 'mean velocity of the stream')
    """
    rows = ((column.name, column.unit_text("metric"), column.symbol, column.meaning) for column in COLUMNS.values())
    return catalogue(("name", "unit", "symbol", "meaning"), rows)


def limits_table() -> Grid:
    """Return a row for each limit: its key, default, finding, source and meaning.

    >>> limits_table().rows[0][:4]
    ('max_impact_angle_deg', '20°', 'steep_impact', 'rule of thumb')
    """
    rows = ((limit.key, limit.text, limit.finding, limit.source, limit.meaning) for limit in LIMITS.values())
    return catalogue(("key", "default", "finding", "source", "meaning"), rows)
