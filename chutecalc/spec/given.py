"""The quantities that a spec gives, with their keys and numbers as written."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import convert, first_unit, unit_keys
from chutecalc.physics.arrays import Array
from chutecalc.spec.inputs import given_keys


class Given(NamedTuple):
    """A quantity that a spec gives."""

    path: str
    """Path of its key, as written."""
    key: str
    """The documented key, which ends in the first unit of its dimension."""
    unit: str
    """Unit in which it is given."""
    quantity: Quantity
    written: Any
    """Number or numbers in that unit: one, lists of them, or arrays of shape (designs,) in their places."""

    def numbers(self) -> Array:
        """Return the numbers in the unit in which they are given, shape (numbers, designs)."""
        return np.stack(np.broadcast_arrays(*(np.atleast_1d(one) for one in _flat(self.written))))

    def in_first_unit(self, numbers: Array, unit: str) -> Array:
        """Return numbers in the first unit of the dimension, as if they were given in some unit.

        Args:
            numbers: of any shape, in that unit.
            unit: one of the dimension's.
        """
        dimension = self.quantity.dimension
        converted: Array = convert(numbers, dimension, unit, first_unit(dimension))
        return converted

    @property
    def keys(self) -> dict[str, str]:
        """Unit to the key in that unit, for all units of the dimension."""
        return {unit: key for key, unit in unit_keys(self.key, self.quantity.dimension).items()}


def given_quantities(table: Table, data: Mapping[str, Any]) -> Iterator[Given]:
    """Yield the quantities of a table and of the tables in it that are given, in the order in which they are written.

    Args:
        table: a checked table.
        data: the same as written.

    >>> from chutecalc.spec.chute_spec import Flow
    >>> [(one.path, one.unit, one.written) for one in given_quantities(Flow(rate_kg_s=250.0), {"rate_kg_s": 250.0})]
    [('rate_kg_s', 'kg_s', 250.0)]
    """
    for key in given_keys(table, data):
        if key.quantity is not None:
            path = ".".join(str(item + 1) if isinstance(item, int) else item for item in key.location)
            yield Given(path, key.name, key.unit, key.quantity, key.written)


def _flat(written: Any) -> Iterator[Any]:
    """Yield the numbers in nested lists."""
    if isinstance(written, list | tuple):
        for item in written:
            yield from _flat(item)
    else:
        yield written
