"""Every number that a spec gives, with the bounds of its key."""

from collections.abc import Iterator
from typing import Any

from chutecalc.api.chute import Chute
from chutecalc.api.parameter import Parameter, parameter_at
from chutecalc.api.scatter import is_number
from chutecalc.errors import SpecError
from chutecalc.fields.units import first_unit, same_quantity
from chutecalc.spec.paths import item_names

LEFT_OUT = ("limits", "cases", "uncertainty")
"""Tables whose numbers are not of the chute and its stream."""


def numbers_of(chute: Chute) -> list[Parameter]:
    """Return every number that a spec gives, in its unit, by key path.

    Args:
        chute: of one design.

    >>> import chutecalc
    >>> [each.path for each in numbers_of(chutecalc.parse(chutecalc.STARTER))][:2]
    ['flow.rate_t_h', 'material.density_kg_m3']
    """
    data = {name: table for name, table in chute.data.items() if name not in LEFT_OUT}
    return [found for path in _paths(data, ()) if (found := _parameter(chute, path))]


def _paths(item: Any, above: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Yield the paths of all numbers, as parts; items of lists by their name, or their number from 1."""
    if is_number(item):
        yield above
    elif isinstance(item, dict):
        for key, value in item.items():
            yield from _paths(value, (*above, key))
    elif isinstance(item, list):
        names = item_names(item)
        for number, (name, value) in enumerate(zip(names, item, strict=True), 1):
            yield from _paths(value, (*above, name or str(number)))


def _parameter(chute: Chute, parts: tuple[str, ...]) -> Parameter | None:
    """Return the number at a path; None if it is no quantity, such as the version of the format."""
    tables = [k for k, part in enumerate(parts) if not part.isdigit()]
    key = parts[tables[-1]]  # what follows are places in its lists
    documented = same_quantity(key)[0]
    path = (*parts[: tables[-1]], documented, *parts[tables[-1] + 1 :])
    try:
        found = parameter_at(chute.spec, ".".join(path), None)
    except SpecError:
        return None
    stem = documented.removesuffix(first_unit(found.quantity.dimension))
    return found._replace(path=".".join(parts), unit=key.removeprefix(stem))
