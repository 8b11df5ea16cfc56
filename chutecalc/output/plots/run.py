"""The picture of a run: the chute from the side, beside what the stream does along it."""

import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.side import END, Mark, Trace, deepest, draw_stream, extent, traces
from chutecalc.output.plots.style import INK, PALE, SMALL, label_axes, labels_of, looks, styled
from chutecalc.output.table import outcome
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Finding
from chutecalc.results.solved import SolvedChute

ALONG = ("velocity_m_s", "depth_m", "pressure_kpa")
"""The columns that are drawn along the stream."""
WIDTH, SIDE, PANEL, NOTE = 10.0, 3.6, 2.0, 0.17  # inches: the picture's width; heights, NOTE of a line of text
WIDE = 1.7  # a chute so many times as wide as high has the panels below it
STEEP = 12.0  # what is more than so many times its median leaves its panel through the top
MANY = 20  # more parts of the way than that are not marked along it
CHARACTER = 0.6  # width of a character over its height
LINE = 165  # characters of a note


def draw_run(solutions: Sequence[SolvedChute], units: str = "metric") -> Figure:
    """Draws one chute with its stream, or several as lines to compare.

    Args:
        solutions: of one design each.
        units: ``metric`` or ``us``.

    Returns:
        The figure: axes ``side`` to scale, and one for each of ``ALONG`` over the distance along the stream.
    """
    with styled():
        return _one(solutions[0], units) if len(solutions) == 1 else _several(solutions, units)


def _one(solution: SolvedChute, units: str) -> Figure:
    """A chute with its stream at its depth."""
    way = traces(solution)
    notes, marks = _notes(solution, way, units)
    figure, axes = _layout(len(notes), extent(solution, way), units)
    figure.suptitle(solution.spec.title or solution.source, x=0.01, ha="left")
    draw_stream(axes["side"], solution, way, marks, units)
    for name in ALONG:
        panel = axes[name]
        path = _joined(way, name, units)
        panel.plot(*path, color=INK, gid=name)
        _limit(panel, path[1])
        if solution.status[0] != "ok":
            panel.plot(path[0][-1:], path[1][-1:], **END)
    _mark_segments([axes[name] for name in ALONG], way, units)
    axes["notes"].text(0.0, 1.0, "\n".join(notes), va="top", fontsize=SMALL, linespacing=1.5)
    return figure


