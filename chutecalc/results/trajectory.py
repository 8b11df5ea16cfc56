"""The solved trajectory of the stream, part by part: what the results of a solution are read from."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property, reduce

import numpy as np

from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.results.columns import NUMERIC, REPORTED
from chutecalc.results.edges import Edge
from chutecalc.results.extremes import LARGEST, LEAST, ExtremeOf
from chutecalc.results.finding import Finding
from chutecalc.results.findings import NEEDED, find
from chutecalc.results.last_flights import last_flights
from chutecalc.results.loads import relative_to_first
from chutecalc.results.part import FLIGHT, Part, leaving
from chutecalc.results.part_results import part_result, with_passed_falls
from chutecalc.results.sampled import SampledPart, sample
from chutecalc.results.segments import SegmentResult, Segments, joined
from chutecalc.solver.segment_solution import Ends, SegmentSolution

EXTREMES = [*dict.fromkeys([*((name, sign) for name in REPORTED for sign in (LEAST, LARGEST)), *NEEDED])]
"""The extremes of each part that are reported or that criteria need."""
SAMPLED = [*dict.fromkeys([*NUMERIC, *(name for name, _ in NEEDED)])]
"""The columns that are sampled along each part."""


class Trajectory:
    """The trajectories of n designs, in parts: the spec's segments, each behind the flight that leads to it."""

    def __init__(self, design: Design, segment_solutions: Sequence[SegmentSolution], ends: Ends, count: int) -> None:
        """Take the solved segments of the designs.

        Args:
            design: the numeric description of the chutes.
            segment_solutions: the solved segments in the order in which the stream meets them.
            ends: how the designs end.
            count: number of designs.
        """
        self.design, self.segment_solutions = design, tuple(segment_solutions)
        self.ends, self.count = ends, count
        self.status_numbers: Index = stretched(ends.status, (count,))

    def __repr__(self) -> str:
        """Return the parts.

        >>> import chutecalc
        >>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).trajectory
        <Trajectory: fall, spoon>
        """
        designs = f" of {self.count} designs" if self.count > 1 else ""
        return f"<Trajectory{designs}: {', '.join(part.name for part in self.parts)}>"

    @cached_property
    def parts(self) -> list[Part]:
        """The parts in order; flights are parts of their own where any design flies."""
        parts: list[Part] = []
        before: Part | None = None
        for solved in self.segment_solutions:
            name, kind = solved.segment.name, solved.segment.kind
            if solved.contact is not None and (solved.flight_time > 0.0).any():
                parts.append(Part(f"{name}:{FLIGHT}", FLIGHT, solved, contact=None, before=before, design=self.design))
            before = Part(name, kind, solved, contact=solved.contact, before=before, design=self.design)
            parts.append(before)
        return parts

    @cached_property
    def sampled(self) -> list[SampledPart]:
        """The parts with their columns where they were sampled."""
        return [sample(part, SAMPLED, EXTREMES) for part in self.parts]

    @cached_property
    def results(self) -> list[SegmentResult]:
        """What came out on each part, flights included; a segment that was left and struck again has several.

        A fall onto a segment that is passed is passed too: the stream flies on from where that fall began.
        """
        found = with_passed_falls([part_result(sampled, self.count) for sampled in self.sampled])
        loads = relative_to_first([result.loads for result in found])
        return [replace(result, loads=own) for result, own in zip(found, loads, strict=True)]

    @cached_property
    def last_parts(self) -> list[Part]:
        """The flights behind the last surface: out of the mouth of a pipe, and onto the receiving belt."""
        return list(last_flights(self.design, self.ends, self.parts[-1]))

    @cached_property
    def last_flights(self) -> list[SegmentResult]:
        """What came out on the flights behind the last surface."""
        return [part_result(sample(part, SAMPLED, EXTREMES), self.count) for part in self.last_parts]

    @property
    def rows(self) -> list[SegmentResult]:
        """What came out on each part, and on the flights behind the last surface: the rows of a table."""
        return [*self.results, *self.last_flights]

    def segments(self) -> Segments:
        """Return what came out on each segment of the spec, on all visits together."""
        found: dict[int, SegmentResult] = {}
        for part, result in zip(self.parts, self.results, strict=True):
            if not part.is_flight:
                number = part.solved.number
                found[number] = joined(found[number], result) if number in found else result
        return Segments(found.values())

    def flights(self) -> list[list[SegmentResult]]:
        """Return for each segment of the spec the flights that lead to it."""
        found: list[list[SegmentResult]] = [[] for _ in self.design.segments]
        for part, result in zip(self.parts, self.results, strict=True):
            if part.is_flight:
                found[part.solved.number].append(result)
        return found

    def findings(self, received: Numbers, inlet: Numbers, edges: Sequence[Edge]) -> list[Finding]:
        """Return all findings.

        Args:
            received: receiver columns at the exit; empty where the chute loads no belt.
            inlet: numbers of the inlet, see :func:`chutecalc.results.inlet.inlet_numbers`.
            edges: of a stream that comes from a belt.
        """
        exit_distance = self.exit_columns(("s_m",))["s_m"]
        return find(
            self.sampled,
            received=received,
            exit_distance=exit_distance,
            inlet=inlet,
            edges=edges,
            status=self.status_numbers,
        )

    def exit_columns(self, names: Iterable[str]) -> Numbers:
        """Return columns at the end of the chute.

        Args:
            names: of columns of numbers.

        Returns:
            Arrays of shape (designs,), NaN for designs that fail.
        """
        names = list(names)
        found = {name: np.full(self.count, np.nan) for name in names}
        open_ = self.status_numbers == Status.OK  # designs whose end is not found yet
        for part, leaves in zip(self.parts, leaving(self.parts, open_), strict=True):
            if not leaves.any():
                continue
            open_ = open_ & ~leaves
            if part.segment.closed:  # out of its mouth, without touching it again
                flies = leaves & np.isin(part.solved.status, (Status.PASSED, Status.CONTACT_LOST))
                found, leaves = self._from_air(found, flies), leaves & ~flies
            if leaves.any():
                ends = part.at(np.ones(1), names)
                found = {name: np.where(leaves, ends[name][0], values) for name, values in found.items()}
        # What is left flew past all that came after the inlet, onto its belt.
        return self._from_air(found, open_) if open_.any() else found

    def _from_air(self, found: Numbers, chosen: Mask) -> Numbers:
        """Return columns at the end of the chute with those of designs that leave it in the air: what exists there."""
        ends = self.ends
        known = {
            "s_m": ends.distance,
            "x_m": ends.x,
            "z_m": ends.z,
            "slope_deg": np.degrees(ends.slope),
            "velocity_m_s": ends.velocity,
        }
        return found | {name: np.where(chosen, known[name], values) for name, values in found.items() if name in known}

    def greatest_impacts(self, names: Sequence[str]) -> Numbers:
        """Return the largest numbers of all impacts, 0 for designs whose stream strikes nothing.

        Args:
            names: of numbers of an impact.

        Returns:
            Arrays of shape (designs,) by name.
        """
        if not names:
            return {}
        impacts = [impact for part in self.parts if (impact := part.impact())]
        nothing = np.zeros(self.count)
        return {name: reduce(np.fmax, (impact[name] for impact in impacts), nothing) for name in names}

    def extreme_columns(self, extremes_of: Sequence[ExtremeOf]) -> dict[ExtremeOf, Array]:
        """Return least or largest values of columns on all guiding surfaces together.

        Args:
            extremes_of: pairs of a column's name and ``LEAST`` or ``LARGEST``.

        Returns:
            Arrays of shape (designs,), up to where a stream ends; NaN where there is no such quantity, infinite where
            it grows without bound, as depth does towards a stall.
        """
        names = list(dict.fromkeys(name for name, _ in extremes_of))
        found = {item: np.full(self.count, np.nan) for item in extremes_of}
        for part in self.parts:
            if part.guided and extremes_of:
                here = sample(part, names, extremes_of).extremes
                found = {
                    (name, sign): (np.fmax if sign == LARGEST else np.fmin)(values, here[name, sign].value)
                    for (name, sign), values in found.items()
                }
        return found
