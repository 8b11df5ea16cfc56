"""The picture of a run: the chute from the side, beside columns of its stream along it."""

import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.textpath import TextPath

from chutecalc.output.plots.side import END, Mark, draw_stream
from chutecalc.output.plots.style import INK, PALE, SMALL, label_axes, labels_of, looks, styled
from chutecalc.output.plots.traces import Trace, deepest, extent, traces
from chutecalc.output.table import outcome
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Finding
from chutecalc.results.solved import SolvedChute

PANELS = ("velocity_m_s", "depth_m", "pressure_kpa")
"""Columns that are drawn along the stream."""
WIDTH, SIDE_HEIGHT, PANEL_HEIGHT, NOTE_HEIGHT = 10.0, 3.6, 2.0, 0.17
"""Width of the picture; heights of the side view in a wide picture, of a panel, and of a line of notes; inches."""
WIDE = 1.7
"""Width over height from which a chute has its panels below it."""
CUT_OFF = 12.0
"""A panel ends at this multiple of the median of its values."""
MOST_MARKED = 20
"""With more segments and flights than this, their ends are not marked in the panels."""
CHARACTER_WIDTH = 0.6
"""Width of a character over its height, about."""
NOTE_LENGTH = 165
"""Characters in a line of notes."""
LABEL_LENGTH = 130
"""Characters in a line of a legend's label."""
LEGEND_LINE = 6.0
"""Width of a line, and of the gaps beside it and its label, in a legend; over the size of its letters."""


def draw_run(solutions: Sequence[SolvedChute], units: str = "metric") -> Figure:
    """Draws one chute with its stream, or several as lines to compare.

    Args:
        solutions: of one design each.
        units: ``metric`` or ``us``.

    Returns:
        The figure: axes ``side`` to scale, and one for each of ``PANELS`` over the distance along the stream.
    """
    with styled():
        return _one(solutions[0], units) if len(solutions) == 1 else _several(solutions, units)


def _one(solution: SolvedChute, units: str) -> Figure:
    """Draw a chute with its stream at its depth."""
    stream = traces(solution)
    notes, marks = _notes(solution, stream, units)
    figure, axes = _layout(extent(solution, stream), units, notes=len(notes))
    figure.suptitle(solution.spec.title or solution.source, x=0.01, ha="left")
    draw_stream(axes["side"], solution, stream, marks, units)
    for name in PANELS:
        panel = axes[name]
        path = _joined(stream, name, units)
        panel.plot(*path, color=INK, gid=name)
        _limit(panel, path[1])
        if not solution.ok[0]:
            panel.plot(path[0][-1:], path[1][-1:], **END)
    _mark_segments([axes[name] for name in PANELS], stream, units)
    axes["notes"].text(0.0, 1.0, "\n".join(notes), va="top", fontsize=SMALL, linespacing=1.5)
    return figure


