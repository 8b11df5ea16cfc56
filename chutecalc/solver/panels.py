"""The panels of many designs along one segment: the stream at any place of it."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.core import dense, gauss, state
from chutecalc.core.slide import Slide
from chutecalc.physics.arrays import Array, Index
from chutecalc.solver.course import Kind, stream_of
from chutecalc.solver.effort import compiled_rule


class Way(NamedTuple):
    """Designs on a segment, as the compiled solver reads them."""

    kind: Kind
    numbers: Array
    """Of all designs, a row each, as they were solved with."""
    start: int
    """Where in a row the segment's own begin, its wall first."""
    surfaces: Array
    """Entry slope, turn and length of the segment, a row each."""

    def widened(self, count: int) -> "Way":
        """The same of so many designs, where one has gone for all of them."""
        numbers, surfaces = np.repeat(self.numbers, count, axis=0), np.repeat(self.surfaces, count, axis=0)
        return self._replace(numbers=numbers, surfaces=surfaces)

    @property
    def slide(self) -> Slide:
        """A record of its kind."""
        return stream_of(self.kind).way

    @property
    def read(self) -> tuple[Slide, Array, int, Array]:
        """As the compiled functions of :mod:`chutecalc.core.profile` take it."""
        return self.slide, self.numbers, self.start, self.surfaces


class Panels:
    """The panels of n designs along a segment, those of a design one after the other."""

    def __init__(self, way: Way, kept: Array, first: Index, count: Index) -> None:
        """Panels as they were kept; there may be none.

        Args:
            way: the designs on it.
            kept: the panels, in one row.
            first, count: the number of each design's first panel, and how many it has.
        """
        self.way = way
        self.kept, self.first, self.count = kept, np.ascontiguousarray(first), np.ascontiguousarray(count)

    def of(self, design: int) -> Array:
        """A design's panels, a row each: 1 in r, nodes, facet, piece, start and end in c or r, the knots of y or c."""
        first = self.first[design]
        return self.kept.reshape(-1, state.PANEL)[first : first + self.count[design]]

    def velocities(self, ends: Array, places: Array, out: Array) -> None:
        """v² at places, shape (places, designs); ``ends`` as of :func:`chutecalc.core.dense.velocities`."""
        assert places.shape == out.shape == (len(places), len(self.count))  # the compiled loop does not look
        dense.velocities(self.kept, self.first, self.count, self._rules, ends, places, out)

    def times(self, places: Array, out: Array) -> None:
        """Seconds since the contact began, likewise; where no panel is, what stands there stays."""
        assert places.shape == out.shape == (len(places), len(self.count))
        dense.times(
            stream_of(self.way.kind), *self.way[1:], self.kept, self.first, self.count, self._rules, places, out
        )

    def knots(self) -> Array:
        """Places of the panels' knots after their starts, shape (knots, designs); NaN for what a design has too few."""
        nodes = self.kept.reshape(-1, state.PANEL)[:, 1].astype(np.intp)
        ends = np.concatenate([np.zeros(1, dtype=np.intp), np.cumsum(nodes + 1)])
        counts = ends[self.first + self.count] - ends[self.first]
        places = np.full((max(counts.max(initial=0), 1), len(counts)), np.nan)
        dense.knot_places(self.kept, self.first, self.count, self._rules, places)
        return places

    @cached_property
    def _rules(self) -> dict[int, gauss.Rule]:
        return {count: compiled_rule(count) for count in set(self.kept[1 :: state.PANEL].astype(int).tolist())}
