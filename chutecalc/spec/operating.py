"""Which keys of a spec are operating: they vary while the steel stands still. All others are the drawing."""

import re
from collections.abc import Iterator
from typing import Any

from chutecalc.errors import Fault
from chutecalc.fields.faults import Location
from chutecalc.fields.table import Violation
from chutecalc.spec.faults import value_text

DESIGN_POINT = "design"
"""Name of the state that the spec describes itself; no case may have it."""
OPERATING = (
    *("flow", "material", "liners", "limits", "model.friction_law"),
    *("model.momentum_factor", "model.longitudinal_pressure_ratio"),
    *("inlet.velocity", "inlet.belt.velocity", "inlet.belt.material_depth"),
    *("inlet.belt.surcharge", "inlet.belt.friction", "receiver.velocity", "receiver.friction"),
)
"""Tables whose keys are all operating, and single keys without their unit."""
NOT_FELT = ("limits.", "receiver.")
"""Beginnings of the paths of keys that the stream in the chute does not feel."""
OPERATING_OF_SEGMENT = ("liner", "may_be_passed")
DRAWING = ("sections", "segments", "inlet", "receiver", "model")
"""Tables with keys of the drawing."""
OF_ALL_CASES = ("title", "format")
"""Keys at the top of a spec that hold for all its cases."""


def is_operating(path: str) -> bool:
    """Return whether a key may vary while the steel stands still.

    Args:
        path: key path.

    >>> is_operating("flow.rate_kg_s"), is_operating("segments.spoon.radius_m"), is_operating("segments.spoon.liner")
    (True, False, True)
    """
    parts = path.split(".")
    if parts[0] == "segments":
        return len(parts) == 3 and parts[2] in OPERATING_OF_SEGMENT
    return any(path == name or path.startswith((f"{name}.", f"{name}_")) for name in OPERATING)


def is_felt(path: str) -> bool:
    """Return whether the stream in the chute feels a key.

    Args:
        path: key path.
    """
    return not f"{path}.".startswith(NOT_FELT)


def case_values(case: dict[str, Any]) -> dict[str, Any]:
    """Return the values of a case by key path, whether its keys stand in quotes or not.

    Args:
        case: its table.

    >>> case_values({"flow.rate_t_h": 2200, "flow": {"gravity_m_s2": 9.8}})
    {'flow.rate_t_h': 2200, 'flow.gravity_m_s2': 9.8}
    """
    return {".".join(keys): value for keys, value in _values(case)}


def _values(table: dict[str, Any], *above: str) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield the values in a table and in the tables below, each with the keys that lead to it."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _values(value, *above, str(key))
        else:
            yield (*above, str(key)), value


def case_keys(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of the names of cases, and of key paths that a case gives twice.

    Args:
        table: the spec, with documented keys.
    """
    cases = table.get("cases")
    for name, case in cases.items() if isinstance(cases, dict) else ():
        if name == DESIGN_POINT:
            yield Violation(("cases", name), "is the name of the state that the spec describes", "rename the case")
        first: dict[str, Location] = {}
        for keys, _ in _values(case) if isinstance(case, dict) else ():
            before = first.setdefault(".".join(keys), keys)
            if before is not keys:
                problem = f"is given twice, as {_toml(before)} and as {_toml(keys)}"
                yield Violation(("cases", name, *keys), problem, "keep one of them")


def _toml(keys: Location) -> str:
    """Return keys as TOML has them."""
    return ".".join(str(key) if re.fullmatch("[A-Za-z0-9_-]+", str(key)) else f'"{key}"' for key in keys)


def drawing_faults(values: dict[str, Any]) -> list[Fault]:
    """Return a fault for each key that a case may not set.

    Args:
        values: of the case, by key path.
    """
    keys = "keys of flow, material, liners, limits, inlet velocity or belts"
    found = []
    for path, value in values.items():
        if is_operating(path):
            continue
        if path in OF_ALL_CASES:
            problem, remedy = "holds for all cases", f"put it at the top of the spec; a case sets {keys}"
        elif path.partition(".")[0] in DRAWING:
            problem = "belongs to the drawing, and all cases are served by the same steel"
            remedy = f"use {keys}, or write another spec"
        else:
            problem, remedy = "is not a key that a case may set", f"use {keys}, such as flow.rate_t_h"
        found.append(Fault(path, problem, remedy, value_text(value)))
    return found
