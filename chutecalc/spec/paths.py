"""Puts values at key paths: ``segments.2.radius_m``, or by name ``segments.spoon.radius_m``."""

from collections.abc import Iterator, Sequence
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.faults import value_text
from chutecalc.spec.segment_names import segment_names

OPTIONAL_TABLES = ("model", "receiver", "belt", "limits")
"""Tables that a path creates where they are missing; the check that follows refuses them in the wrong place."""


def with_values(data: dict[str, Any], changes: dict[str, Any], source: str) -> dict[str, Any]:
    """Return a copy of a spec's data with values put at key paths.

    Args:
        data: nested tables as the user wrote them.
        changes: key path to value: a number, text, or an array with an entry for each design. The same quantity in
            another unit is replaced. An entry of a library replaces all keys of the table that uses it.
        source: what messages call the spec.

    Raises:
        SpecError: Paths to tables that do not exist, all of them. The last key is left to the check that follows.

    >>> with_values({"flow": {"rate_t_h": 1000}}, {"flow.rate_kg_s": 250.0}, "spec")
    {'flow': {'rate_kg_s': 250.0}}
    """
    changed: dict[str, Any] = _copied(data)
    done: dict[tuple[int, str], str] = {}
    in_order = sorted(changes.items(), key=lambda change: not change[0].endswith(".use"))
    faults = [fault for path, value in in_order if (fault := _put(changed, path, value, done))]
    if faults:
        raise SpecError(faults, source)
    return changed


def value_at(data: dict[str, Any], path: str) -> Any:
    """Return what a spec's data hold at a key path; None if that is nothing.

    Args:
        data: nested tables as the user wrote them.
        path: the path.

    >>> value_at({"segments": [{"kind": "fall", "drop_m": 2.0}]}, "segments.fall.drop_m")
    2.0
    """
    here: Any = _copied(data)  # a copy, for tables that may be left out are made
    for item in path.split("."):
        here = _below(here, item)
    return here


def _copied(item: Any) -> Any:
    """Copy tables and lists. One that is shared between two keys becomes two, so that each can be changed alone."""
    if isinstance(item, dict):
        return {key: _copied(value) for key, value in item.items()}
    return [_copied(value) for value in item] if isinstance(item, list) else item


def _put(data: dict[str, Any], path: str, value: Any, put: dict[tuple[int, str], str]) -> Fault | None:
    """Put one value; return the fault of a path to no table, or to a quantity that has a value already."""
    *tables, key = path.split(".")
    here: Any = data
    if not tables and key not in data and (meant := list(_paths_to(data, key))):
        return Fault(path, "is not a key of the spec", f"did you mean {' or '.join(meant)}?", value_text(value))
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
    for name in [*here] if key == "use" else same_quantity(key):
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
        return next((table for table, name in zip(here, item_names(here), strict=True) if name == item != ""), None)
    return None


def _paths_to(here: Any, key: str, above: str = "") -> Iterator[str]:
    """Yield the paths of the tables below that have a quantity, each with the key that was given for it."""
    if isinstance(here, list):
        here = {name or str(k): table for k, (name, table) in enumerate(zip(item_names(here), here, strict=True), 1)}
    for name, table in here.items() if isinstance(here, dict) else ():
        if isinstance(table, dict) and not {*same_quantity(key)}.isdisjoint(table):
            yield f"{above}{name}.{key}"
        yield from _paths_to(table, key, f"{above}{name}.")


def _nowhere(here: Any, path: str, item: str) -> tuple[str, str]:
    """Return what is wrong with an item that is not below a path, and what to do."""
    if isinstance(here, dict):
        tables = [key for key, value in here.items() if isinstance(value, dict | list)]
        remedy = f"use one of {', '.join(tables)}" if tables else f"use a key of {path or 'the spec'}"
        return f"does not exist: {path or 'the spec'} has no table {item}", remedy
    if isinstance(here, list):
        return f"does not exist: {path} has no item {item!r}", f"use {_listed(here)}"
    return f"does not exist: {path} is a value, not a table", f"use the path {path}"


def item_names(tables: Sequence[Any]) -> list[str]:
    """Return the name of each item of a list, as paths take it: that of a segment, which may be its kind; else empty.

    Args:
        tables: the list, as the user wrote it.

    >>> item_names([{"kind": "fall"}, {"name": "spoon", "kind": "curve"}]), item_names([{"slope_deg": 5}])
    (['fall', 'spoon'], [''])
    """
    known = [(_text(table, "name"), _text(table, "kind")) for table in tables]
    return [name if any(own) else "" for name, own in zip(segment_names(known), known, strict=True)]


def _text(table: Any, key: str) -> str:
    """Return the text that a table has at a key, or empty text."""
    value = table.get(key) if isinstance(table, dict) else None
    return value if isinstance(value, str) else ""


def _listed(tables: list[Any]) -> str:
    """Return the items of a list as a path may call them; one called by its kind also by its number."""
    names = enumerate(zip(tables, item_names(tables), strict=True), 1)
    items = [
        name if _text(table, "name") else f"{number} ({name})" if name else str(number)
        for number, (table, name) in names
    ]
    return " or ".join(filter(None, (", ".join(items[:-1]), *items[-1:])))


def is_number(item: str) -> bool:
    """Return whether a part of a key path is the number of a list item.

    Args:
        item: the part.

    >>> is_number("2"), is_number("spoon")
    (True, False)
    """
    return len(item) < 10 and item.isascii() and item.isdecimal()  # a longer one is out of any list, and slow to read
