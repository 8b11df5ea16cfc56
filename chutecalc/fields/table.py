"""The base class of a spec's tables: units by suffix, no unknown keys, rules between keys, faults in plain words."""

import math
from collections.abc import Callable, Iterator
from functools import cache
from sys import float_info
from typing import Any, ClassVar, NamedTuple, get_args, get_origin

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.units import convert, first_unit, unit_keys
from chutecalc.fields.wording import EXPECTED, NOT_VARIED, TABLE, Unknown, as_added, meant, out_of_bounds, unknown_key

MAX = float_info.max


def _converted(value: Any, dimension: str, unit: str) -> Any:
    """Return numbers, also in lists, in the dimension's first unit; anything else stays for the check to find."""
    if isinstance(value, list | tuple):
        return [_converted(item, dimension, unit) for item in value]
    number = isinstance(value, int | float | np.number | np.ndarray) and not isinstance(value, bool)
    if number and isinstance(value, int) and abs(value) > MAX:
        value = math.copysign(math.inf, value > 0 or -1)  # an integer of TOML may be too large to compute with
    return convert(value, dimension, unit, first_unit(dimension)) if number else value


class Violation(NamedTuple):
    """A rule that a table breaks: the location within the table, what is wrong, and what to do."""

    location: tuple[str | int, ...]
    problem: str
    remedy: str
    is_missing: bool = False
    """Whether a key is missing. That is no news where the key is there, misspelt or without its unit."""


Rules = tuple[Callable[[dict[str, Any]], Iterator[Violation]], ...]


