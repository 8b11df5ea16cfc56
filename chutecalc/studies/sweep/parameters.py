"""What a sweep varies: arguments such as ``beta=15:90:5`` as spec paths and values."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.fields.ranges import read_values
from chutecalc.fields.units import same_quantity
from chutecalc.physics.arrays import Array

SHORT = {
    "beta": ("sections", "chamfer_deg"),
    "delta": ("material", "internal_friction_deg"),
    "phi": ("liners", "friction_deg"),
    "rate": ("flow", "rate_t_h"),
    "radius": ("segments", "radius_m"),
    "base": ("sections", "base_m"),
}
"""Short names: the table that they are looked for in, and the key."""
DEFAULT_VALUES = {"beta": "15:90:5", "delta": "30:55:5"}
"""What a short name means that stands without values."""


class Parameter(NamedTuple):
    """A quantity that is varied."""

    name: str
    """Of its column: the key of a short name, else the path as given."""
    paths: tuple[str, ...]
    """Where its values go; each takes the same one."""
    values: Array


def read_parameters(arguments: list[str], chute: Chute) -> list[Parameter]:
    """The parameters that arguments mean for a chute.

    Args:
        arguments: ``name=values`` each, or a name of :data:`DEFAULT_VALUES` alone.
        chute: whose keys short names stand for.

    Raises:
        UsageError: all that is wrong with them.
    """
    found: list[Parameter] = []
    faults: list[str] = []
    for argument in arguments:
        try:
            found.append(_parameter(argument, chute))
        except UsageError as error:
            faults.append(str(error))
    names = [parameter.name for parameter in found]
    faults += [f"{name} is given twice. Keep one of them." for name in dict.fromkeys(names) if names.count(name) > 1]
    if faults:
        raise UsageError("\n".join(faults))
    return found


def split_argument(argument: str, defaults: dict[str, str]) -> tuple[str, Array]:
    """Name and values of an argument.

    Raises:
        UsageError: it has no values, and is none of the names that may stand without values.
    """
    name, equals, text = argument.partition("=")
    name = name.strip()
    if not equals and name in defaults:
        return name, read_values(name, defaults[name])
    if not (name and equals):
        raise UsageError(f"{argument!r} has no values. Write NAME=VALUES, such as beta=15:90:5 or rate=500,1000.")
    return name, read_values(name, text)


def _parameter(argument: str, chute: Chute) -> Parameter:
    """One argument."""
    name, values = split_argument(argument, DEFAULT_VALUES)
    for short, (table, key) in SHORT.items():
        keys = same_quantity(key)
        stem = min(keys, key=len).rpartition("_")[0]
        spellings = {short: key} | {each.replace(stem, short, 1): each for each in keys} | {each: each for each in keys}
        if name in spellings:
            return Parameter(spellings[name], tuple(_paths(name, table, spellings[name], chute)), values)
    if "." not in name:
        known = ", ".join(SHORT)
        raise UsageError(f"{name} is neither a short name ({known}) nor a path such as segments.1.drop_m")
    return Parameter(name, (name,), values)


def _paths(name: str, table: str, key: str, chute: Chute) -> list[str]:
    """The paths that a short name stands for.

    Raises:
        UsageError: there is none, or it is not clear which is meant.
    """
    keys = same_quantity(key)
    tables = dict(_tables(chute.data.get(table), table))
    found = {path: next(each for each in keys if each in entry) for path, entry in tables.items() if {*keys} & {*entry}}
    paths = [f"{path}.{key}" for path in found]
    if not found:
        others = [f"{path}.{own}" for path, entry in _all_tables(chute.data) for own in entry if own in keys]
        remedy = f"Use {' or '.join(others)}." if others else "Use the path of another number."
        raise UsageError(f"{name}: the spec has no {key} in its {table}. {remedy}")
    if name.partition("_")[0] == "delta" and "pressure_ratio" in chute.data["material"]:
        raise UsageError(f"{name}: material.pressure_ratio sets K_v, whatever δ is. Vary that, or remove it.")
    many = {repr(tables[path][own]) for path, own in found.items()}
    if len(found) > 1 and (table == "segments" or (key in same_quantity("base_m") and len(many) > 1)):
        raise UsageError(f"{name}: the spec has several. Use {' or '.join(paths)}.")
    return paths


def _tables(tables: Any, path: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """The tables of one kind by their paths: one, those of a list, or those that have names."""
    if isinstance(tables, list):
        for number, entry in enumerate(tables, 1):
            yield f"{path}.{entry.get('name', number)}", entry
    elif path in ("sections", "liners"):
        for name, entry in tables.items():
            yield f"{path}.{name}", entry
    elif tables:
        yield path, tables


def _all_tables(data: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """All tables of a spec by their paths."""
    for table in ("flow", "material", "liners", "sections", "inlet", "segments", "receiver"):
        yield from _tables(data.get(table), table)
