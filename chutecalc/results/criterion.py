"""What makes a function a design criterion: its code, severities, limit and source, and what it needs to be known."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.extremes import ExtremeOf
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.scene import Scene, Written


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
    asks: str = ""
    """What its advice changes where the stream leaves the segment: ``steeper`` or ``flatter``, ``faster`` or
    ``slower``; empty for anything else."""


Cases = Callable[[Any], Iterable[Case]]
"""A function that takes a scene, or the spec as written, and yields what it finds there."""


class Criterion:
    """A design criterion: the decorator of the function that yields its cases."""

    cases: Cases

    def __init__(
        self,
        code: str,
        *severities: Severity,
        summary: str,
        limit: str = "",
        source: str = "",
        needs: Sequence[ExtremeOf] = (),
        in_falls: bool = False,
        foretells_failure: bool = False,
        judges_spec: bool = False,
    ) -> None:
        """Take what is known of a criterion beside its function.

        Args:
            code: short name of its findings.
            severities: of its findings, the usual one first.
            summary: what it finds, in a line for tables.
            limit: condition for a finding; empty where it has no number.
            source: where the limit comes from; empty for what follows from the model itself.
            needs: extremes along a part that it reads, pairs of a column's name and ``LEAST`` or ``LARGEST``.
            in_falls: whether it judges falls beside guiding surfaces.
            foretells_failure: whether a stream that stalls or chokes shows it on the way, so that it is no news beside
                the failure.
            judges_spec: whether the function takes the spec as written, once, instead of each segment with its stream.
        """
        self.code, self.severities, self.summary, self.limit, self.source = code, severities, summary, limit, source
        self.needs, self.in_falls, self.foretells_failure = tuple(needs), in_falls, foretells_failure
        self.judges_spec = judges_spec

    def __call__(self, cases: Cases) -> Cases:
        """Register the function that yields the cases of the criterion.

        Args:
            cases: takes a scene, or the spec as written, and yields what it finds.

        Returns:
            The same function.
        """
        if self.code in {each.code for each in CRITERIA}:
            raise ValueError(f"the finding {self.code!r} is registered twice, the second time in {cases.__module__}")
        self.cases = cases
        CRITERIA.append(self)
        return cases

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
                yield self._finding(case._replace(mask=concerned), scene.part.segment.name, scene.designs)

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
            asks=case.asks,
        )


CRITERIA: list[Criterion] = []
"""All criteria, in the order of their findings; filled when :mod:`chutecalc.results.findings` is imported."""

criterion = Criterion
"""The name under which criteria are decorated."""
