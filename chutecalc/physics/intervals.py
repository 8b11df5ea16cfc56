"""Tables with a row for each interval and a column for each design: facets of a section, pieces of a yield locus."""

import numpy as np

from chutecalc.physics.arrays import Array, Index


def interval_of(starts: Array, value: Array) -> Index:
    """Find the interval in which a value lies.

    Args:
        starts: Lower ends of the intervals, rising, any unit, shape (intervals, designs) or
            (intervals, stations, designs).
        value: Values in the same unit, of the shape of one row, or (stations, designs).

    Returns:
        Row numbers from 0, in the broadcast shape. A value at the start of an interval lies in that one, so that an
        empty interval is never returned.

    >>> interval_of(np.array([[0.0], [1.0], [1.0], [2.0]]), np.array([0.5, 1.0, 3.0]))
    array([0, 2, 3])
    """
    numbers: Index = (value >= with_axes(starts[1:], np.ndim(value))).sum(axis=0)
    return numbers


def take_row(field: Array, rows: Index) -> Array:
    """Take the entry of each design's own row, ``field[rows[i], ..., i]``.

    Args:
        field: Table in any unit, shape (intervals, designs) or (intervals, stations, designs). One row or one column
            that holds for all is broadcast.
        rows: Row numbers, shape (designs,) or (stations, designs).

    Returns:
        The entries, in the broadcast shape of a row and ``rows``.

    >>> take_row(np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([1, 0]))
    array([3., 2.])
    """
    if len(field) == 1:
        only: Array = field[0]
        return only
    if rows.ndim == 1 and field.ndim == 2:
        return np.atleast_1d(field[rows, np.arange(len(rows)) if field.shape[1] != 1 else 0])
    field = with_axes(field, rows.ndim)
    wide = np.broadcast_to(field, (len(field), *np.broadcast_shapes(field.shape[1:], rows.shape)))
    taken: Array = np.take_along_axis(wide, np.broadcast_to(rows, wide.shape[1:])[None], axis=0)[0]
    return taken


def with_axes(field: Array, dimensions: int) -> Array:
    """Insert axes behind the first one until each row of a table has so many.

    Args:
        field: Table in any unit, a row for each interval.
        dimensions: Axes that each row must have.

    Returns:
        A view of the table.

    >>> with_axes(np.zeros((4, 3)), 2).shape
    (4, 1, 3)
    """
    lacking = dimensions - (field.ndim - 1)
    return field if lacking <= 0 else field.reshape(len(field), *[1] * lacking, *field.shape[1:])
