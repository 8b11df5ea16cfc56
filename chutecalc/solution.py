"""What came out: the stream at every place of every design, by the names of the column catalogue."""

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from chutecalc.along import LARGEST, LEAST, SAMPLES, Extreme, Numbers, Part, Wanted, extremes
from chutecalc.columns import COLUMNS
from chutecalc.design import Design, Status, Stream
from chutecalc.errors import UsageError
from chutecalc.findings import WORST, Finding, findings
from chutecalc.physics.arrays import Array, Index
from chutecalc.solver.chain import Leg

MOST_STATIONS = 1_000_000
EXTREMES = (
    "velocity_m_s",
    "depth_m",
    "equivalent_friction",
    "pressure_kpa",
    "wear_w_m2",
    "chamfer_pressure_kpa",
    "chamfer_wear_w_m2",
    "side_pressure_kpa",
    "side_wear_w_m2",
    "froude",
)
"""The columns of which a segment's least and largest values are told."""
TOLD = list(dict.fromkeys([(name, sign) for name in EXTREMES for sign in (LEAST, LARGEST)] + [*WORST]))


class SegmentResult(NamedTuple):
    """A segment of the spec, or a flight that leads to one.

    Numbers are by column name, each of shape (designs,), NaN where a design did not get there.
    """

    name: str
    kind: str
    status: Any
    """``ok``, what ended the stream here, or ``not_reached``, for each design."""
    entry: Numbers
    exit: Numbers
    minimum: Numbers
    maximum: Numbers
    duration: Array
    """s."""


class Solution:
    """The solution of a chute, or of n variants of it. Numbers are NaN after a design's failure."""

    def __init__(self, design: Design, legs: tuple[Leg, ...], final: Stream, rtol: float) -> None:
        self.design, self.legs, self.final, self.rtol = design, legs, final, rtol
        self.count = max(len(leg.exit.status) for leg in legs)

    @cached_property
    def codes(self) -> Index:
        """The :class:`~chutecalc.design.Status` of each design, shape (designs,)."""
        return np.broadcast_to(self.final.status, self.count)

    @cached_property
    def status(self) -> Any:
        """``ok``, ``stall``, ``choke``, ``contact_lost`` or ``missed`` for each design, shape (designs,)."""
        return _labels(self.codes)

    @property
    def exit_velocity(self) -> Array:
        """Velocity at the end of the chute, m/s, shape (designs,)."""
        return self.exit["velocity_m_s"]

    @property
    def exit_depth(self) -> Array:
        """Flow depth there, m, shape (designs,); NaN in free flight."""
        return self.exit["depth_m"]

    @cached_property
    def exit(self) -> Numbers:
        """The stream at the end of the chute, by column name, each of shape (designs,)."""
        last = self.segments[-1].exit
        return {name: np.where(self.codes == Status.OK, values, np.nan) for name, values in last.items()}

    @cached_property
    def error_estimate(self) -> Array:
        """Estimated relative error of the last velocity; after a stall, of its place as a share of the segment."""
        return np.broadcast_to(self.final.error, self.count)

    @cached_property
    def parts(self) -> list[Part]:
        """The way in order: the spec's segments, each behind the flight that leads to it if any design flies there."""
        parts: list[Part] = []
        elapsed = np.zeros(1)
        for leg in self.legs:
            name, kind = leg.segment.name, leg.segment.kind
            if leg.contact is not None and (leg.flight_time > 0.0).any():
                parts.append(Part(f"{name}:flight", "flight", leg, None, elapsed, self.design))
            parts.append(Part(name, kind, leg, leg.contact, elapsed, self.design))
            time = parts[-1].at(np.ones(1))["time_s"][0]
            elapsed = np.where(np.isfinite(time), time, elapsed)
        return parts

    @cached_property
    def samples(self) -> list[Numbers]:
        """The columns of each part at ``SAMPLES``; what extremes and findings are read from."""
        return [part.at(SAMPLES) for part in self.parts]

    @cached_property
    def extremes(self) -> list[dict[Wanted, Extreme]]:
        """The extremes of each part that are told, or that findings ask for."""
        return [extremes(part, sampled, TOLD) for part, sampled in zip(self.parts, self.samples, strict=True)]

    @cached_property
    def ways(self) -> list[SegmentResult]:
        """The parts of the way in order: the segments, each behind the flight that leads to it, if there is one."""
        return [self._result(*items) for items in zip(self.parts, self.samples, self.extremes, strict=True)]

    @property
    def segments(self) -> list[SegmentResult]:
        """The segments of the spec, in order; one that was left and struck again as one."""
        found: dict[int, SegmentResult] = {}
        for part, way in zip(self.parts, self.ways, strict=True):
            if way.kind != "flight":
                number = part.leg.number
                found[number] = _joined(found[number], way) if number in found else way
        return list(found.values())

    def findings(self) -> list[Finding]:
        """Failures, warnings and notes, each with a mask of the designs that it is about."""
        return findings(self.parts, self.samples, self.extremes, self.count)

    def stations(self, points: int | None = None, spacing: float | None = None) -> dict[str, Any]:
        """The stream along the chute.

        Args:
            points: so many stations a segment, both ends included, on the part travelled; 101 where nothing is given.
            spacing: instead, stations at multiples of so many metres from where the stream enters each segment, and
            its end.

        Returns:
            Arrays by the names of the CSV's columns, each of shape (designs, stations); NaN where a design has no such
            station or the stream no such quantity there.

        Raises:
            UsageError: both are given, or they would make no stations or more than a million.

        >>> import chutecalc
        >>> table = chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).stations(points=3)
        >>> table["segment"][0].tolist()
        ['fall', 'fall', 'fall', 'spoon', 'spoon', 'spoon']
        """
        if points is not None and spacing is not None:
            raise UsageError("stations go by points or by spacing, not by both")
        if points is not None and not 2 <= points <= MOST_STATIONS:
            raise UsageError(f"points has to be from 2 to {MOST_STATIONS}, not {points}")
        if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
            raise UsageError(f"the spacing of stations has to be greater than 0 m, not {spacing:g}")
        blocks = [self._stations(part, points or 101, spacing) for part in self.parts]
        return {name: np.concatenate([block[name] for block in blocks], axis=1) for name in blocks[0]}

    def _stations(self, part: Part, points: int, spacing: float | None) -> dict[str, Any]:
        """The stations of one part, each of shape (designs, stations)."""
        columns = part.at(np.linspace(0.0, 1.0, points) if spacing is None else _spaced(part.length(), spacing))
        shape = (self.count, len(columns["s_m"]))
        table: dict[str, Any] = {"segment": np.full(shape, part.name), "kind": np.full(shape, part.kind)}
        return table | {name: np.broadcast_to(columns[name].T, shape) for name in COLUMNS if name in columns}

    def _result(self, part: Part, sampled: Numbers, found: dict[Wanted, Extreme]) -> SegmentResult:
        """A part's ends and extremes."""

        def whole(values: Any) -> Any:
            return np.broadcast_to(values, self.count)

        return SegmentResult(
            name=part.name,
            kind=part.kind,
            status=whole(_labels(part.status())),
            entry={name: whole(sampled[name][0]) for name in COLUMNS if name in sampled},
            exit={name: whole(sampled[name][-1]) for name in COLUMNS if name in sampled},
            minimum={name: whole(found[name, LEAST].value) for name in EXTREMES},
            maximum={name: whole(found[name, LARGEST].value) for name in EXTREMES},
            duration=whole(sampled["time_s"][-1] - sampled["time_s"][0]),
        )


