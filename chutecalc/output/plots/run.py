"""The picture of a run: a chute from the side with columns of its stream, or several chutes to compare."""

from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.band import band_notes, draw_band
from chutecalc.output.plots.cases import case_lines, case_notes, draw_columns, handles
from chutecalc.output.plots.compare import draw_comparison
from chutecalc.output.plots.impacts import draw_impacts, label_impacts
from chutecalc.output.plots.layout import PANELS, WIDTH, page
from chutecalc.output.plots.notes import notes
from chutecalc.output.plots.panels import draw_panels, limit, mark_ends
from chutecalc.output.plots.side import SideView
from chutecalc.output.plots.style import SMALL, lay_out, styled
from chutecalc.output.plots.text import legend_columns, legend_rows
from chutecalc.output.plots.traces import extent
from chutecalc.output.plots.view import view
from chutecalc.results.band import Band
from chutecalc.results.cases import Cases
from chutecalc.spec.operating import DESIGN_POINT

KEY: dict[str, Any] = {"handlelength": 2.2, "columnspacing": 1.4, "borderaxespad": 0.0, "borderpad": 0.0}
"""Look of the legends of the side view: of what is drawn, in one line, and of the operating states below it."""

LONG = {"handlelength": 3.6}
"""Lines that show their strokes."""


def draw_run(chutes: Sequence[Cases], units: str = "metric", band: Band | None = None) -> Figure:
    """Draws one chute with its stream in all its operating states, or the design points of several to compare.

    Args:
        chutes: the operating states of each chute, of one design each.
        units: ``metric`` or ``us``.
        band: of one chute, if it is asked for.

    Returns:
        The figure: axes ``side`` to scale, and one for each of ``PANELS`` over the distance along the stream.
    """
    with styled():
        if len(chutes) == 1:
            return _one(chutes[0], units, band)
        return draw_comparison([states.main_solution for states in chutes], units)


def _one(states: Cases, units: str, band: Band | None) -> Figure:
    """Draw a chute with its stream between its edges, and those of its other operating states as lines."""
    solution = states.main_solution
    seen, cases = view(solution), case_lines(states)
    lines, marks = notes(solution, seen, units, WIDTH)
    lines += case_notes(states, units, WIDTH)
    if band:
        lines += band_notes(band, units, WIDTH)
    title, named = solution.spec.title or solution.source, handles(cases)
    if states.main != DESIGN_POINT:
        title += f" — case {states.main}"
    columns = legend_columns([*named], WIDTH)
    size = extent([*seen.lines, *(line for case in cases for line in case.lines)])
    figure, axes = page(title, size, units, notes=len(lines), key=1 + (legend_rows([*named], columns) if named else 0))
    axes["notes"].text(0.0, 1.0, "\n".join(lines), va="top", fontsize=SMALL, linespacing=1.5)
    side = SideView(axes["side"], solution, seen, cases, units)
    _explain(axes["key"], side.handles, named, columns)
    draw_panels(axes, seen, units)
    if band:
        draw_band(axes, band, units)
    draw_columns(axes, cases, units)
    for panel in PANELS:
        limit(axes[panel])
    draw_impacts(axes, seen, cases, units)
    lay_out(figure)
    mark_ends(axes, seen.traces, units)
    if any(name.get_rotation() for name in axes[PANELS[0]].texts):  # upright names take room
        lay_out(figure)
    label_impacts(axes, seen, units)
    side.label(marks)
    return figure


def _explain(axes: Axes, drawn: Mapping[str, Any], named: Mapping[str, Any], columns: int) -> None:
    """Draw the legends: what is drawn, and below it the operating states."""
    if named:
        look = KEY | LONG
        axes.add_artist(axes.legend(named.values(), named.keys(), loc="lower left", ncols=columns, **look))
    axes.legend(drawn.values(), drawn.keys(), loc="upper left", ncols=len(drawn), **KEY)
