"""Rules that several tables of a spec share."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from chutecalc.fields.table import Violation


def one_of(*keys: str) -> Callable[[dict[str, Any]], Iterator[Violation]]:
    """Return the rule that exactly one of some keys is given.

    Args:
        keys: documented keys of a table.

    >>> [broken.problem for broken in one_of("drop_m", "run_m")({})]
    ['is missing: give one of drop_m, run_m']
    """

    def rule(table: dict[str, Any]) -> Iterator[Violation]:
        given = [key for key in keys if key in table]
        if len(given) != 1:
            names = ", ".join(keys)
            if given:
                problem = f"is given together with {', '.join(given[:-1])}: give only one of {names}"
                yield Violation((given[-1],), problem, "remove the others")
            else:
                yield Violation((keys[0],), f"is missing: give one of {names}", f"add {keys[0]}", is_missing=True)

    return rule


def is_numeric(value: Any) -> bool:
    """Return whether a value can be compared with a number.

    Args:
        value: of a table; a number, an array, and what a tape records in their place can.
    """
    return isinstance(value, int | float | np.lib.mixins.NDArrayOperatorsMixin | np.ndarray)
