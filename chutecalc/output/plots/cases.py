"""The operating states of a chute in its picture: each a thin line over the stream of the design point."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from chutecalc.output.outcome import outcome
from chutecalc.output.plots.flights import Line
from chutecalc.output.plots.layout import PANELS, VISIBLE
from chutecalc.output.plots.looks import END, MISSED
from chutecalc.output.plots.style import INK, MARKS, colours
from chutecalc.output.plots.text import fitted
from chutecalc.output.plots.traces import View, along
from chutecalc.output.plots.view import view
from chutecalc.results.cases import Cases
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Severity

WARM = ("plasma", 0.4, 0.72)
"""Colours of the lines: part of a map whose colours the stream, coloured by velocity, does not have."""
STROKES: tuple[Any, ...] = ((0, (5, 1.5)), "-.", (0, (6, 1.5, 1, 1.5, 1, 1.5)), (0, (12, 2)), (0, (2, 1)))
"""Neither a solid line, which is the design point, nor dots, which are not solved."""
THIN = 0.9
"""Width of a line, points."""


class CaseLine(NamedTuple):
    """An operating state beside the design point, and how it is drawn."""

    name: str
    seen: View
    status: str
    look: dict[str, Any]

    @property
    def fails(self) -> bool:
        """Whether its stream ends before the chute does."""
        return self.seen.end is not None

    @property
    def lines(self) -> list[Line]:
        """The line in the middle of its stream, m; then that on which it flies on where nothing catches it."""
        stream = np.concatenate([trace.middle for trace in self.seen.stream], axis=1)
        return [stream, *([self.seen.lost.middle] if self.seen.lost else [])]

    @property
    def stroke(self) -> dict[str, Any]:
        """Look of its line."""
        return {"color": self.look["color"], "linestyle": self.look["linestyle"], "linewidth": THIN}

    @property
    def lost(self) -> dict[str, Any]:
        """Look of its line where nothing catches it."""
        return MISSED | {"color": self.look["color"], "gid": "case lost"}

    @property
    def end(self) -> dict[str, Any]:
        """Look of its last point: its marker, or the mark of a stream that ends before its chute does."""
        own: dict[str, Any] = {} if self.fails else {"marker": self.look["marker"], "markersize": 5.5}
        return END | own | {"color": self.look["color"], "markeredgecolor": "white", "zorder": 3.5, "gid": "case end"}


def case_lines(cases: Cases) -> list[CaseLine]:
    """Return the operating states that are drawn beside the design point.

    Args:
        cases: the states of one design.
    """
    states = {name: solution for name, solution in cases.solutions.items() if name != cases.main}
    found = []
    for k, ((name, solution), colour) in enumerate(zip(states.items(), colours(len(states), *WARM), strict=True)):
        look = {"color": colour, "marker": MARKS[k % len(MARKS)], "linestyle": STROKES[k % len(STROKES)]}
        found.append(CaseLine(name, view(solution), str(solution.status[0]), look))
    return found


def draw_paths(axes: Axes, lines: Sequence[CaseLine], units: str) -> None:
    """Draw the middle of the streams from the side.

    Args:
        axes: axes to draw on.
        lines: the operating states.
        units: ``metric`` or ``us``.
    """
    for line in lines:
        path, *lost = (COLUMNS["x_m"].converted(each, units) for each in line.lines)
        axes.plot(*path, **line.stroke, zorder=2.5, gid="case")
        for each in lost:
            axes.plot(*each, **line.lost)
        end = path[:, -1:] if line.seen.end is None else COLUMNS["x_m"].converted(line.seen.end.middle, units)
        axes.plot(*end, **line.end)


def draw_columns(axes: Mapping[str, Axes], lines: Sequence[CaseLine], units: str) -> None:
    """Draw the columns of the streams in the panels.

    Args:
        axes: axes by name.
        lines: the operating states.
        units: ``metric`` or ``us``.
    """
    for panel in PANELS:
        for line in lines:
            stream, lost, end = line.seen.stream, line.seen.lost, line.seen.end
            axes[panel].plot(*along(stream, panel, units), **line.stroke, gid="case")
            if lost:
                axes[panel].plot(*along([lost], panel, units), **line.lost)
            axes[panel].plot(*along([end or stream[-1].at(-1)], panel, units), **line.end)


def handles(lines: Sequence[CaseLine]) -> dict[str, Any]:
    """Return what a legend shows for the operating states, by its text; nothing where there are none.

    Args:
        lines: the operating states.
    """
    found = {"design point": Line2D([], [], color=INK)} if lines else {}
    for line in lines:
        ends = {"marker": "X"} if line.fails else {}
        text = f"{line.name} ({line.status.replace('_', ' ')})" if line.fails else line.name
        found[text] = Line2D([], [], linewidth=THIN, markersize=5, **line.look | ends)
    return found


def case_notes(cases: Cases, units: str, width: float) -> list[str]:
    """Return lines of text for each operating state: its outcome, and what it has to tell beside the design point.

    Args:
        cases: the states of one design.
        units: ``metric`` or ``us``.
        width: of the lines, inches.
    """
    lines = []
    for name, solution in cases.solutions.items():
        if name == cases.main:
            continue
        found = cases.findings(name)
        warned = dict.fromkeys(finding.code for finding in found if finding.severity == Severity.WARNING)
        more = f"; warning {', '.join(warned)}" if warned else ""
        texts = [f"case {name}: {outcome(solution, units, VISIBLE)}{more}"]
        texts += [
            f"    failure {finding.code}: {finding.segment}: {finding.message(0, units)}"
            for finding in found
            if finding.severity == Severity.FAILURE
        ]
        lines += [line for text in texts for line in fitted(text, width, indent="    ").split("\n")]
    return lines
