"""A number of a checked spec that is to be varied: where it stands, its unit, its bounds."""

import math
import operator
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from chutecalc.api.tape import Traced
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import convert, first_unit
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.paths import is_number

Limits = tuple[float, float]
COMPARISONS = {"gt": operator.gt, "ge": operator.ge, "lt": operator.lt, "le": operator.le}
"""How a quantity's bounds are asked for."""


class Parameter(NamedTuple):
    """A number of the spec that is varied."""

    path: str
    table: Table
    """That it stands in, with its documented key and, of a list, the indices in it."""
    key: str
    indices: tuple[int, ...]
    unit: str
    limits: Limits | None

    @property
    def quantity(self) -> Quantity:
        """Its bounds and its dimension."""
        return self.table.quantities()[self.key]

    @property
    def value(self) -> Any:
        """In the dimension's first unit, as the spec has it."""
        value = getattr(self.table, self.key)
        for index in self.indices:
            value = value[index]
        return value

    @property
    def value_in_unit(self) -> float:
        """In the unit of its path."""
        return float(convert(self.value, self.quantity.dimension, first_unit(self.quantity.dimension), self.unit))

    def set_value(self, value: Any) -> None:
        """Has the spec say so."""
        if not self.indices:
            self.table.__dict__[self.key] = value  # a model is frozen against everybody else
            return
        rows = getattr(self.table, self.key)
        for index in self.indices[:-1]:
            rows = rows[index]
        rows[self.indices[-1]] = value

    def to_first_unit(self, value: Any) -> Any:
        """To the dimension's first unit."""
        return convert(value, self.quantity.dimension, self.unit, first_unit(self.quantity.dimension))

    @property
    def bounds(self) -> Limits:
        """The limits, infinite where none were asked for."""
        return self.limits or (-math.inf, math.inf)

    def is_within(self, value: Any) -> Any:
        """Whether a number is within them, or which of several are."""
        low, high = self.bounds
        return (value >= low) & (value <= high)

    def accepts(self, value: Traced) -> bool:
        """Whether the spec's bounds, and the rules of its table, let a converted value be; asked on its tape."""
        table = {key: item for key, item in self.table.__dict__.items() if item is not None}
        table |= {} if self.indices else {self.key: value}
        finite = bool(value - value == 0.0)
        bounded = [bool(COMPARISONS[name](value, limit)) for name, limit in self.quantity.bounds.items()]
        return finite and all(bounded) and not any(True for rule in self.table.rules for _ in rule(table))


def check_names(given: Any, what: str) -> tuple[str, ...]:
    """Names that somebody asks for.

    Raises:
        UsageError: they are none.
    """
    names = () if isinstance(given, str) or not isinstance(given, Iterable) else tuple(given)
    if not names or not all(isinstance(name, str) for name in names):
        raise UsageError(f"{what} has to be a list of names, not {given!r}")
    return names


def check_distinct(parameters: Sequence[Parameter]) -> None:
    """That no number is given twice.

    Raises:
        SpecError: some are.
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
    """Where a path leads in a checked spec.

    Raises:
        SpecError: to no number.
        UsageError: limits that are none.
    """
    try:
        wrong = limits is not None and not float(limits[0]) <= float(limits[1])
    except (TypeError, ValueError, IndexError):
        wrong = True
    if wrong:
        raise UsageError(f"limits of {path} have to be two numbers, the lower one first, not {limits!r}")
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
    except (KeyError, IndexError, AttributeError, ValueError, TypeError, StopIteration):
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
    """Where in a list a number of a path leads."""
    if not is_number(part) or int(part) == 0:
        raise IndexError("they are counted from 1")
    return int(part) - 1


def _below(here: Any, part: str) -> Any:
    if isinstance(here, dict):
        return here[part]
    if isinstance(here, list):
        if not is_number(part):
            return next(item for item in here if item.name == part)
        return here[_index(part)]
    return getattr(here, part)