def _joined(first: SegmentResult, again: SegmentResult) -> SegmentResult:
    """A segment that some designs left and struck again."""
    there = again.status != Status.NOT_REACHED.label
    return SegmentResult(
        name=first.name,
        kind=first.kind,
        status=np.where(there, again.status, first.status),
        entry=first.entry,
        exit={name: np.where(there, again.exit[name], values) for name, values in first.exit.items()},
        minimum={name: np.fmin(again.minimum[name], values) for name, values in first.minimum.items()},
        maximum={name: np.fmax(again.maximum[name], values) for name, values in first.maximum.items()},
        duration=first.duration + np.where(there, again.duration, 0.0),
    )


def _labels(codes: Index) -> Any:
    """Statuses as users read them."""
    return np.array([status.label for status in Status])[codes]


def _spaced(way: Array, spacing: float) -> Array:
    """Shares of the way at multiples of a spacing, and its end, shape (places, designs); NaN past a design's end."""
    longest = float(np.nan_to_num(way).max())
    if longest / spacing >= MOST_STATIONS:
        raise UsageError(f"a spacing of {spacing:g} m makes more than {MOST_STATIONS} stations on {longest:.6g} m")
    multiples = spacing * np.arange(int(longest / spacing) + 1)[:, None]
    inside = np.where(multiples < way * (1.0 - 1e-12), multiples / way, np.nan)
    inside[0] = np.where(np.isnan(way), np.nan, 0.0)
    return np.concatenate([inside, np.where(np.isnan(way), np.nan, 1.0)[None]])
