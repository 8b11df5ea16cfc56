"""Key paths, one grammar everywhere: ``segments.2.radius_m``, ``segments.spoon.radius_m``."""

import copy
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.spec.faults import value_text
from chutecalc.units import UNITS


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
    faults = [fault for path, value in changes.items() if (fault := _put(changed, path, value))]
    if faults:
        raise SpecError(faults, source)
    return changed


def _put(data: dict[str, Any], path: str, value: Any) -> Fault | None:
    """Puts one value; the fault where there is no such table."""
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
    if isinstance(here, list) and key.isdigit() and 1 <= int(key) <= len(here):
        here[int(key) - 1] = value
        return None
    if not isinstance(here, dict) or not key:
        return Fault(path, "names no key", "use a path such as segments.1.drop_m", value_text(value))
    for name in _same_quantity(key):
        here.pop(name, None)
    here[key] = value
    return None


def _step(here: Any, item: str) -> tuple[Any, list[str]]:
    """The table below, and what there is to choose from. A table of the spec that is not written yet is made."""
    if isinstance(here, dict):
        return here.get(item), [key for key, value in here.items() if isinstance(value, dict | list)]
    if isinstance(here, list):
        named = [table.get("name") if isinstance(table, dict) else None for table in here]
        names = [name or str(number) for number, name in enumerate(named, 1)]
        if item.isdigit() and 1 <= int(item) <= len(here):
            return here[int(item) - 1], names
        return (here[named.index(item)] if item in named else None), names
    return None, []


def _same_quantity(key: str) -> list[str]:
    """The key and its unit twins."""
    endings = [
        (unit, dimension) for dimension, units in UNITS.items() for unit in units if unit and key.endswith(f"_{unit}")
    ]
    if not endings:
        return [key]
    unit, dimension = max(endings, key=lambda ending: len(ending[0]))
    stem = key.removesuffix(unit)
    return [stem + other for other in UNITS[dimension]]
