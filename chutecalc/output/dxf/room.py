"""Where a drawing has room for notes: beside a point, clear of lines, dimensions and other notes."""

import math
from itertools import product

import numpy as np

from chutecalc.output.dxf.points import Point
from chutecalc.output.plots.flights import Line

NEARBY = [
    (away, sign * turn)
    for away in (3.0, 5.0, 9.0, 14.0, 20.0)
    for turn in (0.0, 0.5, 1.0, 1.5, 2.6)
    for sign in (1, -1)
]
"""Distances and turns at which notes are tried, mm on paper and rad."""


CELL = 0.5
"""Side of a cell of the map of what is taken, mm on paper."""


class Room:
    """A map of the places in a drawing that notes stand clear of, in cells.

    Args:
        scale: of the drawing, as in 1:scale.
    """

    def __init__(self, scale: float) -> None:
        self._scale = scale
        self._taken: set[tuple[int, int]] = set()

    def keep_clear(self, points: Line) -> None:
        """Keep notes off points.

        Args:
            points: mm, shape (2, points), NaN where there is none.
        """
        self._taken.update(zip(*self._cells(points[:, np.isfinite(points).all(axis=0)]), strict=True))

    def take(self, at: Point, towards: Point, half: Point) -> Point:
        """Return the middle of a free place beside a point, which is free no longer; the point itself if there is none.

        Args:
            at: the point, mm.
            towards: direction from the point in which to look first, of any length.
            half: half the width and half the height that is needed, mm.
        """
        first = math.atan2(towards[1], towards[0])
        for away, turn in NEARBY:
            across, up = math.cos(first + turn), math.sin(first + turn)
            reach = away * self._scale + abs(across) * half[0] + abs(up) * half[1]
            middle = at[0] + reach * across, at[1] + reach * up
            if self._is_clear(middle, half):
                break
        else:
            middle = at
        columns, rows = np.meshgrid(np.linspace(-1.0, 1.0, 20) * half[0], np.linspace(-1.0, 1.0, 4) * half[1])
        self.keep_clear(np.stack([middle[0] + columns.ravel(), middle[1] + rows.ravel()]))
        return middle

    def _is_clear(self, middle: Point, half: Point) -> bool:
        """Return whether nothing is taken in a box about a point."""
        (left, right), (bottom, top) = self._cells(np.array([middle, middle]).T + np.outer(half, (-1.0, 1.0)))
        return self._taken.isdisjoint(product(range(left, right + 1), range(bottom, top + 1)))

    def _cells(self, points: Line) -> list[list[int]]:
        """Return columns and rows of the cells in which points lie."""
        cells: list[list[int]] = np.floor(points / (CELL * self._scale)).astype(int).tolist()
        return cells
