"""The keys of a spec, its tables, and the limits of findings, explained."""

from collections.abc import Iterator
from typing import Any, get_args

from pydantic_core import PydanticUndefined

from chutecalc.fields.quantity import Quantity
from chutecalc.fields.table import Table
from chutecalc.fields.units import TEXT, convert, first_unit, unit_keys, with_unit
from chutecalc.glossary.entry import Entry, facts, listed
from chutecalc.glossary.tables import KIND_OR_SHAPE, SpecTable, spec_tables
from chutecalc.results.symbols import SYMBOLS
from chutecalc.spec.limits import LIMITS

KEYS, TABLES, LIMITED = "keys of a spec", "tables, kinds and shapes of a spec", "limits of findings"
NO_DEFAULT = "none: it may be left out"
HEADINGS = {
    "project": "project",
    "flow": "flow-and-material",
    "material": "flow-and-material",
    "liners": "liners",
    "sections": "sections",
    "segments": "segments",
    "inlet.belt": "from-a-belt",
    "receiver": "to-a-belt",
    "model": "friction-law",
    "limits": "limits",
    "cases": "cases",
    "uncertainty": "uncertainty",
}
"""Heading of docs/spec.md that describes a table, by its path."""


def page_of(path: str) -> str:
    """Return the page of the documentation that describes a table.

    Args:
        path: of the table.

    >>> page_of("sections.facets"), page_of("")
    ('docs/spec.md#sections', 'docs/spec.md')
    """
    heading = HEADINGS.get(path, HEADINGS.get(path.partition(".")[0], ""))
    return f"docs/spec.md#{heading}" if heading else "docs/spec.md"


def key_entries() -> Iterator[Entry]:
    """Yield an entry for each key and each of its units; tables in which it is the same share one."""
    alike: dict[tuple[Any, ...], list[tuple[SpecTable, str]]] = {}
    tables = {table.path for table in spec_tables() if not table.kind_or_shape}
    for table in spec_tables():
        for key, symbol in table.described():
            if f"{table.path}.{key}".lstrip(".") in tables:
                continue  # explained as a table
            field = table.model.model_fields[key]
            same = key, field.description, str(field.default), field.is_required(), _bounds(table.model, key)
            alike.setdefault(same, []).append((table, symbol))
    for (key, *_), found in alike.items():
        yield from _spellings(key, found)
    for key in KIND_OR_SHAPE:
        tables_of = [table for table in spec_tables() if key in table.model.model_fields]
        path = tables_of[0].path
        choices = " or ".join(f'"{table.kind_or_shape}"' for table in tables_of)
        known = facts(stands_in=path, must_be=choices, default="none: it must be given", docs=page_of(path))
        yield Entry(KEYS, key, f"which {key} the table describes", known, (path,))


def _bounds(model: type[Table], key: str) -> str:
    """Return the bounds of a key and its usual range as text."""
    quantity = model.quantities().get(key)
    return f"{quantity.bounds_text(first_unit(quantity.dimension))} {quantity.plausible}" if quantity else ""


def _spellings(key: str, found: list[tuple[SpecTable, str]]) -> Iterator[Entry]:
    """Yield the entries of a key in its units, the documented one first."""
    table, field = found[0][0], found[0][0].model.model_fields[key]
    quantity, limit = table.model.quantities().get(key), LIMITS.get(key) if table.path == "limits" else None
    names = unit_keys(key, quantity.dimension) if quantity else {key: ""}
    places = tuple(dict.fromkeys(each.path for each, _ in found))
    symbols = dict.fromkeys(symbol for _, symbol in found if symbol)
    for name, unit in names.items():
        others = listed([other for other in names if other != name])
        shown = TEXT.get(unit, unit)
        known = facts(
            stands_in=listed([each.name for each, _ in found]),
            symbol=listed(list(symbols)),
            unit=f"{shown} (also {others})" if quantity and others else shown,
            must_be=allowed_text(field, quantity, unit),
            because=_because(quantity) if quantity else "",
            usual=_usual(quantity, unit) if quantity else "",
            default=default_text(field, quantity, unit),
            finding=limit.finding if limit else "",
            source=limit.source if limit else listed([each.source for each in SYMBOLS if each.symbol in symbols]),
            docs=page_of(key if not table.path and key in HEADINGS else table.path),
        )
        yield Entry(LIMITED if limit else KEYS, name, field.description or "", known, places, derived=name != key)


