"""A column of a sweep as contours over two parameters, hatched where designs fail."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from chutecalc.design import Status
from chutecalc.output.dataset import Block
from chutecalc.output.plots.style import INK, MAP, SHADE, SMALL, mathematical
from chutecalc.results.column import Column
from chutecalc.studies.sweep.parameters import AnyParameter
from chutecalc.studies.sweep.plot_status import LOOKS, failed
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of, parameter_label

LEVELS = 10
"""Number of contours, about."""
CUT_OFF = 4.0
"""A panel with designs that fail ends at this multiple of the median: values grow without bound towards a stall."""
TOUCHED = (1e-6, 2.0)
"""Levels of a field that is 1 where a design fails and 0 elsewhere, between which it touches such a design."""


def draw_contours(
    axes: Axes, sweep: Sweep, varied: Sequence[AnyParameter], block: Block, column: Column, units: str
) -> None:
    """Draw filled contours, and hatch around the designs that fail, up to those beside them that do not.

    Args:
        axes: the panel.
        sweep: a sweep over all combinations.
        varied: its two parameters of several numbers.
        block: all its rows.
        column: the column to draw.
        units: ``metric`` or ``us``.
    """
    first, second = varied
    shape = (len(first.values), len(second.values))
    rows, columns = np.argsort(first.values, kind="stable"), np.argsort(second.values, kind="stable")

    def on_grid(values: Any) -> Any:
        return values.reshape(shape)[rows][:, columns].T

    x, y = first.values[rows], second.values[columns]
    values = np.ma.masked_invalid(on_grid(column.converted(block[column.name], units)))
    if values.count():
        top = float(column.converted(top_of(block[column.name], block["status"] == Status.OK_LABEL), units))
        _fill(axes, x, y, values, top)
    for status in failed(block):
        ends = on_grid((block["status"] == status).astype(float))
        axes.contourf(x, y, ends, levels=TOUCHED, colors=[SHADE], zorder=0.5)
        axes.contourf(x, y, ends, levels=TOUCHED, colors="none", hatches=[LOOKS[status].hatch])
    axes.grid(False)
    axes.set_xlabel(mathematical(parameter_label(column_of(sweep, first.name))))
    axes.set_ylabel(mathematical(parameter_label(column_of(sweep, second.name))))
    axes.set_title(mathematical(column.label(units)))


def top_of(values: Any, ok: Any) -> float:
    """Return where a panel ends: at the largest value, but below the peaks of streams that nearly stall.

    Args:
        values: a column of the rows, NaN where there is none.
        ok: which designs do not fail.
    """
    known = finite(values)
    return float(known.max() if ok.all() else min(known.max(), CUT_OFF * np.median(known)))


def finite(values: Any) -> Any:
    """Return the finite values, or a zero if there are none.

    Args:
        values: a column of the rows.
    """
    found = values[np.isfinite(values)]
    return found if found.size else np.zeros(1)


def _fill(axes: Axes, x: Any, y: Any, values: Any, top: float) -> None:
    """Draw contours of what is known, up to the triangle of a cell that has one unknown corner."""
    levels = np.asarray(MaxNLocator(LEVELS).tick_values(float(values.min()), top))
    above = bool(values.max() > levels[-1])
    look: dict[str, Any] = {"levels": levels, "corner_mask": True}
    filled = axes.contourf(x, y, values, cmap=MAP, extend="max" if above else "neither", **look)
    drawn = axes.contour(x, y, values, colors=INK, linewidths=0.6, **look)
    labelled = levels[levels <= (0.5 * top if above else top)]  # lines on a peak are too close
    for label in axes.clabel(drawn, labelled, fontsize=SMALL) if labelled.size else ():
        label.set_bbox({"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.75})
    axes.figure.colorbar(filled, ax=axes).outline.set_visible(False)
