"""Named tuples whose arrays have designs along their last axis, of length 1 or n."""

from typing import Any, TypeVar

import numpy as np

from chutecalc.physics.arrays import Index

Record = TypeVar("Record", bound=tuple[Any, ...])
"""A named tuple whose fields are arrays, such tuples, or values that all designs share."""


def stretched(array: Any, shape: tuple[int, ...]) -> Any:
    """Return an array broadcast to a shape; the array itself if it has that shape, as NumPy is slow even then.

    Args:
        array: any NumPy array.
        shape: of the result.
    """
    return array if array.shape == shape else np.broadcast_to(array, shape)


def select(record: Record, rows: Index | slice) -> Record:
    """Return the record of some of the designs; values that all designs share stay as they are.

    Args:
        record: named tuple whose arrays have designs along their last axis, of length 1 or n.
        rows: numbers of the designs from 0; a slice is faster for neighbours.
    """
    chosen: list[Any] = []
    for field in record:
        if isinstance(field, np.ndarray):
            if field.shape[-1] != 1:
                field = field[..., rows] if isinstance(rows, slice) else field.take(rows, axis=-1)
        elif isinstance(field, tuple) and field:
            field = select(field, rows)
        chosen.append(field)
    return type(record)(*chosen) if hasattr(record, "_fields") else type(record)(chosen)


def length(record: tuple[Any, ...]) -> int:
    """Return how many designs a record describes.

    Args:
        record: named tuple whose arrays have designs along their last axis, of length 1 or n.
    """
    longest = 1
    for field in record:
        if isinstance(field, np.ndarray):
            longest = max(longest, field.shape[-1])
        elif isinstance(field, tuple) and field:
            longest = max(longest, length(field))
    return longest