def _choices(annotation: Any) -> list[str]:
    """Return the values of which one must be given, as TOML has them."""
    arguments = get_args(annotation)
    if type(None) in arguments:
        return _choices(next(each for each in arguments if each is not type(None)))
    plain = [each for each in arguments if isinstance(each, str | int)]
    return [
        str(each).lower() if isinstance(each, bool) else f'"{each}"' if isinstance(each, str) else str(each)
        for each in plain
    ]


def _because(quantity: Quantity) -> str:
    """Return why the bounds are what they are."""
    reasons = quantity.plausible.reasons if quantity.plausible else {}
    return listed([f"{side} {why}" for side, why in reasons.items()])


def _usual(quantity: Quantity, unit: str) -> str:
    """Return the range beyond which a number draws the finding ``implausible``."""
    usual = quantity.plausible
    if usual is None:
        return ""
    first = first_unit(quantity.dimension)
    low, high = (with_unit(convert(each, quantity.dimension, first, unit), unit) for each in (usual.low, usual.high))
    return f"{low} to {high}; less is {usual.below}, more is {usual.above}"


def allowed_text(field: Any, quantity: Quantity | None, unit: str) -> str:
    """Return which values a key may have: its bounds in a unit, or the choices.

    Args:
        field: of the model.
        quantity: what it is a number of, if it is one.
        unit: suffix of the unit, such as ``mm``.
    """
    return quantity.bounds_text(unit) if quantity else " or ".join(_choices(field.annotation))


def default_text(field: Any, quantity: Quantity | None, unit: str) -> str:
    """Return the default of a key, in a unit; that it has to be given, or may be left out.

    Args:
        field: of the model.
        quantity: what it is a number of, if it is one.
        unit: suffix of the unit, such as ``mm``.
    """
    default = field.default
    if default is PydanticUndefined:
        return "none: it must be given"
    if default is None or isinstance(default, Table | dict):
        return NO_DEFAULT
    if quantity is None:
        return f'"{default}"' if isinstance(default, str) else str(default)
    first = first_unit(quantity.dimension)
    numbers = default if isinstance(default, list) else [default]
    shown = [with_unit(convert(each, quantity.dimension, first, unit), unit) for each in numbers]
    return f"[{listed(shown)}]" if isinstance(default, list) else shown[0]


def table_entries() -> Iterator[Entry]:
    """Yield an entry for each table, kind of segment and shape of section."""
    for table in spec_tables():
        if not table.path:
            continue
        fields = {key: table.model.model_fields[key] for key, _ in table.described()}
        needed = [key for key, field in fields.items() if field.is_required()]
        yield Entry(
            TABLES,
            table.kind_or_shape or table.path.rpartition(".")[2],
            table.meaning,
            facts(
                written=_written(table),
                needs=listed(needed),
                may_have=listed([key for key in fields if key not in needed]),
                docs=page_of(table.path),
            ),
            (table.path.rpartition(".")[0] or table.path,),
        )


def _written(table: SpecTable) -> str:
    """Return how a spec has a table, with NAME where the user gives a name."""
    kind_or_shape = next((each for each in KIND_OR_SHAPE if each in table.model.model_fields), "")
    if table.path == "sections.facets":
        return "facets = [{...}, ...] in [sections.NAME]"
    named = f"{table.path}.NAME" if table.path in ("sections", "liners") else table.path
    header = f"[[{named}]]" if table.path == "segments" else f"[{named}]"
    return f'{header} with {kind_or_shape} = "{table.kind_or_shape}"' if kind_or_shape else header
