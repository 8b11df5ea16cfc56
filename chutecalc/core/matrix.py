"""Multiply small matrices with values at the nodes of a panel."""

from array import array

ROOM = 32
"""Length of arrays at the knots of a panel: 26 for the finest rule, and three that :func:`multiply` may write past the
end."""


class Matrix:
    """A matrix held in groups of four rows, column after column; the last group is padded with zeros."""

    def __init__(self, rows: list[list[float]]) -> None:
        self.groups, self.columns = (len(rows) + 3) // 4, len(rows[0])
        filled = [*rows, *[[0.0] * self.columns] * (4 * self.groups - len(rows))]
        self.values = array(
            "d", [filled[4 * g + i][j] for g in range(self.groups) for j in range(self.columns) for i in range(4)]
        )


def multiply(matrix: Matrix, x: "array[float]", out: "array[float]", first: int) -> None:
    """Write a matrix times x to ``out`` from ``first`` on, four rows at a time so that compiled they stay in registers.

    Up to three zeros more than there are rows are written: ``out``, which is not ``x``, needs room for them.
    """
    at = 0
    for group in range(matrix.groups):
        a, b, c, d = 0.0, 0.0, 0.0, 0.0
        for j in range(matrix.columns):
            a += matrix.values[at] * x[j]
            b += matrix.values[at + 1] * x[j]
            c += matrix.values[at + 2] * x[j]
            d += matrix.values[at + 3] * x[j]
            at += 4
        to = first + 4 * group
        out[to], out[to + 1], out[to + 2], out[to + 3] = a, b, c, d


def entry(matrix: Matrix, i: int, j: int) -> float:
    """Return one of its entries."""
    return float(matrix.values[4 * ((i // 4) * matrix.columns + j) + i % 4])
