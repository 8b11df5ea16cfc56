"""The results of a run as tables beside its stations: what each spec gives, its segments, findings and cases."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from chutecalc.output.dataset import Table, first, table_of
from chutecalc.output.table import StreamTables
from chutecalc.results.cases import Cases
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import status_words
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.inputs import inputs

SPEC = "spec"
"""Heading of the column that says which spec a row belongs to, where there are several."""
Row = Mapping[str, Any]


def run_tables(chutes: Sequence[Cases], columns: Sequence[str]) -> list[Table]:
    """Return inputs, segments, findings and, where there are any, cases of chutes, as tables.

    Args:
        chutes: chutes of one design each, in all their states.
        columns: names of the columns of segments.
    """
    along = {name: COLUMNS[name] for name in columns if COLUMNS[name].formula}
    measures = {m.column.name: m.column for chute in chutes for m in chute.measures}
    made: dict[str, tuple[dict[str, type], Any]] = {
        "inputs": ({"key": str, "meaning": str, "value": object, "unit": str}, _inputs),
        "segments": ({"segment": str, "kind": str, "at": str, **_types(along)}, _segments(along)),
        "findings": (_FINDING, _findings),
        "cases": ({"case": str, "status": str, **dict.fromkeys(_types(measures), object)}, _cases),
    }
    tables = []
    for name, (types, rows_of) in made.items():
        rows = [{SPEC: chute.main_solution.source} | dict(row) for chute in chutes for row in rows_of(chute)]
        numbers = {key: float for row in rows if name == "findings" for key in row if key not in {SPEC, *types}}
        spec = {SPEC: str} if len(chutes) > 1 else {}
        if rows or name != "cases":
            tables.append(table_of(name, rows, spec | types | numbers))
    return tables


_FINDING: dict[str, type] = {
    **dict.fromkeys(("case", "severity", "code", "segment", "key"), str),
    "s, m": float,
    "message": str,
}
"""Columns of findings; the numbers of each follow, a column each."""


def heading(column: Column) -> str:
    """Return the heading of a column in one line, with its unit.

    Args:
        column: of the catalogue.

    >>> heading(COLUMNS["velocity_m_s"]), heading(COLUMNS["equivalent_friction"])
    ('velocity, m/s', 'μ_e')
    """
    return ", ".join(filter(None, (column.heading, column.unit_text("metric"))))


def _types(columns: Mapping[str, Column]) -> dict[str, type]:
    """Return columns of numbers by their headings."""
    return {heading(column): float for column in columns.values()}


def _inputs(chute: Cases) -> Iterator[Row]:
    """Yield all that a spec gives; a list as text."""
    solution = chute.main_solution
    for one in inputs(solution.spec, solution.data):
        value = one.text if isinstance(one.written, list) else one.written
        yield {"key": one.path, "meaning": one.meaning, "value": value, "unit": one.unit}


def _segments(columns: Mapping[str, Column]) -> Any:
    """Return what yields the ends of the segments of a chute, and extremes beyond those, as on a terminal."""

    def rows(chute: Cases) -> Iterator[Row]:
        for result, label, numbers in StreamTables(list(columns), "metric").ends(chute.main_solution.trajectory.rows):
            known = {heading(columns[name]): numbers[name] for name in columns if name in numbers}
            yield {"segment": result.name, "kind": result.kind, "at": label} | known

    return rows


def _findings(chute: Cases) -> Iterator[Row]:
    """Yield the findings of the state shown in full, and what the others have to tell beside it."""
    for name, solution in chute.solutions.items():
        for finding in solution.findings() if name == chute.main else chute.findings(name):
            found = {"case": name, "severity": str(finding.severity), "code": finding.code}
            where = {"segment": finding.segment, "key": finding.key, "s, m": finding.s_m[0]}
            yield found | where | {"message": finding.message()} | first(finding.numbers)


def _cases(chute: Cases) -> Iterator[Row]:
    """Yield the states of a chute with what they are compared by, and the names of the worst; none without cases."""
    if len(chute.names) == 1:
        return
    headings = {m.column.name: heading(m.column) for m in chute.measures}
    for k, (name, solution) in enumerate(chute.solutions.items()):
        numbers = {headings[key]: float(values[k, 0]) for key, values in chute.numbers.items()}
        yield {"case": name, "status": _status(solution)} | numbers
    worst = {name: str(states[0]) for name, states in chute.worst.items()}
    named = {headings[name]: state for name, state in worst.items() if name in headings}
    yield {"case": "worst", "status": worst["status"]} | named


def _status(solution: SolvedChute) -> str:
    """Return the status of a solution in words."""
    return status_words(solution.status[0])
