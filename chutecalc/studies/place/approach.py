"""The part of a chute before a segment that is to be placed, and the flight that leads to it."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.design import Status
from chutecalc.errors import UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.segments.registry import KINDS
from chutecalc.spec.frozen import FALL
from chutecalc.spec.library import Library
from chutecalc.spec.operating import case_values
from chutecalc.spec.paths import item_names
from chutecalc.studies.place.strike import Launch

RTOL = 1e-12
"""Relative tolerance of the velocity with which the stream before a segment is solved."""
A_FALL = {"kind": FALL, "drop_m": 1.0}
ONTO_NEXT = {"kind": FALL, "onto_next": True}
"""The fall before a segment that has a place."""
NOT_YET = ("receiver", "uncertainty")
"""Tables of a spec that may name what is not placed yet."""
START = same_quantity("start_m")


def lacks_place(tables: list[dict[str, Any]], number: int) -> bool:
    """Return whether a segment of a sketch has no place yet.

    Args:
        tables: of the segments.
        number: of the segment, from 0.

    >>> lacks_place([{"kind": "fall", "onto_next": True}, {"kind": "hood", "radius_m": 2.0}], 1)
    True
    """
    kind, before = KINDS.get(tables[number].get("kind", "")), tables[number - 1] if number else {}
    guides = kind is not None and kind.guides
    return guides and before.get("onto_next") is True and not tables[number].keys() & {*START}


def chute_up_to(
    data: dict[str, Any], number: int, table: dict[str, Any], source: str, library: Library | None
) -> Chute:
    """Return the chute up to a segment, which lies after a flight.

    Args:
        data: tables of the spec.
        number: of the segment, from 0.
        table: of the segment, with its place.
        source: name of the spec in messages.
        library: that the spec may use.

    Raises:
        SpecError: the spec has faults.
    """
    return chute_of(data, [*data["segments"][: max(number - 1, 0)], ONTO_NEXT, table], source, library)


def chute_of(data: dict[str, Any], segments: list[dict[str, Any]], source: str, library: Library | None) -> Chute:
    """Return a chute of other segments, without what need not be there yet.

    Args:
        data: tables of the spec.
        segments: tables of its segments.
        source: name of the spec in messages.
        library: that the spec may use.

    Raises:
        SpecError: the spec has faults.
    """
    own = {key: value for key, value in data.items() if key not in NOT_YET}
    if isinstance(cases := own.get("cases"), dict):
        names = item_names(segments)
        own["cases"] = {name: _known(case, names) if isinstance(case, dict) else case for name, case in cases.items()}
    return Chute(own | {"segments": segments}, source, library=library)


def _known(case: Mapping[str, Any], names: list[str]) -> dict[str, Any]:
    """Return what a case says about the inlet, the material, and segments of these names."""
    known = {}
    for path, value in case_values(dict(case)).items():
        table, _, rest = path.partition(".")
        if table not in NOT_YET and (table != "segments" or rest.partition(".")[0] in names):
            known[path] = value
    return known


def launch_to(data: dict[str, Any], number: int, source: str, library: Library | None) -> Launch:
    """Return the stream where the flight to a segment begins: at the inlet, or where it leaves what comes before.

    Args:
        data: tables of the spec.
        number: of the segment, from 0.
        source: name of the spec in messages.
        library: that the spec may use.

    Raises:
        UsageError: it does not get that far.
        SpecError: the spec has faults.
    """
    if number < 2:
        design = chute_of(data, [A_FALL], source, library).design
        start, velocity = design.inlet_position, design.inlet_velocity.item()
        slope = design.inlet_slope.item() if velocity else np.pi / 2
        return Launch(start[0].item(), start[1].item(), slope, velocity, design.gravity.item())
    solution = solve(chute_of(data, data["segments"][: number - 1], source, library), RTOL)
    status, ends = str(solution.status[0]), solution.trajectory.ends
    if status == "ok":
        at = ends.x, ends.z, ends.slope, ends.velocity
    elif status == "contact_lost":  # it flies on from there
        left = solution.trajectory.segment_solutions[-1].exit
        at = left.x, left.z, left.slope, left.velocity
    else:
        failed = next(part.name for part in solution.trajectory.parts if part.status().item() != Status.OK)
        raise UsageError(f"the stream does not get there: {status} at {failed}. Place that first")
    x, z, slope, velocity = (each.item() for each in at)
    return Launch(x, z, slope, velocity, solution.design.gravity.item())
