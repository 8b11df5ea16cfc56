"""What came out: the stream at every place of every design, by the names of the column catalogue."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Index
from chutecalc.results.belts import TAKEN, entering, received
from chutecalc.results.column import Numbers
from chutecalc.results.columns import COLUMNS, NUMERIC, REPORTED
from chutecalc.results.criterion import SampledPart
from chutecalc.results.described import html_table, number, outcomes
from chutecalc.results.extremes import LARGEST, LEAST, Extreme, ExtremeOf, extremes
from chutecalc.results.finding import Finding
from chutecalc.results.findings import NEEDED, find
from chutecalc.results.part import Part
from chutecalc.results.segments import SegmentResult, Segments, joined
from chutecalc.results.stations import at_stations
from chutecalc.solver.leg import Ends, Leg

TOLD = list(dict.fromkeys([(name, sign) for name in REPORTED for sign in (LEAST, LARGEST)] + [*NEEDED]))

SAMPLED = [*dict.fromkeys([*NUMERIC, *(name for name, _ in NEEDED)])]


class Solution:
    """The solution of a chute, or of n variants of it. Numbers are NaN after a design's failure."""

    def __init__(self, design: Design, legs: tuple[Leg, ...], ends: Ends, rtol: float, count: int) -> None:
        self.design, self.legs, self.ends, self.rtol, self.count = design, legs, ends, rtol, count
        self.codes: Index = stretched(ends.status, (count,))
        """The :class:`~chutecalc.design.Status` of each design, shape (designs,)."""
        self.error_estimate: Array = stretched(ends.error, (count,))
        """Estimated relative error of the last velocity; after a stall, of its place as a share of the segment."""

    def __repr__(self) -> str:
        """Outcome, and how the stream leaves.

        >>> import chutecalc
        >>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
        <Solution: ok, leaves spoon at 3.878 m/s, 0.1399 m deep>
        """
        return f"<Solution{self._described()}>"

    def _repr_html_(self) -> str:
        """A row for each segment, for notebooks: of several designs the ranges."""
        headings = ("segment", "kind", "status", "entry, m/s", "exit, m/s", "exit depth, m")
        rows = [
            (
                segment.name,
                segment.kind,
                str(segment.status[0]) if self.count == 1 else outcomes(segment.status),
                number(segment.entry["velocity_m_s"]),
                number(np.where(segment.status == "ok", segment.exit["velocity_m_s"], np.nan)),
                number(np.where(segment.status == "ok", segment.exit["depth_m"], np.nan)),
            )
            for segment in self.segments
        ]
        return html_table(f"Solution{self._described()}", headings, rows)

    def _described(self) -> str:
        if self.count > 1:
            return f" of {self.count} designs: {outcomes(self.status)}"
        last, status = self.design.segments[-1].name, str(self.status[0])
        if status != Status.LABELS[Status.OK]:
            failed = next((leg for leg in self.legs if leg.status[0] == self.codes[0]), self.legs[-1])
            return f": {status} in {failed.segment.name} at s = {number(failed.exit.distance, 'm')}"
        depth = number(self.exit_depth, "m deep")
        return f": ok, leaves {last} at {number(self.exit_velocity, 'm/s')}" + ("" if depth == "–" else f", {depth}")

    @cached_property
    def status(self) -> Any:
        """``ok``, ``stall``, ``choke``, ``contact_lost`` or ``missed`` for each design, shape (designs,)."""
        return _labels(self.codes)

    @property
    def exit_velocity(self) -> Array:
        """Velocity at the end of the chute, m/s, shape (designs,)."""
        return self.exit_columns(("velocity_m_s",))["velocity_m_s"]

    @property
    def exit_depth(self) -> Array:
        """Flow depth there, m, shape (designs,); NaN in free flight."""
        return self.exit_columns(("depth_m",))["depth_m"]

    @cached_property
    def exit(self) -> Numbers:
        """The stream at the end of the chute, by column name, each of shape (designs,)."""
        return self.exit_columns(NUMERIC)

    def exit_columns(self, names: Iterable[str]) -> Numbers:
        """Some of :attr:`exit`, without the others being worked out."""
        names = list(names)
        last = len(self.design.segments) - 1
        found = {name: np.full(self.count, np.nan) for name in names}
        for part in self.parts:  # of a hood that is left and struck again there are several
            if part.leg.number == last and part.kind != "flight":
                ends = part.at(np.ones(1), names)
                here = (part.leg.status == Status.OK) & (self.codes == Status.OK)
                found = {name: np.where(here, ends[name][0], values) for name, values in found.items()}
        return found

    def extreme_columns(self, wanted: Sequence[ExtremeOf]) -> dict[ExtremeOf, Array]:
        """The least or largest values of some columns on all guiding surfaces together, without the others.

        Args:
            wanted: pairs of a column's name and ``LEAST`` or ``LARGEST``.

        Returns:
            Arrays of shape (designs,), up to where a stream ends; NaN where there is no such quantity, infinite where
            it grows without bound, as depth does towards a stall.
        """
        names = list(dict.fromkeys(name for name, _ in wanted))
        found = {item: np.full(self.count, np.nan) for item in wanted}
        for part in self.parts:
            if part.contact is not None and wanted:
                shares = part.shares()
                here = extremes(part, part.at(shares, names), shares, wanted)
                found = {
                    (name, sign): (np.fmax if sign == LARGEST else np.fmin)(values, here[name, sign].value)
                    for (name, sign), values in found.items()
                }
        return found

    @cached_property
    def receiver(self) -> Numbers:
        """What the stream does to the belt that it goes to; empty where the spec has none.

        Arrays by name with unit, each of shape (designs,), NaN for designs that fail. ``matching_slope_deg`` is the
        exit slope, next to the one there is, at which the stream would have the belt's velocity along it, and
        ``matching_velocity_m_s`` the exit velocity that would do so at the slope there is; infinite or NaN where there
        is none.
        """
        if self.design.receiver is None:
            return {}
        return received(self.design, self.exit_columns(TAKEN))

    @cached_property
    def inlet(self) -> Numbers:
        """The stream where it enters, each of shape (designs,); from a belt also V²/(g r) and its lower edge."""
        return {name: np.broadcast_to(values, self.count) for name, values in entering(self.design).items()}

    @cached_property
    def parts(self) -> list[Part]:
        """The way in order: the spec's segments, each behind the flight that leads to it if any design flies there."""
        parts: list[Part] = []
        before: Part | None = None
        for leg in self.legs:
            name, kind = leg.segment.name, leg.segment.kind
            if leg.contact is not None and (leg.flight_time > 0.0).any():
                parts.append(Part(f"{name}:flight", "flight", leg, None, before, self.design))
            before = Part(name, kind, leg, leg.contact, before, self.design)
            parts.append(before)
        return parts

    @cached_property
    def shares(self) -> list[Array]:
        """Where each part is sampled, see :meth:`chutecalc.results.part.Part.shares`."""
        return [part.shares() for part in self.parts]

    @cached_property
    def samples(self) -> list[Numbers]:
        """The columns of each part there; what extremes and findings are read from."""
        return [part.at(shares, SAMPLED) for part, shares in zip(self.parts, self.shares, strict=True)]

    @cached_property
    def extremes(self) -> list[dict[ExtremeOf, Extreme]]:
        """The extremes of each part that are told, or that findings ask for."""
        return [extremes(*items, TOLD) for items in zip(self.parts, self.samples, self.shares, strict=True)]

    @cached_property
    def ways(self) -> list[SegmentResult]:
        """The parts of the way in order: the segments, each behind the flight that leads to it, if there is one."""
        return [self._result(*items) for items in zip(self.parts, self.samples, self.extremes, strict=True)]

    @property
    def segments(self) -> Segments:
        """The segments of the spec, by number or name; one that was left and struck again as one."""
        found: dict[int, SegmentResult] = {}
        for part, way in zip(self.parts, self.ways, strict=True):
            if way.kind != "flight":
                number = part.leg.number
                found[number] = joined(found[number], way) if number in found else way
        return Segments(found.values())

    @property
    def flights(self) -> list[list[SegmentResult]]:
        """For each segment of the spec the flights that lead to it; several where it is left and struck again."""
        pairs = list(zip(self.parts, self.ways, strict=True))
        return [
            [way for part, way in pairs if part.leg.number == number and way.kind == "flight"]
            for number in range(len(self.design.segments))
        ]

    def findings(self) -> list[Finding]:
        """Failures, warnings and notes, each with a mask of the designs that it is about."""
        sampled = [
            SampledPart(*items) for items in zip(self.parts, self.shares, self.samples, self.extremes, strict=True)
        ]
        return find(sampled, self.receiver, self.exit_columns(("s_m",))["s_m"], self.count)

    def stations(
        self, points: int | None = None, spacing: float | None = None, columns: Iterable[str] = ()
    ) -> dict[str, Any]:
        """The stream along the chute.

        Args:
            points: so many stations a segment, both ends included, on the part travelled; 101 where nothing is given.
            spacing: instead, stations at multiples of so many metres from each segment's drawn start (a flight's from
            where it begins), and at both ends of the part travelled.
            columns: names of those wanted; the others are not worked out. All, where none is named.

        Returns:
            Arrays by the names of the CSV's columns, each of shape (designs, stations); NaN where a design has no such
            station or the stream no such quantity there.

        Raises:
            UsageError: both are given, or they would make no stations or more than a million; a name is no column's.

        >>> import chutecalc
        >>> table = chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).stations(points=3)
        >>> table["segment"][0].tolist()
        ['fall', 'fall', 'fall', 'spoon', 'spoon', 'spoon']
        """
        names = list(columns) or [name for name in COLUMNS if name != "spec"]
        return at_stations(self.parts, self.count, points, spacing, names)

    def _result(self, part: Part, sampled: Numbers, found: dict[ExtremeOf, Extreme]) -> SegmentResult:
        """A part's ends and extremes."""

        def whole(values: Any) -> Any:
            return stretched(values, (self.count,))

        return SegmentResult(
            name=part.name,
            kind=part.kind,
            status=whole(_labels(part.status())),
            entry={name: whole(sampled[name][0]) for name in NUMERIC},
            exit={name: whole(sampled[name][-1]) for name in NUMERIC},
            minimum={name: whole(found[name, LEAST].value) for name in REPORTED},
            maximum={name: whole(found[name, LARGEST].value) for name in REPORTED},
            duration=whole(sampled["time_s"][-1] - sampled["time_s"][0]),
            impact={name: whole(values) for name, values in part.impact().items()},
        )


def _labels(codes: Index) -> Any:
    """Statuses as users read them."""
    return np.array(Status.LABELS)[codes]
