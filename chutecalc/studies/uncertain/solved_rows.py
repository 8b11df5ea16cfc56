"""Solves rows of values of uncertain keys, in blocks, so that memory does not grow with their number."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.api.uncertain_keys import UncertainKeys
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.uncertain.statistics import STATUSES, Ends
from chutecalc.studies.variants import Variants
from chutecalc.workers import Pool

BLOCK = 1 << 17
"""Rows that are solved together."""
Show = Callable[[int], None]
"""Takes the number of rows that were solved."""
WARNINGS = "warnings"
"""Column of the codes of warnings."""


class Rows(NamedTuple):
    """How rows end, and their columns."""

    ends: Ends
    """Number of each row's status in :data:`STATUSES`, shape (rows,)."""
    columns: Numbers
    """Columns by name, shape (rows,): NaN where a row fails."""
    warned: dict[str, Mask]
    """By the code of a warning, the rows that have it; empty if they were not asked for."""


class RowSolver:
    """Solves rows of values.

    Args:
        chute: in the state in which it is solved.
        keys: what varies.
        columns: names of columns of numbers, as those of a sweep, and ``warnings`` if these are wanted.
        rtol: relative tolerance, as in :func:`chutecalc.solve`.
        pool: where they are solved. Numbers do not depend on it.
    """

    def __init__(self, chute: Chute, keys: UncertainKeys, columns: Sequence[str], rtol: float, pool: Pool) -> None:
        parameters = [
            Parameter(key.path, (key.path,), np.array([key.parameter.value_in_unit] * 2)) for key in keys.keys
        ]
        self._variants = Variants(chute, parameters, columns, rtol=rtol, pool=pool)
        self.columns = [name for name in self._variants.columns if name != WARNINGS]

    def __call__(self, values: Array, show: Show = lambda count: None) -> Rows:
        """Solve rows.

        Args:
            values: in the units of the keys, shape (rows, keys).
            show: is told of each block.
        """
        ends = np.zeros(len(values), dtype=np.int8)
        columns = {name: np.empty(len(values)) for name in self.columns}
        warned: dict[str, Mask] = {}
        for first in range(0, len(values), BLOCK):
            block = slice(first, first + BLOCK)
            solved = self._variants(list(values[block].T))
            for code, status in enumerate(STATUSES):
                ends[block][solved["status"][0] == status] = code
            for name in self.columns:
                columns[name][block] = solved[name][0]
            if WARNINGS in solved:
                for warning, rows in _by_code(solved[WARNINGS][0]).items():
                    warned.setdefault(warning, np.zeros(len(values), dtype=bool))[block] = rows
            show(len(values[block]))
        return Rows(ends, columns, warned)


def _by_code(texts: Any) -> dict[str, Mask]:
    """Return by code the rows whose text has it.

    Args:
        texts: codes of each row, with spaces between, shape (rows,).
    """
    different, which = np.unique(texts.astype(str), return_inverse=True)
    codes = [text.split() for text in different]
    known = dict.fromkeys(code for own in codes for code in own)
    return {code: np.array([code in own for own in codes])[which] for code in known}
