"""A parameter whose values are names, such as those of liners."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.fields.units import same_quantity
from chutecalc.spec.paths import value_at


class TextParameter(NamedTuple):
    """Names that a sweep goes through."""

    name: str
    """Name of its column."""
    values: Any
    """The names, an array of text of shape (values,)."""
    chute_of: Callable[[Chute, str], Chute]
    """Returns a chute with one of the names in place of its own."""
    paths: tuple[str, ...] = ()
    """Key paths that get the name, if it is the value of keys."""


def text_parameter(path: str, text: str) -> TextParameter:
    """Return the parameter that puts names at a key path.

    Args:
        path: of a key that takes names.
        text: the names, with commas between.

    >>> import chutecalc
    >>> law = text_parameter("model.friction_law", "paper,equilibrium")
    >>> law.chute_of(chutecalc.parse(chutecalc.STARTER), "equilibrium").spec.model.friction_law
    'equilibrium'
    """
    names = np.array([name.strip() for name in text.split(",")])
    return TextParameter(path, names, lambda chute, name: chute.put({path: name}), (path,))


def takes_names(path: str, data: dict[str, Any]) -> bool:
    """Return whether a key may take names: it has no unit, and holds no number.

    Args:
        path: of the key.
        data: of the spec.

    >>> takes_names("segments.1.liner", {"segments": [{}]}), takes_names("segments.1.drop_m", {"segments": [{}]})
    (True, False)
    """
    held = value_at(data, path)
    return len(same_quantity(path.rpartition(".")[2])) == 1 and not isinstance(held, int | float)
