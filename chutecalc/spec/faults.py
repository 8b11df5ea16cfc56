"""Pydantic's errors as faults, with the value that stands there and its line."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from chutecalc.errors import Fault

Place = tuple[str | int, ...]


def faults_of(error: ValidationError, data: Any, lines: Mapping[Place, int]) -> list[Fault]:
    """All faults of a spec, in the order of its lines.

    Args:
        error: what checking the spec raised; :class:`~chutecalc.spec.quantity.Table` has put it into words.
        data: the spec as the user wrote it.
        lines: line of each place, as far as known.
    """
    found = []
    for item in error.errors(include_url=False):
        place, value = _as_written(tuple(item["loc"]), data)
        remedy = (item.get("ctx") or {}).get("remedy", "")
        found.append(fault_at(place, item["msg"], remedy, value, lines))
    return sorted(dict.fromkeys(found), key=lambda fault: fault.line or 0)


def fault_at(place: Place, problem: str, remedy: str, value: Any, lines: Mapping[Place, int]) -> Fault:
    """A fault at a place, ``segments.2.radius_m`` with lists from 1; its line, or that of the table around it."""
    path = ".".join(str(item + 1) if isinstance(item, int) else item for item in place)
    line = next((lines[place[:k]] for k in range(len(place), 0, -1) if place[:k] in lines), None)
    return Fault(path, problem, remedy, value_text(value), line)


def value_text(value: Any) -> str:
    """A value as it stands in a TOML file; a varied one by its extremes, a table or nothing as nothing."""
    if value is None or isinstance(value, dict | list):
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if hasattr(value, "min"):
        return f"{value.min():.6g} to {value.max():.6g}"
    return str(value)


def _as_written(loc: Place, data: Any) -> tuple[Place, Any]:
    """The place without the tags that pydantic puts in for kinds and shapes, and what stands there."""
    place: Place = ()
    here = data
    for item in loc:
        if isinstance(here, dict):
            if item not in here and item in (here.get("kind"), here.get("shape")):
                continue
            here = here.get(item)
        else:
            here = here[item] if isinstance(here, list) and isinstance(item, int) and item < len(here) else None
        place = (*place, item)
    return place, here
