"""Faults as users see them: with the key path and the value as written, and the line."""

from collections.abc import Iterable
from typing import Any

from pydantic import ValidationError

from chutecalc.errors import Fault
from chutecalc.fields.faults import LocatedFault, Location
from chutecalc.fields.units import same_quantity
from chutecalc.spec.parse import key_lines


def faults_of(error: ValidationError, data: Any, text: str) -> list[Fault]:
    """Return all faults that checking a spec found, in the order of its lines.

    Args:
        error: raised by the check, in the words of :class:`~chutecalc.fields.table.Table`.
        data: nested tables as the user wrote them.
        text: TOML text of the data, for line numbers; empty if there is none.
    """
    found = []
    for item in error.errors(include_url=False):
        location, value = _as_written(tuple(item["loc"]), data)
        found.append(LocatedFault(location, item["msg"], (item.get("ctx") or {}).get("remedy", ""), value))
    return _located(found, text)


def geometry_faults(faults: Iterable[LocatedFault], data: Any, text: str) -> list[Fault]:
    """Return faults of geometry, in the order of the spec's lines.

    Args:
        faults: whose locations have documented keys; the keys and values that the user wrote take their place.
        data: nested tables as the user wrote them.
        text: TOML text of the data, for line numbers; empty if there is none.
    """
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


def case_faults(faults: Iterable[Fault], name: str, text: str) -> list[Fault]:
    """Return the faults of a case, with the line of its key.

    Args:
        faults: of the spec with the values of the case.
        name: of the case.
        text: TOML text of the spec, for line numbers; empty if there is none.
    """
    return table_faults(faults, ("cases", name), text)


def table_faults(faults: Iterable[Fault], table: tuple[str, ...], text: str) -> list[Fault]:
    """Return the faults of a table whose keys are key paths, in quotes or not, with the line of the key.

    Args:
        faults: with the key paths.
        table: keys that lead to the table.
        text: TOML text of the spec, for line numbers; empty if there is none.
    """
    lines = key_lines(text)
    found = []
    for fault in faults:
        keys = ((*table, fault.path), (*table, *fault.path.split(".")), table)
        line = next((lines[location] for location in keys if location in lines), None)
        found.append(fault._replace(path=".".join((*table, fault.path)), line=line))
    return found


def _located(faults: Iterable[LocatedFault], text: str) -> list[Fault]:
    """Return faults with key paths, list items counted from 1, and the line of the key or of the table around it."""
    lines = key_lines(text)
    found = []
    for location, problem, remedy, value in faults:
        path = ".".join(str(item + 1) if isinstance(item, int) else item for item in location)
        line = next((lines[location[:k]] for k in range(len(location), 0, -1) if location[:k] in lines), None)
        found.append(Fault(path, problem, remedy, value_text(value), line))
    return sorted(dict.fromkeys(found), key=lambda fault: fault.line or 0)


def value_text(value: Any) -> str:
    """Return a value as a TOML file has it; an array as its extremes, a table or None as empty text.

    Args:
        value: any value of a spec's data.

    >>> import numpy as np
    >>> value_text(True), value_text("spoon"), value_text(np.array([2.0, 3.0])), value_text({})
    ('true', '"spoon"', '2 to 3', '')
    """
    if value is None or isinstance(value, dict | list):
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if hasattr(value, "ndim"):  # an array; a date has a min too
        low, high = f"{value.min():z.6g}", f"{value.max():z.6g}"
        return low if low == high else f"{low} to {high}"
    return str(value)


def _as_written(loc: Location, data: Any) -> tuple[Location, Any]:
    """Return the location without the tags that pydantic inserts for kinds and shapes, and the value there."""
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
