"""Baselines: the numbers, statuses and findings of a standard design, in a file beside its spec."""

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
"""Relative tolerance of a new baseline."""
STATIONS = np.linspace(0.0, 1.0, 5)
"""Stations of each segment, as shares of its length."""
RECEIVER = (
    "velocity_along_m_s",
    "velocity_across_m_s",
    "velocity_ratio",
    "impact_pressure_kpa",
    "wear_w_m2",
    "acceleration_length_m",
)
"""Columns of the receiver in a baseline. The others follow from these, and lose digits where the stream matches the
belt's velocity."""
EXTREME_MARGIN = 1e-6
"""Share of its value by which an extreme must exceed all stations to be stored."""
LEAST_SCALE = 1e-3
"""Smallest scale of any column: 1e-12 m, kPa or ° is rounding, such as x in a vertical fall."""

Row = dict[str, FiniteFloat]
"""Numbers by the names of their columns."""


class BaselineFinding(Table):
    """A finding in a baseline."""

    severity: str
    """``failure``, ``warning`` or ``note``."""
    code: str
    """Code of the finding, such as ``stall``."""
    segment: str
    """Name of its segment."""


class BaselineSegment(Table):
    """A segment in a baseline, or a flight to one."""

    name: str
    """Name of the segment."""
    kind: str
    """Kind of the segment, or ``flight``."""
    status: str
    """Status of the stream at its end."""
    impact: Row = Field(default_factory=dict)
    """Numbers of the impact at its start."""
    stations: list[Row] = Field(default_factory=list)
    """Columns at its stations."""
    minimum: Row = Field(default_factory=dict)
    """Smallest values of columns, where no station shows them."""
    maximum: Row = Field(default_factory=dict)
    """Largest values of columns, where no station shows them."""


class Baseline(Table):
    """The results of a design, stored or computed now.

    >>> import chutecalc
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> now = baseline_of(chute, chutecalc.solve(chute), [])
    >>> list(now.visits()), [key.row for key, _ in now.rows() if key.segment == "fall"][:2]
    ([('fall', 1), ('spoon', 1)], ['impact', 'station 1'])
    >>> now.document()["status"]
    'ok'
    """

    format: Literal[1]
    """Version of the file format."""
    chutecalc: str
    """Version of chutecalc that computed the results."""
    spec_sha256: str
    """Hash of the spec, from :func:`spec_hash`."""
    rtol: FiniteFloat
    """Relative tolerance of the solution."""
    tolerance: Annotated[Number, Quantity("number", ge=1e-13, le=0.1)]
    """Relative tolerance of the comparison."""
    status: str
    """Status of the design."""
    findings: list[BaselineFinding]
    """Findings in the order of the flow."""
    inlet: Row
    """Numbers of the inlet."""
    segments: list[BaselineSegment]
    """Segments and flights in the order of the flow."""
    receiver: Row = Field(default_factory=dict)
    """Numbers of the receiver, where there is one."""

    def visits(self) -> dict[tuple[str, int], BaselineSegment]:
        """Return the segments by name and number of the visit: a hood may be struck again."""
        met: dict[str, int] = {}
        found = {}
        for segment in self.segments:
            met[segment.name] = met.get(segment.name, 0) + 1
            found[segment.name, met[segment.name]] = segment
        return found

    def rows(self) -> Iterator[tuple["RowKey", Row]]:
        """Yield all rows of numbers with their keys, in the order of the flow."""
        yield RowKey("inlet", 1, ""), self.inlet
        for visit, segment in self.visits().items():
            yield RowKey(*visit, "impact"), segment.impact
            for number, station in enumerate(segment.stations, 1):
                yield RowKey(*visit, f"station {number}"), station
            yield RowKey(*visit, "minimum"), segment.minimum
            yield RowKey(*visit, "maximum"), segment.maximum
        yield RowKey("receiver", 1, ""), self.receiver

    def scales(self) -> dict[str, float]:
        """Return the scale of each column in this chute, its largest magnitude, by the name of the column."""
        found: dict[str, float] = {}
        for _, row in self.rows():
            for name, value in row.items():
                kind = column_of(name)
                found[kind] = max(found.get(kind, LEAST_SCALE), abs(value))
        return found

    def document(self) -> dict[str, Any]:
        """Return the content of the file. Rounding takes at most a tenth of the tolerance."""
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


class RowKey(NamedTuple):
    """The key of a row of numbers in a baseline."""

    segment: str
    """Name of the segment, or ``inlet`` or ``receiver``."""
    visit: int
    """Number of the visit, from 1: more than one where the stream leaves the segment and comes back."""
    row: str
    """``impact``, ``station 1`` to ``station 5``, ``minimum`` or ``maximum``; empty for inlet and receiver."""


