"""The tables of a spec and their keys, found in the models."""

from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple, get_args

from chutecalc.fields.table import Table
from chutecalc.glossary.key_symbols import OF_KEYS
from chutecalc.spec.chute_spec import ChuteSpec

TOP = "(top)"
"""Name of the spec itself among its tables."""
KIND_OR_SHAPE = ("kind", "shape")
"""Keys that tell which table it is, and so are no keys of it."""


class SpecTable(NamedTuple):
    """A table of a spec."""

    path: str
    """Keys that lead to it; names of one's own are left out."""
    name: str
    kind_or_shape: str
    """Its kind or shape; empty for others."""
    model: type[Table]

    def described(self) -> Iterator[tuple[str, str]]:
        """Yield its documented keys, each with its symbol or empty text."""
        for key in self.model.model_fields:
            if key not in KIND_OR_SHAPE:
                yield key, OF_KEYS.get(f"{self.name}.{key}", OF_KEYS.get(key, ""))

    @property
    def meaning(self) -> str:
        """What it describes, from its docstring."""
        return (self.model.__doc__ or "").partition("\n")[0].removesuffix(".")


@cache
def spec_tables() -> tuple[SpecTable, ...]:
    """Return all tables of a spec.

    >>> [table.name for table in spec_tables()][:4]
    ['(top)', 'project', 'flow', 'material']
    """
    return (SpecTable("", TOP, "", ChuteSpec), *_below("", ChuteSpec))


def _below(above: str, model: type[Table]) -> Iterator[SpecTable]:
    """Yield the tables below one."""
    for key, field in model.model_fields.items():
        path = f"{above}.{key}".lstrip(".")
        for table in _models(field.annotation):
            kind_or_shape = next(
                (
                    get_args(table.model_fields[each].annotation)[0]
                    for each in KIND_OR_SHAPE
                    if each in table.model_fields
                ),
                "",
            )
            yield SpecTable(path, f"{path}: {kind_or_shape}" if kind_or_shape else path, kind_or_shape, table)
            yield from _below(path, table)


def _models(annotation: Any) -> Iterator[type[Table]]:
    """Yield the models of tables in an annotation."""
    if isinstance(annotation, type) and issubclass(annotation, Table):
        yield annotation
    for item in get_args(annotation):
        yield from _models(item)
