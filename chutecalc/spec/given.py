"""The quantities that a spec gives, with their keys and numbers as written."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import convert, first_unit, unit_keys
from chutecalc.physics.arrays import Array


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


def given_quantities(table: Table, data: Any, path: str = "") -> Iterator[Given]:
    """Yield the quantities of a table and of the tables in it that are given, in the order of its keys.

    Args:
        table: a checked table.
        data: the same as written.
        path: of the table, with a dot behind, or empty.

    >>> from chutecalc.spec.chute_spec import Flow
    >>> [(one.path, one.unit, one.written) for one in given_quantities(Flow(rate_kg_s=250.0), {"rate_kg_s": 250.0})]
    [('rate_kg_s', 'kg_s', 250.0)]
    """
    for name in type(table).model_fields:
        if name not in table.model_fields_set:
            continue
        quantity = table.quantities().get(name)
        if quantity is not None:
            key, unit = next(item for item in unit_keys(name, quantity.dimension).items() if item[0] in data)
            yield Given(f"{path}{key}", name, unit, quantity, data[key])
            continue
        below = getattr(table, name)
        entries: Any = [("", below)]
        if isinstance(below, dict):
            entries = below.items()
        elif isinstance(below, list):
            entries = enumerate(below)
        for item, entry in entries:
            if isinstance(entry, Table):
                inner, step = (data[name], "") if item == "" else (data[name][item], f"{_step(item)}.")
                yield from given_quantities(entry, inner, f"{path}{name}.{step}")


def _step(item: Any) -> str:
    """Return a part of a path: a name, or the number of a list item from 1."""
    return str(item + 1) if isinstance(item, int) else str(item)


def _flat(written: Any) -> Iterator[Any]:
    """Yield the numbers in nested lists."""
    if isinstance(written, list | tuple):
        for item in written:
            yield from _flat(item)
    else:
        yield written