def _is_number(name: str, value: Any) -> bool:
    return isinstance(value, float) and name not in ("rtol", "tolerance")


_OF_UNIT = {"m": "s_m", "m_s": "velocity_m_s", "deg": "slope_deg", "kpa": "pressure_kpa", "w_m2": "wear_w_m2"}


@cache
def column_of(name: str) -> str:
    """Return the column that gives the scale of a number: its own, or one of its unit for numbers without a column.

    Both coordinates have the scale of the distance along the flow, because neither has a size of its own.

    Args:
        name: Name of the number, which ends with its unit.

    >>> column_of("depth_m"), column_of("velocity_after_m_s"), column_of("x_m"), column_of("velocity_ratio")
    ('depth_m', 'velocity_m_s', 's_m', 'velocity_ratio')
    """
    if name in COLUMNS and name not in ("x_m", "z_m"):
        return name
    units = [unit for unit in _OF_UNIT if name.endswith(f"_{unit}")]
    return _OF_UNIT[max(units, key=len)] if units else name


def baseline_path(spec: Path) -> Path:
    """Return the path of the baseline of a spec.

    Args:
        spec: Path of the spec.

    >>> baseline_path(Path("spoon.toml")).name
    'spoon.baseline.toml'
    """
    return spec.with_name(spec.name.removesuffix(".toml") + BASELINE_SUFFIX)


def spec_path(baseline: Path) -> Path:
    """Return the path of the spec of a baseline.

    Args:
        baseline: Path of the baseline.

    >>> spec_path(Path("spoon.baseline.toml")).name
    'spoon.toml'
    """
    return baseline.with_name(baseline.name.removesuffix(BASELINE_SUFFIX) + ".toml")


def spec_hash(data: Mapping[str, Any]) -> str:
    """Compute the hash of the parsed content of a spec, whatever its comments, layout and line ends.

    A checkout that changes line ends passes, and a better comment needs no new baseline.

    Args:
        data: The parsed content.

    >>> spec_hash({"b": 1, "a": 2}) == spec_hash({"a": 2, "b": 1})
    True
    """
    text = json.dumps(data, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def baseline_of(
    chute: Chute, solution: Solution, findings: Sequence[Finding], tolerance: float = TOLERANCE
) -> Baseline:
    """Return the baseline of a solved design, unrounded.

    Args:
        chute: A chute of one design.
        solution: Its solution.
        findings: The findings of the solution.
        tolerance: Relative tolerance of the comparison.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER)
    >>> baseline_of(spoon, chutecalc.solve(spoon), []).segments[1].stations[4]["velocity_m_s"].__round__(3)
    3.878
    """
    segments = []
    for result, part in zip(solution.trajectory.results, solution.trajectory.parts, strict=True):
        columns = part.at(STATIONS, NUMERIC)
        stations = [_finite({name: columns[name][k] for name in NUMERIC}) for k in range(len(STATIONS))]
        segments.append(
            BaselineSegment(
                name=result.name,
                kind=result.kind,
                status=str(result.status[0]),
                impact=_finite(result.impact),
                stations=[station for station in stations if station],
                minimum=_beyond(result.minimum, stations, -1.0),
                maximum=_beyond(result.maximum, stations, 1.0),
            )
        )
    return Baseline(
        format=1,
        chutecalc=__version__,
        spec_sha256=spec_hash(chute.data),
        rtol=solution.rtol,
        tolerance=tolerance,
        status=str(solution.status[0]),
        findings=[BaselineFinding(severity=item.severity, code=item.code, segment=item.segment) for item in findings],
        inlet=_finite(solution.inlet),
        segments=segments,
        receiver=_finite({name: values for name, values in solution.receiver.items() if name in RECEIVER}),
    )


def _finite(numbers: Mapping[str, Any]) -> Row:
    """Return the numbers of the first design, without NaN."""
    return {name: float(values[0]) for name, values in numbers.items() if np.isfinite(values[0])}


def _beyond(extremes: Mapping[str, Any], stations: Sequence[Row], sign: float) -> Row:
    """Return the extremes that no station shows; beside a station that does, an extreme is rounding."""
    return {
        name: value
        for name, value in _finite(extremes).items()
        if all(sign * (value - row[name]) > EXTREME_MARGIN * abs(value) for row in stations if name in row)
    }


def read_baseline(path: Path) -> Baseline:
    """Read a baseline from its file.

    Args:
        path: Path of the baseline.

    Raises:
        SpecError: The file cannot be read; otherwise all faults in it.
    """
    text = read_text(path)
    data = parse_text(text, str(path))
    try:
        return Baseline.model_validate(data)
    except ValidationError as error:
        raise SpecError(faults_of(error, data, text), str(path)) from None
