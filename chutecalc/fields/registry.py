"""Finds the variants of a table, one to a module of a package: cross-section shapes, kinds of segment."""

from functools import reduce
from importlib import import_module
from operator import or_
from pkgutil import iter_modules
from types import ModuleType
from typing import Annotated, Any, TypeVar, get_args

from pydantic import Field

from chutecalc.fields.table import Table

Variant = TypeVar("Variant", bound=Table)


def variants(package: ModuleType, base: type[Variant], tag: str) -> dict[str, type[Variant]]:
    """Import all modules of a package and return the tables found there by the value of their tag.

    Args:
        package: its modules are searched in alphabetical order.
        base: what the tables derive from.
        tag: name of the key that tells them apart, a ``Literal`` of one value in each table.

    Returns:
        Tag value to table, in the order of the modules.

    Raises:
        ValueError: Two tables have the same tag value.
    """
    found: dict[str, type[Variant]] = {}
    for name in sorted(module.name for module in iter_modules(package.__path__)):
        module = import_module(f"{package.__name__}.{name}")
        for item in vars(module).values():
            if not (isinstance(item, type) and issubclass(item, base) and item.__module__ == module.__name__):
                continue
            for value in get_args(item.model_fields[tag].annotation):
                if value in found:
                    raise ValueError(f"{tag} = {value!r} stands in {found[value].__module__} and in {module.__name__}")
                found[value] = item
    return found


def union(tables: dict[str, type[Variant]], tag: str) -> Any:
    """Return the type of a field that takes any of some tables.

    Args:
        tables: by tag value, as :func:`variants` returns them.
        tag: name of the key that tells them apart.
    """
    return Annotated[reduce(or_, tables.values()), Field(discriminator=tag)]
