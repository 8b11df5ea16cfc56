"""The lines of a chute seen from the side: its surfaces, its belts, and its stream with its edges."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact
from chutecalc.output.plots.flights import Line
from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import Surface
from chutecalc.results.columns import COLUMNS
from chutecalc.results.drawn import DrawnSegment, drawn_segment

DEEPEST = 0.25
"""Greatest depth drawn, over the greater side of the chute: the depth has no bound where a stream nearly stops."""
LOST = "lost"
"""Kind of the trace of a stream that nothing catches."""
STRUCK = ("pressure_kpa", "wear_w_m2")
"""Columns that an impact has of its own, beside those of the stream along the surface."""
Lines = dict[str, Array]
"""Columns by name, each of shape (stations,)."""


class Trace(NamedTuple):
    """The stations of one segment or flight that the stream reached."""

    name: str
    kind: str
    side: float
    """1 on a floor, -1 under a roof, 0 in flight."""
    columns: Lines
    edges: list[Line]
    """The path in flight, if its edges are not known; else the edges, that on the surface or the lower one first."""

    def at(self, station: int) -> "Trace":
        """Return one station.

        Args:
            station: its number from 0; negative from the end.
        """
        columns = {name: values[[station]] for name, values in self.columns.items()}
        return self._replace(columns=columns, edges=[edge[:, [station]] for edge in self.edges])

    @property
    def path(self) -> Line:
        """The path of the stream, m."""
        return np.stack([self.columns["x_m"], self.columns["z_m"]])

    @property
    def middle(self) -> Line:
        """The line in the middle between its edges, m, or the middle one of three; the path where it comes to rest."""
        count = len(self.edges)
        middle = 0.5 * (self.edges[(count - 1) // 2] + self.edges[count // 2])
        return np.where(np.isfinite(middle), middle, self.path)

    @property
    def is_plate(self) -> bool:
        """Whether the stream strikes a surface at one point and leaves it there, with the pressure of the impact."""
        return self.side != 0.0 and not np.ptp(self.columns["s_m"]) and bool(self.columns["pressure_kpa"][0] > 0.0)


class Steel(NamedTuple):
    """The surface of a segment, whether the stream reaches it or not."""

    segment: Contact
    surface: Surface
    """Its surface where it is drawn."""
    path: Line
    """The same as a line."""
    top: Line
    """Where its walls end, or its roof; NaN where no height is given."""

    @property
    def drawn(self) -> DrawnSegment:
        """Where it begins and ends, and what is between."""
        return drawn_segment(self.segment, self.surface)

    @property
    def name(self) -> str:
        """Name of the segment."""
        return self.segment.name

    @property
    def side(self) -> float:
        """Sign of its side: 1 for a floor, -1 for a roof."""
        return self.segment.side

    @property
    def closed(self) -> bool:
        """Whether it has a roof where its walls end."""
        return self.segment.closed


class View(NamedTuple):
    """All that is to be seen of one design from the side."""

    stream: list[Trace]
    lost: Trace | None
    end: Trace | None
    """Where the stream ends before the chute does, of one station; None where it does not."""
    surfaces: list[Steel]
    feed: list[Line]
    """The belt that the stream comes from, see :func:`chutecalc.output.plots.belt_lines.feed_lines`."""
    received: list[Line]
    """The belt that it goes to, as one line."""
    impacts: Lines
    """``s_m`` and the columns of :data:`STRUCK` where the stream strikes surfaces, each of shape (impacts,)."""
    size: float
    """Greater side of the chute without belts, m."""

    @property
    def deepest(self) -> float:
        """Greatest depth to which the stream is drawn, m."""
        return DEEPEST * self.size

    @property
    def traces(self) -> list[Trace]:
        """The stream, with what is lost of it."""
        return [*self.stream, *([self.lost] if self.lost else [])]

    @property
    def lines(self) -> list[Line]:
        """All lines."""
        edges, steel = (
            (edge for trace in self.traces for edge in trace.edges),
            (line for each in self.surfaces for line in (each.path, each.top)),
        )
        return [*edges, *steel, *self.feed, *self.received]


def extent(lines: Sequence[Line]) -> Array:
    """Return width and height of lines together, m.

    Args:
        lines: at least one; NaN where there is none.
    """
    points = np.concatenate(lines, axis=1)
    size: Array = np.nanmax(points, axis=1) - np.nanmin(points, axis=1)
    return size


def along(stream: Sequence[Trace], name: str, units: str) -> tuple[Array, Array]:
    """Return the distance along the stream and another column, of all traces in order; NaN where it does not exist.

    Args:
        stream: the traces.
        name: of the column.
        units: ``metric`` or ``us``.
    """
    s, values = (np.concatenate([trace.columns[column] for trace in stream]) for column in ("s_m", name))
    return COLUMNS["s_m"].converted(s, units), COLUMNS[name].converted(values, units)
