"""Rules that several tables of a spec share."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from chutecalc.fields.table import Violation


def one_of(*keys: str) -> Callable[[dict[str, Any]], Iterator[Violation]]:
    """The rule that exactly one of some keys is given."""

    def rule(table: dict[str, Any]) -> Iterator[Violation]:
        given = [key for key in keys if key in table]
        if len(given) != 1:
            names = ", ".join(keys)
            if given:
                problem = f"is given together with {', '.join(given[:-1])}: give only one of {names}"
                yield Violation((given[-1],), problem, "remove the others")
            else:
                yield Violation((keys[0],), f"is missing: give one of {names}", f"add {keys[0]}")

    return rule


def is_numeric(value: Any) -> bool:
    """Whether a value can be compared with a number: a number, an array, or what stands for one on a tape."""
    return isinstance(value, int | float | np.lib.mixins.NDArrayOperatorsMixin | np.ndarray)
