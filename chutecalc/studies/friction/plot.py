"""The picture of the friction study: sections, and the equivalent friction over the chamfer angle."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.style import INK, PALE, SMALL, TITLE, label_axes, lay_out, looks, styled
from chutecalc.output.plots.text import POINTS, fitted
from chutecalc.results.columns import COLUMNS
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.friction.report import CONSTRAINT_TEXT, given_text
from chutecalc.studies.friction.study import FrictionStudy

FILL = "0.8"
"""Shade of grey of the stream."""
STAR: dict[str, Any] = {"marker": "*", "markersize": 11, "color": "white", "markeredgecolor": INK, "linestyle": ""}
OUTLINES = 5
"""Most sections drawn."""
MOST_LINES = 10
"""Most materials with a line of their own look in the legend; of more, the lines have their names at their ends."""
WIDTH, HEIGHT = 10.0, 5.0
"""Size of the picture, inches."""


def draw_study(study: FrictionStudy, units: str = "metric") -> Figure:
    """Draw a friction study as in Figures 4 and 5 (or 6 and 7, or 8 and 9) of the paper.

    Args:
        study: the study.
        units: units of the sections, ``metric`` or ``us``.

    Returns:
        The figure: axes ``sections`` to scale, and ``friction`` with a line for each material.
    """
    with styled():
        title = fitted(f"Equivalent friction over the chamfer angle, {CONSTRAINT_TEXT[study.keep]}", WIDTH, TITLE)
        figure = Figure(figsize=(WIDTH, HEIGHT))
        axes = figure.subplot_mosaic([["sections", "friction"]], width_ratios=[1.0, 1.7])
        figure.suptitle(title, x=0.01, ha="left")
        _draw_sections(axes["sections"], study, units)
        _draw_friction(axes["friction"], study, units)
        figure.supxlabel(given_text(study, units), x=0.01, ha="left", fontsize=SMALL)
        return figure


def _draw_sections(axes: Axes, study: FrictionStudy, units: str) -> None:
    """Draw cross-sections of the stream at some of the angles, one below the other."""
    rows = study.line(float(study.internal_friction_deg[0]))
    drawn = np.flatnonzero(rows["chamfer_deg"] > 0.0)
    chosen = drawn[np.unique(np.linspace(0, len(drawn) - 1, OUTLINES).round().astype(int))] if drawn.size else drawn
    length = COLUMNS["depth_m"]
    half, depth = (length.converted(rows[name][chosen], units) for name in ("base_m", "depth_m"))
    half = 0.5 * half
    flank = length.converted(rows["chamfer_wetted_m"][chosen] * np.cos(np.radians(rows["chamfer_deg"][chosen])), units)
    pitch = max(2.0 * depth.max(initial=0.0), 0.44 * (half + flank).max(initial=0.0))
    for k, row in enumerate(chosen):
        x = np.array([-half[k] - flank[k], -half[k], half[k], half[k] + flank[k]])
        z = np.array([depth[k], 0.0, 0.0, depth[k]]) - k * pitch
        axes.fill(x, z, color=FILL, linewidth=0.0, gid="stream")
        axes.plot(x, z, color=INK, gid="section")
        axes.text(0.0, depth[k] - k * pitch, f"β = {rows['chamfer_deg'][row]:g}°\n", ha="center", fontsize=SMALL)
    if chosen.size:
        axes.update_datalim([(0.0, depth[0] + 0.5 * pitch)])
    axes.set_xlabel(f"across the chute, {length.unit_text(units)}")
    axes.set_title("sections of the stream, to scale")
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)


def _draw_friction(axes: Axes, study: FrictionStudy, units: str) -> None:
    """Draw a line for each material, with the best angle inside the range."""
    names = [f"δ = {delta:g}°" for delta in study.internal_friction_deg]
    few = len(names) <= MOST_LINES
    for delta, name, look in zip(study.internal_friction_deg, names, looks([(name,) for name in names]), strict=True):
        rows = study.line(float(delta))
        shown: dict[str, Any] = look | {"label": name} if few else {"color": look["color"], "linewidth": 0.9}
        axes.plot(rows["chamfer_deg"], rows["equivalent_friction"], **shown, gid="friction")
    best = [(each.inside_deg, each.inside_friction) for each in study.best() if np.isfinite(each.inside_deg)]
    if best:
        size = STAR["markersize"] if few else 0.5 * STAR["markersize"]
        axes.plot(*np.transpose(best), **STAR | {"markersize": size}, label="minimum inside the range", gid="best")
    axes.axhline(np.tan(np.radians(study.wall_friction_deg)), color=PALE, linewidth=1.0, label="tan φ", gid="wall")
    label_axes(axes, FRICTION_COLUMNS["chamfer_deg"], FRICTION_COLUMNS["equivalent_friction"], units)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0 if few else 1.1, 1.0))
    if not few:
        _name_ends(axes, names)


def _name_ends(axes: Axes, names: Sequence[str]) -> None:
    """Write the names of lines at their right ends, those that have room."""
    figure = axes.figure.figure
    lay_out(figure)
    low, high = axes.get_ylim()
    line = SMALL * (high - low) / (axes.get_position().height * HEIGHT * POINTS)
    lines = [each for each in axes.lines if each.get_gid() == "friction" and np.size(each.get_xdata())]
    paths = [np.stack([np.asarray(each.get_xdata()), np.asarray(each.get_ydata())]) for each in lines]
    ends = [(float(path[0, -1]), float(path[1, -1]), name) for path, name in zip(paths, names, strict=True)]
    free = -np.inf
    for x, y, name in sorted(ends, key=lambda end: end[1]):
        if y - free > line:
            look: dict[str, Any] = {"textcoords": "offset points", "va": "center", "fontsize": SMALL}
            axes.annotate(name, (x, y), (4.0, 0.0), annotation_clip=False, **look)
            free = y
