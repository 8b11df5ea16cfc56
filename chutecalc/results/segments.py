"""Results of each segment: ends, extremes and impacts, by column name, for all designs."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, overload

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.described import html_table, number, outcomes
from chutecalc.results.loads import joined_loads


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
    """Columns at the start of the segment, after any impact."""
    exit: Numbers
    """Columns at its end, or where the design fails."""
    minimum: Numbers
    """Least values on the segment, of the columns whose extremes are reported."""
    maximum: Numbers
    """Largest values on the segment, of the same columns; infinite where a quantity grows without bound."""
    duration: Array
    """Time from its start to its end, s, shape (designs,)."""
    impact: Numbers
    """Numbers of the impact, see :data:`chutecalc.results.impacts.IMPACT_COLUMNS`; empty where no stream strikes it."""
    strikes_roof: Mask = field(default_factory=lambda: np.zeros(1, dtype=bool))
    """Whether that impact is on the roof of a closed section, shape (designs,)."""
    loads: Numbers = field(default_factory=dict)
    """Forces and wear of the segment, see :data:`chutecalc.results.loads.LOAD_COLUMNS`; empty in flight."""
    landing_margin: Array = field(default_factory=lambda: np.full(1, np.nan))
    """How far from the nearer of its ends a stream lands on it, m, shape (designs,); NaN where none lands."""

    def __repr__(self) -> str:
        """Return name and outcome, and velocity and depth at both ends: of several designs the ranges.

        >>> import chutecalc
        >>> chutecalc.solve(chutecalc.parse(chutecalc.STARTER)).segments["spoon"]
        <SegmentResult spoon: ok, 6.263 to 6.222 m/s, depth 0.09342 to 0.09396 m>
        """
        designs = f" of {len(self.status)} designs" if len(self.status) > 1 else ""
        depth = self._ends("depth_m", "m")
        known = [_outcome(self.status), self._ends("velocity_m_s", "m/s"), depth and f"depth {depth}"]
        return f"<SegmentResult {self.name}{designs}: {', '.join(filter(None, known))}>"

    def _ends(self, name: str, unit: str) -> str:
        """Return a column at both ends, as text; empty where no design has it."""
        ends = {
            label: end[name] for label, end in (("in", self.entry), ("out", self.exit)) if np.isfinite(end[name]).any()
        }
        if len(self.status) == 1:
            return " to ".join(number(values) for values in ends.values()) + f" {unit}" if ends else ""
        return ", ".join(f"{number(values, unit)} {label}" for label, values in ends.items())


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
            try:
                return self._results[key]
            except IndexError:
                count = f"{len(self)} segment{'s' if len(self) != 1 else ''}"
                raise IndexError(f"the chute has {count}: {', '.join(self.names)}") from None
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

    def _repr_html_(self) -> str:
        """Return a table for notebooks."""
        return self.html_table("Segments")

    def html_table(self, caption: str) -> str:
        """Return an HTML table with a row for each segment: of several designs the ranges.

        Args:
            caption: above the table.
        """
        headings = ("segment", "kind", "status", "entry, m/s", "exit, m/s", "exit depth, m")
        rows = []
        for result in self._results:
            ok = result.status == Status.OK_LABEL
            leaves = (number(np.where(ok, result.exit[name], np.nan)) for name in ("velocity_m_s", "depth_m"))
            rows.append(
                (result.name, result.kind, _outcome(result.status), number(result.entry["velocity_m_s"]), *leaves)
            )
        return html_table(caption, headings, rows)


def _outcome(statuses: Any) -> str:
    """Return a status as text; of several designs how many have each."""
    return str(statuses[0]) if len(statuses) == 1 else outcomes(statuses)


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
        impact=_either(first.impact, again.impact),
        strikes_roof=np.where(_struck(first), first.strikes_roof, again.strikes_roof),
        loads=joined_loads(first.loads, again.loads),
        landing_margin=np.fmin(again.landing_margin, first.landing_margin),
    )


def _struck(result: SegmentResult) -> Mask:
    """Return whether each design's stream strikes the segment."""
    if not result.impact:
        return np.zeros(1, dtype=bool)
    struck: Mask = ~np.isnan(result.impact["incidence_deg"])
    return struck


def _either(first: Numbers, again: Numbers) -> Numbers:
    """Return the numbers of the first impact; of designs that it lacks those of the next one."""
    if not (first and again):
        return first or again
    return {name: np.where(np.isnan(values), again[name], values) for name, values in first.items()}
