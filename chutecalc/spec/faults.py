"""Faults as users see them: with the key path and the value as written, and the line."""

from collections.abc import Iterable, Mapping
from itertools import takewhile
from typing import Any

from pydantic import ValidationError

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.faults import LocatedFault, Location
from chutecalc.fields.units import same_quantity
from chutecalc.spec.lines import key_lines
from chutecalc.spec.parse import parse_text
from chutecalc.spec.segment_names import segment_names


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
    return _located(found, data, text)


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
    return _located(found, data, text)


def case_faults(faults: Iterable[Fault], name: str, text: str) -> list[Fault]:
    """Return the faults of a case, with the line and the words of its key, or the line of its nearest one.

    Args:
        faults: of the spec with the values of the case.
        name: of the case.
        text: TOML text of the spec, for line numbers; empty if there is none.
    """
    return table_faults(faults, ("cases", name), text)


def table_faults(faults: Iterable[Fault], table: tuple[str, ...], text: str) -> list[Fault]:
    """Return the faults of a table whose keys are key paths, as its own keys are written, with their lines.

    Args:
        faults: with the key paths.
        table: keys that lead to the table.
        text: TOML text of the spec, for line numbers; empty if there is none.
    """
    depth = len(table)
    numbers = _segment_numbers(text)
    keys = [
        (".".join(map(str, location[depth:])).split(".") if location[depth:] else [], line)
        for location, line in key_lines(text).items()
        if location[:depth] == table
    ]
    found = []
    for fault in faults:
        path, line = fault.path.split("."), None
        whole = _by_number(path, numbers)
        written, best = path, (-1, 0, 0)
        for key, at in keys:
            own = _by_number(key, numbers)
            shared = _shared(own, whole)
            rank = shared, _shared(key, path), bool(shared) * len(own)
            if rank > best:
                best, line = rank, at
                written = [*key, *whole[shared:]] if shared == len(own) else path
        found.append(fault._replace(path=".".join([*table, *written]), line=line))
    return found


def _segment_numbers(text: str) -> dict[str, str]:
    """Return the number of each segment, from 1, by its name; none where the spec has no list of segments."""
    try:
        tables = parse_text(text, "spec").get("segments")
    except SpecError:
        return {}
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        return {}
    names = segment_names([(table.get("name"), str(table.get("kind", ""))) for table in tables])
    return {name: str(number) for number, name in enumerate(names, 1)}


def _by_number(path: list[str], numbers: dict[str, str]) -> list[str]:
    """Return a key path with the number of a segment in place of its name."""
    return [*path[:1], numbers.get(path[1], path[1]), *path[2:]] if path[:1] == ["segments"] and path[1:] else path


def _shared(one: list[str], other: list[str]) -> int:
    """Return how many parts two key paths share at their beginning."""
    return len(list(takewhile(lambda pair: pair[0] == pair[1], zip(one, other, strict=False))))


def changed_faults(faults: Iterable[Fault], arguments: Mapping[str, str], text: str) -> list[Fault]:
    """Return faults with those of changed keys laid on what changed them.

    Args:
        faults: of a spec with changes.
        arguments: what a user wrote for each change, by its key path.
        text: TOML text of the spec before them.
    """
    numbers = _segment_numbers(text)
    changed = {tuple(_by_number(path.split("."), numbers)): argument for path, argument in arguments.items()}
    found = []
    for fault in faults:
        path = tuple(_by_number(fault.path.split("."), numbers))
        given = next((changed[path[:k]] for k in range(len(path), 0, -1) if path[:k] in changed), "")
        if given and path not in changed:  # a fault of a key within what was put there
            given = f"{given}: {fault.shown}"
        found.append(fault._replace(argument=given, line=None) if given else fault)
    return found


def _located(faults: Iterable[LocatedFault], data: Any, text: str) -> list[Fault]:
    """Return faults with key paths, list items counted from 1, and the line of the key or of the table around it.

    A value that was put in place of that of the file has no line there.
    """
    lines, written = key_lines(text), parse_text(text, "spec") if text else {}
    found = []
    for location, problem, remedy, value in faults:
        path = ".".join(str(item + 1) if isinstance(item, int) else item for item in location)
        line = next((lines[location[:k]] for k in range(len(location), 0, -1) if location[:k] in lines), None)
        if not _same(_value_at(written, location), _value_at(data, location)):
            line = None
        found.append(Fault(path, problem, remedy, value_text(value), line))
    return sorted(dict.fromkeys(found), key=lambda fault: fault.line or 0)


def _value_at(data: Any, location: Location) -> Any:
    """Return what data have at a location, or None."""
    for item in location:
        if isinstance(data, dict):
            data = data.get(item)
        else:
            data = data[item] if isinstance(data, list) and isinstance(item, int) and item < len(data) else None
    return data


def _same(one: Any, other: Any) -> bool:
    """Return whether two values are the same; an array is never that of a file."""
    if isinstance(one, dict | list) and type(one) is type(other):
        return True  # what is wrong with a table is that of its keys
    return type(one) is type(other) and (one == other or one != one)


def value_text(value: Any) -> str:
    """Return a value as a TOML file has it; an array as its extremes; None and what has no number as empty text.

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
        if not value.size or value.dtype.kind not in "biufc":
            return ""
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
