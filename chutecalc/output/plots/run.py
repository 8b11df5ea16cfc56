"""The picture of a run: a chute from the side with columns of its stream, or several chutes to compare."""

from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.band import band_notes, draw_band
from chutecalc.output.plots.cases import case_lines, case_notes, draw_columns, handles
from chutecalc.output.plots.compare import draw_comparison
from chutecalc.output.plots.impacts import draw_impacts, label_impacts
from chutecalc.output.plots.layout import ARRANGEMENTS, PANELS, PANELS_ALONE, SIDE, SIDE_ALONE, WIDTH, Arrangement, page
from chutecalc.output.plots.marks import Mark
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
    if len(chutes) > 1:
        with styled():
            return draw_comparison([states.main_solution for states in chutes], units)
    picture = _Picture(chutes[0], units, band)
    lines, marks = notes(picture.solution, picture.seen, units, WIDTH)
    lines += case_notes(chutes[0], units, WIDTH)
    if band:
        lines += band_notes(band, units, WIDTH)
    title = picture.solution.spec.title or picture.solution.source
    if chutes[0].main != DESIGN_POINT:
        title += f" — case {chutes[0].main}"
    return picture.drawn(ARRANGEMENTS, marks, title, lines)


def draw_parts(
    states: Cases, marks: Sequence[Mark], units: str = "metric", band: Band | None = None
) -> tuple[Figure, Figure]:
    """Draws the side view of a chute, and the columns of its stream, as two pictures without titles or notes.

    Args:
        states: the operating states of one design.
        marks: numbers to set beside the stream.
        units: ``metric`` or ``us``.
        band: of the chute, if it is asked for.
    """
    picture = _Picture(states, units, band)
    return picture.drawn(SIDE_ALONE, marks), picture.drawn(PANELS_ALONE)


class _Picture:
    """A chute with its stream between its edges, and those of its other operating states as lines."""

    def __init__(self, states: Cases, units: str, band: Band | None) -> None:
        self.solution, self.units, self.band = states.main_solution, units, band
        self.seen, self.cases = view(self.solution), case_lines(states)

    def drawn(
        self,
        arrangements: Sequence[Arrangement],
        marks: Sequence[Mark] = (),
        title: str = "",
        lines: Sequence[str] = (),
    ) -> Figure:
        """Return what arrangements have of it: the side view, the panels, or both."""
        with styled():
            named = handles(self.cases)
            columns = legend_columns([*named], WIDTH)
            size = extent([*self.seen.lines, *(line for case in self.cases for line in case.lines)])
            key = 1 + (legend_rows([*named], columns) if named else 0)
            figure, axes = page(title, size, self.units, len(lines), key, arrangements=arrangements)
            if lines:
                axes["notes"].text(0.0, 1.0, "\n".join(lines), va="top", fontsize=SMALL, linespacing=1.5)
            side = SideView(axes[SIDE], self.solution, self.seen, self.cases, self.units) if SIDE in axes else None
            _explain(axes["key"], side.handles if side else {}, named, columns)
            if PANELS[0] in axes:
                self._draw_panels(figure, axes)
            else:
                lay_out(figure)
            if side:
                side.label(marks)
            return figure

    def _draw_panels(self, figure: Figure, axes: dict[str, Axes]) -> None:
        """Draw the columns along the stream, and lay the figure out."""
        draw_panels(axes, self.seen, self.units)
        if self.band:
            draw_band(axes, self.band, self.units)
        draw_columns(axes, self.cases, self.units)
        for panel in PANELS:
            limit(axes[panel])
        draw_impacts(axes, self.seen, self.cases, self.units)
        lay_out(figure)
        mark_ends(axes, self.seen.traces, self.units)
        if any(name.get_rotation() for name in axes[PANELS[0]].texts):  # upright names take room
            lay_out(figure)
        label_impacts(axes, self.seen, self.units)


def _explain(axes: Axes, drawn: Mapping[str, Any], named: Mapping[str, Any], columns: int) -> None:
    """Draw the legends: what is drawn, and below it the operating states."""
    if named:
        look = KEY | LONG
        legend = axes.legend(named.values(), "-" * len(named), loc="lower left", ncols=columns, **look)
        for text, name in zip(legend.get_texts(), named, strict=True):  # old releases leave out what begins with _
            text.set_text(name)
        axes.add_artist(legend)
    if drawn:
        axes.legend(drawn.values(), drawn.keys(), loc="upper left", ncols=len(drawn), **KEY)