def _several(solutions: Sequence[SolvedChute], units: str) -> Figure:
    """Chutes as lines: their paths from the side, and what their streams do along them."""
    titles = [solution.spec.title or solution.source for solution in solutions]
    labels, shared = labels_of(
        titles if len(set(titles)) == len(titles) else [solution.source for solution in solutions]
    )
    ways = [traces(solution) for solution in solutions]
    size = np.max([extent(solution, way) for solution, way in zip(solutions, ways, strict=True)], axis=0)
    figure, axes = _layout(1 + -(-len(solutions) // 4), size, units)
    figure.suptitle(shared or "Comparison", x=0.01, ha="left")
    lines = []
    for way, label, look in zip(ways, labels, looks(labels), strict=True):
        x, z = (_joined(way, name, units)[1] for name in ("x_m", "z_m"))
        axes["side"].plot(x, z, **look, markevery=[-1], gid="path")
        for name in ALONG:
            path = _joined(way, name, units)
            lines += axes[name].plot(*path, **look, markevery=[-1], gid=name, label=", ".join(label))
    for name in ALONG:
        _limit(axes[name], np.concatenate([np.asarray(line.get_ydata()) for line in axes[name].get_lines()]))
    axes["side"].set_aspect("equal", adjustable="datalim")
    axes["side"].set_title("paths of the streams, to scale")
    axes["notes"].legend(
        handles=lines[:: len(ALONG)], ncols=min(len(solutions), 4), loc="upper left", borderaxespad=0.0
    )
    return figure


def _layout(notes: int, size: Array, units: str) -> tuple[Figure, dict[str, Axes]]:
    """The figure and its axes: from the side; along the stream beside that or, of a wide chute, below it; notes."""
    wide = size[0] > WIDE * size[1]
    rows: list[Any] = [["side"] * 3, list(ALONG)] if wide else [["side", name] for name in ALONG]
    heights = [*([SIDE, PANEL] if wide else [PANEL] * 3), NOTE * notes]
    columns = len(rows[0])
    figure = Figure(figsize=(WIDTH, sum(heights)))
    axes = figure.subplot_mosaic([*rows, ["notes"] * columns], height_ratios=heights, width_ratios=[1.0] * columns)
    axes["notes"].set_axis_off()
    label_axes(axes["side"], COLUMNS["x_m"], COLUMNS["z_m"], units)
    for name in ALONG[1:]:
        axes[name].sharex(axes[ALONG[0]])
    for name in ALONG:
        label_axes(axes[name], COLUMNS["s_m"], COLUMNS[name], units)
    if not wide:
        figure.align_ylabels([axes[name] for name in ALONG])
        for name in ALONG[:-1]:
            axes[name].set_xlabel("")
            axes[name].tick_params(labelbottom=False)
    return figure, axes


def _joined(way: Sequence[Trace], name: str, units: str) -> tuple[Array, Array]:
    """Distance along the stream and another column, all parts after each other; a gap where it does not exist."""
    s, values = (np.concatenate([part.columns[column] for part in way]) for column in ("s_m", name))
    return COLUMNS["s_m"].converted(s, units), COLUMNS[name].converted(values, units)


def _limit(panel: Axes, values: Array) -> None:
    """From 0 to what is largest, but for the peaks of a stream at a crawl."""
    values = values[np.isfinite(values)]
    top = min(1.06 * values.max(), STEEP * np.median(values)) if values.size else 0.0
    panel.set_ylim(0.0, top if top > 0.0 else 1.0)


def _mark_segments(panels: Sequence[Axes], way: Sequence[Trace], units: str) -> None:
    """Lines where one part of the way ends and the next begins, and names above those that have room for them."""
    ends = [COLUMNS["s_m"].converted(part.columns["s_m"][[0, -1]], units) for part in way]
    low, high = ends[0][0], ends[-1][1]
    if not high > low:
        return
    room = panels[0].get_position().width * WIDTH * 72.0
    for panel in panels:
        panel.set_xlim(low, high)
        for _, end in ends[:-1] if len(ends) <= MANY else ():
            panel.axvline(end, color=PALE, linewidth=0.7, zorder=1)
    for part, (first, last) in zip(way, ends, strict=True):
        if (last - first) / (high - low) * room > CHARACTER * SMALL * len(part.name):
            place: dict[str, Any] = {"transform": panels[0].get_xaxis_transform(), "ha": "center", "fontsize": SMALL}
            panels[0].text(0.5 * (first + last), 1.03, part.name, **place)


def _notes(solution: SolvedChute, way: Sequence[Trace], units: str) -> tuple[list[str], list[Mark]]:
    """How the stream ends and what to mind, a number for each kind of finding, with the places of that."""
    lines, marks = [outcome(solution, units)], []
    found: dict[str, list[Finding]] = {}
    for finding in solution.findings():
        found.setdefault(finding.code, []).append(finding)
    column = COLUMNS["s_m"]
    for number, (code, alike) in enumerate(found.items(), 1):
        first, more = alike[0], len(alike) - 1
        place = f"{first.segment}, s = {column.shown(float(first.s_m[0]), units)} {column.unit_text(units)}"
        others = f" and {more} more" if more else ""
        text = f"{number}  {first.severity} {code}: {place}{others}: {first.message(0, units)}"
        lines += textwrap.wrap(text, LINE, subsequent_indent="    ")
        if np.isfinite(first.s_m[0]):
            marks.append(Mark(str(number), float(first.s_m[0])))
    depths = _joined(way, "depth_m", "metric")[1]
    depth, most = COLUMNS["depth_m"], deepest(solution, way)
    if (depths > most).any():
        lines.append(f"the stream is drawn to a depth of {depth.shown(most, units)} {depth.unit_text(units)}")
    return lines, marks
