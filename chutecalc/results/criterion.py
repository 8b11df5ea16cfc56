"""What makes a function a design criterion: its code, severities, limit and source, and what it needs to be known."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Contact, Design, Status
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.edges import Edge
from chutecalc.results.extremes import Extreme, ExtremeOf
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.part import Part
from chutecalc.results.sampled import SampledPart
from chutecalc.solver.segment_solution import ContactSolution, SegmentSolution
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.limits import LIMITS, PRACTICE


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

    @property
    def overwhelmed(self) -> Mask:
        """Designs whose stream stalls or chokes here: it grows thick and slow on the way to that."""
        status = self.solved.status
        overwhelmed: Mask = (status == Status.STALL) | (status == Status.CHOKE)
        return overwhelmed

    def limit(self, key: str) -> Array:
        """Return a limit in force, in the unit of its key, shape (1,) or (designs,).

        Args:
            key: of the table ``[limits]``.
        """
        return LIMITS[key].of(self.design.limits)

    def extreme(self, name: str, sign: float) -> Extreme:
        """Return the least or largest value of a column that the criterion needs.

        Args:
            name: of the column.
            sign: ``LEAST`` or ``LARGEST``.
        """
        return self.sampled.extremes[name, sign]

    def has_own_limits(self, code: str) -> bool:
        """Return whether the spec gives a limit of a finding that is not the default.

        Args:
            code: of the finding.
        """
        limits = [limit for limit in LIMITS.values() if limit.finding == code and limit.default is not None]
        return any((limit.of(self.design.limits) != limit.default).any() for limit in limits)

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


class Written(NamedTuple):
    """A spec, for what can be judged without a solution."""

    spec: ChuteSpec
    """The checked spec."""
    data: dict[str, Any]
    """The same as written."""
    design: Design
    """The same as numbers, on steel that is not yet laid down at the design point, but is in another state."""
    designs: int
    """Number of designs."""


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
    key: str = ""
    """Path of the key of the spec that it is about, where it is about no segment."""
    badness: Any = 0.0
    """How bad it is, the larger the worse, shape (designs,) or 1: operating states are compared by it."""


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
    foretells_failure: bool
    """Whether a stream that stalls or chokes shows it on the way, so that it is no news beside the failure."""
    judges_spec: bool
    """Whether it judges the spec as written, once, instead of each segment with its stream."""
    cases: Callable[[Any], Iterable[Case]]

    def findings(self, scene: Scene) -> Iterator[Finding]:
        """Return what the criterion finds on a segment, for any design.

        Args:
            scene: the segment with the stream along it.
        """
        if self.judges_spec or not (scene.part.guided or self.in_falls):
            return
        for case in self.cases(scene):
            concerned = case.mask & ~scene.overwhelmed if self.foretells_failure else case.mask
            if concerned.any():
                template = case.template
                if scene.has_own_limits(self.code):
                    template = template.replace(f", {PRACTICE}", ", set in the spec")
                case = case._replace(mask=concerned, template=template)
                yield self._finding(case, scene.part.segment.name, scene.designs)

    def findings_of_spec(self, written: Written) -> Iterator[Finding]:
        """Return what the criterion finds in a spec, for any design.

        Args:
            written: the spec.
        """
        if self.judges_spec:
            yield from (self._finding(case, "", written.designs) for case in self.cases(written) if case.mask.any())

    def _finding(self, case: Case, segment: str, designs: int) -> Finding:
        """Return a case as a finding of all designs."""
        items = (case.mask, case.s, case.badness, *case.numbers.values())
        mask, s, badness, *values = (np.broadcast_to(item, designs) for item in items)
        return Finding(
            code=self.code,
            severity=case.severity or self.severities[0],
            segment=segment,
            key=case.key,
            mask=mask,
            s_m=s,
            template=case.template,
            numbers=dict(zip(case.numbers, values, strict=True)),
            badness=badness,
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
    foretells_failure: bool = False,
    judges_spec: bool = False,
) -> Callable[[Callable[[Any], Iterable[Case]]], Any]:
    """Register the decorated function as a design criterion.

    Args:
        code: short name of its findings.
        severities: of its findings, the usual one first.
        summary: what it finds, in a line for tables.
        limit: from where on.
        source: where the limit comes from.
        needs: extremes that it reads, pairs of a column's name and ``LEAST`` or ``LARGEST``.
        in_falls: whether it judges falls beside guiding surfaces.
        foretells_failure: whether it keeps silent where the stream stalls or chokes on the segment.
        judges_spec: whether the function takes the spec as written, once, instead of each segment.

    Returns:
        The decorator; the function takes a scene and yields cases.
    """

    def register(cases: Callable[[Any], Iterable[Case]]) -> Callable[[Any], Iterable[Case]]:
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
                foretells_failure=foretells_failure,
                judges_spec=judges_spec,
                cases=cases,
            )
        )
        return cases

    return register
