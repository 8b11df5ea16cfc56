"""A column of a sweep as lines over one parameter, one for each value of a second."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from chutecalc.design import Status
from chutecalc.fields.units import TEXT as UNIT_TEXT
from chutecalc.output.dataset import Block
from chutecalc.output.plots.style import looks, mathematical
from chutecalc.output.plots.text import fitted
from chutecalc.results.column import Column
from chutecalc.studies.sweep.axis import along, different, places
from chutecalc.studies.sweep.parameters import AnyParameter
from chutecalc.studies.sweep.plot_contours import finite, top_of
from chutecalc.studies.sweep.plot_status import LOOKS, failed
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of, parameter_label
from chutecalc.studies.sweep.text_parameter import TextParameter

CROSS_SPACING = 0.02
"""Distance between the marks of one line and the next, over the height of a panel."""
MARKERS = 12
"""Number of markers on a line, about."""
LABEL_WIDTH, LABEL_LINES = 2.2, 3
"""Width of a label in the legend, inches, and its greatest number of lines."""


def draw_lines(
    axes: Axes, sweep: Sweep, varied: Sequence[AnyParameter], block: Block, column: Column, units: str
) -> None:
    """Draw lines over the parameter with the most values, and a mark above the panel where a design fails.

    Args:
        axes: the panel.
        sweep: the sweep.
        varied: its parameters of several values.
        block: all its rows.
        column: the column to draw.
        units: ``metric`` or ``us``.
    """
    over = along(varied, sweep.parallel)
    second = None if sweep.parallel else next((each for each in varied if each is not over), None)
    chosen = [None] if second is None else different(second)
    labels = ["" if second is None else given(sweep, second, value) for value in chosen]
    height = 1.0
    for value, label, look in zip(chosen, labels, looks([(label,) for label in labels]), strict=True):
        rows = np.ones(len(block["status"]), bool) if second is None else block[second.name] == value
        x, y = places(over, block[over.name][rows]), column.converted(block[column.name][rows], units)
        order = np.argsort(x, kind="stable")
        every = max(1, len(x) // MARKERS)
        if isinstance(over, TextParameter):
            look |= {"linestyle": ""}  # between names there is nothing
            every = 1
        axes.plot(x[order], y[order], **look, markevery=every, label=label, gid="line")
        height += CROSS_SPACING * _mark_failed(axes, x, block["status"][rows], height, look["color"])
    whole = column.converted(block[column.name], units)
    top = top_of(whole, block["status"] == Status.OK_LABEL)
    if top < finite(whole).max():
        axes.set_ylim(top=top)
    if isinstance(over, TextParameter):
        names = different(over)
        axes.set_xticks(range(len(names)), names)
    axes.set_xlabel(mathematical(parameter_label(column_of(sweep, over.name))))
    axes.set_ylabel(mathematical(column.label(units)))


def given(sweep: Sweep, parameter: AnyParameter, value: Any) -> str:
    """Return a value of a parameter with its name, as text.

    Args:
        sweep: the sweep.
        parameter: the parameter.
        value: one of its values.
    """
    column = column_of(sweep, parameter.name)
    unit = "°" if column.unit == "deg" else f" {UNIT_TEXT.get(column.unit, column.unit)}".rstrip()
    text = value if isinstance(value, str) else f"{value:zg}{unit}"
    return fitted(f"{column.heading} = {text}", LABEL_WIDTH, most=LABEL_LINES)


def _mark_failed(axes: Axes, x: Any, statuses: Any, height: float, colour: str) -> bool:
    """Mark the designs of a line that fail above the panel, and return whether there are any."""
    marked = [status for status in failed({"status": statuses}) if status != Status.IMPOSSIBLE_LABEL]
    look: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "clip_on": False, "linestyle": ""}
    for status in marked:
        here = x[statuses == status]
        marker = LOOKS[status].marker
        axes.plot(here, np.full(len(here), height), marker=marker, color=colour, markersize=4, gid=status, **look)
    return bool(marked)
