"""Checks of what a sweep is given: its columns, and the values of its parameters."""

from collections.abc import Sequence
from functools import reduce

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.output.dataset import Block
from chutecalc.results.column_names import closest
from chutecalc.results.columns import AT_STATION
from chutecalc.spec.operating import case_values
from chutecalc.spec.paths import with_values
from chutecalc.studies.sweep.columns import own_columns, row_columns
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.text_parameter import CASE

DEFAULT = ("exit_velocity_m_s", "exit_depth_m", "exit_slope_deg", "max_depth_m", "min_velocity_m_s")
"""Columns of a sweep of designs where none are asked for."""
CLEARANCE = "receiver_clearance_m"
"""The column that a belt without a place lacks."""
DEFAULT_ON_BELT = ("receiver_velocity_ratio", "receiver_velocity_into_m_s")
"""Those beside, where there is a receiving belt."""


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
    own = {} if profiles else own_columns(names, chute)
    known = AT_STATION if profiles else {**row_columns(), **own}
    usual = AT_STATION if profiles else DEFAULT + (DEFAULT_ON_BELT if chute.spec.receiver else ())
    unknown = [name for name in names if name not in known and name != "status"]
    if unknown:
        use = "Use the columns of a station" if profiles else "Use exit_, max_ or min_ before a station's column"
        plural = "s" if len(unknown) > 1 else ""
        raise UsageError(
            f"unknown column{plural} {', '.join(unknown)}. {closest(unknown, known)}{use}; chutecalc columns lists them"
            " all"
        )
    belt = [name for name in names if name.startswith("receiver_")]
    if belt and chute.spec.receiver is None:
        raise UsageError(f"{belt[0]}: the spec has no [receiver]")
    if CLEARANCE in belt and chute.spec.receiver is not None and chute.spec.receiver.at_m is None:
        raise UsageError(f"{CLEARANCE}: give receiver.at_m, a point of the belt's surface")
    return [name for name in dict.fromkeys(names or usual) if name != "status"]


def chutes_by_names(chute: Chute, grid: Grid) -> dict[tuple[str, ...], Chute]:
    """Return the chutes that the names of a sweep make, once every path is in the spec and takes its values.

    Args:
        chute: The chute.
        grid: The parameters to vary.

    Returns:
        A chute for each of the names that rows have together, without those that cannot be built.

    Raises:
        SpecError: All faults of names and values, whatever they make together.
    """
    found: dict[tuple[str, ...], Chute] = {}
    faults: list[Fault] = []
    for names in grid.names():
        try:
            found[names] = reduce(
                lambda changed, each: each[0].chute_of(changed, each[1]), zip(grid.texts, names, strict=True), chute
            )
            faults += _value_faults(found[names], grid.numbers)
        except SpecError as error:
            faults += error.faults if error.designs is None else ()
    if faults:
        raise SpecError(list(dict.fromkeys(faults)), chute.source)
    _check_cases(chute, grid)
    whole = {path: each.values[0] for each in grid.parameters for path in each.paths}
    with_values(chute.data, whole, chute.source)  # where names and numbers meet at a key, it is given twice
    return found


def _check_cases(chute: Chute, grid: Grid) -> None:
    """Check that no case of a sweep sets a key that the sweep varies too: the column would state what does not hold."""
    varied = {spelling: path for each in grid.parameters for path in each.paths for spelling in _spellings(path)}
    names = {str(name) for each in grid.texts if each.name == CASE for name in each.values}
    cases = {name: case_values(chute.data["cases"][name]) for name in chute.cases if name in names}
    for spelling, path in varied.items():
        if setting := [name for name, values in cases.items() if spelling in values]:
            raise UsageError(
                f"{path}: case{'s' * (len(setting) > 1)} {', '.join(setting)} set{'s' * (len(setting) == 1)} it too."
                " Vary another key, or choose other cases (case=design,…)"
            )


def _spellings(path: str) -> list[str]:
    """Return the paths of a quantity in each of its units."""
    table, dot, key = path.rpartition(".")
    return [f"{table}{dot}{each}" for each in same_quantity(key)]


def _value_faults(chute: Chute, parameters: Sequence[Parameter]) -> list[Fault]:
    """Return the faults of paths and of values, each path for itself, or else of the first values together."""
    first = {path: each.values[:1] for each in parameters for path in each.paths}
    ends = {path: np.array([each.values.min(), each.values.max()]) for each in parameters for path in each.paths}
    faults: list[Fault] = []
    for path, values in ends.items():
        faults += _faults(chute, {path: values})
    return faults or [*_faults(chute, first)]


def _faults(chute: Chute, changes: Block) -> tuple[Fault, ...]:
    """Return the faults of values, other than that a section cannot be built."""
    try:
        chute.vary(changes)
    except SpecError as error:
        return error.faults if error.designs is None else ()
    return ()
