"""The public solution of a chute: its results, a picture, data frames, and how it shows itself."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from chutecalc.errors import UsageError
from chutecalc.extras import PLOT, require_extra
from chutecalc.results.column import Units
from chutecalc.results.described import number, outcomes
from chutecalc.results.solved import SolvedChute

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DEFAULT_COLUMNS = ("velocity_m_s", "depth_m", "slope_deg")
"""Columns at the exit that are shown by default."""


class Solution(SolvedChute):
    """The solution of a chute, or of n variants of it. Numbers are NaN after a design's failure.

    Arrays over designs are of shape (designs,), also for one design.

    >>> import chutecalc
    >>> solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    >>> solution.status.tolist(), solution.exit_velocity.round(3).tolist()
    (['ok'], [6.222])
    >>> level = chutecalc.parse(chutecalc.STARTER).put({"segments.spoon.to_slope_deg": 0})
    >>> [finding.code for finding in chutecalc.solve(level).findings()]
    ['below_cut_off', 'will_not_clear']
    """

    def plot(self, units: str = "metric") -> "Figure":
        """Draw the chute from the side with its stream, and velocity, depth and pressure along it.

        Args:
            units: ``metric`` or ``us``.

        Returns:
            The Matplotlib figure; ``figure.savefig("chute.svg")`` writes it.

        Raises:
            UsageError: the solution is that of several designs, or the units are unknown.
            ExtraMissingError: Matplotlib is not installed.
        """
        if self.count != 1:
            raise UsageError(
                f"plot draws one design, and this solution has {self.count}: take one design with `chute.put`"
                " and solve it"
            )
        if units not in tuple(Units):
            raise UsageError(f"units must be {' or '.join(Units)}, not {units!r}")
        require_extra("Solution.plot", PLOT)
        from chutecalc.output.plots.run import draw_run
        from chutecalc.results.cases import Cases
        from chutecalc.spec.operating import DESIGN_POINT

        return draw_run([Cases({DESIGN_POINT: self})], units)

    def to_dataframe(
        self,
        points: int | None = None,
        spacing: float | None = None,
        columns: Iterable[str] = (),
        library: str = "pandas",
    ) -> Any:
        """Return the stations as a data frame, a row for each that a design's stream reached.

        Args:
            points: number of stations on each segment, as for :meth:`stations`.
            spacing: instead, distance between stations, m.
            columns: names of the columns; all by default.
            library: ``pandas`` or ``polars``; it is imported only here.

        Returns:
            A ``DataFrame`` of that library. Of several designs it begins with a column ``design``, numbered from 0.

        Raises:
            UsageError: as for :meth:`stations`, or another library.
            ExtraMissingError: the library is not installed.
        """
        from chutecalc.api.dataframe import stations_frame

        return stations_frame(self, points, spacing, columns, library)

    def designs_dataframe(self, columns: Iterable[str] = DEFAULT_COLUMNS, library: str = "pandas") -> Any:
        """Return a data frame with a row for each design: its status and columns at the exit.

        Args:
            columns: names of columns at the exit; in the frame ``exit_`` stands before them, as in sweeps.
            library: ``pandas`` or ``polars``; it is imported only here.

        Returns:
            A ``DataFrame`` of that library, NaN for designs that fail.

        Raises:
            UsageError: a name is unknown, or the library.
            ExtraMissingError: the library is not installed.
        """
        from chutecalc.api.dataframe import designs_frame

        return designs_frame(self, columns, library)

    def __repr__(self) -> str:
        """Return the outcome and how the stream leaves.

        >>> import chutecalc
        >>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
        <Solution: ok, leaves spoon at 6.222 m/s, 0.09396 m deep>
        """
        return f"<Solution{self._described()}>"

    def _repr_html_(self) -> str:
        """Return a table of the segments, for notebooks."""
        return self.segments.html_table(f"Solution{self._described()}")

    def _described(self) -> str:
        """Return how the designs end, as text."""
        if self.count > 1:
            return f" of {self.count} designs: {outcomes(self.status)}"
        if not self.ok[0]:
            segment_solutions, code = self.trajectory.segment_solutions, self.trajectory.status_numbers[0]
            failed = next((solved for solved in segment_solutions if solved.status[0] == code), segment_solutions[-1])
            return f": {self.status[0]} in {failed.segment.name} at s = {number(failed.exit.distance, 'm')}"
        last, depth = self.design.segments[-1].name, number(self.exit_depth, "m deep")
        return f": ok, leaves {last} at {number(self.exit_velocity, 'm/s')}" + ("" if depth == "–" else f", {depth}")
