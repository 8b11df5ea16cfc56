"""The picture of several chutes: their streams as lines."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.layout import PANELS, WIDTH, page
from chutecalc.output.plots.looks import MISSED
from chutecalc.output.plots.panels import limit
from chutecalc.output.plots.style import labels_of, looks
from chutecalc.output.plots.text import fitted, legend_columns, legend_rows
from chutecalc.output.plots.traces import View, along, extent
from chutecalc.output.plots.view import view
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

LABEL_WIDTH, LABEL_LINES = 4.0, 2
"""Width of a label in the legend, inches, and the number of lines from which on it is cut off."""
MOST_LABELLED = 40
"""Most chutes in the legend."""


def draw_comparison(solutions: Sequence[SolvedChute], units: str) -> Figure:
    """Draws chutes as lines: their paths from the side, and columns of their streams.

    Args:
        solutions: of one design each.
        units: ``metric`` or ``us``.

    Returns:
        The figure.
    """
    parts, names, shared = _labels(solutions)
    views = [view(solution) for solution in solutions]
    size = np.max([extent([trace.path for trace in seen.traces]) for seen in views], axis=0)
    shown = names[:MOST_LABELLED]
    columns = legend_columns(shown, WIDTH)
    more = len(names) - len(shown)
    title = f"Comparison: {shared}" if shared else "Comparison"
    figure, axes = page(title, size, units, legend=legend_rows(shown, columns) + bool(more))
    lines = []
    for seen, name, look in zip(views, names, looks(parts), strict=True):
        path = COLUMNS["x_m"].converted(np.concatenate([trace.path for trace in seen.stream], axis=1), units)
        ends = {"markevery": [] if seen.end else [-1]}
        axes["side"].plot(*path, **look | ends, gid="path")
        for panel in PANELS:
            lines += axes[panel].plot(*along(seen.stream, panel, units), **look | ends, gid=panel, label=name)
        _draw_end(axes, seen, look, units)
    for panel in PANELS:
        limit(axes[panel])
    axes["side"].set_aspect("equal", adjustable="datalim")
    axes["side"].set_title("paths of the streams, to scale")
    handles = lines[:: len(PANELS)][:MOST_LABELLED]
    below: dict[str, Any] = {"title": f"… and {more} more" if more else None, "alignment": "left"}
    figure.legend(handles=handles, ncols=columns, loc="outside lower left", **below)
    return figure


def _draw_end(axes: Mapping[str, Axes], seen: View, look: Mapping[str, Any], units: str) -> None:
    """Draw where a stream flies on that nothing catches, and its marker where it fails."""
    lost, mark = MISSED | {"color": look["color"]}, {**look, "linestyle": "", "gid": "end"}
    for trace, drawn in ((seen.lost, lost), (seen.end, mark)):
        if trace:
            axes["side"].plot(*COLUMNS["x_m"].converted(trace.path, units), **drawn)
            for panel in PANELS:
                axes[panel].plot(*along([trace], panel, units), **drawn)


def _labels(solutions: Sequence[SolvedChute]) -> tuple[list[tuple[str, ...]], list[str], str]:
    """Return what sets the look of each chute, its name in the legend, and what all names share."""
    titles = [solution.spec.title or solution.source for solution in solutions]
    whole = titles if len(set(titles)) == len(titles) else [solution.source for solution in solutions]
    parts, shared = labels_of(whole)
    names = [", ".join(each) for each in parts] if shared else whole
    ends = ["" if solution.ok[0] else f" ({solution.status[0].replace('_', ' ')})" for solution in solutions]
    return (
        parts,
        [fitted(name + end, LABEL_WIDTH, most=LABEL_LINES) for name, end in zip(names, ends, strict=True)],
        shared,
    )
