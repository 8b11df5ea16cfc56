"""What a spec gives, key by key as written, with the meaning of each."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple, get_args

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import TEXT
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.faults import value_text
from chutecalc.spec.operating import case_values
from chutecalc.spec.paths import is_number, item_names
from chutecalc.spec.segment_names import segment_names

SHEAR_TEST = "shear_test"
"""Part of a path whose numbers are not in the unit of its key: the points of a shear test are stresses, in kPa."""
OF_PATHS = {"cases": 1, "uncertainty": 0}
"""Keys at the top of a spec whose own keys are paths, to the number of names before each path."""


class Input(NamedTuple):
    """A key of a spec with its value."""

    path: str
    """Its path, as written, with the names of segments."""
    meaning: str
    """What it says."""
    written: Any
    """Its value as written: a number, text, true or false, a list of numbers or of rows of numbers."""
    unit: str
    """Unit of its numbers as people write it, empty where they have none or are none."""

    @property
    def text(self) -> str:
        """The value as people write it; rows of a list stand between semicolons.

        >>> Input("", "", [[0.0, 0.4], [5, 3.1]], "kPa").text, Input("", "", True, "").text
        ('0, 0.4; 5, 3.1', 'true')
        """
        return _text(self.written)


class Key(NamedTuple):
    """A key of a table that is given, other than one of a table below it."""

    location: tuple[str | int, ...]
    """Where it stands in the spec's data."""
    name: str
    """The documented key, which ends in the first unit of its dimension."""
    unit: str
    """Suffix of the unit in which it is given."""
    quantity: Quantity | None
    """What it measures; None if it is no quantity."""
    meaning: str
    """What it says."""
    written: Any
    """Its value."""


def inputs(spec: ChuteSpec, data: Mapping[str, Any]) -> Iterator[Input]:
    """Yield all that a spec gives, in the order in which it is written: keys of tables, then of its cases and so on.

    Args:
        spec: a checked spec.
        data: the same as written.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER)
    >>> [item for item in inputs(spoon.spec, spoon.data) if item.path == "segments.spoon.radius_m"][0][1:]
    ('radius of the guiding surface', 3.0, 'm')
    """
    for key in given_keys(spec, data):
        name = str(key.location[0])
        if name not in OF_PATHS:
            single = getattr(key.written, "size", 0) == 1  # of a case, whose values are arrays
            written = key.written.item() if single else key.written
            yield Input(_path(data, key.location), key.meaning, written, _unit_text(key.unit))
            continue
        for path, value in case_values(key.written).items():
            meaning, unit = _described(spec, path.split(".")[OF_PATHS[name] :])
            yield Input(f"{name}.{path}", meaning or key.meaning, value, unit)


def given_keys(table: Table, data: Mapping[str, Any], *above: str | int) -> Iterator[Key]:
    """Yield the keys of a table and of the tables in it, in the order in which they are written.

    Args:
        table: a checked table.
        data: the same as written.
        *above: where the table stands.
    """
    for key, value in data.items():
        name, unit = table.keys()[key]
        below = getattr(table, name)
        entries = below.items() if isinstance(below, dict) else enumerate(below) if isinstance(below, list) else ()
        tables = {item: entry for item, entry in entries if isinstance(entry, Table)}
        if isinstance(below, Table):
            yield from given_keys(below, value, *above, key)
        for item, entry in tables.items():
            yield from given_keys(entry, value[item], *above, key, item)
        if not tables and not isinstance(below, Table):
            yield Key((*above, key), name, unit, table.quantities().get(name), _meaning(type(table), name), value)


def _meaning(table: type[Table], name: str) -> str:
    """Return what a key says; of one that chooses a kind or a shape, what the chosen one is."""
    words = (table.__doc__ or "").partition("\n")[0].rstrip(".")
    return table.model_fields[name].description or words[:1].lower() + words[1:]


def _path(data: Any, location: tuple[str | int, ...]) -> str:
    """Return a location as a path, with the name of each segment; items of other lists are counted from 1."""
    parts, here = [], data
    for item in location:
        parts.append(item_names(here)[item] or str(item + 1) if isinstance(item, int) else item)
        here = here[item]
    return ".".join(parts)


def _described(spec: ChuteSpec, parts: Sequence[str]) -> tuple[str, str]:
    """Return meaning and unit of the key at a path, which the spec itself may leave out; empty if it is none."""
    here: Any = spec  # a table, or the model of one that it leaves out
    for number, part in enumerate(parts, 1):
        if isinstance(here, list):  # of segments
            names = segment_names([(item.name, item.kind) for item in here])
            here = here[int(part) - 1 if is_number(part) else names.index(part)]
        elif isinstance(here, dict):
            here = here[part]
        elif part not in (keys := here.keys()):  # what goes together of what is uncertain
            break
        else:
            name, unit = keys[part]
            table: type[Table] = here if isinstance(here, type) else type(here)
            if name in table.quantities() or number == len(parts):
                return _meaning(table, name), "kPa" if SHEAR_TEST in parts[number:] else _unit_text(unit)
            here = getattr(here, name, None) or next(iter(get_args(table.model_fields[name].annotation)))
    return "", ""


def _unit_text(unit: str) -> str:
    """Return a unit as people write it."""
    return TEXT.get(unit, unit)


def _text(value: Any) -> str:
    """Return a value as people write it."""
    if isinstance(value, list | tuple):
        rows = any(isinstance(item, list | tuple) for item in value)
        return ("; " if rows else ", ").join(map(_text, value))
    if isinstance(value, bool | str):
        return str(value).lower() if isinstance(value, bool) else value
    return f"{value:.12g}" if isinstance(value, int | float) else value_text(value)
