"""Places labels beside what they are about, so that they cover neither each other nor the drawing."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes

from chutecalc.output.plots.flights import Line
from chutecalc.output.plots.style import INK, SMALL
from chutecalc.output.plots.text import POINTS, width_of
from chutecalc.physics.arrays import Array, Mask

DIRECTIONS = 24
GAPS = (5.0, 9.0, 15.0, 23.0, 33.0, 45.0, 60.0, 80.0)
"""Distances between a point and its label, points."""
NEAR = 12.0
"""From this distance on a line leads to the label."""
CELL = 2.0
"""Side of a cell of the map of what is taken, points."""
PAD = 2.5
"""Margin around a label, points."""
COVERED, CROSSED, TURNED, FAR = 3.0, 1.0, 8.0, 0.5
"""Costs of a place: of each cell of the drawing that the label covers, or that its leader crosses, of a label on the
other side, and of each point of distance."""
FORBIDDEN = 1000.0
"""Cost of a label over another, over the leader of another, or outside the axes."""


class Label(NamedTuple):
    """Text about a point of the drawing."""

    text: str
    x: float
    """Position of the point, in the units of the axes."""
    z: float
    away: tuple[float, float]
    """Direction in which the label is best, of length 1."""
    leads: bool = False
    """Whether a line leads to it wherever it is; else only from afar."""
    boxed: bool = False


class Place(NamedTuple):
    """A place for a label; positions in points from the corner of the axes."""

    centre: Array
    gap: float
    low: Array
    """Lower left corner of its box."""
    high: Array
    """Upper right corner."""
    leader: Array
    """Points of the line that leads there, shape (points, 2); none where the label is near."""


class Taken:
    """A map of the page in cells: where the drawing is, and where labels are."""

    def __init__(self, size: Array) -> None:
        """Begin with nothing taken.

        Args:
            size: width and height of the axes, points.
        """
        self.size = size
        self.cells = np.maximum(np.ceil(size / CELL).astype(int), 1)
        self.drawing: Mask = np.zeros(tuple(self.cells), bool)
        self.labels: Mask = np.zeros(tuple(self.cells), bool)

    def draw(self, path: Array) -> None:
        """Take the cells along a path.

        Args:
            path: shape (stations, 2), points; NaN where there is none.
        """
        self.drawing[self._at(dense(path))] = True

    def write(self, place: Place) -> None:
        """Take the cells of a label and its leader.

        Args:
            place: of the label.
        """
        self.labels[self._box(place)] = True
        self.labels[self._at(place.leader)] = True

    def cost(self, place: Place, point: Array, away: tuple[float, float]) -> float:
        """Return how bad a place is.

        Args:
            place: the place.
            point: what the label is about, points.
            away: direction in which it is best, a vector of length 1, dimensionless.
        """
        box, leader = self._box(place), self._at(place.leader[2:])
        covers, crosses = int(self.drawing[box].sum()), int(self.drawing[leader].sum())
        outside = bool((place.low < 0.0).any() or (place.high > self.size).any())
        forbidden = int(self.labels[box].sum()) + int(self.labels[leader].sum()) + 10 * outside
        direction = (place.centre - point) / np.hypot(*(place.centre - point))
        turned = 1.0 - float(direction @ np.array(away))
        return FORBIDDEN * forbidden + COVERED * covers + CROSSED * crosses + TURNED * turned + FAR * place.gap

    def _at(self, points: Array) -> tuple[Any, ...]:
        """Return the cells of points, those outside moved to the border."""
        return tuple(np.clip((points / CELL).astype(int), 0, self.cells - 1).T)

    def _box(self, place: Place) -> tuple[slice, slice]:
        """Return the cells of a label's box."""
        (left, right), (bottom, top) = self._at(np.stack([place.low, place.high]))
        return slice(left, right + 1), slice(bottom, top + 1)


def place_labels(axes: Axes, labels: Sequence[Label], lines: Sequence[Line]) -> None:
    """Write labels, each at the best free place, one after the other.

    Places are in points on the page. The same picture gets the same places.

    Args:
        axes: axes of a figure that is laid out, see :func:`chutecalc.output.plots.style.lay_out`.
        labels: in order: the first ones choose first.
        lines: what is better not covered, in the units of the axes.
    """
    figure = axes.figure.figure
    scale = POINTS / figure.dpi
    corners = axes.transAxes.transform([(0.0, 0.0), (1.0, 1.0)]) * scale

    def on_page(line: Line) -> Array:
        points: Array = axes.transData.transform(line.T) * scale - corners[0]
        return points

    taken = Taken(corners[1] - corners[0])
    for line in lines:
        taken.draw(on_page(line))
    for label in labels:
        point = on_page(np.array([[label.x], [label.z]]))[0]
        best = min(_places(point, label), key=lambda place: taken.cost(place, point, label.away))
        taken.write(best)
        _write(axes, label, best, point)


def dense(path: Array) -> Array:
    """Return points along a path, closely spaced.

    Args:
        path: shape (stations, 2), points; what is NaN is left out.

    >>> dense(np.array([[0.0, 0.0], [3.0, 0.0]])).tolist()
    [[0.0, 0.0], [1.5, 0.0], [3.0, 0.0]]
    """
    path = path[np.isfinite(path).all(axis=1)]
    if len(path) < 2:
        return path
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    at = np.linspace(0.0, along[-1], int(along[-1] / CELL) + 2)
    return np.stack([np.interp(at, along, path[:, axis]) for axis in (0, 1)], axis=1)


def _places(point: Array, label: Label) -> Iterator[Place]:
    """Yield the places around a point at which its label may be."""
    half = np.array([0.5 * width_of(label.text), 0.5 * SMALL]) + PAD * (1.6 if label.boxed else 1.0)
    angles = np.arctan2(label.away[1], label.away[0]) + np.linspace(0.0, 2.0 * np.pi, DIRECTIONS, endpoint=False)
    for gap in (gap for gap in GAPS if gap > NEAR or not label.leads):
        for direction in np.stack([np.cos(angles), np.sin(angles)], axis=1):
            end = point + gap * direction
            centre = end + np.min(half / np.maximum(np.abs(direction), 1e-9)) * direction
            leader = dense(np.stack([point, end])) if gap > NEAR else np.empty((0, 2))
            yield Place(centre, gap, centre - half, centre + half, leader)


def _write(axes: Axes, label: Label, place: Place, point: Array) -> None:
    """Write a label at its place."""
    look: dict[str, Any] = {}
    if len(place.leader):
        look["arrowprops"] = {"arrowstyle": "-", "color": INK, "linewidth": 0.5, "shrinkA": 0.0, "shrinkB": 0.0}
    if label.boxed:
        look["bbox"] = {"boxstyle": "round,pad=0.25", "facecolor": "white", "edgecolor": INK, "linewidth": 0.7}
    text = axes.annotate(
        label.text,
        (label.x, label.z),
        xytext=tuple(place.centre - point),
        textcoords="offset points",
        ha="center",
        va="center",
        color=INK,
        fontsize=SMALL,
        zorder=5.0,
        **look,
    )
    text.set_in_layout(False)