class Table(BaseModel):
    """A table of a spec.

    Every quantity may be given in any unit of its dimension, by the ending of its key. Unknown keys and broken rules
    are faults, each with a problem and a remedy in plain words.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, arbitrary_types_allowed=True, defer_build=True)

    rules: ClassVar[Rules] = ()
    """Functions that yield what is broken in a table, which they get with documented keys alone."""
    choices: ClassVar[dict[str, tuple[str, ...]]] = {}
    """Key that tells variants of the tables below apart, ``kind`` or ``shape``, to its known values."""
    hints: ClassVar[dict[str, str]] = {}
    """Value that such a key does not know, to what to do."""

    @classmethod
    @cache
    def quantities(cls) -> dict[str, Quantity]:
        """Return the fields that are quantities, by their documented keys."""
        return {
            name: item
            for name, field in cls.model_fields.items()
            for item in field.metadata
            if isinstance(item, Quantity)
        }

    @classmethod
    @cache
    def keys(cls) -> dict[str, tuple[str, str]]:
        """Return every key that the table takes, with its documented key and the suffix of its unit."""
        known: dict[str, tuple[str, str]] = {}
        for name in cls.model_fields:
            quantity = cls.quantities().get(name)
            units = unit_keys(name, quantity.dimension) if quantity else {name: ""}
            known |= {key: (name, unit) for key, unit in units.items()}
        return known

    @model_validator(mode="wrap")
    @classmethod
    def _check(cls, data: Any, handler: Any) -> Any:
        if not isinstance(data, dict):
            return handler(data)
        broken: list[Violation] = []
        table, written, meant = cls._in_first_units(data, broken)
        for rule in cls.rules:
            broken += [item for item in rule(table) if not (item.location[0] in meant and item.is_missing)]
        details = [
            _detail((written.get(str(location[0]), location[0]), *location[1:]), problem, remedy)
            for location, problem, remedy, _ in broken
        ]
        try:
            model = handler(table)
        except ValidationError as error:
            own = error.errors(include_url=False)
            details += [cls._worded(item, written) for item in own if not cls._explained(item, meant)]
        if details:
            raise ValidationError.from_exception_data(cls.__name__, details)
        return model

    @classmethod
    def _in_first_units(
        cls, data: dict[str, Any], broken: list[Violation]
    ) -> tuple[dict[str, Any], dict[str, str], set[str]]:
        """Return the table with documented keys and first units, those keys as written, and keys that have a fault."""
        table: dict[str, Any] = {}
        written: dict[str, str] = {}
        meant: set[str] = set()
        known = cls.keys()
        for key, value in data.items():
            if key not in known:
                unknown = cls._unknown(str(key))
                broken.append(Violation((key,), unknown.problem, unknown.remedy))
                meant.add(unknown.meant)
                continue
            name, unit = known[key]
            if name in written:
                broken.append(Violation((key,), f"is given twice, as {written[name]} and as {key}", "keep one of them"))
                continue
            written[name] = key
            quantity = cls.quantities().get(name)
            if quantity is None and isinstance(value, np.ndarray):
                broken.append(Violation((key,), *NOT_VARIED))
                meant.add(name)
                continue
            table[name] = _converted(value, quantity.dimension, unit) if quantity else value
        return table, written, meant

    @classmethod
    def _unknown(cls, key: str) -> Unknown:
        """Return the fault of an unknown key."""
        return unknown_key(key, cls.keys(), cls.quantities(), list(cls.model_fields), cls._below())

    @classmethod
    @cache
    def _below(cls) -> dict[str, dict[str, tuple[str, str]]]:
        """Return the keys of the tables in it, by name of the table."""
        return {
            name: kind.keys()
            for name, field in cls.model_fields.items()
            if get_origin(field.annotation) not in (dict, list)
            for kind in (field.annotation, *get_args(field.annotation))
            if isinstance(kind, type) and issubclass(kind, Table)
        }

    @classmethod
    def _explained(cls, item: Any, meant: set[str]) -> bool:
        """Return whether a missing key has a fault already: it is given without its unit, or misspelt."""
        return item["type"] == "missing" and len(item["loc"]) == 1 and item["loc"][0] in meant

    @classmethod
    def _worded(cls, item: Any, written: dict[str, str]) -> InitErrorDetails:
        """Return one of pydantic's errors in plain words; those of tables below are in plain words already."""
        location, kind = tuple(item["loc"]), item["type"]
        if kind == "fault":
            return _detail(location, item["msg"], item["ctx"]["remedy"])
        name = location[0] if len(location) == 1 else ""
        quantity = cls.quantities().get(str(name))
        if kind == "missing":
            names = (
                list(unit_keys(str(name), quantity.dimension))
                if quantity
                else [as_added(str(name), cls.model_fields[str(name)].annotation)]
            )
            return _detail(location, "is missing", f"add {' or '.join(names)}")
        if quantity and kind == "quantity":
            key = written[str(name)]
            return _detail((key,), *out_of_bounds(quantity, str(name), cls.keys()[key][1], item["msg"], item["ctx"]))
        if kind in {"union_tag_invalid", "union_tag_not_found"}:
            tag = str(item["ctx"]["discriminator"]).strip("'")
            if isinstance(item["input"], dict) and isinstance(item["input"].get(tag), np.ndarray):
                return _detail((*location, tag), *NOT_VARIED)
            value = item["input"].get(tag) if isinstance(item["input"], dict) else None
            problem = "is missing" if value is None else f"is not a known {tag}"
            return _detail((*location, tag), problem, meant(str(value), cls.choices[tag], cls.hints))
        if kind == "list_type":
            return _detail(location, "must be a list of tables", f"write [[{location[-1]}]] above each of them")
        if EXPECTED.get(kind) == TABLE and isinstance(item["input"], list):
            header = ".".join([*map(str, location), *(["NAME"] if kind == "dict_type" else [])])
            return _detail(location, "must be a table, and is a list", f"write [{header}], in single brackets")
        if EXPECTED.get(kind) == TABLE and len(location) == 2:
            return _detail(location, "must be a table", f"put it under a name of your choice: [{location[0]}.NAME]")
        if kind == "string_pattern_mismatch":
            return _detail(location, "is not a valid name", "use letters, digits, - and _; begin with a letter or _")
        if kind == "string_too_long":
            return _detail(location, f"has more than {item['ctx']['max_length']} characters", "use a shorter name")
        if kind == "too_long":
            problem = f"has {item['ctx']['actual_length']} items, and at most {item['ctx']['max_length']} are allowed"
            return _detail(location, problem, "leave out those that tell least")
        if kind == "literal_error":
            return _detail(location, f"must be {item['ctx']['expected']}", "correct the value")
        return _detail(location, *EXPECTED.get(kind, (item["msg"], "correct it")))


def _detail(location: tuple[str | int, ...], problem: str, remedy: str) -> InitErrorDetails:
    """Return a fault as pydantic carries it; its text is final and has no placeholders."""
    text = problem.replace("{", "(").replace("}", ")")
    return InitErrorDetails(type=PydanticCustomError("fault", text, {"remedy": remedy}), loc=location, input=None)
