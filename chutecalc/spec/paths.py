"""Key paths, one grammar everywhere: ``segments.2.radius_m``, ``segments.spoon.radius_m``."""

import copy
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.faults import value_text

OPTIONAL_TABLES = ("model", "receiver", "belt")
"""Tables that a path may lead to before they are written; the check that follows refuses them elsewhere."""


def with_values(data: dict[str, Any], changes: dict[str, Any], source: str) -> dict[str, Any]:
    """A copy of a spec's data with values put at paths; the unit twin of a key replaces it.

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
    done: list[str] = []
    for item in tables:
        below, known = _step(here, item)
        if below is None:
            where = ".".join(done) or "the spec"
            remedy = f"there are {', '.join(known)}" if known else "use a path of the spec"
            return Fault(path, f"leads nowhere: {where} has no {item}", remedy, value_text(value))
        here = below
        done.append(item)
    quantity = (id(here), min(same_quantity(key)))
    if quantity in put:
        return Fault(path, f"is given twice, as {put[quantity]} too", "keep one of them", value_text(value))
    put[quantity] = path
    if isinstance(here, list) and is_number(key) and 1 <= int(key) <= len(here):
        here[int(key) - 1] = value
        return None
    if not isinstance(here, dict | list):
        remedy = f"put a value at {'.'.join(tables)} itself"
        return Fault(path, f"leads nowhere: {'.'.join(tables)} is no table", remedy, value_text(value))
    if not isinstance(here, dict) or not key:
        return Fault(path, "names no key", "use a path such as segments.1.drop_m", value_text(value))
    for name in same_quantity(key):
        here.pop(name, None)
    here[key] = value
    return None


def _step(here: Any, item: str) -> tuple[Any, list[str]]:
    """The table below, and what there is to choose from. A table of the spec that is not written yet is made."""
    if isinstance(here, dict):
        if item in OPTIONAL_TABLES and item not in here:
            here[item] = {}
        return here.get(item), [key for key, value in here.items() if isinstance(value, dict | list)]
    if isinstance(here, list):
        given = [table.get("name") if isinstance(table, dict) else None for table in here]
        named = [name if isinstance(name, str) else None for name in given]
        names = [name or str(number) for number, name in enumerate(named, 1)]
        if is_number(item) and 1 <= int(item) <= len(here):
            return here[int(item) - 1], names
        return (here[named.index(item)] if item in named else None), names
    return None, []


def is_number(item: str) -> bool:
    """Whether part of a path counts in a list, from 1."""
    return item.isascii() and item.isdecimal()
