"""What a standard design is held to: the numbers, outcomes and findings of its solution, in a file beside its spec."""

import hashlib
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, FiniteFloat, ValidationError

from chutecalc import __version__
from chutecalc.api.chute import Chute
from chutecalc.api.solution import Solution
from chutecalc.errors import SpecError
from chutecalc.fields.quantity import Number, Quantity
from chutecalc.fields.table import Table
from chutecalc.results.columns import COLUMNS, NUMERIC
from chutecalc.results.finding import Finding
from chutecalc.spec.faults import faults_of
from chutecalc.spec.parse import BASELINE_SUFFIX, parse_text, read_text

TOLERANCE = 1e-9
STATIONS = np.linspace(0.0, 1.0, 5)  # of each segment's way
RECEIVER = (
    "velocity_along_m_s",
    "velocity_across_m_s",
    "velocity_ratio",
    "impact_pressure_kpa",
    "wear_w_m2",
    "acceleration_length_m",
)
"""What is kept of the receiver; the rest follows from these, and loses its digits where the stream suits the belt."""
BEYOND = 1e-6  # of its value: so much an extreme exceeds what the stations show, or is not kept
LEAST_SCALE = 1e-3  # of any column: 1e-12 m, kPa or ° is rounding, such as x in a vertical fall

Row = dict[str, FiniteFloat]


class KeptFinding(Table):
    """A finding of the baseline."""

    severity: str
    code: str
    segment: str


class KeptSegment(Table):
    """A segment of the baseline, or a flight that leads to one."""

    name: str
    kind: str
    status: str
    impact: Row = Field(default_factory=dict)
    stations: list[Row] = Field(default_factory=list)
    minimum: Row = Field(default_factory=dict)
    maximum: Row = Field(default_factory=dict)


class Baseline(Table):
    """What came out of a design when its baseline was written, or comes out now."""

    format: Literal[1]
    chutecalc: str
    spec_sha256: str
    rtol: FiniteFloat
    tolerance: Annotated[Number, Quantity("number", ge=1e-13, le=0.1)]
    status: str
    findings: list[KeptFinding]
    inlet: Row
    segments: list[KeptSegment]
    receiver: Row = Field(default_factory=dict)

    def visits(self) -> dict[tuple[str, int], KeptSegment]:
        """The segments by name and by how often the stream has come to them: a hood may be struck again."""
        met: dict[str, int] = {}
        found = {}
        for segment in self.segments:
            met[segment.name] = met.get(segment.name, 0) + 1
            found[segment.name, met[segment.name]] = segment
        return found

    def rows(self) -> Iterator[tuple["Place", Row]]:
        """All numbers, along the way."""
        yield Place("inlet", 1, ""), self.inlet
        for here, segment in self.visits().items():
            yield Place(*here, "impact"), segment.impact
            for number, station in enumerate(segment.stations, 1):
                yield Place(*here, f"station {number}"), station
            yield Place(*here, "minimum"), segment.minimum
            yield Place(*here, "maximum"), segment.maximum
        yield Place("receiver", 1, ""), self.receiver

    def scales(self) -> dict[str, float]:
        """How large the numbers of each column are in this chute, by the name of the column: the largest."""
        found: dict[str, float] = {}
        for _, row in self.rows():
            for name, value in row.items():
                kind = column_of(name)
                found[kind] = max(found.get(kind, LEAST_SCALE), abs(value))
        return found

    def document(self) -> dict[str, Any]:
        """As it is written: with no more digits than the tolerance needs, a tenth of it or less lost to rounding."""
        decimals = {kind: 1 - math.floor(math.log10(self.tolerance * scale)) for kind, scale in self.scales().items()}

        def rounded(item: Any) -> Any:
            if isinstance(item, list):
                return [rounded(value) for value in item]
            if not isinstance(item, dict):
                return item
            return {
                name: round(value, decimals[column_of(name)]) + 0.0 if _is_number(name, value) else rounded(value)
                for name, value in item.items()
            }

        return dict(rounded(self.model_dump(exclude_defaults=True)))


class Place(NamedTuple):
    """Where a row of numbers of a baseline stands."""

    segment: str
    """Its name; ``inlet`` and ``receiver`` for those."""
    visit: int
    """1, or more where the stream has left the segment and come back."""
    row: str
    """``impact``, ``station 1`` to ``station 5``, ``minimum``, ``maximum``; empty where there is one row only."""


