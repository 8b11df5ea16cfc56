"""Checks of what a sweep is given: its columns, and the values of its parameters."""

from collections.abc import Sequence

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.output.dataset import Block
from chutecalc.results.columns import AT_STATION, closest
from chutecalc.studies.sweep.columns import row_columns
from chutecalc.studies.sweep.parameters import Parameter

DEFAULT = ("exit_velocity_m_s", "exit_depth_m", "exit_slope_deg", "max_depth_m", "min_velocity_m_s")
"""Columns of a sweep of designs where none are asked for."""


def selected_columns(names: Sequence[str], chute: Chute, profiles: bool) -> list[str]:
    """Return the columns asked for, each once, without those that every row has.

    Args:
        names: Names of columns; empty for those computed by default.
        chute: The chute.
        profiles: Whether rows are stations instead of designs.

    Raises:
        UsageError: Columns that do not exist, or columns of a receiver that the chute does not have.

    >>> import chutecalc
    >>> selected_columns(["status", "max_depth_m", "max_depth_m"], chutecalc.parse(chutecalc.STARTER), profiles=False)
    ['max_depth_m']
    """
    known = AT_STATION if profiles else row_columns()
    usual = AT_STATION if profiles else DEFAULT
    unknown = [name for name in names if name not in known and name != "status"]
    if unknown:
        own = "Use the columns of a station" if profiles else "Use exit_, max_ or min_ before a station's column"
        plural = "s" if len(unknown) > 1 else ""
        raise UsageError(
            f"unknown column{plural} {', '.join(unknown)}. {closest(unknown, known)}{own}; chutecalc columns lists them"
            " all"
        )
    belt = [name for name in names if name.startswith("receiver_")]
    if belt and chute.spec.receiver is None:
        raise UsageError(f"{belt[0]}: the spec has no [receiver]")
    return [name for name in dict.fromkeys(names or usual) if name != "status"]


def check_values(chute: Chute, parameters: Sequence[Parameter]) -> None:
    """Check that every path is in the spec and takes its values, whatever they make together.

    Args:
        chute: The chute.
        parameters: The parameters to vary.

    Raises:
        SpecError: All faults.
    """
    first = {path: each.values[:1] for each in parameters for path in each.paths}
    ends = {path: np.array([each.values.min(), each.values.max()]) for each in parameters for path in each.paths}
    faults: list[Fault] = []
    for path, values in ends.items():
        faults += _faults(chute, {path: values})
    faults = faults or [*_faults(chute, first)]
    if faults:
        raise SpecError(list(dict.fromkeys(faults)), chute.source)


def _faults(chute: Chute, changes: Block) -> tuple[Fault, ...]:
    """Return the faults of values, other than that a section cannot be built."""
    try:
        chute.vary(changes)
    except SpecError as error:
        return error.faults if error.designs is None else ()
    return ()
