"""Pydantic's errors as faults, with the value that stands there and its line."""

from collections.abc import Iterable
from typing import Any

from pydantic import ValidationError

from chutecalc.errors import Fault
from chutecalc.fields.faults import LocatedFault, Location
from chutecalc.fields.units import same_quantity
from chutecalc.spec.parse import key_lines


def faults_of(error: ValidationError, data: Any, text: str) -> list[Fault]:
    """All faults of a spec, in the order of its lines.

    Args:
        error: what checking the spec raised; :class:`~chutecalc.fields.table.Table` has put it into words.
        data: the spec as the user wrote it.
        text: that it comes from, empty where there is none.
    """
    found = []
    for item in error.errors(include_url=False):
        location, value = _as_written(tuple(item["loc"]), data)
        found.append(LocatedFault(location, item["msg"], (item.get("ctx") or {}).get("remedy", ""), value))
    return _located(found, text)


def geometry_faults(faults: Iterable[LocatedFault], data: Any, text: str) -> list[Fault]:
    """Faults that name documented keys, at the keys and with the values that the user wrote."""
    found = []
    for fault in faults:
        *above, key = fault.location
        here = data
        for item in above:
            here = here[item]
        given = next((other for other in same_quantity(str(key)) if isinstance(here, dict) and other in here), key)
        value = here[given] if isinstance(here, dict) and given in here else fault.value
        found.append(fault._replace(location=(*above, given), value=value))
    return _located(found, text)


def _located(faults: Iterable[LocatedFault], text: str) -> list[Fault]:
    """Faults with paths as users write them, lists from 1, and lines: the key's, or that of the table around."""
    lines = key_lines(text)
    found = []
    for location, problem, remedy, value in faults:
        path = ".".join(str(item + 1) if isinstance(item, int) else item for item in location)
        line = next((lines[location[:k]] for k in range(len(location), 0, -1) if location[:k] in lines), None)
        found.append(Fault(path, problem, remedy, value_text(value), line))
    return sorted(dict.fromkeys(found), key=lambda fault: fault.line or 0)


def value_text(value: Any) -> str:
    """A value as it stands in a TOML file; a varied one by its extremes, a table or nothing as nothing."""
    if value is None or isinstance(value, dict | list):
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if hasattr(value, "ndim"):  # an array; a date has a min too
        low, high = f"{value.min():.6g}", f"{value.max():.6g}"
        return low if low == high else f"{low} to {high}"
    return str(value)


def _as_written(loc: Location, data: Any) -> tuple[Location, Any]:
    """The location without the tags that pydantic puts in for kinds and shapes, and what stands there."""
    location: Location = ()
    here, tagged = data, False
    for item in loc:
        if item == "[key]":  # pydantic's name for a key itself
            continue
        if isinstance(here, dict):
            tags = [tag for tag in (here.get("kind"), here.get("shape")) if isinstance(tag, str)]
            if not tagged and item in tags:
                tagged = True
                continue
            here = here.get(item)
        else:
            here = here[item] if isinstance(here, list) and isinstance(item, int) and item < len(here) else None
        location, tagged = (*location, item), False
    return location, here
