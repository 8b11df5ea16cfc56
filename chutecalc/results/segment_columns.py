"""The columns of a segment's results: its ends, extremes and impact, by one name each."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS, NUMERIC, REPORTED
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.loads import LOAD_COLUMNS
from chutecalc.results.segments import SegmentResult


@dataclass(frozen=True, eq=False, kw_only=True)
class SegmentColumn(Column):
    """A column of a segment's results."""

    of: Callable[[SegmentResult], Any]
    """Returns its values, shape (designs,). NaN where the results lack it, as those of an impact that no design has."""


@dataclass(frozen=True, eq=False)
class ColumnGroup:
    """Columns that stand together in a segment's results."""

    prefix: str
    """Before the name of a column, with an underscore between; empty for none."""
    meaning: str
    """What the columns say; empty where each says that itself."""
    columns: Sequence[Column]
    of: Callable[[SegmentResult], Mapping[str, Any]]
    """Returns their values by name."""

    def named(self, name: str) -> str:
        """Return a name with the prefix.

        Args:
            name: of a column.
        """
        return f"{self.prefix}_{name}" if self.prefix else name

    def members(self) -> dict[str, SegmentColumn]:
        """Return the columns by name, that with the prefix."""
        return {self.named(column.name): self._member(column) for column in self.columns}

    def _member(self, column: Column) -> SegmentColumn:
        """Return a column of the results."""

        def values(result: SegmentResult) -> Any:
            numbers = self.of(result)
            return numbers[column.name] if column.name in numbers else result.duration * float("nan")

        shared = {field.name: getattr(column, field.name) for field in fields(Column)}
        named = {
            "heading": f"{self.prefix} {column.heading}".strip(),
            "symbol": "",
            "meaning": self.meaning or column.meaning,
        }
        return SegmentColumn(**shared | named, of=values)


_AT_ENDS, _EXTREME = [COLUMNS[name] for name in NUMERIC], [COLUMNS[name] for name in REPORTED]
GROUPS = (
    ColumnGroup("entry", "where the stream enters it, after any impact", _AT_ENDS, lambda result: result.entry),
    ColumnGroup("exit", "where the stream leaves it, or ends", _AT_ENDS, lambda result: result.exit),
    ColumnGroup("min", "least value on it", _EXTREME, lambda result: result.minimum),
    ColumnGroup("max", "largest value on it", _EXTREME, lambda result: result.maximum),
    ColumnGroup("impact", "of the impact on it", list(IMPACT_COLUMNS.values()), lambda result: result.impact),
    ColumnGroup("", "", list(LOAD_COLUMNS.values()), lambda result: result.loads),
)
"""What a segment's results consist of, beside its status and duration."""


@cache
def segment_columns() -> dict[str, SegmentColumn]:
    """Return all columns of a segment's results by name.

    >>> segment_columns()["impact_incidence_deg"].label("metric")
    'impact incidence, °'
    """
    ends, lasts = "ok, what ends the stream there, or not_reached", "time from its start to its end"
    margin = "from where a stream lands on it that comes through the air to the nearer of its ends"
    found = {
        "status": SegmentColumn("status", "status", "", ends, of=lambda result: result.status),
        "duration_s": SegmentColumn(
            "duration_s", "duration", "", lasts, "time", "s", 3, of=lambda result: result.duration
        ),
        "landing_margin_m": SegmentColumn(
            "landing_margin_m",
            "landing margin",
            "",
            margin,
            "length",
            "m",
            3,
            "ft",
            2,
            of=lambda result: result.landing_margin,
        ),
    }
    for group in GROUPS:
        found |= group.members()
    return found
