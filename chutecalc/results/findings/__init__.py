"""Design criteria, each a function with a decorator in a module of this package, and what they find.

To add a criterion, write a function with :func:`chutecalc.results.criterion.criterion` in any module here, or in a new
one: the modules are found by the package itself, and a criterion is all that is known of its findings.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.registry import load_modules
from chutecalc.results.criterion import CRITERIA as CRITERIA
from chutecalc.results.edges import Edge
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.part import Part, leaving
from chutecalc.results.sampled import SampledPart
from chutecalc.results.scene import Scene, Written

load_modules(__name__, __path__)

NEEDED = tuple(dict.fromkeys(needed for criterion in CRITERIA for needed in criterion.needs))
"""The extremes along a part that criteria read."""
_RANK = {severity: rank for rank, severity in enumerate(Severity)}


def find(
    parts: Sequence[SampledPart],
    *,
    received: Numbers,
    exit_distance: Array,
    inlet: Numbers,
    edges: Sequence[Edge],
    status: Index,
) -> list[Finding]:
    """Return all findings of a solution: failures, then warnings, then notes, each along the stream.

    Args:
        parts: of the trajectory, with ``NEEDED`` among their extremes.
        received: receiver columns at the exit; empty where the chute loads no belt.
        exit_distance: distance from the inlet at the exit, m, shape (designs,).
        inlet: numbers of the inlet.
        edges: of a stream that comes from a belt.
        status: how the designs end, shape (designs,).
    """
    designs = len(status)
    found: list[Finding] = []
    surfaces = [sampled.part for sampled in parts if sampled.part.guided]
    leaves = _leaving([sampled.part for sampled in parts], designs)
    continues = _continuing([sampled.part for sampled in parts], designs)
    first = {sampled.part.solved.number: sampled.part.solved for sampled in reversed(parts)}
    met = _by_segment(edges)
    with np.errstate(all="ignore"):
        for number, sampled in enumerate(parts):
            if sampled.part.is_flight:
                continue
            solved = sampled.part.solved
            at_end = {name: np.where(leaves[number], values, np.nan) for name, values in received.items()}
            scene = Scene(
                sampled,
                continues=continues[number],
                last_surface=bool(surfaces) and sampled.part is surfaces[-1],
                received=at_end if leaves[number].any() else {},
                exit_distance=exit_distance,
                inlet=inlet if solved is parts[0].part.solved else {},
                edges=met[solved.number] if solved is first[solved.number] else (),
                status=status,
            )
            found += [finding for criterion in CRITERIA for finding in criterion.findings(scene)]
    return in_order(found)


def _leaving(parts: Sequence[Part], designs: int) -> list[Mask]:
    """Return for each part the designs that get through the chute and leave it from there.

    One whose stream touches nothing, and flies from the inlet onto its belt, counts for the last part.
    """
    through = np.ones(designs, dtype=bool)
    for part in parts:
        through = through & ~np.isin(part.solved.status, (Status.STALL, Status.CHOKE, Status.MISSED))
    found = leaving(parts, through)
    found[-1] = found[-1] | through & ~np.any(found, axis=0)
    return found


def _continuing(parts: Sequence[Part], designs: int) -> list[Mask]:
    """Return for each part the designs whose stream goes on to a later one."""
    found = [np.zeros(designs, dtype=bool)]
    for part in reversed(parts[1:]):
        found.append(found[-1] | (part.solved.status != Status.NOT_REACHED))
    return found[::-1]


def _by_segment(edges: Iterable[Edge]) -> defaultdict[int, list[Edge]]:
    """Return the edges by the number of the segment that they meet or miss, for any design."""
    found: defaultdict[int, list[Edge]] = defaultdict(list)
    for edge in edges:
        for number in {*edge.number.tolist(), *edge.target.tolist()}:
            found[number].append(edge)
    return found


def find_in_spec(written: Written) -> list[Finding]:
    """Return all findings about the keys of a spec, in the order of its keys.

    Args:
        written: the spec.
    """
    return [finding for criterion in CRITERIA for finding in criterion.findings_of_spec(written)]


def in_order(findings: Iterable[Finding]) -> list[Finding]:
    """Return findings with failures first, then warnings, then notes; otherwise as they are.

    Args:
        findings: in any order.
    """
    return sorted(findings, key=lambda finding: _RANK[finding.severity])
