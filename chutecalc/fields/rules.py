"""Rules that several tables of a spec share."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from chutecalc.fields.table import Rule


def one_of(*keys: str) -> Callable[[dict[str, Any]], Iterator[Rule]]:
    """The rule that exactly one of some keys is given."""

    def rule(table: dict[str, Any]) -> Iterator[Rule]:
        given = [key for key in keys if key in table]
        if len(given) != 1:
            names = ", ".join(keys)
            problem = f"is one too many: give only one of {names}" if given else f"is missing: give one of {names}"
            yield Rule((given[-1] if given else keys[0],), problem, "remove the others" if given else f"add {keys[0]}")

    return rule


def is_numeric(value: Any) -> bool:
    """Whether a value can be compared with a number: a number, an array, or what stands for one on a tape."""
    return isinstance(value, int | float | np.lib.mixins.NDArrayOperatorsMixin | np.ndarray)
