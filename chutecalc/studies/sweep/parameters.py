"""Reads what a sweep varies: arguments such as ``beta=15:90:5`` as key paths and values."""

from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from typing import Any, NamedTuple

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.fields.ranges import read_values
from chutecalc.fields.units import UNITS, same_quantity, unit_keys
from chutecalc.physics.arrays import Array
from chutecalc.spec.paths import item_names
from chutecalc.studies.sweep.text_parameter import CASE, TextParameter, case_parameter, takes_names, text_parameter

SHORT = {
    "beta": ("sections", "chamfer_deg"),
    "delta": ("material", "internal_friction_deg"),
    "phi": ("liners", "friction_deg"),
    "rate": ("flow", "rate_t_h"),
    "radius": ("segments", "radius_m"),
    "base": ("sections", "base_m"),
}
"""Short name to the tables that it is looked up in, and the key there."""
DEFAULT_VALUES = {"beta": "15:90:5", "delta": "30:55:5"}
"""Values of a short name that is given without any."""


class Parameter(NamedTuple):
    """A quantity that a sweep varies."""

    name: str
    """Name of its column: the key of a short name, else the path as given."""
    paths: tuple[str, ...]
    """Key paths that get its value; all get the same one."""
    values: Array
    """Values in the units of the paths, shape (values,)."""


AnyParameter = Parameter | TextParameter


def read_parameters(arguments: list[str], chute: Chute) -> list[AnyParameter]:
    """Return the parameters that some arguments stand for.

    Args:
        arguments: ``NAME=VALUES`` each, or a name of :data:`DEFAULT_VALUES` alone. Values of a key that takes names
            are names.
        chute: in whose spec short names are looked up.

    Raises:
        UsageError: Any of the arguments is wrong; the message has a line for each.

    >>> import chutecalc
    >>> (rate,) = read_parameters(["rate=500,1000"], chutecalc.parse(chutecalc.STARTER))
    >>> rate.name, rate.paths, rate.values.tolist()
    ('rate_t_h', ('flow.rate_t_h',), [500.0, 1000.0])
    """
    found: list[AnyParameter] = []
    faults: list[str] = []
    for argument in arguments:
        try:
            found.append(_parameter(argument, chute))
        except UsageError as error:
            faults.append(str(error))
    faults += _twice(found)
    if faults:
        raise UsageError(*faults)
    return found


def _twice(parameters: Sequence[AnyParameter]) -> Iterator[str]:
    """Yield what is wrong with parameters of one name, or of one path under two names."""
    names = [parameter.name for parameter in parameters]
    yield from (f"{name} is given twice. Keep one of them." for name in dict.fromkeys(names) if names.count(name) > 1)
    first: dict[str, str] = {}
    for parameter in parameters:
        for path in parameter.paths:
            other = first.setdefault(path, parameter.name)
            if other != parameter.name:
                yield f"{path} is given twice, as {other} and as {parameter.name}. Keep one of them."


def split_argument(argument: str, defaults: dict[str, str]) -> tuple[str, Array]:
    """Return the name and the values of an argument.

    Args:
        argument: ``NAME=VALUES``, or a name alone.
        defaults: values, as text, of names that may stand alone.

    Raises:
        UsageError: The argument has no values, or they are not numbers.

    >>> split_argument("rate=500,1000", {})
    ('rate', array([ 500., 1000.]))
    """
    name, equals, text = argument.partition("=")
    name = name.strip()
    if not equals and name in defaults:
        return name, read_values(name, defaults[name])
    if not (name and equals):
        raise UsageError(f"{argument!r} has no values. Write NAME=VALUES, such as beta=15:90:5 or rate=500,1000.")
    return name, read_values(name, text)


def _parameter(argument: str, chute: Chute) -> AnyParameter:
    """Return the parameter that an argument stands for."""
    first, _, rest = (part.strip() for part in argument.partition("="))
    if first == CASE:
        return case_parameter(rest, chute)
    try:
        name, values = split_argument(argument, DEFAULT_VALUES)
    except UsageError:
        path, _, text = (part.strip() for part in argument.partition("="))
        if text and "." in path and takes_names(path, chute.data):
            return text_parameter(path, text)
        raise
    for short, (table, key) in SHORT.items():
        keys = same_quantity(key)
        stem = min(keys, key=len).rpartition("_")[0]
        spellings = {short: key} | {each.replace(stem, short, 1): each for each in keys} | {each: each for each in keys}
        if name in spellings:
            return Parameter(spellings[name], tuple(_paths(name, table, spellings[name], chute)), values)
    if "." not in name:
        raise UsageError(f"{name}: {_unknown(name, chute)}")
    return Parameter(name, (name,), values)


def _unknown(name: str, chute: Chute) -> str:
    """Return what is wrong with a name that is neither a short name nor a path, and what to do."""
    if paths := [f"{path}.{name}" for path, entry in _all_tables(chute.data) if {*same_quantity(name)} & {*entry}]:
        return f"name the whole path, {' or '.join(paths)}."
    for short, (_, key) in SHORT.items():
        stem, _, unit = name.partition("_")
        if stem == short:
            dimension = next(each for each, units in UNITS.items() if key.endswith(f"_{next(iter(units))}"))
            return f"_{unit} is not a unit of {dimension}. Use {' or '.join(unit_keys(short + '_', dimension))}."
    if close := get_close_matches(name, SHORT, n=1, cutoff=0.65):
        return f"did you mean {close[0]}?"
    return f"it is neither a short name ({', '.join(SHORT)}) nor a path such as segments.1.drop_m."


def _paths(name: str, table: str, key: str, chute: Chute) -> list[str]:
    """Return the key paths that a short name stands for.

    Raises:
        UsageError: The spec has no such key, or several that may be meant.
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
    """Yield tables of the spec with their paths: the items of a list, named tables, or one table."""
    if isinstance(tables, list):
        for name, entry in zip(item_names(tables), tables, strict=True):
            yield f"{path}.{name}", entry
    elif path in ("sections", "liners"):
        for name, entry in tables.items():
            yield f"{path}.{name}", entry
    elif tables:
        yield path, tables


def _all_tables(data: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield all tables of a spec with their paths."""
    for table in ("flow", "material", "liners", "sections", "inlet", "segments", "receiver"):
        yield from _tables(data.get(table), table)
