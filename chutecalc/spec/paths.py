"""Key paths, one grammar everywhere: ``segments.2.radius_m``, ``segments.spoon.radius_m``."""

import copy
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.faults import value_text

OPTIONAL_TABLES = ("model", "receiver", "belt")
"""Tables that a path may lead to before they are written; the check that follows refuses them elsewhere."""


def with_values(data: dict[str, Any], changes: dict[str, Any], source: str) -> dict[str, Any]:
    """A copy of a spec's data with values put at paths; a key in another unit is replaced.

    Args:
        data: nested tables as the user wrote them.
        changes: path to value, a number, text, or an array of designs.
        source: what messages call the spec.

    Raises:
        SpecError: paths that lead nowhere, all of them. Whether a key is known is for the check that follows.
    """
    changed = copy.deepcopy(data)
    done: dict[tuple[int, str], str] = {}
    faults = [fault for path, value in changes.items() if (fault := _put(changed, path, value, done))]
    if faults:
        raise SpecError(faults, source)
    return changed


def _put(data: dict[str, Any], path: str, value: Any, put: dict[tuple[int, str], str]) -> Fault | None:
    """Puts one value; the fault where there is no such table, or where an earlier path has put the same quantity."""
    *tables, key = path.split(".")
    here: Any = data
    for number, item in enumerate(tables):
        below = _below(here, item)
        if below is None:
            problem, remedy = _nowhere(here, ".".join(tables[:number]), item)
            return Fault(path, problem, remedy, value_text(value))
        here = below
    quantity = (id(here), min(same_quantity(key)))
    if quantity in put:
        return Fault(path, f"is given twice, also as {put[quantity]}", "keep one of them", value_text(value))
    put[quantity] = path
    if isinstance(here, list) and is_number(key) and 1 <= int(key) <= len(here):
        here[int(key) - 1] = value
        return None
    if not isinstance(here, dict | list):
        problem, remedy = _nowhere(here, ".".join(tables), key)
        return Fault(path, problem, remedy, value_text(value))
    if not isinstance(here, dict) or not key:
        return Fault(path, "does not end in a key", "use a path such as segments.1.drop_m", value_text(value))
    for name in same_quantity(key):
        here.pop(name, None)
    here[key] = value
    return None


def _below(here: Any, item: str) -> Any:
    """Return the table below a key, a name or a number from 1, or None; a table that may be left out is made."""
    if isinstance(here, dict):
        if item in OPTIONAL_TABLES and item not in here:
            here[item] = {}
        return here.get(item)
    if isinstance(here, list):
        if is_number(item):
            return here[int(item) - 1] if 1 <= int(item) <= len(here) else None
        named = (table for table, name in zip(here, _names(here), strict=True) if name == item != "")
        return next(named, None)
    return None


def _nowhere(here: Any, path: str, item: str) -> tuple[str, str]:
    """Return what is wrong with an item that is not below a path, and what to do."""
    if isinstance(here, dict):
        tables = [key for key, value in here.items() if isinstance(value, dict | list)]
        remedy = f"use one of {', '.join(tables)}" if tables else f"use a key of {path or 'the spec'}"
        return f"does not exist: {path or 'the spec'} has no table {item}", remedy
    if isinstance(here, list):
        names = ", ".join(name or str(number) for number, name in enumerate(_names(here), 1))
        return f"does not exist: {path} has no item {item} (it has {len(here)}: {names})", "use one of these"
    return f"does not exist: {path} is a value, not a table", f"use the path {path}"


def _names(tables: list[Any]) -> list[str]:
    """Return the name of each table of a list; empty for those without one."""
    names = [table.get("name") if isinstance(table, dict) else None for table in tables]
    return [name if isinstance(name, str) else "" for name in names]


def is_number(item: str) -> bool:
    """Whether part of a path counts in a list, from 1."""
    return item.isascii() and item.isdecimal()
