"""A number of a checked spec that a function varies: where it stands, its unit and its limits."""

import math
import operator
from collections.abc import Iterable, Sequence
from reprlib import repr as short
from typing import Any, NamedTuple

from chutecalc.api.tape import Traced
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import convert, first_unit
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.paths import is_number
from chutecalc.spec.segment_names import segment_names

Limits = tuple[float, float]
"""Least and greatest value."""
COMPARISONS = {"gt": operator.gt, "ge": operator.ge, "lt": operator.lt, "le": operator.le}
"""The comparison that each bound of a quantity stands for."""


class Parameter(NamedTuple):
    """A number of a spec that is varied."""

    path: str
    """Key path, as given."""
    table: Table
    """Table of the checked spec that it stands in."""
    key: str
    """Documented key in that table."""
    indices: tuple[int, ...]
    """Indices from 0 in the lists that the key holds; empty for a single number."""
    unit: str
    """Suffix of the unit of the path."""
    limits: Limits | None
    """Limits in the unit of the path; None for the bounds of the spec alone."""

    @property
    def quantity(self) -> Quantity:
        """Declaration of the quantity: its dimension and bounds."""
        return self.table.quantities()[self.key]

    @property
    def value(self) -> Any:
        """Value in the dimension's first unit, as the spec has it."""
        value = getattr(self.table, self.key)
        for index in self.indices:
            value = value[index]
        return value

    @property
    def value_in_unit(self) -> float:
        """Value in the unit of the path."""
        return float(convert(self.value, self.quantity.dimension, first_unit(self.quantity.dimension), self.unit))

    def set_value(self, value: Any) -> None:
        """Put a value into the spec.

        Args:
            value: in the dimension's first unit.
        """
        if not self.indices:
            self.table.__dict__[self.key] = value  # a model is frozen against everybody else
            return
        rows = getattr(self.table, self.key)
        for index in self.indices[:-1]:
            rows = rows[index]
        rows[self.indices[-1]] = value

    def to_first_unit(self, value: Any) -> Any:
        """Convert a value from the unit of the path to the dimension's first unit.

        Args:
            value: a number, an array, or a :class:`~chutecalc.api.tape.Traced`.
        """
        return convert(value, self.quantity.dimension, self.unit, first_unit(self.quantity.dimension))

    @property
    def bounds(self) -> Limits:
        """Limits in the unit of the path; infinite if there are none."""
        return self.limits or (-math.inf, math.inf)

    def is_within(self, value: Any) -> Any:
        """Return whether a number is within the limits, or the mask of an array's numbers that are.

        Args:
            value: in the unit of the path.
        """
        low, high = self.bounds
        return (value >= low) & (value <= high)

    def accepts(self, value: Traced) -> bool:
        """Return whether a value keeps the bounds of its quantity and the rules of its table; its tape records that.

        Args:
            value: in the dimension's first unit.
        """
        table = {key: item for key, item in self.table.__dict__.items() if item is not None}
        table |= {} if self.indices else {self.key: value}
        finite = bool(value - value == 0.0)
        bounded = [bool(COMPARISONS[name](value, limit)) for name, limit in self.quantity.bounds.items()]
        bounded += [bool(value == 0.0) or bool(value >= self.quantity.least)] if self.quantity.least else []
        return finite and all(bounded) and not any(True for rule in self.table.rules for _ in rule(table))


def check_names(given: Any, what: str) -> tuple[str, ...]:
    """Return names as a tuple.

    Args:
        given: a list of names, or a mapping that has them as keys.
        what: the names are, for the message.

    Raises:
        UsageError: It is empty, a single text, or not all of it is text.

    >>> check_names(["flow.rate_t_h"], "parameters")
    ('flow.rate_t_h',)
    """
    names = () if isinstance(given, str) or not isinstance(given, Iterable) else tuple(given)
    if not names or not all(isinstance(name, str) for name in names):
        raise UsageError(f"{what} must be a list of names, not {short(given)}")
    return names


def check_distinct(parameters: Sequence[Parameter]) -> None:
    """Check that no number of a spec is varied twice.

    Args:
        parameters: of one spec.

    Raises:
        SpecError: Several parameters are the same number.
    """
    seen: dict[tuple[int, str, tuple[int, ...]], str] = {}
    faults = []
    for each in parameters:
        quantity = id(each.table), each.key, each.indices
        if quantity in seen:
            faults.append(
                Fault(each.path, f"is given twice, as {seen[quantity]} and as {each.path}", "keep one of them")
            )
        seen.setdefault(quantity, each.path)
    if faults:
        raise SpecError(faults)


def parameter_at(spec: ChuteSpec, path: str, limits: Limits | None) -> Parameter:
    """Return the number at a key path of a checked spec.

    Args:
        spec: to be varied.
        path: key path, in any unit, with names or numbers of list items.
        limits: in the unit of the path, or None.

    Raises:
        SpecError: There is no number at the path.
        UsageError: The limits are not two numbers, the lower one first.
    """
    try:
        wrong = limits is not None and not float(limits[0]) <= float(limits[1])
    except (TypeError, ValueError, LookupError, OverflowError):
        wrong = True
    if wrong:
        raise UsageError(f"limits of {path} must be two numbers, the lower one first, not {short(limits)}")
    here: Any = spec
    parts = path.split(".")
    try:
        for number, part in enumerate(parts):
            if isinstance(here, Table):
                name, unit = here.keys()[part]
                if name in type(here).quantities():
                    indices = tuple(map(_index, parts[number + 1 :]))
                    found = Parameter(path, here, name, indices, unit, limits)
                    listed = not indices or unit == first_unit(found.quantity.dimension)  # as changes take it
                    if isinstance(found.value, float | int) and listed:
                        return found
                    break
                part = name
            here = _below(here, part)
    except (KeyError, IndexError, AttributeError, ValueError, TypeError):
        pass
    raise SpecError(
        [
            Fault(
                path,
                "is not a number in the spec",
                "use the path of a number that it has, or add this one to the spec first",
            )
        ]
    )


def _index(part: str) -> int:
    """Return the index from 0 of a list item, from its number in a path."""
    if not is_number(part) or int(part) == 0:
        raise IndexError("they are counted from 1")
    return int(part) - 1


def _below(here: Any, part: str) -> Any:
    if isinstance(here, dict):
        return here[part]
    if isinstance(here, list):
        if not is_number(part):
            return here[segment_names([(item.name, item.kind) for item in here]).index(part)]
        return here[_index(part)]
    return getattr(here, part)
