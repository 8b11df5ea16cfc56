"""Words of the faults of tables: what was probably meant, and what is expected."""

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from typing import Any, NamedTuple, get_origin

import numpy as np
from pydantic import BaseModel

from chutecalc.fields.likely_units import PERCENT, likely_units
from chutecalc.fields.quantity import Quantity
from chutecalc.fields.units import convert, first_unit, unit_keys

NOT_VARIED = "cannot be varied: it is not a quantity", "use the path of a quantity, such as flow.rate_t_h"
TABLE = "must be a table", "write its keys under a header, as in [flow]"
EXPECTED = {
    "string_type": ("must be text in quotes", "put quotes around it"),
    "dict_type": TABLE,
    "model_type": TABLE,
    "model_attributes_type": TABLE,
    "too_short": ("must have at least one table", "add one"),
    "bool_type": ("must be true or false", "write one of these without quotes"),
    "float_type": ("must be a number", "write a number"),
    "finite_number": ("must be a finite number", "write a finite number"),
}
"""Problem and remedy of each of pydantic's errors, by its type."""


class Unknown(NamedTuple):
    """What is wrong with an unknown key."""

    problem: str
    remedy: str
    meant: str = ""
    """The documented key that was probably meant; empty if that is not known."""


def unknown_key(
    key: str,
    keys: Mapping[str, tuple[str, str]],
    quantities: Mapping[str, Quantity],
    fields: Sequence[str],
    below: Mapping[str, Mapping[str, tuple[str, str]]],
) -> Unknown:
    """Return what is wrong with a key, and what to do.

    Args:
        key: that the table does not take.
        keys: that it takes, each with its documented key and the suffix of its unit.
        quantities: of the table, by their documented keys.
        fields: documented keys of the table, quantities or not.
        below: keys of the tables in it, by name of the table.

    >>> unknown_key("Flow", {"flow": ("flow", "")}, {}, ["flow"], {})
    Unknown(problem='is not a key of this table: keys are in small letters', remedy='write flow', meant='flow')
    """
    if key.lower() in keys:
        problem = "is not a key of this table: keys are in small letters"
        return Unknown(problem, f"write {key.lower()}", keys[key.lower()][0])
    for name, quantity in quantities.items():
        names = list(unit_keys(name, quantity.dimension))
        stem = name.removesuffix("_" + first_unit(quantity.dimension))
        if len(names) > 1 and key == stem:
            return Unknown("needs its unit at the end", f"write {' or '.join(names)}", name)
        if len(names) > 1 and key.startswith(stem + "_"):
            return Unknown("does not end in a unit that fits", f"write {' or '.join(names)}", name)
    problem = "is not a key of this table"
    if close := get_close_matches(key, keys, n=1):
        return Unknown(problem, f"did you mean {close[0]}?", keys[close[0]][0])
    if tables := [f"[{name}]" for name, own in below.items() if key in own]:
        return Unknown(problem, f"put it below {' or '.join(tables)}")
    return Unknown(problem, f"use one of {', '.join(fields)}")


def out_of_bounds(
    quantity: Quantity, name: str, unit: str, problem: str, context: Mapping[str, Any]
) -> tuple[str, str]:
    """Return what is wrong with a value of a quantity, and what to do: what was meant in another unit, where that fits.

    Args:
        quantity: that it is of.
        name: documented key.
        unit: suffix of the unit in which it is given.
        problem: the beginning of it, to which the bounds belong.
        context: the ``remedy``, and the ``number`` that is out of bounds, in the dimension's first unit, or None.

    >>> from chutecalc.fields.quantities import WIDE
    >>> context = {"remedy": "use a larger value", "number": 9e-4}
    >>> out_of_bounds(Quantity("length", WIDE), "width_m", "mm", "must be", context)[1]
    'did you mean width_m = 0.9?'
    """
    number, remedy, sizes = context["number"], context["remedy"], quantity.plausible
    problem = f"{problem} {quantity.bounds_text(unit)}".rstrip(" ,")
    if number is None or number <= 0.0 or sizes is None:
        return problem, remedy
    side = "less" if number < sizes.low else "more"
    if why := sizes.reasons.get(side):
        problem += f": {side} {why}"
    written = convert(np.array([number]), quantity.dimension, first_unit(quantity.dimension), unit)
    likely = next((other for other, suits in likely_units(quantity, written, unit).items() if suits), None)
    if likely is None:
        return problem, remedy
    key = {suffix: key for key, suffix in unit_keys(name, quantity.dimension).items()}.get(likely, name)
    value = written[0] / PERCENT if likely == "%" else written[0]
    return problem, f"did you mean {key}?" if quantity.shape else f"did you mean {key} = {value:.12g}?"


def meant(value: str, choices: Sequence[str], hints: Mapping[str, str]) -> str:
    """Return what to do about a value that is none of the choices.

    Args:
        value: that was given.
        choices: values that there are.
        hints: what to do about some other values.

    >>> meant("Hood", ["curve", "hood"], {}), meant("arc", ["curve", "hood"], {})
    ('did you mean hood?', 'use one of curve, hood')
    """
    close = get_close_matches(value.lower(), choices, n=1, cutoff=0.75)
    return hints.get(value.lower()) or (f"did you mean {close[0]}?" if close else f"use one of {', '.join(choices)}")


def as_added(name: str, kind: Any) -> str:
    """Return a key as a user adds it: as the header of a table, where it is one.

    Args:
        name: the key.
        kind: its type.

    >>> as_added("segments", list[int]), as_added("name", str)
    ('a header [[segments]]', 'name')
    """
    forms = {dict: f"a header [{name}.NAME]", list: f"a header [[{name}]]", BaseModel: f"a header [{name}]"}
    origin = get_origin(kind) or kind
    return next((form for base, form in forms.items() if isinstance(origin, type) and issubclass(origin, base)), name)
