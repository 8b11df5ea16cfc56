"""The designs of a sweep by row number: the value of each parameter in any row, without a table of all rows."""

from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Index
from chutecalc.studies.sweep.parameters import AnyParameter, Parameter
from chutecalc.studies.sweep.text_parameter import TextParameter


class Grid:
    """Rows of parameter values: all combinations with the last parameter fastest, or parallel lists.

    Args:
        parameters: The parameters, at least one.
        parallel: Whether their lists run side by side instead of in all combinations.

    Raises:
        UsageError: Parallel lists differ in length.

    >>> grid = Grid([Parameter("a", (), np.array([1.0, 2.0])), Parameter("b", (), np.array([3.0, 4.0, 5.0]))])
    >>> [(parameter.name, values.tolist()) for parameter, values in grid.at(np.arange(1, 3))]
    [('a', [1.0]), ('b', [4.0, 5.0])]
    """

    def __init__(self, parameters: Sequence[AnyParameter], parallel: bool = False) -> None:
        self.parameters, self.parallel = tuple(parameters), parallel
        self.numbers = [each for each in parameters if isinstance(each, Parameter)]
        """The parameters that are numbers."""
        self.texts = [each for each in parameters if isinstance(each, TextParameter)]
        """The parameters that are names."""
        counts = [len(parameter.values) for parameter in self.parameters]
        longest = max(counts)
        if parallel and any(count not in (1, longest) for count in counts):
            given = ", ".join(f"{parameter.name} {count}" for parameter, count in zip(parameters, counts, strict=True))
            raise UsageError(f"--zip needs lists of equal length, or single values. Given: {given}")
        self.count = longest if parallel else int(np.prod([*counts], dtype=object))
        """Number of rows."""
        strides = [1] * len(counts)
        for k in reversed(range(len(counts) - 1)):
            strides[k] = 1 if parallel else strides[k + 1] * counts[k + 1]
        self._steps = list(zip(strides, counts, strict=True))

    def names(self) -> list[tuple[str, ...]]:
        """Return the names that rows have together, for each of :attr:`texts` one: no names if there are none."""
        lists = [each.values.tolist() for each in self.texts]
        if self.parallel:
            lists = [names * (self.count // len(names)) for names in lists]
        return list(dict.fromkeys(zip(*lists, strict=True) if self.parallel and lists else product(*lists)))

    def at(self, rows: Index) -> list[tuple[AnyParameter, Any]]:
        """Return each parameter with its values in some rows.

        Args:
            rows: Row numbers, from 0.

        Returns:
            Pairs of a parameter and an array, of names or of numbers in its unit; of length 1 where all rows have one
            value.
        """
        found: list[tuple[AnyParameter, Any]] = []
        for parameter, (stride, count) in zip(self.parameters, self._steps, strict=True):
            chosen = rows // stride % count
            found.append((parameter, parameter.values[chosen[:1] if (chosen == chosen[0]).all() else chosen]))
        return found
