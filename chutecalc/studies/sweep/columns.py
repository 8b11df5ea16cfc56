"""The columns that the rows of a sweep can have."""

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.column_names import closest
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Severity
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.segment_columns import GROUPS, SegmentColumn, segment_columns
from chutecalc.results.stream_column import Extremes
from chutecalc.spec.paths import is_number

PREFIXES = {"exit": "at the end of the chute", "max": "largest on guiding surfaces", "min": "least on guiding surfaces"}
"""Prefixes of the names of station columns in a sweep's rows, each with its meaning."""
IMPACT = "max_impact"
"""Prefix of the names of the numbers of an impact, of which the largest counts."""
GREATEST = {name: IMPACT_COLUMNS[name] for name in ("incidence_deg", "pressure_kpa", "wear_w_m2")}
"""Numbers of an impact of which that is so."""
IMPACTS = "largest of all impacts, 0 without one"
CODES = {"findings": tuple(Severity), "warnings": (Severity.WARNING,)}
"""Columns of the codes of findings, each with the severities of these."""
ALONE = ("landing_margin_m", "duration_s", "status")
"""Columns of a segment that belong to no group."""


def row_columns() -> dict[str, Column]:
    """Return all columns that a sweep's rows can have, by name.

    >>> row_columns()["max_depth_m"].label("metric")
    'max depth H, m'
    """
    found = {
        "status": Column("status", "status", "", "how the design ends; impossible: a section that cannot exist"),
        "findings": Column("findings", "findings", "", "codes of the findings, see docs/findings.md"),
        "warnings": Column("warnings", "warnings", "", "codes of those findings that are warnings"),
        "error_estimate": Column("error_estimate", "error", "", "of the exit velocity, relative", "number", "", 14),
    }
    for prefix, where in PREFIXES.items():
        for name, column in COLUMNS.items():
            if column.formula and (prefix == "exit" or column.extremes is not Extremes.NONE):
                symbol = "" if column.heading == column.symbol else column.symbol
                found[f"{prefix}_{name}"] = replace(
                    column, name=f"{prefix}_{name}", heading=f"{prefix} {column.heading}", symbol=symbol, meaning=where
                )
    for name, greatest in GREATEST.items():
        named, words = f"{IMPACT}_{name}", f"max impact {greatest.heading}"
        found[named] = replace(greatest, name=named, heading=words, symbol="", meaning=IMPACTS)
    return found | {
        f"receiver_{name}": replace(column, name=f"receiver_{name}") for name, column in RECEIVER_COLUMNS.items()
    }


class OwnColumn(NamedTuple):
    """A column of one segment."""

    segment: int
    """Number of the segment, from 0."""
    column: SegmentColumn
    """Named and headed with the segment."""


def own_columns(names: Iterable[str], chute: Chute) -> dict[str, OwnColumn]:
    """Return the columns of segments among some names of columns.

    Args:
        names: of columns; ``segments.NAME.COLUMN`` are those of a segment, which may be named by its number from 1 too.
        chute: the chute.

    Raises:
        UsageError: There is no such segment, or it has no such column.

    >>> import chutecalc
    >>> own = own_columns(["segments.spoon.max_depth_m"], chutecalc.parse(chutecalc.STARTER))
    >>> own["segments.spoon.max_depth_m"].segment, own["segments.spoon.max_depth_m"].column.heading
    (1, 'spoon max depth')
    """
    return {name: _own_column(name, chute) for name in names if name.split(".")[0] == "segments"}


def _own_column(name: str, chute: Chute) -> OwnColumn:
    """Return the column of a segment that a name stands for."""
    segments = [segment.name for segment in chute.design.segments]
    _, *parts = name.split(".")
    if len(parts) != 2:
        raise UsageError(f"{name}: write segments.SEGMENT.COLUMN, such as segments.{segments[-1]}.exit_velocity_m_s.")
    item, key = parts
    number = int(item) - 1 if is_number(item) else segments.index(item) if item in segments else -1
    if not 0 <= number < len(segments):
        raise UsageError(f"{name}: there is no segment {item}. {closest([item], segments)}Use {_listed(segments)}.")
    known = segment_columns()
    if key not in known:
        use = "Use entry_, exit_, max_ or min_ before a station's column, impact_ and a column of an impact, or status"
        raise UsageError(f"{name}: a segment has no column {key}. {closest([key], known)}{use}.")
    column = known[key]
    return OwnColumn(number, replace(column, name=name, heading=f"{segments[number]} {column.heading}"))


def _listed(names: Iterable[str]) -> str:
    """Return the names of segments with their numbers."""
    return ", ".join(f"{number} ({name})" for number, name in enumerate(names, 1))


def column_forms() -> list[tuple[str, str]]:
    """Return the forms of the names of columns in a sweep, each with its meaning."""
    own = [(f"segments.SEGMENT.{group.prefix}_NAME", f"{group.meaning}: {_members(group.columns)}") for group in GROUPS]
    return [
        *((f"{prefix}_NAME", where) for prefix, where in PREFIXES.items()),
        (f"{IMPACT}_NAME", f"{IMPACTS}: {_members(GREATEST.values())}"),
        ("receiver_NAME", f"of the receiving belt: {_members(RECEIVER_COLUMNS.values())}"),
        *((name, row_columns()[name].meaning) for name in ("error_estimate", *CODES)),
        *own,
        *((f"segments.SEGMENT.{name}", segment_columns()[name].meaning) for name in ALONE),
    ]


def _members(columns: Iterable[Column]) -> str:
    """Return the names of columns; of those along the stream only what to look for."""
    names = [column.name for column in columns]
    return "a column above" if {*names} <= {*COLUMNS} else ", ".join(names)
