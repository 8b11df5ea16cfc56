"""Baselines: the numbers, statuses and findings of a standard design."""

import math
from collections.abc import Iterator
from functools import cache
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, FiniteFloat

from chutecalc.fields.quantity import Number, Quantity
from chutecalc.fields.table import Table
from chutecalc.results.columns import COLUMNS

TOLERANCE = 1e-9
"""Relative tolerance of a new baseline."""
STATIONS = np.linspace(0.0, 1.0, 5)
"""Stations of each segment, as shares of its length."""
RECEIVER = (
    "velocity_along_m_s",
    "velocity_into_m_s",
    "velocity_across_m_s",
    "landing_x_m",
    "landing_z_m",
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
    loads: Row = Field(default_factory=dict)
    """Forces and wear of the segment."""
    stations: list[Row] = Field(default_factory=list)
    """Columns at its stations."""
    minimum: Row = Field(default_factory=dict)
    """Smallest values of columns, where no station shows them."""
    maximum: Row = Field(default_factory=dict)
    """Largest values of columns, where no station shows them."""


class State(Table):
    """The results in one operating state."""

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


class Baseline(State):
    """The results of a design at its design point and in its cases, stored or computed now.

    >>> import chutecalc
    >>> from chutecalc.studies.regression.record import baseline_of
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> now = baseline_of(chute, chutecalc.solve(chute), [])
    >>> list(now.visits()), [key.row for key, _ in now.rows() if key.segment == "fall"][:2]
    ([('fall', 1), ('spoon', 1)], ['impact', 'loads'])
    >>> now.document()["status"]
    'ok'
    """

    format: Literal[1]
    """Version of the file format."""
    chutecalc: str
    """Version of chutecalc that computed the results."""
    spec_sha256: str
    """Hash of the spec, from :func:`chutecalc.studies.regression.record.spec_hash`."""
    rtol: FiniteFloat
    """Relative tolerance of the solution."""
    tolerance: Annotated[Number, Quantity("number", ge=1e-13, le=0.1)]
    """Relative tolerance of the comparison."""
    cases: dict[str, State] = Field(default_factory=dict)
    """Results in the operating states of the spec's cases, by name."""

    def states(self) -> dict[str, State]:
        """Return the operating states by the text that stands before the names of their segments: none at first."""
        return {"": self} | {f"{name}: ": state for name, state in self.cases.items()}

    def visits(self) -> dict[tuple[str, int], BaselineSegment]:
        """Return the segments by name and number of the visit: a hood may be struck again."""
        met: dict[str, int] = {}
        found = {}
        for before, state in self.states().items():
            for segment in state.segments:
                name = before + segment.name
                met[name] = met.get(name, 0) + 1
                found[name, met[name]] = segment
        return found

    def rows(self) -> Iterator[tuple["RowKey", Row]]:
        """Yield all rows of numbers with their keys, in the order of the flow."""
        for before, state in self.states().items():
            yield RowKey(f"{before}inlet", 1, ""), state.inlet
        for visit, segment in self.visits().items():
            yield RowKey(*visit, "impact"), segment.impact
            yield RowKey(*visit, "loads"), segment.loads
            for number, station in enumerate(segment.stations, 1):
                yield RowKey(*visit, f"station {number}"), station
            yield RowKey(*visit, "minimum"), segment.minimum
            yield RowKey(*visit, "maximum"), segment.maximum
        for before, state in self.states().items():
            yield RowKey(f"{before}receiver", 1, ""), state.receiver

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

        content = self.model_dump(exclude_defaults=True)
        head = {name: content[name] for name in type(self).__annotations__ if name in content and name != "cases"}
        return dict(rounded(head | content))


class RowKey(NamedTuple):
    """The key of a row of numbers in a baseline."""

    segment: str
    """Name of the segment, or ``inlet`` or ``receiver``."""
    visit: int
    """Number of the visit, from 1: more than one where the stream leaves the segment and comes back."""
    row: str
    """``impact``, ``loads``, ``station 1`` to ``station 5``, ``minimum``, ``maximum``; empty for inlet and receiver."""


def _is_number(name: str, value: Any) -> bool:
    return isinstance(value, float) and name not in ("rtol", "tolerance")


_OF_UNIT = {
    "m": "s_m",
    "m_s": "velocity_m_s",
    "deg": "slope_deg",
    "kpa": "pressure_kpa",
    "w_m2": "wear_w_m2",
    "n": "force_n",
}


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
