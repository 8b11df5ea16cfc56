"""Evaluate the panels of many designs along one segment."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.core import batch, dense_output, gauss, state
from chutecalc.core.guide_surface import Guide
from chutecalc.physics.arrays import Array, Index
from chutecalc.solver.chain_input import SegmentLayout, stream_for
from chutecalc.solver.options import compiled_rule


class GuideRows(NamedTuple):
    """A segment of many designs, as the compiled solver reads it."""

    layout: SegmentLayout
    rows: Array
    """Rows of the designs as they were solved with, shape (designs, numbers)."""
    offset: int
    """Offset of the segment's own numbers in a row, its wall first."""
    surfaces: Array
    """Entry slope, rad, turn, rad, length, m, and side of the surface, shape (designs, 4)."""

    def broadcast(self, count: int) -> "GuideRows":
        """Return the rows of ``count`` designs, where one stands for all of them.

        Args:
            count: number of designs.
        """
        rows, surfaces = np.repeat(self.rows, count, axis=0), np.repeat(self.surfaces, count, axis=0)
        return self._replace(rows=rows, surfaces=surfaces)

    @property
    def momentum_root(self) -> Array:
        """√α_m of the designs, a ratio: the core's y is α_m v². Shape (designs,)."""
        root: Array = np.sqrt(self.rows[:, batch.MOMENTUM_COLUMN])
        return root

    @property
    def guide(self) -> Guide:
        """A core record of the segment's layout."""
        return stream_for(self.layout).guide

    @property
    def core_arguments(self) -> tuple[Guide, Array, int, Array]:
        """First arguments of the functions of :mod:`chutecalc.core.profile`, numbers in SI units."""
        return self.guide, self.rows, self.offset, self.surfaces


class Panels:
    """Panels of n designs along a segment, those of a design one after the other."""

    def __init__(self, guide_rows: GuideRows, store: Array, first: Index, count: Index) -> None:
        """Hold stored panels; there may be none.

        Args:
            guide_rows: the segment.
            store: numbers of all panels in one row, see :meth:`of_design`.
            first: number of each design's first panel, shape (designs,).
            count: how many each has, shape (designs,).
        """
        self.guide_rows = guide_rows
        self.store, self.first, self.count = store, np.ascontiguousarray(first), np.ascontiguousarray(count)

    def of_design(self, design: int) -> Array:
        """Return a design's panels, a row each.

        A row has 1 for a panel in r, nodes, facet, piece, start and end in c or r, and the knots' y or c.

        Args:
            design: its number, from 0.
        """
        first = self.first[design]
        return self.store.reshape(-1, state.PANEL_NUMBERS)[first : first + self.count[design]]

    def velocities_squared(self, ends: Array, shares: Array, out: Array) -> None:
        """Write α_m v² at shares, m²/s².

        Args:
            ends: as in :func:`chutecalc.core.dense_output.velocities_squared`, shape (4, designs).
            shares: shares of the segment, shape (shares, designs).
            out: α_m v², m²/s², of the same shape.
        """
        assert shares.shape == out.shape == (len(shares), len(self.count))  # the compiled loop does not check
        dense_output.velocities_squared(self.store, self.first, self.count, self._rules, ends, shares, out)

    def times(self, shares: Array, out: Array) -> None:
        """Write the time since contact began, s; entries where no panel is stay as they are.

        Args:
            shares: shares of the segment, shape (shares, designs).
            out: times, s, of the same shape.
        """
        assert shares.shape == out.shape == (len(shares), len(self.count))
        dense_output.times(
            stream_for(self.guide_rows.layout),
            *self.guide_rows[1:],
            self.store,
            self.first,
            self.count,
            self._rules,
            shares,
            out,
        )

    def knot_shares(self) -> Array:
        """Return the shares of the panels' knots after their starts, shape (knots, designs).

        It is NaN past a design's last knot.
        """
        nodes = self.store.reshape(-1, state.PANEL_NUMBERS)[:, 1].astype(np.intp)
        ends = np.concatenate([np.zeros(1, dtype=np.intp), np.cumsum(nodes + 1)])
        counts = ends[self.first + self.count] - ends[self.first]
        shares = np.full((max(counts.max(initial=0), 1), len(counts)), np.nan)
        dense_output.knot_shares(self.store, self.first, self.count, self._rules, shares)
        return shares

    @cached_property
    def _rules(self) -> dict[int, gauss.Rule]:
        return {count: compiled_rule(count) for count in set(self.store[1 :: state.PANEL_NUMBERS].astype(int).tolist())}
