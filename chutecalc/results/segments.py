"""What came out on each segment: ends, extremes and impacts, by column name, for all designs."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array
from chutecalc.results.column import Numbers


@dataclass(frozen=True, repr=False)
class SegmentResult:
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


class Segments(Sequence[SegmentResult]):
    """The segments of a chute in order, by number or by name.

    >>> import chutecalc
    >>> segments = chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).segments
    >>> segments.names, segments["spoon"].kind, segments[-1].name
    (['fall', 'spoon'], 'curve', 'spoon')
    """

    def __init__(self, results: Iterable[SegmentResult]) -> None:
        self._results = list(results)

    @property
    def names(self) -> list[str]:
        """In order."""
        return [result.name for result in self._results]

    @overload
    def __getitem__(self, key: int | str) -> SegmentResult: ...
    @overload
    def __getitem__(self, key: slice) -> list[SegmentResult]: ...
    def __getitem__(self, key: int | str | slice) -> SegmentResult | list[SegmentResult]:
        """A segment, or some of them.

        Raises:
            KeyError: no segment has that name.
            IndexError: there are fewer.
        """
        if not isinstance(key, str):
            return self._results[key]
        for result in self._results:
            if result.name == key:
                return result
        raise KeyError(f"no segment is called {key!r}: there are {', '.join(self.names)}")

    def __len__(self) -> int:
        return len(self._results)

    def __iter__(self) -> Iterator[SegmentResult]:
        return iter(self._results)

    def __repr__(self) -> str:
        return f"<Segments {', '.join(f'{result.name} ({result.kind})' for result in self._results)}>"


def joined(first: SegmentResult, again: SegmentResult) -> SegmentResult:
    """A segment that some designs left and struck again."""
    there = again.status != Status.LABELS[Status.NOT_REACHED]
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
