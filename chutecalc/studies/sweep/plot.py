"""The picture of a sweep: lines over one parameter, one for each value of a second, or contours over two."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from chutecalc.design import Status
from chutecalc.fields.units import TEXT as UNIT_TEXT
from chutecalc.output.dataset import Block
from chutecalc.output.plots.style import INK, MAP, SMALL, looks, mathematical, styled
from chutecalc.results.column import Column
from chutecalc.studies.sweep.axis import along, different, places
from chutecalc.studies.sweep.parameters import AnyParameter
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of, parameter_label
from chutecalc.studies.sweep.text_parameter import TextParameter

MOST_LINES = 8
"""Most values of a second parameter that are drawn as lines; more are drawn as contours."""
MOST_PANELS = 6
LEVELS = 10
"""Number of contours, about."""
CROSS_SPACING = 0.02
"""Distance between the crosses of one line and the next, over the height of a panel."""
WIDTH, HEIGHT = 4.6, 3.3
"""Size of a panel, inches."""
MARKERS = 12
"""Number of markers on a line, about."""
CUT_OFF = 4.0
"""A panel with designs that fail ends at this multiple of the median: values grow without bound towards a stall."""


def draw_sweep(sweep: Sweep, block: Block, units: str = "metric") -> Figure:
    """Draw the columns of a sweep.

    Args:
        sweep: a sweep over one or two parameters of several values, or parallel lists.
        block: all its rows.
        units: ``metric`` or ``us``.

    Returns:
        The figure: a panel for each column of numbers that varies, by the column's name.
    """
    with styled():
        varied = [each for each in sweep.parameters if len(each.values) > 1]
        names = _drawn(sweep, block)
        across = 1 if len(names) == 1 else 2
        down = -(-len(names) // across)
        figure = Figure(figsize=(max(WIDTH * across, 6.0), HEIGHT * down + 0.6))
        panels = [figure.add_subplot(down, across, k + 1) for k in range(len(names))]
        figure.suptitle(sweep.chute.spec.title or sweep.chute.source, x=0.01, ha="left")
        few = min(len(each.values) for each in varied) <= MOST_LINES
        lines = sweep.parallel or len(varied) == 1 or few or any(isinstance(each, TextParameter) for each in varied)
        for axes, name in zip(panels, names, strict=True):
            axes.set_gid(name)
            column = column_of(sweep, name)
            if lines:
                _lines(axes, sweep, varied, block, column, units)
            else:
                _contours(axes, sweep, varied, block, column, units)
        if lines and len(varied) > 1 and not sweep.parallel:
            figure.legend(*panels[0].get_legend_handles_labels(), loc="outside right upper")
        figure.supxlabel(_note(sweep, block, lines), x=0.01, ha="left", fontsize=SMALL)
        return figure


def _drawn(sweep: Sweep, block: Block) -> list[str]:
    """Return the columns to draw: numbers that vary, or else the first column."""
    numbers = [name for name in sweep.columns if name not in sweep.texts]
    differ = [name for name in numbers if np.ptp(_finite(block[name])) > 1e-9 * np.abs(_finite(block[name])).max()]
    shown: list[str] = []
    for name in differ or numbers[:1]:
        if not any(np.array_equal(block[name], block[other], equal_nan=True) for other in shown):
            shown.append(name)
    return shown[:MOST_PANELS]


def _top(values: Any, ok: Any) -> float:
    """Return where a panel ends: at the largest value, but below the peaks of streams that nearly stall."""
    finite = _finite(values)
    return float(finite.max() if ok.all() else min(finite.max(), CUT_OFF * np.median(finite)))


def _finite(values: Any) -> Any:
    """Return the finite values, or a zero if there are none."""
    found = values[np.isfinite(values)]
    return found if found.size else np.zeros(1)


def _lines(axes: Axes, sweep: Sweep, varied: Sequence[AnyParameter], block: Block, column: Column, units: str) -> None:
    """Draw lines over the parameter with the most values, and a cross above the panel where a design fails."""
    x_parameter = along(varied, sweep.parallel)
    second = None if sweep.parallel else next((each for each in varied if each is not x_parameter), None)
    chosen = [None] if second is None else different(second)
    labels = ["" if second is None else _given(sweep, second, value) for value in chosen]
    fail = 0
    for value, label, look in zip(chosen, labels, looks([(label,) for label in labels]), strict=True):
        rows = np.ones(len(block["status"]), bool) if second is None else block[second.name] == value
        x, y = places(x_parameter, block[x_parameter.name][rows]), column.converted(block[column.name][rows], units)
        order = np.argsort(x, kind="stable")
        every = max(1, len(x) // MARKERS)
        if isinstance(x_parameter, TextParameter):
            look |= {"linestyle": ""}  # between names there is nothing
            every = 1
        axes.plot(x[order], y[order], **look, markevery=every, label=label, gid="line")
        failed = (block["status"][rows] != Status.OK_LABEL) & (block["status"][rows] != Status.IMPOSSIBLE_LABEL)
        if failed.any():
            look_of_crosses: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "clip_on": False}
            axes.plot(
                x[failed],
                np.full(failed.sum(), 1.0 + CROSS_SPACING * fail),
                "x",
                color=look["color"],
                markersize=4,
                gid="failed",
                **look_of_crosses,
            )
            fail += 1
    whole = column.converted(block[column.name], units)
    top = _top(whole, block["status"] == Status.OK_LABEL)
    if top < _finite(whole).max():
        axes.set_ylim(top=top)
    if isinstance(x_parameter, TextParameter):
        names = different(x_parameter)
        axes.set_xticks(range(len(names)), names)
    axes.set_xlabel(mathematical(parameter_label(column_of(sweep, x_parameter.name))))
    axes.set_ylabel(mathematical(column.label(units)))


def _given(sweep: Sweep, parameter: AnyParameter, value: Any) -> str:
    """Return a value of a parameter with its name, as text."""
    words = column_of(sweep, parameter.name).heading
    return f"{words} = {value}" if isinstance(value, str) else f"{words} = {value:zg}{_unit(sweep, parameter)}"


def _contours(
    axes: Axes, sweep: Sweep, varied: Sequence[AnyParameter], block: Block, column: Column, units: str
) -> None:
    """Draw filled contours over two parameters, hatched where a design fails or is impossible."""
    first, second = varied
    shape = (len(first.values), len(second.values))
    rows, columns = np.argsort(first.values, kind="stable"), np.argsort(second.values, kind="stable")

    def on_grid(values: Any) -> Any:
        return values.reshape(shape)[rows][:, columns].T

    x, y = first.values[rows], second.values[columns]
    values = np.ma.masked_invalid(on_grid(column.converted(block[column.name], units)))
    if values.count():
        top = float(column.converted(_top(block[column.name], block["status"] == Status.OK_LABEL), units))
        levels = np.asarray(MaxNLocator(LEVELS).tick_values(float(values.min()), top))
        filled = axes.contourf(
            x, y, values, levels=levels, cmap=MAP, extend="max" if values.max() > levels[-1] else "neither"
        )
        drawn = axes.contour(x, y, values, levels=filled.levels, colors=INK, linewidths=0.6)
        labelled = levels[levels <= (top if values.max() <= levels[-1] else 0.5 * top)]  # lines on a peak are too close
        for label in axes.clabel(drawn, labelled, fontsize=SMALL) if labelled.size else ():
            label.set_bbox({"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.75})
        bar = axes.figure.colorbar(filled, ax=axes)
        bar.outline.set_visible(False)
    fails = on_grid((block["status"] != Status.OK_LABEL).astype(float))
    if fails.any():
        axes.contourf(x, y, fails, levels=[0.5, 1.5], colors="none", hatches=["////"])
    axes.grid(False)
    axes.set_xlabel(mathematical(parameter_label(column_of(sweep, first.name))))
    axes.set_ylabel(mathematical(parameter_label(column_of(sweep, second.name))))
    axes.set_title(mathematical(column.label(units)))


def _unit(sweep: Sweep, parameter: AnyParameter) -> str:
    """Return the unit of a parameter, to follow a number."""
    unit = column_of(sweep, parameter.name).unit
    return "°" if unit == "deg" else f" {UNIT_TEXT.get(unit, unit)}".rstrip()


def _note(sweep: Sweep, block: Block, lines: bool) -> str:
    """Return how the designs end, and what the marks mean, as text."""
    words, counts = np.unique(block["status"], return_counts=True)
    ends = ", ".join(f"{count:,} {word.replace('_', ' ')}" for word, count in zip(words, counts, strict=True))
    single = [
        f"{each.name} = {each.values[0] if isinstance(each, TextParameter) else f'{each.values[0]:zg}'}"
        for each in sweep.parameters
        if len(each.values) == 1
    ]
    constant = [f"constant {sweep.keep}"] if sweep.is_adjusted else []
    marks = f" ({'crosses' if lines else 'hatched'}: no stream leaves)" if (words != Status.OK_LABEL).any() else ""
    return "; ".join([f"{sweep.count:,} designs: {ends}{marks}", *constant, *single])
