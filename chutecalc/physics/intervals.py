"""Tables of intervals, a row each and a column a design: facets of a section, pieces of a wall's friction."""

import numpy as np

from chutecalc.physics.arrays import Array, Index


def interval_of(starts: Array, value: Array) -> Index:
    """The interval in which a value lies, 0 for the first.

    Args:
        starts: where each begins, rising, shape (intervals, designs) or (intervals, stations, designs).
        value: of the shape of one row, or (stations, designs).

    Returns:
        Numbers of intervals, in the broadcast shape. A value where one begins counts to that one, and so no empty
        interval is ever told.

    >>> interval_of(np.array([[0.0], [1.0], [1.0], [2.0]]), np.array([0.5, 1.0, 3.0]))
    array([0, 2, 3])
    """
    numbers: Index = (value >= with_axes(starts[1:], np.ndim(value))).sum(axis=0)
    return numbers


def take_row(field: Array, rows: Index) -> Array:
    """Entries ``field[rows[i], ..., i]``; what one row or one column holds for all is broadcast."""
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
    """A table with room for as many axes as each of its rows is to have."""
    lacking = dimensions - (field.ndim - 1)
    return field if lacking <= 0 else field.reshape(len(field), *[1] * lacking, *field.shape[1:])
