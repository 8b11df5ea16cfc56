"""A parameter whose values are names, such as those of liners."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.fields.units import same_quantity
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.spec.paths import value_at

TRUTH = {"true", "false"}
"""What a key that is true or false takes, as specs write it."""
CASE = "case"
"""Name of the parameter that goes through the cases of a spec."""


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

    def value(self, name: str) -> str | bool:
        """Return what the keys get: the name, or true or false where the names are these.

        Args:
            name: one of the names.
        """
        return name == "true" if {*self.values.tolist()} <= TRUTH else name


def text_parameter(path: str, text: str) -> TextParameter:
    """Return the parameter that puts names at a key path.

    Args:
        path: of a key that takes names.
        text: the names, with commas between; ``true`` and ``false`` for a key that takes these.

    >>> import chutecalc
    >>> law = text_parameter("model.friction_law", "paper,equilibrium")
    >>> law.chute_of(chutecalc.parse(chutecalc.STARTER), "equilibrium").spec.model.friction_law
    'equilibrium'
    """
    names = np.array([name.strip() for name in text.split(",")])
    found = TextParameter(path, names, lambda chute, name: chute.vary({path: found.value(name)}), (path,))
    return found


def case_parameter(text: str, chute: Chute) -> TextParameter:
    r"""Return the parameter that goes through operating states of the spec.

    Args:
        text: names of cases with commas between, ``design`` for the spec as written; empty for all of them.
        chute: whose spec has the cases.

    Raises:
        UsageError: the spec has no such case.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[cases.surge]\n"flow.rate_t_h" = 1500')
    >>> case_parameter("", spoon).values.tolist()
    ['design', 'surge']
    """
    known = [DESIGN_POINT, *chute.cases]
    if len(known) == 1:
        raise UsageError('case: the spec has no cases. Add a table [cases.NAME] with keys such as "flow.rate_t_h".')
    names = [name.strip() for name in text.split(",")] if text else known
    if unknown := [name for name in names if name not in known]:
        raise UsageError(f"case: there is no case {', '.join(unknown)}. Use some of {', '.join(known)}.")
    return TextParameter(CASE, np.array(names), _state)


def _state(chute: Chute, name: str) -> Chute:
    """Return a chute in one of its operating states."""
    return chute if name == DESIGN_POINT else chute.cases[name]


def takes_names(path: str, data: dict[str, Any]) -> bool:
    """Return whether a key may take names, or true and false: it has no unit, and holds no number.

    Args:
        path: of the key.
        data: of the spec.

    >>> takes_names("segments.1.liner", {"segments": [{}]}), takes_names("segments.1.drop_m", {"segments": [{}]})
    (True, False)
    """
    held = value_at(data, path)
    return len(same_quantity(path.rpartition(".")[2])) == 1 and (
        isinstance(held, bool) or not isinstance(held, int | float)
    )
