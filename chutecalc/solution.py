"""What came out: the stream at every place of every design, by the names of the column catalogue."""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from chutecalc.along import Numbers, Part
from chutecalc.columns import COLUMNS
from chutecalc.design import Design, Status, Stream, stretched
from chutecalc.errors import UsageError
from chutecalc.extremes import FEW, LARGEST, LEAST, SAMPLES, Extreme, Wanted, extremes
from chutecalc.findings import WARNING, WORST, Finding, findings, in_order
from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.belt import discharge, loading
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
    impact: Numbers
    """Where the stream strikes the segment: the angle of incidence, velocities and pressure; else empty."""


class Solution:
    """The solution of a chute, or of n variants of it. Numbers are NaN after a design's failure."""

    def __init__(self, design: Design, legs: tuple[Leg, ...], final: Stream, rtol: float, count: int) -> None:
        self.design, self.legs, self.final, self.rtol, self.count = design, legs, final, rtol, count

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
        return self.exit_columns(("velocity_m_s",))["velocity_m_s"]

    @property
    def exit_depth(self) -> Array:
        """Flow depth there, m, shape (designs,); NaN in free flight."""
        return self.exit_columns(("depth_m",))["depth_m"]

    @cached_property
    def exit(self) -> Numbers:
        """The stream at the end of the chute, by column name, each of shape (designs,)."""
        return self.exit_columns(name for name in COLUMNS if name not in ("spec", "segment", "kind"))

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

    def extreme_columns(self, wanted: Sequence[Wanted]) -> dict[Wanted, Array]:
        """The least or largest values of some columns on all guiding surfaces together, without the others.

        Args:
            wanted: pairs of a column's name and ``LEAST`` or ``LARGEST``.

        Returns:
            Arrays of shape (designs,), up to where a stream ends; NaN where there is no such quantity.
        """
        names = list(dict.fromkeys(name for name, _ in wanted))
        found = {item: np.full(self.count, np.nan) for item in wanted}
        for part in self.parts:
            if part.contact is not None and wanted:
                here = extremes(part, part.at(FEW, names), wanted, FEW)
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
        belt, design = self.design.receiver, self.design
        if belt is None:
            return {}
        end = self.exit_columns(("velocity_m_s", "slope_deg"))
        velocity, slope = end["velocity_m_s"], np.radians(end["slope_deg"])
        onto = loading(velocity, slope, *belt, design.density, design.mass_rate, design.gravity)
        aside = np.cos(slope - belt.slope)
        with np.errstate(all="ignore"):
            turn = np.arccos(np.where(velocity >= belt.velocity, belt.velocity / velocity, np.nan))
            return {
                "velocity_along_m_s": onto.along,
                "velocity_across_m_s": onto.across,
                "velocity_ratio": onto.velocity_ratio,
                "impact_pressure_kpa": onto.impact_pressure / 1000.0,
                "wear_w_m2": onto.wear,
                "acceleration_length_m": onto.acceleration_length,
                "acceleration_power_kw": onto.acceleration_power / 1000.0,
                "matching_slope_deg": np.degrees(belt.slope + np.where(slope >= belt.slope, turn, -turn)),
                "matching_velocity_m_s": np.where(aside > 0.0, belt.velocity / aside, np.inf),
            }

    @cached_property
    def inlet(self) -> Numbers:
        """The stream where it enters, each of shape (designs,); from a belt also V²/(g r) and its lower edge."""
        design = self.design
        x, z = design.inlet_place
        numbers = {
            "x_m": x,
            "z_m": z,
            "slope_deg": np.degrees(design.inlet_slope),
            "velocity_m_s": design.inlet_velocity,
        }
        if design.belt is not None:
            belt = design.belt
            middle = discharge(belt.velocity, belt.incline, belt.middle_radius, design.gravity)
            reach = belt.lower_radius / belt.middle_radius
            numbers["discharge_froude"] = middle.froude
            numbers["lower_edge_x_m"] = belt.centre[0] + middle.x * reach
            numbers["lower_edge_z_m"] = belt.centre[1] + middle.z * reach
        return {name: np.broadcast_to(values, self.count) for name, values in numbers.items()}

    @cached_property
    def error_estimate(self) -> Array:
        """Estimated relative error of the last velocity; after a stall, of its place as a share of the segment."""
        return np.broadcast_to(self.final.error, self.count)

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
        found = findings(self.parts, self.samples, self.extremes, self.count)
        return found if self.design.receiver is None else in_order([*found, *self._not_accelerated()])

    def _not_accelerated(self) -> Iterator[Finding]:
        """The receiving belt cannot bring the stream to its velocity."""
        assert self.design.receiver is not None
        belt = self.receiver
        numbers = {
            "velocity_along_m_s": belt["velocity_along_m_s"],
            "belt_velocity_m_s": np.broadcast_to(self.design.receiver.velocity, self.count),
            "belt_slope_deg": np.broadcast_to(np.degrees(self.design.receiver.slope), self.count),
        }
        mask = np.isposinf(belt["acceleration_length_m"])
        if mask.any():
            yield Finding(
                "not_accelerated",
                WARNING,
                self.segments[-1].name,
                mask,
                self.exit["s_m"],
                "the belt never brings the stream from {velocity_along_m_s} to its own {belt_velocity_m_s}: friction on"
                " it is too small for its slope of {belt_slope_deg}",
                numbers,
            )

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
        if points is not None and spacing is not None:
            raise UsageError("stations go by points or by spacing, not by both")
        if points is not None and not 2 <= points <= MOST_STATIONS:
            raise UsageError(f"points has to be from 2 to {MOST_STATIONS}, not {points}")
        if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
            raise UsageError(f"the spacing of stations has to be greater than 0 m, not {spacing:g}")
        names = list(columns) or [name for name in COLUMNS if name != "spec"]
        unknown = [name for name in names if name not in COLUMNS or name == "spec"]
        if unknown:
            raise UsageError(f"there is no column {', '.join(unknown)}; chutecalc columns lists what there is")
        blocks = [self._stations(part, points or 101, spacing, names) for part in self.parts]
        return {name: np.concatenate([block[name] for block in blocks], axis=1) for name in blocks[0]}

    def _stations(self, part: Part, points: int, spacing: float | None, names: list[str]) -> dict[str, Any]:
        """The stations of one part, each of shape (designs, stations)."""
        shares = np.linspace(0.0, 1.0, points) if spacing is None else _spaced(part, spacing)
        shape = (self.count, len(shares))
        labels = {"segment": part.name, "kind": part.kind}
        numbers = part.at(shares, [name for name in names if name not in labels] or ["s_m"])
        return {
            name: np.full(shape, labels[name]) if name in labels else stretched(numbers[name].T, shape)
            for name in names
        }

    def _result(self, part: Part, sampled: Numbers, found: dict[Wanted, Extreme]) -> SegmentResult:
        """A part's ends and extremes."""

        def whole(values: Any) -> Any:
            return stretched(values, (self.count,))

        return SegmentResult(
            name=part.name,
            kind=part.kind,
            status=whole(_labels(part.status())),
            entry={name: whole(sampled[name][0]) for name in COLUMNS if name in sampled},
            exit={name: whole(sampled[name][-1]) for name in COLUMNS if name in sampled},
            minimum={name: whole(found[name, LEAST].value) for name in EXTREMES},
            maximum={name: whole(found[name, LARGEST].value) for name in EXTREMES},
            duration=whole(sampled["time_s"][-1] - sampled["time_s"][0]),
            impact={name: whole(values) for name, values in part.impact().items()},
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
        impact=first.impact or again.impact,
    )


def _labels(codes: Index) -> Any:
    """Statuses as users read them."""
    return np.array([status.label for status in Status])[codes]


def _spaced(part: Part, spacing: float) -> Array:
    """Shares of the way at multiples of a spacing and at its ends, (places, designs); NaN past a design's end."""
    begin, end = part.ends()
    scale = 1.0 if part.contact is None else part.contact.surface.length
    first, way = begin * scale, (end - begin) * scale
    longest = float(np.nan_to_num(first + way).max())
    if longest / spacing >= MOST_STATIONS:
        raise UsageError(f"a spacing of {spacing:g} m makes more than {MOST_STATIONS} stations on {longest:.6g} m")
    travelled = spacing * np.arange(int(longest / spacing) + 1)[:, None] - first
    slack = 1e-12 * (first + way)
    inside = (travelled > slack) & (travelled < way - slack)
    shares = np.where(inside, travelled / np.where(way > 0.0, way, 1.0), np.nan)
    ends = np.where(np.isnan(way), np.nan, np.array([[0.0], [1.0]]))
    return np.concatenate([ends[:1], shares, ends[1:]])
