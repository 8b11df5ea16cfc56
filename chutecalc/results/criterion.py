"""What makes a function a design criterion: its code, severities, limit and source, and what it needs to be known."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Contact, Design
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.edges import Edge
from chutecalc.results.extremes import Extreme, ExtremeOf
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.part import Part
from chutecalc.results.sampled import SampledPart
from chutecalc.solver.segment_solution import ContactSolution, SegmentSolution


class Scene(NamedTuple):
    """What a criterion judges: a segment as the stream went along it."""

    sampled: SampledPart
    continues: Mask
    """Designs whose stream goes on to another part after this one."""
    last_surface: bool
    """Whether this is the last guiding surface."""
    received: Numbers
    """Receiver columns, at the end of a chute that loads a belt; else empty."""
    exit_distance: Array
    """Distance from the inlet at the exit, m; there too."""
    inlet: Numbers
    """Numbers of the inlet, at the first segment; else empty."""
    edges: Sequence[Edge]
    """Edges of a stream that comes from a belt; none where it is on the segment again."""
    designs: int
    """Number of designs."""

    @property
    def part(self) -> Part:
        """The part of the trajectory."""
        return self.sampled.part

    @property
    def solved(self) -> SegmentSolution:
        """The solved segment."""
        return self.sampled.part.solved

    @property
    def design(self) -> Design:
        """The numeric description of the chutes."""
        return self.sampled.part.design

    @property
    def contact(self) -> ContactSolution:
        """The contact with the guiding surface; there is none in a fall."""
        contact = self.sampled.part.contact
        assert contact is not None
        return contact

    @property
    def segment(self) -> Contact:
        """The description of the guiding surface; there is none of a fall."""
        segment = self.sampled.part.segment
        assert isinstance(segment, Contact)
        return segment

    def extreme(self, name: str, sign: float) -> Extreme:
        """Return the least or largest value of a column that the criterion needs.

        Args:
            name: of the column.
            sign: ``LEAST`` or ``LARGEST``.
        """
        return self.sampled.extremes[name, sign]

    def distance(self, share: Array) -> Array:
        """Return the distance from the inlet at shares of the part's length.

        Args:
            share: dimensionless, shape (designs,).

        Returns:
            Distance along the stream, m, shape (designs,).
        """
        s = self.sampled.columns["s_m"]
        distance: Array = s[0] + share * (s[-1] - s[0])
        return distance

    def at(self, share: Array, *names: str) -> list[Array]:
        """Return columns at shares of the part's length.

        Args:
            share: dimensionless, shape (designs,).
            names: of the columns.

        Returns:
            Arrays of shape (designs,), one for each name; at the end of the part their limits there.
        """
        there, limits = self.part.at(np.broadcast_to(share, (1, len(share))), names), self.part.limits(names)
        return [np.where(share == 1.0, limits[name], there[name][0]) for name in names]


class Case(NamedTuple):
    """One thing that a criterion found, for the designs of which it holds."""

    mask: Mask
    """True for the designs concerned, shape (designs,) or 1."""
    s: Array
    """Position, distance from the inlet, m, likewise."""
    template: str
    """The message, with names of numbers in braces; ``{depth_m:in}`` is in inches in US units."""
    numbers: Numbers = {}  # noqa: RUF012 - never changed
    """Numbers of the message by name with unit, each of shape (designs,) or 1."""
    severity: Severity | None = None
    """One of the criterion's severities; its first if None."""


class Criterion(NamedTuple):
    """A design criterion, as its decorator registered it."""

    code: str
    severities: tuple[Severity, ...]
    summary: str
    """What it finds."""
    limit: str
    """Condition for a finding; empty where it has no number."""
    source: str
    """Source of the limit; empty for what follows from the model itself."""
    needs: tuple[ExtremeOf, ...]
    """Extremes along a part that it reads."""
    in_falls: bool
    """Whether falls are judged too."""
    cases: Callable[[Scene], Iterable[Case]]

    def findings(self, scene: Scene) -> Iterator[Finding]:
        """Return what the criterion finds for any design.

        Args:
            scene: the segment with the stream along it.
        """
        if not (scene.part.guided or self.in_falls):
            return
        for case in self.cases(scene):
            if case.mask.any():
                mask, s, *values = (
                    np.broadcast_to(item, scene.designs) for item in (case.mask, case.s, *case.numbers.values())
                )
                severity, name = case.severity or self.severities[0], scene.part.segment.name
                numbers = dict(zip(case.numbers, values, strict=True))
                yield Finding(
                    code=self.code,
                    severity=severity,
                    segment=name,
                    mask=mask,
                    s_m=s,
                    template=case.template,
                    numbers=numbers,
                )


CRITERIA: list[Criterion] = []
"""All criteria, in the order of their findings; filled when :mod:`chutecalc.results.findings` is imported."""


def criterion(
    code: str,
    *severities: Severity,
    summary: str,
    limit: str = "",
    source: str = "",
    needs: Sequence[ExtremeOf] = (),
    in_falls: bool = False,
) -> Callable[[Callable[[Scene], Iterable[Case]]], Any]:
    """Register the decorated function as a design criterion.

    Args:
        code: short name of its findings.
        severities: of its findings, the usual one first.
        summary: what it finds, in a line for tables.
        limit: from where on.
        source: where the limit comes from.
        needs: extremes that it reads, pairs of a column's name and ``LEAST`` or ``LARGEST``.
        in_falls: whether it judges falls beside guiding surfaces.

    Returns:
        The decorator; the function takes a scene and yields cases.
    """

    def register(cases: Callable[[Scene], Iterable[Case]]) -> Callable[[Scene], Iterable[Case]]:
        if code in {each.code for each in CRITERIA}:
            raise ValueError(f"the finding {code!r} is registered twice, the second time in {cases.__module__}")
        CRITERIA.append(
            Criterion(
                code=code,
                severities=severities,
                summary=summary,
                limit=limit,
                source=source,
                needs=tuple(needs),
                in_falls=in_falls,
                cases=cases,
            )
        )
        return cases

    return register
