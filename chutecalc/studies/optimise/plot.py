"""Pictures of optima: the neighbourhood over one or two keys, or the front of two objectives."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from chutecalc.output.plots.style import INK, SHADE, SMALL, TITLE, mathematical, styled
from chutecalc.output.plots.text import LINE_HEIGHT, fitted
from chutecalc.physics.arrays import Mask
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.optimise.neighbourhood import Neighbourhood, neighbourhood
from chutecalc.studies.optimise.optimum import Optimum
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.plot import picture_title
from chutecalc.studies.sweep.plot_contours import draw_contours
from chutecalc.studies.sweep.plot_status import LOOKS
from chutecalc.studies.sweep.table import column_of, parameter_label

WIDTH, HEIGHT, LEGEND = 8.4, 4.2, 2.3
"""Size of the picture, and width of a line of its legend, inches."""
HATCHES = ("xx", "oo", "--", "**", "OO")
"""What covers the designs that a limit excludes, one after the other; different from that of failures."""
COVER: dict[str, Any] = {"facecolor": (1.0, 1.0, 1.0, 0.6), "edgecolor": INK, "linewidth": 0.0}
"""Look of designs that are excluded, below their hatch."""
BEST: dict[str, Any] = {
    "marker": "o",
    "linestyle": "",
    "color": INK,
    "markerfacecolor": "white",
    "markersize": 7,
    "zorder": 5.0,
    "clip_on": False,
    "gid": "best",
}


def draw_optimum(found: Optimum, units: str = "metric") -> Figure:
    """Draw the objective around the best design over the first two keys of numbers, or a front.

    Args:
        found: the optimum.
        units: ``metric`` or ``us``.
    """
    with styled():
        return _front(found, units) if len(found.objectives) > 1 else _neighbourhood(found, units)


def _neighbourhood(found: Optimum, units: str) -> Figure:
    """Draw the objective in the worst state of each design, hatched where a design fails or a limit excludes it."""
    near = neighbourhood(found)
    title = fitted(picture_title(near.sweep), WIDTH - LEGEND - 1.0, TITLE)
    figure = Figure(figsize=(WIDTH, HEIGHT + 1.5 * LINE_HEIGHT * title.count("\n")))
    figure.suptitle(title, x=0.01, ha="left")
    axes = figure.add_subplot()
    name = found.objectives[0].column
    column = column_of(near.sweep, name)
    hatches = [HATCHES[k % len(HATCHES)] for k in range(len(near.margins))]
    if len(near.best) > 1:
        _draw_plane(axes, near, name, hatches, units)
        place = tuple(near.best)
    else:
        _draw_line(axes, near, name, hatches, units)
        place = near.best[0], float(column.converted(found.worst[name][0], units))
    axes.set_title(mathematical(f"{column.label(units)}{_which(found)}"), parse_math=True)
    text = "best design" if found.feasible else "no design keeps all limits; this one comes closest"
    axes.plot(*place, **BEST)
    shown: list[Any] = [Line2D([], [], label=fitted(text, LEGEND), **BEST)]
    shown += [_patch(near.texts[status], LOOKS[status].hatch, SHADE) for status in near.fails]
    shown += [_patch(f"excluded: {text}", hatch) for text, hatch in zip(near.margins, hatches, strict=True)]
    figure.legend(handles=shown, loc="outside right upper")
    figure.supxlabel(fitted(_note(found, near), WIDTH), x=0.01, ha="left", fontsize=SMALL)
    return figure


def _draw_plane(axes: Axes, near: Neighbourhood, name: str, hatches: list[str], units: str) -> None:
    """Draw contours of the objective over two keys, and hatch what is excluded."""
    status = np.full(near.worst.shape, "ok", dtype=object)
    for failure, those in near.fails.items():
        status[those & (status == "ok")] = failure
    first, second = (each for each in near.sweep.parameters if isinstance(each, Parameter))
    block = {name: near.worst, "status": status.astype(str)}
    draw_contours(axes, near.sweep, [first, second], block, column_of(near.sweep, name), units)
    for margin, hatch in zip(near.margins.values(), hatches, strict=True):
        on_grid = np.ma.masked_invalid(margin.reshape(len(first.values), len(second.values)).T)
        look: dict[str, Any] = {"levels": [min(float(on_grid.min()), 0.0) - 1.0, 0.0], "corner_mask": True}
        axes.contourf(first.values, second.values, on_grid, colors=[COVER["facecolor"]], zorder=2.0, **look)
        drawn = axes.contourf(first.values, second.values, on_grid, colors="none", hatches=[hatch], zorder=2.1, **look)
        drawn.set_gid("excluded")


def _draw_line(axes: Axes, near: Neighbourhood, name: str, hatches: list[str], units: str) -> None:
    """Draw the objective over one key, and hatch what is excluded."""
    (key,) = (each for each in near.sweep.parameters if isinstance(each, Parameter))
    column = column_of(near.sweep, name)
    axes.plot(key.values, column.converted(near.worst, units), color=INK, gid="objective")
    covered: list[tuple[Mask, str, Any]] = [(those, LOOKS[status].hatch, SHADE) for status, those in near.fails.items()]
    covered += [
        (margin < 0.0, hatch, COVER["facecolor"]) for margin, hatch in zip(near.margins.values(), hatches, strict=True)
    ]
    middles = 0.5 * (key.values[1:] + key.values[:-1])
    edges = np.concatenate([key.values[:1], middles, key.values[-1:]])
    for those, hatch, shade in covered:
        ends = np.flatnonzero(np.diff(np.concatenate([[False], those, [False]]).astype(int))).reshape(-1, 2)
        for low, high in ends:
            look: dict[str, Any] = COVER | {"facecolor": shade, "hatch": hatch}
            axes.axvspan(edges[low], edges[high], **look, zorder=0.5, gid="excluded")
    axes.set_xlim(key.values[0], key.values[-1])
    axes.set_xlabel(mathematical(parameter_label(column_of(near.sweep, key.name))), parse_math=True)


def _patch(text: str, hatch: str, shade: Any = "white") -> Patch:
    """Return an entry of the legend."""
    return Patch(hatch=hatch, facecolor=shade, edgecolor=INK, linewidth=0.5, label=fitted(text, LEGEND))


def _which(found: Optimum) -> str:
    """Return which state is shown, as the end of a title."""
    if len(found.states) > 1:
        return ", in its worst case"
    if found.states == (DESIGN_POINT,):
        return ", at the design point" if found.chute.cases else ""
    return f", case {found.states[0]}"


def _note(found: Optimum, near: Neighbourhood) -> str:
    """Return how many designs are excluded, which states are shown, and where other keys stand, as text."""
    out = np.any([*near.fails.values(), *(margin < 0.0 for margin in near.margins.values()), np.isnan(near.worst)], 0)
    parts = [f"{len(out):,} designs around the best one, {int(out.sum()):,} of them excluded"]
    if len(found.states) > 1:
        objective = found.objectives[0]
        own = np.nan_to_num(objective.sign * found.outcome[objective.column][:, 0], nan=-np.inf)
        worst = f"; for the best one that is {found.states[int(own.argmax())]}" if found.feasible else ""
        parts.append(f"each is shown in the worst of {', '.join(found.states)}{worst}")
    varied = [each.name for each in near.sweep.parameters]
    others = [f"{key.name} = {_shown(found, key.name)}" for key in found.keys if key.name not in varied]
    return "; ".join([*parts, *([f"other keys as they are best: {', '.join(others)}"] if others else [])])


def _shown(found: Optimum, name: str) -> str:
    """Return the best value of a key."""
    value = found.values[name][0].item()
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _front(found: Optimum, units: str) -> Figure:
    """Draw the designs of a front, one objective over the other."""
    figure = Figure(figsize=(6.0, 4.0))
    axes = figure.add_subplot()
    first, second = (found.columns[each.column] for each in found.objectives)
    x, y = (column.converted(found.worst[column.name], units) for column in (first, second))
    _points(axes, x, y)
    axes.set_xlabel(mathematical(first.label(units)), parse_math=True)
    axes.set_ylabel(mathematical(second.label(units)), parse_math=True)
    axes.set_title(found.chute.spec.title or found.chute.source, loc="left")
    parts = [f"subject to {', '.join(found.subject)}"]
    if len(found.states) > 1 or found.states != (DESIGN_POINT,):
        parts.insert(
            0, f"the worst of {', '.join(found.states)}" if len(found.states) > 1 else f"case {found.states[0]}"
        )
    figure.supxlabel(fitted("; ".join(parts), 6.0), x=0.01, ha="left", fontsize=SMALL)
    return figure


def _points(axes: Any, x: Any, y: Any) -> None:
    """Draw numbered points joined by a line."""
    axes.plot(x, y, "o-", color=INK, gid="front")
    for number, place in enumerate(zip(x, y, strict=True), 1):
        axes.annotate(str(number), place, xytext=(4, 4), textcoords="offset points")
