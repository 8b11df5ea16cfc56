"""The result of checking a standard design: an outcome, and what differs."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from chutecalc.studies.regression.baseline import TOLERANCE, RowKey
from chutecalc.studies.regression.record import spec_path

OK, DRIFTED, CHANGED, EDITED = "ok", "drifted", "changed", "edited"
"""Outcomes of a check: as the baseline; numbers differ by more than the tolerance; a segment, a status or a finding has
changed; the spec is not the one that the baseline was written for."""
NO_BASELINE, BROKEN_BASELINE, NO_SPEC = "no_baseline", "broken_baseline", "no_spec"
"""Outcomes without a comparison: the spec has no baseline; the baseline cannot be read; the baseline has no spec."""


class Change(NamedTuple):
    """A difference other than that of a number."""

    kind: str
    """``spec``, ``status``, ``segment`` or ``finding``; ``baseline`` where none can be compared with."""
    segment: str
    """Name of the segment; empty for the whole design."""
    message: str
    """The difference in words."""


class Drift(NamedTuple):
    """A number that differs by more than the tolerance."""

    key: RowKey
    """The row that it stands in."""
    column: str
    """The column that it stands in, which names its unit."""
    s_m: float | None
    """Distance of its station from the inlet, m."""
    was: float | None
    """Value in the baseline, in the column's unit; None where it has none."""
    now: float | None
    """Value now, in the column's unit; None where there is none."""
    off: float
    """|was - now| over the largest of both and the column's scale, a ratio; 1 where only one of both has a value."""


class Verdict(NamedTuple):
    """The result of checking one design."""

    spec: str
    """Path of the spec."""
    outcome: str
    """One of the outcomes above."""
    changes: tuple[Change, ...] = ()
    """Differences other than those of numbers."""
    drifts: tuple[Drift, ...] = ()
    """Numbers that differ, in the order of the flow."""
    notes: tuple[str, ...] = ()
    """Conditions that differ from those of the baseline. They may explain differences; they are none themselves."""
    tolerance: float = TOLERANCE
    """Relative tolerance of the comparison."""
    seconds: float = 0.0
    """Time that the check took, s."""
    document: Mapping[str, Any] | None = None
    """The baseline to write, with ``update`` and where the existing one does not agree."""

    @property
    def lines(self) -> list[str]:
        """The changes and the notes in words."""
        return [*(change.message for change in self.changes), *self.notes]


def first_and_largest(drifts: Sequence[Drift]) -> list[tuple[Drift, Drift]]:
    """Select the first and the largest drift of each column.

    Args:
        drifts: Drifts in the order of the flow.

    >>> key = RowKey("spoon", 1, "station 1")
    >>> near = Drift(key, "depth_m", s_m=1.0, was=0.1, now=0.101, off=0.01)
    >>> [(first.s_m, largest.s_m) for first, largest in first_and_largest([near, near._replace(s_m=2.0, off=0.02)])]
    [(1.0, 2.0)]
    """
    columns: dict[str, list[Drift]] = {}
    for drift in drifts:
        columns.setdefault(drift.column, []).append(drift)
    return [(found[0], max(found, key=lambda drift: drift.off)) for found in columns.values()]


def without_spec(baseline: Path) -> Verdict:
    """Return the verdict on a baseline whose spec does not exist.

    Args:
        baseline: Path of the baseline.

    >>> without_spec(Path("spoon.baseline.toml")).changes[0].message
    'spoon.toml does not exist. Restore it, or delete its baseline'
    """
    message = f"{spec_path(baseline).name} does not exist. Restore it, or delete its baseline"
    return Verdict(str(baseline), NO_SPEC, (Change("baseline", "", message),))
