"""The page of a picture: the side view, the panels beside it or below a wide chute, and room for text."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.style import TITLE, label_axes
from chutecalc.output.plots.text import LINE_HEIGHT, fitted
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS

PANELS = ("velocity_m_s", "depth_m", "pressure_kpa", "wear_w_m2")
"""Columns that are drawn along the stream."""
WIDTH, PANEL_HEIGHT = 10.0, 1.75
"""Width of the picture and height of a panel, inches."""
KEY, NOTES, SIDE = "key", "notes", "side"
"""Names of the axes beside the panels: the legend of the side view, lines of text, and the side view."""
SCALES, COLOUR_BAR = 0.6, 0.9
"""What scales take of the width and height of the side view, and what the colour bar takes of its width, inches."""
VISIBLE = 2e-3
"""Smallest share of a panel that can be seen, a quarter of the width of a line: a smaller error is not told."""


class Arrangement(NamedTuple):
    """An arrangement of the side view and the panels, in two columns."""

    rows: tuple[tuple[str, str], ...]
    widths: tuple[float, float]
    heights: tuple[float, ...]
    """Inches."""

    def scale(self, size: Array) -> float:
        """Return the scale at which a chute fits in, inches for a metre.

        Args:
            size: its width and height, m.
        """
        columns = {k for row in self.rows for k in range(2) if row[k] == SIDE}
        width = sum(self.widths[k] for k in columns) - SCALES - COLOUR_BAR
        height = sum(high for row, high in zip(self.rows, self.heights, strict=True) if SIDE in row) - SCALES
        return float(min(width / max(size[0], 1e-9), height / max(size[1], 1e-9)))


_V, _H, _P, _W = PANELS
ARRANGEMENTS = (
    *(
        Arrangement(((SIDE, _V), (SIDE, _H), (SIDE, _P), (SIDE, _W)), (side, WIDTH - side), (PANEL_HEIGHT,) * 4)
        for side in (3.6, 4.5, 5.4)
    ),
    Arrangement(((SIDE, _V), (SIDE, _H), (_P, _W)), (6.0, 4.0), (2.2, 2.2, 1.9)),
    *(
        Arrangement(((SIDE, SIDE), (_V, _H), (_P, _W)), (5.0, 5.0), (high, PANEL_HEIGHT, PANEL_HEIGHT))
        for high in (2.4, 3.2)
    ),
)
"""The panels beside the side view, around its corner, or below it. The first one with the largest scale is taken."""
SIDE_ALONE = tuple(Arrangement(((SIDE, SIDE),), (5.0, 5.0), (high,)) for high in (3.0, 4.5, 6.0, 7.5))
PANELS_ALONE = (Arrangement(((_V, _H), (_P, _W)), (5.0, 5.0), (2.2, 2.2)),)
"""Pictures of one of the two."""


def page(
    title: str,
    size: Array,
    units: str,
    notes: int = 0,
    key: int = 0,
    legend: int = 0,
    arrangements: Sequence[Arrangement] = ARRANGEMENTS,
) -> tuple[Figure, dict[str, Axes]]:
    """Return a figure and its axes.

    Args:
        title: of the figure.
        size: width and height of the chute, m.
        units: ``metric`` or ``us``.
        notes: number of lines of notes, which get axes of their own.
        key: number of lines of the legend of the side view, likewise.
        legend: number of lines of a legend of the figure, which needs room below the axes.
        arrangements: those to choose from.

    Returns:
        The figure, and its axes: ``side``, one for each of ``PANELS``, and with such lines ``notes`` and ``key``.
    """
    title = fitted(title, WIDTH, TITLE)
    best = max(arrangements, key=lambda each: round(each.scale(size), 6))
    rows: list[Any] = [list(row) for row in best.rows]
    heights = [*best.heights]
    for name, lines, place in ((NOTES, notes, len(rows)), (KEY, key, 0)):
        if lines:
            rows.insert(place, [name, name])
            heights.insert(place, LINE_HEIGHT * lines)
    text = LINE_HEIGHT * (legend + 1.5 * title.count("\n"))
    figure = Figure(figsize=(WIDTH, sum(heights) + text))
    axes = figure.subplot_mosaic(rows, height_ratios=heights, width_ratios=best.widths)
    figure.suptitle(title, x=0.01, ha="left")
    for name in (KEY, NOTES):
        if name in axes:
            axes[name].set_axis_off()
    if SIDE in axes:
        label_axes(axes[SIDE], COLUMNS["x_m"], COLUMNS["z_m"], units)
    panels = {name: axes[name] for name in PANELS if name in axes}
    for name, panel in panels.items():
        if name != PANELS[0]:
            panel.sharex(panels[PANELS[0]])
        label_axes(panel, COLUMNS["s_m"], COLUMNS[name], units)
    for column in (0, 1):
        below = [axes[row[column]] for row in best.rows if row[column] != SIDE]
        figure.align_ylabels(below)
        for panel in below[:-1]:
            panel.set_xlabel("")
            panel.tick_params(labelbottom=False)
    return figure, axes
