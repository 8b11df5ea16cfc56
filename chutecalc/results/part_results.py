"""What came out on each part of a trajectory."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from chutecalc.design import Status, stretched
from chutecalc.results.columns import NUMERIC, REPORTED
from chutecalc.results.described import status_text
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.loads import loads_of
from chutecalc.results.part import FLIGHT
from chutecalc.results.sampled import SampledPart
from chutecalc.results.segments import SegmentResult


def part_result(sampled: SampledPart, count: int) -> SegmentResult:
    """Return a part's ends and extremes.

    Args:
        sampled: the part with its columns.
        count: number of designs.
    """

    def whole(values: Any) -> Any:
        return stretched(values, (count,))

    part, columns, found = sampled.part, sampled.columns, sampled.extremes
    duration, impact = columns["time_s"][-1] - columns["time_s"][0], part.impact()
    maximum = {name: found[name, LARGEST].value for name in REPORTED}
    return SegmentResult(
        name=part.name,
        kind=part.kind,
        status=whole(status_text(part.status())),
        entry={name: whole(columns[name][0]) for name in NUMERIC},
        exit={name: whole(columns[name][-1]) for name in NUMERIC},
        minimum={name: whole(found[name, LEAST].value) for name in REPORTED},
        maximum={name: whole(values) for name, values in maximum.items()},
        duration=whole(duration),
        strikes_roof=whole(part.strikes_roof()),
        landing_margin=whole(part.landing_margin()),
        impact={name: whole(values) for name, values in impact.items()},
        loads={name: whole(values) for name, values in loads_of(part, duration, maximum, impact).items()},
    )


def with_passed_falls(results: Sequence[SegmentResult]) -> list[SegmentResult]:
    """Return results in which a fall that ends on no segment, because the stream passes that, is passed itself.

    Args:
        results: of the parts in order.
    """
    passed, unreached = Status.LABELS[Status.PASSED], Status.LABELS[Status.NOT_REACHED]
    found = list(results)
    for number, (fall, after) in enumerate(pairwise(results)):
        if not (fall.loads or fall.kind == FLIGHT):
            through = (fall.status == unreached) & (after.status == passed)
            found[number] = replace(fall, status=np.where(through, passed, fall.status))
    return found
