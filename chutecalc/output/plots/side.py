"""A chute from the side, to scale: surfaces, belts, and the stream between its edges, coloured by velocity."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import Collection, LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from chutecalc.output.plots.belts import draw_feed, draw_receiver
from chutecalc.output.plots.cases import CaseLine, draw_paths
from chutecalc.output.plots.flights import Line
from chutecalc.output.plots.labels import Label, place_labels
from chutecalc.output.plots.looks import EDGE, END, MISSED, ROOF, STRUCK, SURFACE, WALLS
from chutecalc.output.plots.marks import Mark, belt_labels, impact_labels, mark_labels, names
from chutecalc.output.plots.style import INK, MAP, PALE, SMALL, STEEL
from chutecalc.output.plots.traces import Steel, Trace, View
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

ROOM = 0.06
"""Margin for names and numbers, over the greater side of the picture."""
FILLED_BETWEEN = np.linspace(0.0, 1.0, 5)
"""Shares of its depth at which lines stand for a stream where labels are placed."""


def draw_surfaces(axes: Axes, surfaces: Sequence[Steel], units: str) -> dict[str, Any]:
    """Draw the surfaces of a chute, and its roofs or the tops of its walls.

    Args:
        axes: axes to draw on.
        surfaces: of the chute.
        units: ``metric`` or ``us``.

    Returns:
        What a legend explains, by its text.
    """
    length = COLUMNS["x_m"]
    handles: dict[str, Any] = {}
    for steel in surfaces:
        axes.plot(*length.converted(steel.path, units), **SURFACE)
        handles.setdefault("surface", Line2D([], [], color=STEEL, linewidth=2.2))
        if np.isfinite(steel.top).any():
            (top,) = axes.plot(*length.converted(steel.top, units), **ROOF if steel.closed else WALLS)
            handles.setdefault("roof" if steel.closed else "top of the walls", top)
    return handles


def set_scale(axes: Axes) -> None:
    """Set the same scale in both directions, with a margin for names and numbers.

    Args:
        axes: axes on which all lines are drawn.
    """
    low, high = axes.dataLim.get_points()
    room = ROOM * (high - low).max()
    axes.update_datalim([low - room, high + room])
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.0)


class SideView:
    """A chute with its stream, drawn on axes."""

    def __init__(self, axes: Axes, solution: SolvedChute, seen: View, cases: Sequence[CaseLine], units: str) -> None:
        """Draw all but the labels, and set the scale.

        Args:
            axes: axes to draw on.
            solution: solution of one design.
            seen: its lines.
            cases: its other operating states.
            units: ``metric`` or ``us``.
        """
        self.axes, self.solution, self.seen, self.cases, self.units = axes, solution, seen, cases, units
        self.handles: dict[str, Any] = {}
        """What the legend explains, by its text."""
        self.shades = self._shades()
        self.handles |= draw_surfaces(axes, seen.surfaces, units)
        for trace in seen.stream:
            if np.ptp(trace.path, axis=1).any():  # not on a plate
                self._draw_trace(trace)
        for edge in seen.lost.edges if seen.lost else ():
            (drawn,) = axes.plot(*self._long(edge), **MISSED)
            self._explain("flies on, not solved", drawn)
        self.feed, self.received = ([self._long(line) for line in lines] for lines in (seen.feed, seen.received))
        draw_feed(axes, self.feed)
        draw_receiver(axes, self.received, solution.design.receiver)
        if seen.end:
            (drawn,) = axes.plot(*self._long(seen.end.path), **END)
            self._explain("end", drawn)
        draw_paths(axes, cases, units)
        self._frame()

    def label(self, marks: Sequence[Mark]) -> None:
        """Write names, incidences and numbers. Call it when all else of the figure is there.

        Args:
            marks: numbers to set beside the stream.
        """
        stream, size = self.seen.stream, self.seen.size
        struck = [label for label in impact_labels(self.solution, self.units) if label.text]
        labels: list[Label] = [*names(self.seen, self.units), *struck]
        labels += belt_labels(self.solution, self.seen, self.units)
        labels += mark_labels(stream, marks, size, self.units)
        lines = (*self.seen.lines, *self._inside(), *(line for case in self.cases for line in case.lines))
        place_labels(self.axes, labels, [self._long(line) for line in lines])

    def _inside(self) -> list[Line]:
        """Return lines that stand for the stream between its edges, and for a pulley inside its rim."""
        rims = [(pulley, pulley.mean(axis=1)[:, None]) for pulley in self.seen.feed[2:]]
        bands = [(trace.edges[0], trace.edges[-1]) for trace in self.seen.stream if len(trace.edges) > 1]
        return [one + share * (other - one) for one, other in (*bands, *rims) for share in FILLED_BETWEEN]

    def _long(self, metres: Array) -> Array:
        """Return lengths in the unit of the picture."""
        lengths: Array = COLUMNS["x_m"].converted(metres, self.units)
        return lengths

    def _explain(self, name: str, handle: Any) -> None:
        """Give the legend an entry, once."""
        self.handles.setdefault(name, handle)

    def _shades(self) -> Normalize:
        """Return the scale of colours."""
        velocity = np.concatenate([trace.columns["velocity_m_s"] for trace in self.seen.stream])
        return Normalize(*COLUMNS["velocity_m_s"].converted(np.array([velocity.min(), velocity.max()]), self.units))

    def _draw_trace(self, trace: Trace) -> None:
        """Draw the stream between its edges, or its path where it has none."""
        edges = [self._long(edge).T for edge in trace.edges]
        drawn: Collection
        if len(edges) == 1:
            (path,) = edges
            self.axes.plot(*path.T, color=INK, linewidth=3.0, solid_capstyle="butt", gid="path")
            pieces = list(np.stack([path[:-1], path[1:]], axis=1))
            drawn = LineCollection(pieces, linewidths=1.8, capstyle="projecting", gid="flight")
            self._explain("in flight, path only", Line2D([], [], color=INK, linewidth=3.0))
        else:
            low, high = edges[0], edges[-1]
            cells = np.stack([low[:-1], low[1:], high[1:], high[:-1]], axis=1)
            drawn = PolyCollection(list(cells), edgecolors="face", linewidths=0.4, gid=_band(trace))
            self._draw_edges(trace, edges)
        velocity = COLUMNS["velocity_m_s"].converted(trace.columns["velocity_m_s"], self.units)
        drawn.set(array=0.5 * (velocity[1:] + velocity[:-1]), cmap=MAP, norm=self.shades)
        self.axes.add_collection(drawn)

    def _draw_edges(self, trace: Trace, edges: Sequence[Array]) -> None:
        """Draw the free surface of a stream, or the edges of a flight."""
        patch: dict[str, Any] = {"facecolor": PALE, "edgecolor": INK, "linewidth": 0.7}
        if trace.side:
            self.axes.plot(*edges[-1].T, **EDGE, gid="free surface")
            self._explain("stream", Patch(**patch))
        else:
            for edge in edges:
                self.axes.plot(*edge.T, **EDGE, linestyle="--", gid="edge")
            self._explain("in flight", Patch(**patch, linestyle="--"))

    def _frame(self) -> None:
        """Mark impacts, set the scale, and add the colour bar."""
        struck = impact_labels(self.solution, self.units)
        if struck:
            (drawn,) = self.axes.plot([each.x for each in struck], [each.z for each in struck], **STRUCK)
            self._explain("impact and its incidence", drawn)
        set_scale(self.axes)
        for band in [artist for artist in self.axes.collections if artist.get_array() is not None][:1]:
            bar = self.axes.figure.colorbar(band, ax=self.axes, location="right", aspect=45, pad=0.01)
            column = COLUMNS["velocity_m_s"]
            bar.ax.set_title(f"{column.symbol}, {column.unit_text(self.units)}", fontsize=SMALL, loc="center")


def _band(trace: Trace) -> str:
    """Return the name of a band in the picture."""
    return "stream" if trace.side else "flight"
