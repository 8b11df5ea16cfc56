"""A solved chute: the results that output, studies and the public ``Solution`` read."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.belts import receiver_numbers
from chutecalc.results.column_names import check_columns, column_names
from chutecalc.results.columns import AT_STATION, NUMERIC
from chutecalc.results.described import status_text
from chutecalc.results.edges import Edge, stream_edges
from chutecalc.results.finding import Finding
from chutecalc.results.findings import find_in_spec, in_order
from chutecalc.results.inlet import inlet_numbers
from chutecalc.results.scene import Written
from chutecalc.results.segments import SegmentResult, Segments
from chutecalc.results.stations import at_stations
from chutecalc.results.trajectory import Trajectory
from chutecalc.solver.segment_solution import Ends, SegmentSolution
from chutecalc.spec.chute_spec import ChuteSpec


class CheckedChute(Protocol):
    """What a solved chute keeps of the chute that was solved."""

    data: dict[str, Any]
    source: str
    spec: ChuteSpec
    design: Design
    count: int


class SolvedChute:
    """The solution of a chute, or of n variants of it. Numbers are NaN after a design's failure.

    Arrays over designs are of shape (designs,), also for one design.
    """

    def __init__(
        self, chute: CheckedChute, segment_solutions: Sequence[SegmentSolution], ends: Ends, rtol: float
    ) -> None:
        """Take what the solver found, as :func:`chutecalc.solve` does.

        Args:
            chute: that was solved.
            segment_solutions: the solved segments in the order in which the stream meets them.
            ends: how the designs end.
            rtol: relative error allowed to the velocity.
        """
        self.source: str = chute.source
        """Name of the spec in messages and tables, usually its file."""
        self.spec: ChuteSpec = chute.spec
        """The checked spec."""
        self.data: dict[str, Any] = chute.data
        """The spec as written: nested tables as TOML gives them."""
        self.design: Design = chute.design
        """The numeric description, SI and radians."""
        self.count: int = chute.count
        """Number of designs."""
        self.rtol: float = rtol
        """Relative error allowed to the velocity."""
        self._ends = ends
        self.error_estimate: Array = stretched(ends.error, (chute.count,))
        """Estimated relative error of the last velocity, shape (designs,); after a stall that of its position, as a
        share of the segment's length."""
        self.trajectory = Trajectory(chute.design, segment_solutions, ends, chute.count)
        """The solved trajectory, part by part, for programs that extend chutecalc."""

    @cached_property
    def status(self) -> Any:
        """``ok``, ``stall``, ``choke``, ``contact_lost`` or ``missed`` for each design, text of shape (designs,)."""
        return status_text(self.trajectory.status_numbers)

    @property
    def ok(self) -> Mask:
        """Whether the stream of each design reaches the end of the chute, shape (designs,)."""
        ok: Mask = self.trajectory.status_numbers == Status.OK
        return ok

    @property
    def exit_velocity(self) -> Array:
        """Velocity at the end of the chute, m/s, shape (designs,)."""
        return self.exit_columns(("velocity_m_s",))["velocity_m_s"]

    @property
    def exit_depth(self) -> Array:
        """Flow depth at the end of the chute, m, shape (designs,); NaN in free flight."""
        return self.exit_columns(("depth_m",))["depth_m"]

    @cached_property
    def exit(self) -> Numbers:
        """The stream at the end of the chute: arrays of shape (designs,) by column name."""
        return self.exit_columns(NUMERIC)

    def exit_columns(self, names: Iterable[str]) -> Numbers:
        """Return some columns of :attr:`exit`, without working out the others.

        Args:
            names: of columns, as ``chutecalc columns`` lists them.

        Returns:
            Arrays of shape (designs,) by name, NaN for designs that fail.

        Raises:
            UsageError: a name is unknown.
        """
        names = column_names(names)
        check_columns(names, NUMERIC, " at the exit")
        return self.trajectory.exit_columns(names)

    @cached_property
    def receiver(self) -> Numbers:
        """What the stream does to the receiving belt: arrays of shape (designs,) by name; empty without a receiver.

        NaN for designs that fail. ``matching_slope_deg`` is the slope, next to the present one, at which the stream
        would have the belt's velocity along it where it lands, and ``matching_velocity_m_s`` the velocity that would
        match at the present slope; infinite or NaN where there is none.
        """
        numbers = receiver_numbers(self.design, self._ends)
        return {name: stretched(values, (self.count,)) for name, values in numbers.items()}

    @cached_property
    def inlet(self) -> Numbers:
        """The stream at the inlet: arrays of shape (designs,) by name.

        From a belt also v²/(g r), its lower edge, the load on a belt whose width is given, and the bounds of a stream
        that goes round the pulley.
        """
        return {name: np.broadcast_to(values, self.count) for name, values in inlet_numbers(self.design).items()}

    @cached_property
    def edges(self) -> list[Edge]:
        """The edges of each flight of a stream with a depth, and where they land: those from a belt come first."""
        return stream_edges(self.design, self.trajectory.parts, self.rtol, self.count)

    @property
    def segments(self) -> Segments:
        """Results of the segments of the spec, by number or name; those of a segment struck twice are joined."""
        return self.trajectory.segments()

    @property
    def flights(self) -> list[list[SegmentResult]]:
        """For each segment the flights that lead to it; several where it is left and struck again."""
        return self.trajectory.flights()

    @property
    def last_flights(self) -> list[SegmentResult]:
        """The flights behind the last surface: ``exit:flight`` out of a pipe, ``receiver:flight`` onto a belt."""
        return self.trajectory.last_flights

    def findings(self) -> list[Finding]:
        """Return failures, warnings and notes, each with a mask of the designs concerned."""
        found = find_in_spec(Written(self.spec, self.data, self.design, self.count))
        return in_order([*found, *self.trajectory.findings(self.receiver, self.inlet, self.edges)])

    def stations(
        self, points: int | None = None, spacing: float | None = None, columns: Iterable[str] = ()
    ) -> dict[str, Any]:
        """Return the stream at stations along the chute, and along the flights behind it.

        Args:
            points: number of stations on each segment, both ends of the part travelled included; 101 by default.
            spacing: instead, distance between stations, m: they lie at multiples of it from each segment's drawn start
                (a flight's from where it begins), and at both ends of the part travelled.
            columns: names of the columns to work out; all by default.

        Returns:
            Arrays of shape (designs, stations) by column name; NaN where a design has no such station or the stream
            no such quantity there.

        Raises:
            UsageError: both are given, they would make no stations or more than two million, or a name is unknown.

        >>> import chutecalc
        >>> table = chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).stations(points=3)
        >>> table["segment"][0].tolist()
        ['fall', 'fall', 'fall', 'spoon', 'spoon', 'spoon']
        """
        names = column_names(columns) or AT_STATION
        parts = [*self.trajectory.parts, *self.trajectory.last_parts]
        return at_stations(parts, self.count, points, spacing, names)
