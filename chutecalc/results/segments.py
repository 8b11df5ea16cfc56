"""Results of each segment: ends, extremes and impacts, by column name, for all designs."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.results.described import outcomes


@dataclass(frozen=True, repr=False, eq=False)
class SegmentResult:
    """Results of a segment of the spec, or of a flight that leads to one.

    Numbers are arrays of shape (designs,) by column name, NaN where a design did not get there.
    """

    name: str
    """Name of the segment; ``NAME:flight`` for a flight that leads to it."""
    kind: str
    """Kind of the segment, such as ``curve``; ``flight`` for a flight."""
    status: Any
    """``ok``, what ended the stream here, or ``not_reached`` for each design, text of shape (designs,)."""
    entry: Numbers
    """The stream at its start, after any impact."""
    exit: Numbers
    """The stream at its end, or where the design fails."""
    minimum: Numbers
    """Least values along it, of the columns whose extremes are reported."""
    maximum: Numbers
    """Largest values along it, likewise; infinite where a quantity grows without bound."""
    duration: Array
    """Time that the stream takes along it, s, shape (designs,)."""
    impact: Numbers
    """Numbers of the impact, see :data:`chutecalc.results.impacts.IMPACT_COLUMNS`; empty where no stream strikes it."""

    def __repr__(self) -> str:
        """Return name, kind and outcome.

        >>> import chutecalc
        >>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).segments["spoon"]
        <SegmentResult spoon (curve): 1 ok>
        """
        return f"<SegmentResult {self.name} ({self.kind}): {outcomes(self.status)}>"


class Segments(Sequence[SegmentResult]):
    """The segments of a chute in order, by number or by name.

    >>> import chutecalc
    >>> segments = chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).segments
    >>> segments.names, segments["spoon"].kind, segments[-1].name
    (['fall', 'spoon'], 'curve', 'spoon')
    """

    def __init__(self, results: Iterable[SegmentResult]) -> None:
        """Take the results of all segments.

        Args:
            results: in order.
        """
        self._results = list(results)

    @property
    def names(self) -> list[str]:
        """Names of the segments, in order."""
        return [result.name for result in self._results]

    @overload
    def __getitem__(self, key: int | str) -> SegmentResult: ...
    @overload
    def __getitem__(self, key: slice) -> list[SegmentResult]: ...
    def __getitem__(self, key: int | str | slice) -> SegmentResult | list[SegmentResult]:
        """Return a segment by name or number, or several by a slice.

        Raises:
            KeyError: no segment has that name.
            IndexError: there are fewer segments.
        """
        if not isinstance(key, str):
            return self._results[key]
        for result in self._results:
            if result.name == key:
                return result
        raise KeyError(f"no segment is called {key!r}: the chute has {', '.join(self.names)}")

    def __len__(self) -> int:
        return len(self._results)

    def __iter__(self) -> Iterator[SegmentResult]:
        return iter(self._results)

    def __repr__(self) -> str:
        return f"<Segments {', '.join(f'{result.name} ({result.kind})' for result in self._results)}>"


def joined(first: SegmentResult, again: SegmentResult) -> SegmentResult:
    """Join the results of two visits to a segment that some designs left and struck again.

    Args:
        first: of the first visit.
        again: of the next one.
    """
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
