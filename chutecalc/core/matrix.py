"""Products of a matrix with what stands at the nodes of a panel."""

from array import array

MOST = 32
"""Room for what stands at the knots of a panel: those of the finest rule, 26, and three numbers more, see below."""


class Matrix:
    """A matrix held in groups of four rows, column after column; the last group is filled up with zeros."""

    def __init__(self, rows: list[list[float]]) -> None:
        self.groups, self.columns = (len(rows) + 3) // 4, len(rows[0])
        filled = [*rows, *[[0.0] * self.columns] * (4 * self.groups - len(rows))]
        self.values = array(
            "d", [filled[4 * g + i][j] for g in range(self.groups) for j in range(self.columns) for i in range(4)]
        )


def multiply(own: Matrix, x: "array[float]", out: "array[float]", first: int) -> None:
    """A matrix times x, written from ``first`` on: four rows at a time, so that compiled they stay in registers.

    Writes up to three zeros more than there are rows: ``out``, which is not ``x``, needs room for them.
    """
    at = 0
    for group in range(own.groups):
        a, b, c, d = 0.0, 0.0, 0.0, 0.0
        for j in range(own.columns):
            a += own.values[at] * x[j]
            b += own.values[at + 1] * x[j]
            c += own.values[at + 2] * x[j]
            d += own.values[at + 3] * x[j]
            at += 4
        to = first + 4 * group
        out[to], out[to + 1], out[to + 2], out[to + 3] = a, b, c, d


def entry(own: Matrix, i: int, j: int) -> float:
    """One of its numbers."""
    return float(own.values[4 * ((i // 4) * own.columns + j) + i % 4])