def _several(solutions: Sequence[SolvedChute], units: str) -> Figure:
    """Draw chutes as lines: their paths from the side, and columns of their streams."""
    titles = [solution.spec.title or solution.source for solution in solutions]
    distinct = len(set(titles)) == len(titles)
    labels, shared = labels_of(titles if distinct else [solution.source for solution in solutions])
    streams = [traces(solution) for solution in solutions]
    size = np.max([extent(solution, stream) for solution, stream in zip(solutions, streams, strict=True)], axis=0)
    names = ["\n".join(textwrap.wrap(", ".join(label), LABEL_LENGTH)) for label in labels]
    columns = _legend_columns(names)
    rows = -(-len(names) // columns) * max(name.count("\n") + 1 for name in names)
    figure, axes = _layout(size, units, legend=rows)
    figure.suptitle(f"Comparison: {shared}" if shared else "Comparison", x=0.01, ha="left")
    lines = []
    for stream, label, look in zip(streams, names, looks(labels), strict=True):
        x, z = (_joined(stream, name, units)[1] for name in ("x_m", "z_m"))
        axes["side"].plot(x, z, **look, markevery=[-1], gid="path")
        for name in PANELS:
            path = _joined(stream, name, units)
            lines += axes[name].plot(*path, **look, markevery=[-1], gid=name, label=label)
    for name in PANELS:
        _limit(axes[name], np.concatenate([np.asarray(line.get_ydata()) for line in axes[name].get_lines()]))
    axes["side"].set_aspect("equal", adjustable="datalim")
    axes["side"].set_title("paths of the streams, to scale")
    figure.legend(handles=lines[:: len(PANELS)], ncols=columns, loc="outside lower left")
    return figure


def _legend_columns(labels: Sequence[str]) -> int:
    """Return how many columns of these labels, each with its line beside it, fit on the picture."""
    widest = max(TextPath((0.0, 0.0), label, size=SMALL).get_extents().width for label in labels)
    return max(1, int(WIDTH * 72.0 / (widest + LEGEND_LINE * SMALL)))


def _layout(size: Array, units: str, notes: int = 0, legend: int = 0) -> tuple[Figure, dict[str, Axes]]:
    """Return the figure and its axes: side view, panels beside it or below a wide chute, and notes if there are any.

    Args:
        size: width and height of the chute, m.
        units: ``metric`` or ``us``.
        notes: number of lines of notes.
        legend: number of lines of a legend of the figure, which needs room below the axes.
    """
    wide = size[0] > WIDE * size[1]
    rows: list[Any] = [["side"] * 3, list(PANELS)] if wide else [["side", name] for name in PANELS]
    heights = [SIDE_HEIGHT, PANEL_HEIGHT] if wide else [PANEL_HEIGHT] * 3
    columns = len(rows[0])
    if notes:
        rows.append(["notes"] * columns)
        heights.append(NOTE_HEIGHT * notes)
    figure = Figure(figsize=(WIDTH, sum(heights) + NOTE_HEIGHT * legend))
    axes = figure.subplot_mosaic(rows, height_ratios=heights, width_ratios=[1.0] * columns)
    if notes:
        axes["notes"].set_axis_off()
    label_axes(axes["side"], COLUMNS["x_m"], COLUMNS["z_m"], units)
    for name in PANELS[1:]:
        axes[name].sharex(axes[PANELS[0]])
    for name in PANELS:
        label_axes(axes[name], COLUMNS["s_m"], COLUMNS[name], units)
    if not wide:
        figure.align_ylabels([axes[name] for name in PANELS])
        for name in PANELS[:-1]:
            axes[name].set_xlabel("")
            axes[name].tick_params(labelbottom=False)
    return figure, axes


def _joined(stream: Sequence[Trace], name: str, units: str) -> tuple[Array, Array]:
    """Return the distance along the stream and another column, of all traces in order; NaN where it does not exist."""
    s, values = (np.concatenate([part.columns[column] for part in stream]) for column in ("s_m", name))
    return COLUMNS["s_m"].converted(s, units), COLUMNS[name].converted(values, units)


def _limit(panel: Axes, values: Array) -> None:
    """Limit a panel to its largest value, but cut off the peaks of a stream that nearly stops."""
    values = values[np.isfinite(values)]
    top = min(1.06 * values.max(), CUT_OFF * np.median(values)) if values.size else 0.0
    panel.set_ylim(0.0, top if top > 0.0 else 1.0)


def _mark_segments(panels: Sequence[Axes], stream: Sequence[Trace], units: str) -> None:
    """Mark the ends of segments and flights, and name those with room for their names."""
    ends = [COLUMNS["s_m"].converted(part.columns["s_m"][[0, -1]], units) for part in stream]
    low, high = ends[0][0], ends[-1][1]
    if not high > low:
        return
    room = panels[0].get_position().width * WIDTH * 72.0
    for panel in panels:
        panel.set_xlim(low, high)
        for _, end in ends[:-1] if len(ends) <= MOST_MARKED else ():
            panel.axvline(end, color=PALE, linewidth=0.7, zorder=1)
    for part, (first, last) in zip(stream, ends, strict=True):
        if (last - first) / (high - low) * room > CHARACTER_WIDTH * SMALL * len(part.name):
            text: dict[str, Any] = {"transform": panels[0].get_xaxis_transform(), "ha": "center", "fontsize": SMALL}
            panels[0].text(0.5 * (first + last), 1.03, part.name, **text)


def _notes(solution: SolvedChute, stream: Sequence[Trace], units: str) -> tuple[list[str], list[Mark]]:
    """Return the outcome and the findings as lines, numbered by kind, and marks with these numbers."""
    lines, marks = [outcome(solution, units)], []
    found: dict[str, list[Finding]] = {}
    for finding in solution.findings():
        found.setdefault(finding.code, []).append(finding)
    for number, (code, alike) in enumerate(found.items(), 1):
        first, more = alike[0], len(alike) - 1
        others = f" and {more} more" if more else ""
        text = f"{number}  {first.severity} {code}: {first.where(0, units)}{others}: {first.message(0, units)}"
        lines += textwrap.wrap(text, NOTE_LENGTH, subsequent_indent="    ")
        if np.isfinite(first.s_m[0]):
            marks.append(Mark(str(number), float(first.s_m[0])))
    depths = _joined(stream, "depth_m", "metric")[1]
    depth, most = COLUMNS["depth_m"], deepest(solution, stream)
    if (depths > most).any():
        lines.append(f"the stream is drawn to a depth of {depth.shown(most, units)} {depth.unit_text(units)}")
    return lines, marks
