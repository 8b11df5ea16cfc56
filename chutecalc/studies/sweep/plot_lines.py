"""A column of a sweep as lines over one parameter, one for each value of a second."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from chutecalc.design import Status
from chutecalc.fields.units import TEXT as UNIT_TEXT
from chutecalc.output.dataset import Block
from chutecalc.output.plots.style import looks, mathematical
from chutecalc.output.plots.text import POINTS, fitted, width_of
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
BESIDE, NAME_WIDTH = 0.5, 1.6
"""Width over which the lines' marks of one name stand side by side, over the distance of names; and the greatest width
of a line of a name, inches."""
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
    styles = looks([(label,) for label in labels])
    for number, (value, label, look) in enumerate(zip(chosen, labels, styles, strict=True)):
        rows = np.ones(len(block["status"]), bool) if second is None else block[second.name] == value
        x, y = places(over, block[over.name][rows]), column.converted(block[column.name][rows], units)
        order = np.argsort(x, kind="stable")
        every = max(1, len(x) // MARKERS)
        if isinstance(over, TextParameter):
            look |= {"linestyle": ""}  # between names there is nothing
            every = 1
            x = x + BESIDE * (number - 0.5 * (len(chosen) - 1)) / len(chosen)
        axes.plot(x[order], y[order], **look, markevery=every, label=label, gid="line")
        height += CROSS_SPACING * _mark_failed(axes, x, block["status"][rows], height, look["color"])
    whole = column.converted(block[column.name], units)
    top = top_of(whole, block["status"] == Status.OK_LABEL)
    if top < finite(whole).max():
        axes.set_ylim(top=top)
    if isinstance(over, TextParameter):
        _name_places(axes, different(over))
    axes.set_xlabel(mathematical(parameter_label(column_of(sweep, over.name))))
    axes.set_ylabel(mathematical(column.label(units)))


def _name_places(axes: Axes, names: Sequence[str]) -> None:
    """Write names below a panel, slanted where they have no room side by side."""
    width = axes.get_window_extent().width / axes.figure.dpi * POINTS
    labels = [fitted(name, NAME_WIDTH, most=2) for name in names]
    slanted = max(width_of(line) for label in labels for line in label.split("\n")) > 0.9 * width / len(names)
    turned: dict[str, Any] = {"rotation": 30.0, "ha": "right", "rotation_mode": "anchor"} if slanted else {}
    axes.set_xticks(range(len(names)), labels, **turned)
    axes.set_xlim(-0.5, len(names) - 0.5)


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
    look: dict[str, Any] = {"color": colour, "linestyle": "", "markersize": 6, "markeredgewidth": 1.4}
    for status in marked:
        here = x[statuses == status]
        place: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "clip_on": False}
        axes.plot(here, np.full(len(here), height), marker=LOOKS[status].marker, gid=status, **look, **place)
    return bool(marked)
