"""The designs of a sweep by number: which value each parameter has in which row, without a table of all of them."""

from collections.abc import Sequence

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array, Index
from chutecalc.studies.sweep.parameters import Parameter


class Grid:
    """Rows of parameter values: all combinations, the last parameter fastest, or parallel lists.

    >>> grid = Grid([Parameter("a", (), np.array([1.0, 2.0])), Parameter("b", (), np.array([3.0, 4.0, 5.0]))])
    >>> [values.tolist() for values in grid.at(np.arange(1, 3))]
    [[1.0], [4.0, 5.0]]
    """

    def __init__(self, parameters: Sequence[Parameter], parallel: bool = False) -> None:
        """Lays out the rows.

        Raises:
            UsageError: parallel lists that differ in length.
        """
        self.parameters = tuple(parameters)
        counts = [len(parameter.values) for parameter in self.parameters]
        longest = max(counts)
        if parallel and any(count not in (1, longest) for count in counts):
            given = ", ".join(f"{parameter.name} {count}" for parameter, count in zip(parameters, counts, strict=True))
            raise UsageError(f"--zip takes lists of one length, or single values: {given}")
        self.count = longest if parallel else int(np.prod([*counts], dtype=object))
        """How many rows there are."""
        strides = [1] * len(counts)
        for k in reversed(range(len(counts) - 1)):
            strides[k] = 1 if parallel else strides[k + 1] * counts[k + 1]
        self._steps = list(zip(strides, counts, strict=True))

    def at(self, rows: Index) -> list[Array]:
        """The values of each parameter in some rows; one alone where they all have the same."""
        found = []
        for parameter, (stride, count) in zip(self.parameters, self._steps, strict=True):
            chosen = rows // stride % count
            found.append(parameter.values[chosen[:1] if (chosen == chosen[0]).all() else chosen])
        return found
