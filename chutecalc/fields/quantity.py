"""How fields of a spec are declared: a quantity is a number with a dimension, bounds and a key for each unit."""

import re
from math import isfinite
from typing import Any

import numpy as np
from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from chutecalc.fields.plausible import Plausible
from chutecalc.fields.units import convert, first_unit, to_si, with_unit
from chutecalc.physics.arrays import Array

Number = float | Any
"""A number as the user wrote it, or a one-dimensional array of numbers where designs are varied."""


class Quantity:
    """Declares a field as a quantity: ``Annotated[Number, Quantity("length", LONG)]``.

    Args:
        dimension: one of :data:`chutecalc.fields.units.UNITS`.
        plausible: its sizes; every key of a spec has them. They are its limits where no others are given.
        zero: whether it may be 0 too, however small its least size is.
        gt, ge, lt, le: limits, named as in pydantic, in the first unit of the dimension.
        shape: empty for one number, ``(2,)`` for a list of two, ``(None, 2)`` for any count of rows of two.

    Attributes:
        bounds: the limits, by their names.
        least: the least number above 0 of a quantity that may be 0; 0 where that may be any.
    """

    def __init__(
        self,
        dimension: str,
        plausible: Plausible | None = None,
        *,
        zero: bool = False,
        gt: float | None = None,
        ge: float | None = None,
        lt: float | None = None,
        le: float | None = None,
        shape: tuple[int | None, ...] = (),
    ) -> None:
        if plausible is not None:
            if gt is None and ge is None:
                ge = 0.0 if zero else plausible.least
            if lt is None and le is None:
                le = plausible.most
        self.least = plausible.least if zero and plausible is not None else 0.0
        self.dimension, self.shape, self.plausible = dimension, shape, plausible
        self.bounds = {
            name: limit for name, limit in (("gt", gt), ("ge", ge), ("lt", lt), ("le", le)) if limit is not None
        }

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.check)

    def __get_pydantic_json_schema__(self, schema: Any, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {"x-dimension": self.dimension} | self.json_type(first_unit(self.dimension))

    def json_type(self, unit: str) -> dict[str, Any]:
        """Return the JSON Schema of the value in one of the dimension's units.

        Args:
            unit: suffix of the unit, such as ``mm``.

        >>> Quantity("length", gt=0).json_type("mm")
        {'type': 'number', 'exclusiveMinimum': 0.0}
        """
        described: dict[str, Any] = {"type": "number"} | self.json_bounds(unit)
        for count in reversed(self.shape):
            counts = {} if count is None else {"minItems": count, "maxItems": count}
            described = {"type": "array", "items": described} | counts
        return described

    def json_bounds(self, unit: str) -> dict[str, Any]:
        """Return the bounds by JSON Schema's names, in one of the dimension's units.

        Args:
            unit: suffix of the unit.
        """
        names = {"gt": "exclusiveMinimum", "ge": "minimum", "lt": "exclusiveMaximum", "le": "maximum"}
        bounds: dict[str, Any] = {names[name]: limit for name, limit in self.bounds_in(unit).items()}
        gap = {"exclusiveMinimum": 0, "exclusiveMaximum": self.range_in(unit)["ge"]} if self.least else {}
        return bounds | ({"not": gap} if gap else {})

    def bounds_in(self, unit: str) -> dict[str, float]:
        """Return the bounds by pydantic's names, in one of the dimension's units.

        Args:
            unit: suffix of the unit.
        """
        start = first_unit(self.dimension)
        return {name: convert(limit, self.dimension, start, unit) for name, limit in self.bounds.items()}

    def range_in(self, unit: str) -> dict[str, float]:
        """Return the bounds of a number that is not 0, as :meth:`bounds_in` does.

        Args:
            unit: suffix of the unit.
        """
        least = {"ge": convert(self.least, self.dimension, first_unit(self.dimension), unit)} if self.least else {}
        return self.bounds_in(unit) | least

    @property
    def takes_zero(self) -> bool:
        """Whether the number may be 0."""
        low = self.bounds.get("ge", self.bounds.get("gt", -np.inf))
        return bool(low < 0.0 or self.bounds.get("ge") == 0.0)

    def check(self, value: Any) -> Any:
        """Return the value with its numbers as floats; arrays of numbers stay as they are.

        Args:
            value: in the dimension's first unit, of the declared shape.

        Raises:
            PydanticCustomError: It is not of that shape, or a number is not finite or out of bounds.
        """
        return self._checked(value, self.shape)

    def _checked(self, value: Any, shape: tuple[int | None, ...]) -> Any:
        if shape:
            count = shape[0]
            if not isinstance(value, list | tuple) or (count is not None and len(value) != count):
                raise _fault(f"must be {_LISTS[self.shape]}, each", "write them in brackets")
            return [self._checked(item, shape[1:]) for item in value]
        return self.check_number(value)

    def check_number(self, value: Any) -> Any:
        """Return one number as a float, or an array of numbers as it is.

        Args:
            value: in the dimension's first unit.

        Raises:
            PydanticCustomError: It is not a number, not finite, or out of bounds.
        """
        if isinstance(value, np.ndarray):
            if value.ndim != 1 or not value.size or value.dtype.kind not in "fiu":
                raise _fault("must be a number, or a one-dimensional array of numbers, each", "use numbers")
            smallest, largest = float(value.min()), float(value.max())
        elif isinstance(value, bool) or not isinstance(value, int | float | np.number):
            quoted = isinstance(value, str) and re.fullmatch(r"(?a)\s*([+-]?\d+(?:\.\d+)?)\b.*", value)
            raise _fault("must be a number,", f"write {quoted[1]}, the number alone" if quoted else "write a number")
        else:
            try:
                value = smallest = largest = float(value)
            except OverflowError:
                value = smallest = largest = np.inf
        if not (isfinite(smallest) and isfinite(largest)):
            raise _fault("must be finite and", "write a finite number")
        bounds = self.bounds
        low = smallest > bounds.get("gt", -np.inf) and smallest >= bounds.get("ge", -np.inf)
        high = largest < bounds.get("lt", np.inf) and largest <= bounds.get("le", np.inf)
        if not (low and high):
            raise _fault("must be", f"use a {'smaller' if low else 'larger'} value", largest if low else smallest)
        if self.least:
            numbers = np.atleast_1d(value)
            if (tiny := (numbers > 0.0) & (numbers < self.least)).any():
                raise _fault("must be", "use a larger value, or 0", float(numbers[tiny][0]))
        return value

    def bounds_text(self, unit: str) -> str:
        """Return the bounds in words, in one of the dimension's units.

        Args:
            unit: suffix of the unit.

        >>> Quantity("length", gt=0, le=90).bounds_text("mm")
        'greater than 0 mm and at most 90,000 mm'
        >>> Quantity("velocity", Plausible(0.001, 0.01, 40.0, 200.0, "slow", "fast"), zero=True).bounds_text("m_s")
        '0, or at least 0.001 m/s and at most 200 m/s'
        """
        names = {"gt": "greater than", "ge": "at least", "lt": "less than", "le": "at most"}
        words = " and ".join(f"{names[name]} {with_unit(limit, unit)}" for name, limit in self.range_in(unit).items())
        return f"0, or {words}" if self.least else words


def _fault(problem: str, remedy: str, number: float | None = None) -> PydanticCustomError:
    """Return a fault of a quantity, with the number that is out of bounds; they follow in the message."""
    return PydanticCustomError("quantity", problem, {"remedy": remedy, "number": number})


_LISTS = {(2,): "a list of two numbers", (None, 2): "a list of rows of two numbers"}


def in_si(value: Any, dimension: str) -> Array:
    """Return a number of a spec in SI units (angles in rad), as an array of length 1 or n.

    Args:
        value: in the dimension's first unit: a number, an array, or what a tape records in their place.
        dimension: one of :data:`chutecalc.fields.units.UNITS`.

    >>> in_si(3600.0, "mass rate").tolist()  # t/h to kg/s
    [1000.0]
    """
    if type(value) is float:  # most of them, for which NumPy's functions take five times as long
        return np.array([to_si(value, dimension)])
    values = np.multiply(to_si(value, dimension), 1.0)  # an array, also of what only acts like one
    return np.atleast_1d(values)


def optional(value: Any, dimension: str) -> Array | None:
    """Return a number of a spec as :func:`in_si` does, or None where the spec has none.

    Args:
        value: in the dimension's first unit, or None.
        dimension: one of :data:`chutecalc.fields.units.UNITS`.

    >>> optional(None, "length") is None
    True
    """
    return None if value is None else in_si(value, dimension)
