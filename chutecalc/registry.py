"""Registries: packages that find their own modules, so that a new shape, kind, finding or format is one new file."""

from collections.abc import Iterable
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType
from typing import TypeVar

Item = TypeVar("Item")


def load_modules(package: str, path: Iterable[str]) -> list[ModuleType]:
    """Import all modules of a package.

    Args:
        package: name of the package.
        path: its ``__path__``.

    Returns:
        Its modules in alphabetical order.

    Raises:
        ImportError: a module cannot be imported; the message names it and the cause.

    >>> from chutecalc import sections
    >>> [module.__name__ for module in load_modules(sections.__name__, sections.__path__)][:2]
    ['chutecalc.sections.base', 'chutecalc.sections.box']
    """
    modules = []
    for name in sorted(f"{package}.{module.name}" for module in iter_modules(path)):
        try:
            modules.append(import_module(name))
        except Exception as error:
            raise ImportError(f"{name} cannot be imported: {type(error).__name__}: {error}", name=name) from error
    return modules


def by_name(items: Iterable[tuple[str, Item, str]]) -> dict[str, Item]:
    """Return registered items by name.

    Args:
        items: name, item and module of each.

    Raises:
        ValueError: two items have the same name; the message names their modules.

    >>> by_name([("csv", 1, "a"), ("csv", 2, "b")])
    Traceback (most recent call last):
    ValueError: 'csv' is registered twice, in a and in b
    """
    found: dict[str, Item] = {}
    modules: dict[str, str] = {}
    for name, item, module in items:
        if name in found:
            raise ValueError(f"{name!r} is registered twice, in {modules[name]} and in {module}")
        found[name], modules[name] = item, module
    return found
