"""Finds the variants of a table, one to a module of a package: cross-section shapes, kinds of segment."""

from functools import reduce
from operator import or_
from types import ModuleType
from typing import Annotated, Any, TypeVar, get_args

from pydantic import Field

from chutecalc.fields.table import Table
from chutecalc.registry import by_name, load_modules

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
        ImportError: A module cannot be imported.
        ValueError: Two tables have the same tag value.
    """
    return by_name(
        (value, item, module.__name__)
        for module in load_modules(package.__name__, package.__path__)
        for item in vars(module).values()
        if isinstance(item, type) and issubclass(item, base) and item.__module__ == module.__name__
        for value in get_args(item.model_fields[tag].annotation)
    )


def union(tables: dict[str, type[Variant]], tag: str) -> Any:
    """Return the type of a field that takes any of some tables.

    Args:
        tables: by tag value, as :func:`variants` returns them.
        tag: name of the key that tells them apart.
    """
    return Annotated[reduce(or_, tables.values()), Field(discriminator=tag)]
