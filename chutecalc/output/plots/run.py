"""The picture of a run: a chute from the side with columns of its stream, or several chutes to compare."""

from collections.abc import Sequence
from typing import Any

from matplotlib.figure import Figure

from chutecalc.output.plots.compare import draw_comparison
from chutecalc.output.plots.layout import WIDTH, page
from chutecalc.output.plots.notes import notes
from chutecalc.output.plots.panels import draw_panels, mark_ends
from chutecalc.output.plots.side import SideView
from chutecalc.output.plots.style import SMALL, lay_out, styled
from chutecalc.output.plots.traces import extent
from chutecalc.output.plots.view import view
from chutecalc.results.solved import SolvedChute

KEY: dict[str, Any] = {"handlelength": 2.2, "columnspacing": 1.4, "borderaxespad": 0.0, "borderpad": 0.0}
"""Look of the legend of the side view, in one line."""


def draw_run(solutions: Sequence[SolvedChute], units: str = "metric") -> Figure:
    """Draws one chute with its stream, or several as lines to compare.

    Args:
        solutions: of one design each.
        units: ``metric`` or ``us``.

    Returns:
        The figure: axes ``side`` to scale, and one for each of ``PANELS`` over the distance along the stream.
    """
    with styled():
        return _one(solutions[0], units) if len(solutions) == 1 else draw_comparison(solutions, units)


def _one(solution: SolvedChute, units: str) -> Figure:
    """Draw a chute with its stream between its edges."""
    seen = view(solution)
    lines, marks = notes(solution, seen, units, WIDTH)
    title = solution.spec.title or solution.source
    figure, axes = page(title, extent(seen.lines), units, notes=len(lines))
    axes["notes"].text(0.0, 1.0, "\n".join(lines), va="top", fontsize=SMALL, linespacing=1.5)
    side = SideView(axes["side"], solution, seen, units)
    axes["key"].legend(side.handles.values(), side.handles.keys(), loc="center left", ncols=len(side.handles), **KEY)
    draw_panels(axes, seen, not solution.ok[0], units)
    lay_out(figure)
    mark_ends(axes, seen.traces, units)
    side.label(marks)
    return figure
