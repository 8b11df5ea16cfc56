"""Which uncertain numbers go together, as a spec says it: rows of two keys and their correlation."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from chutecalc.api.scatter import is_number
from chutecalc.physics.arrays import Array

LEAST_EIGENVALUE = 1e-12
"""Least eigenvalue that a correlation matrix has at least: below it, numbers that go together so are none."""
ROW = "write rows such as [PATH, PATH, 0.6]"
"""What to do about a row that is none."""


def read_correlation(paths: Sequence[str], rows: Any) -> tuple[Array, list[tuple[str, str]]]:
    """Return the correlation of keys, and all that is wrong with it.

    Args:
        paths: of all keys, as written.
        rows: as written: two paths and their correlation each.

    Returns:
        A matrix of shape (keys, keys), and what is wrong with what to do about it.

    >>> matrix, wrong = read_correlation(["a_m", "b_m"], [["a_m", "b_m", 0.5], ["a_m", "a_m", 2]])
    >>> float(matrix[1, 0]), wrong
    (0.5, [('row 2 pairs a_m with itself', 'pair two different keys, or remove the row')])
    """
    matrix, wrong, known = np.eye(len(paths)), [], set()
    for number, row in enumerate(rows if isinstance(rows, list) else [rows], 1):
        fault = _row_fault(row, paths)
        if fault is None:
            one, other = sorted((paths.index(row[0]), paths.index(row[1])))
            if (one, other) in known:
                fault = f"pairs {row[0]} and {row[1]} again", "keep one of the rows"
            known.add((one, other))
            matrix[one, other] = matrix[other, one] = row[2]
        if fault is not None:
            wrong.append((f"row {number} {fault[0]}", fault[1]))
    return matrix, wrong or _contradictions(paths, matrix)


def _row_fault(row: Any, paths: Sequence[str]) -> tuple[str, str] | None:
    """Return what is wrong with a row by itself, and what to do."""
    if not isinstance(row, list) or len(row) != 3 or not is_number(row[2]):
        return "is not two keys and a number", ROW
    if unknown := [str(name) for name in row[:2] if name not in paths]:
        known = f"use its keys as they are written, {', '.join(paths)}, or add it" if paths else "add its keys first"
        return f"names {' and '.join(unknown)}, which this table does not call uncertain", known
    if row[0] == row[1]:
        return f"pairs {row[0]} with itself", "pair two different keys, or remove the row"
    if not -1.0 < row[2] < 1.0:
        return f"has {row[2]:g}; a correlation must be greater than -1 and less than 1", "use one such as 0.5"
    return None


def _contradictions(paths: Sequence[str], matrix: Array) -> list[tuple[str, str]]:
    """Return that correlations contradict each other, and by which factor on all of them they would not.

    With the least eigenvalue λ of the matrix, that of 1 + k (matrix - 1) is 1 + k (λ - 1).
    """
    if not len(paths):
        return []
    values, vectors = np.linalg.eigh(matrix)
    if values[0] >= LEAST_EIGENVALUE:
        return []
    those = " and ".join(path for path, share in zip(paths, vectors[:, 0], strict=True) if abs(share) > 1e-6)
    factor = np.floor(1000.0 / (1.0 - values[0])) / 1000.0
    problem = f"has numbers that contradict each other, for {those}: no values go together so (not positive definite)"
    return [(problem, f"correct the one that is wrong, or multiply all of them by {min(factor, 0.999):g} or less")]
