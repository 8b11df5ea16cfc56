"""Which keys of a spec are operating: they vary while the steel stands still. All others are the drawing."""

from typing import Any

from chutecalc.errors import Fault
from chutecalc.spec.faults import value_text

DESIGN_POINT = "design"
"""Name of the state that the spec describes itself; no case may have it."""
OPERATING = (
    *("title", "flow", "material", "liners", "limits", "model.friction_law"),
    *("model.momentum_factor", "model.longitudinal_pressure_ratio"),
    *("inlet.velocity", "inlet.belt.velocity", "inlet.belt.material_depth"),
    *("inlet.belt.surcharge", "inlet.belt.friction", "receiver.velocity", "receiver.friction"),
)
"""Tables whose keys are all operating, and single keys without their unit."""
NOT_FELT = ("title.", "limits.", "receiver.")
"""Beginnings of the paths of keys that the stream in the chute does not feel."""
OPERATING_OF_SEGMENT = ("liner", "may_be_passed")


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


def case_values(case: dict[str, Any], above: str = "") -> dict[str, Any]:
    """Return the values of a case by key path, whether its keys stand in quotes or not.

    Args:
        case: its table.
        above: key path that leads to it, with a dot at its end; for nested tables.

    >>> case_values({"flow.rate_t_h": 2200, "flow": {"gravity_m_s2": 9.8}})
    {'flow.rate_t_h': 2200, 'flow.gravity_m_s2': 9.8}
    """
    found: dict[str, Any] = {}
    for key, value in case.items():
        found |= case_values(value, f"{above}{key}.") if isinstance(value, dict) else {f"{above}{key}": value}
    return found


def drawing_faults(values: dict[str, Any]) -> list[Fault]:
    """Return a fault for each key of a case that changes the drawing.

    Args:
        values: of the case, by key path.
    """
    return [
        Fault(
            path,
            "belongs to the drawing, and all cases are served by the same steel",
            "use keys of flow, material, liners, inlet velocity or belts, or write another spec",
            value_text(value),
        )
        for path, value in values.items()
        if not is_operating(path)
    ]