def _is_number(name: str, value: Any) -> bool:
    return isinstance(value, float) and name not in ("rtol", "tolerance")


_OF_UNIT = {"m": "s_m", "m_s": "velocity_m_s", "deg": "slope_deg", "kpa": "pressure_kpa", "w_m2": "wear_w_m2"}


@cache
def column_of(name: str) -> str:
    """The column whose scale a number has: its own, or that of its unit for what stands in no column.

    Both coordinates have the scale of the way, for neither has a size of its own.

    >>> column_of("depth_m"), column_of("velocity_after_m_s"), column_of("x_m"), column_of("velocity_ratio")
    ('depth_m', 'velocity_m_s', 's_m', 'velocity_ratio')
    """
    if name in COLUMNS and name not in ("x_m", "z_m"):
        return name
    units = [unit for unit in _OF_UNIT if name.endswith(f"_{unit}")]
    return _OF_UNIT[max(units, key=len)] if units else name


def baseline_path(spec: Path) -> Path:
    """``spoon.baseline.toml`` for ``spoon.toml``."""
    return spec.with_name(spec.name.removesuffix(".toml") + BASELINE_SUFFIX)


def spec_path(baseline: Path) -> Path:
    """``spoon.toml`` for ``spoon.baseline.toml``."""
    return baseline.with_name(baseline.name.removesuffix(BASELINE_SUFFIX) + ".toml")


def spec_hash(data: Mapping[str, Any]) -> str:
    """The hash of what a spec says: of its parsed content, so that comments, layout and line ends do not count.

    A checkout that changes line ends has to pass, and a better comment needs no new baseline.

    >>> spec_hash({"b": 1, "a": 2}) == spec_hash({"a": 2, "b": 1})
    True
    """
    text = json.dumps(data, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def baseline_of(
    chute: Chute, solution: Solution, findings: Sequence[Finding], tolerance: float = TOLERANCE
) -> Baseline:
    """What came out of a chute of one design, unrounded; with its findings.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER)
    >>> baseline_of(spoon, chutecalc.solve(spoon), []).segments[1].stations[4]["velocity_m_s"].__round__(3)
    3.878
    """
    segments = []
    for way, part in zip(solution.trajectory.results, solution.trajectory.parts, strict=True):
        columns = part.at(STATIONS, NUMERIC)
        stations = [_finite({name: columns[name][k] for name in NUMERIC}) for k in range(len(STATIONS))]
        segments.append(
            KeptSegment(
                name=way.name,
                kind=way.kind,
                status=str(way.status[0]),
                impact=_finite(way.impact),
                stations=[station for station in stations if station],
                minimum=_beyond(way.minimum, stations, -1.0),
                maximum=_beyond(way.maximum, stations, 1.0),
            )
        )
    return Baseline(
        format=1,
        chutecalc=__version__,
        spec_sha256=spec_hash(chute.data),
        rtol=solution.rtol,
        tolerance=tolerance,
        status=str(solution.status[0]),
        findings=[KeptFinding(severity=item.severity, code=item.code, segment=item.segment) for item in findings],
        inlet=_finite(solution.inlet),
        segments=segments,
        receiver=_finite({name: values for name, values in solution.receiver.items() if name in RECEIVER}),
    )


def _finite(numbers: Mapping[str, Any]) -> Row:
    """The first design's numbers; what does not exist is left out."""
    return {name: float(values[0]) for name, values in numbers.items() if np.isfinite(values[0])}


def _beyond(extremes: Mapping[str, Any], stations: Sequence[Row], sign: float) -> Row:
    """The extremes that no station shows; where one does, what is between is rounding."""
    return {
        name: value
        for name, value in _finite(extremes).items()
        if all(sign * (value - row[name]) > BEYOND * abs(value) for row in stations if name in row)
    }


def read_baseline(path: Path) -> Baseline:
    """A baseline from its file.

    Raises:
        SpecError: it cannot be read, or all that is wrong with it.
    """
    text = read_text(path)
    data = parse_text(text, str(path))
    try:
        return Baseline.model_validate(data)
    except ValidationError as error:
        raise SpecError(faults_of(error, data, text), str(path)) from None
