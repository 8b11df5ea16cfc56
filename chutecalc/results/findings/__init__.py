"""What a designer is told of a solution: each criterion with its place, its numbers, its limit and its source."""

from collections.abc import Callable, Iterator

import numpy as np

from chutecalc.design import Contact, Status
from chutecalc.physics.arrays import Array
from chutecalc.results.column import Numbers
from chutecalc.results.extremes import Extreme, Wanted
from chutecalc.results.findings import failures, warnings
from chutecalc.results.findings.finding import FAILURE, NOTE, WARNING, WORST, Finding, Scene
from chutecalc.results.part import Part

__all__ = ["WORST", "Finding", "findings", "in_order"]

CRITERIA: tuple[Callable[[Scene], Iterator[Finding]], ...] = (
    failures.stall,
    failures.choke,
    failures.contact_lost,
    failures.missed,
    warnings.steep_impact,
    warnings.flown_past,
    warnings.inadmissible_friction,
    warnings.outside_locus,
    warnings.decelerating,
    warnings.below_cut_off,
    warnings.thick_stream,
    warnings.slow_stream,
    warnings.missing_load,
    warnings.above_chamfer,
    warnings.geometry_follows_flow,
)


def findings(
    parts: list[Part],
    samples: list[Numbers],
    shares: list[Array],
    extremes: list[dict[Wanted, Extreme]],
    designs: int,
) -> list[Finding]:
    """All findings of a solution: failures, then warnings, then notes, each along the way.

    Args:
        parts: of the way.
        samples: their columns at
        shares: of their ways.
        extremes: theirs, ``WORST`` among them.
        designs: how many there are.
    """
    found: list[Finding] = []
    guided = [part for part in parts if part.contact is not None]
    with np.errstate(all="ignore"):
        for number, (part, sampled) in enumerate(zip(parts, samples, strict=True)):
            if part.contact is None:
                found += failures.fallen_short(part.leg, designs) if part.kind != "flight" else ()
                continue
            worst = {wanted: extremes[number][wanted] for wanted in WORST}
            goes_on = np.zeros(designs, dtype=bool)
            for later in parts[number + 1 :]:
                goes_on = goes_on | (later.leg.status != Status.NOT_REACHED) & (later.leg is not part.leg)
            segment = part.leg.segment
            assert isinstance(segment, Contact)
            scene = Scene(
                part, part.contact, segment, sampled, shares[number], worst, goes_on, part is guided[-1], designs
            )
            found += [finding for criterion in CRITERIA for finding in criterion(scene)]
    return in_order(found)


def in_order(found: list[Finding]) -> list[Finding]:
    """Failures, then warnings, then notes."""
    order = {FAILURE: 0, WARNING: 1, NOTE: 2}
    return sorted(found, key=lambda finding: order[finding.severity])
