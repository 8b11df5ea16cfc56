"""The operating states of a chute side by side: for people, and as part of a document."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from chutecalc.output.dataset import first
from chutecalc.output.grid import Grid
from chutecalc.output.told import alike_by, subjects_of
from chutecalc.results.cases import Cases
from chutecalc.results.described import status_words
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.measures import MEASURES
from chutecalc.results.solved import SolvedChute

COMPARED = {measure.column.name: measure.column for measure in MEASURES}
"""What states are compared by."""
WORST = ("status", *(measure.column.name for measure in MEASURES if measure.badness is not None))
"""In what a state can be the worst."""
CONCERNED = (Severity.FAILURE, Severity.WARNING)
"""Severities of the findings of cases that are printed."""


def cases_table(cases: Cases, units: str) -> Grid:
    """Return a row for each state, and below them the name of the worst in each column.

    Args:
        cases: the states of one design.
        units: ``metric`` or ``us``.
    """
    moves = cases.main_solution.spec.model.steel == "follows_stream"
    title = "cases, each on steel that follows its stream" if moves else "cases, on the same steel"
    return measures_table(cases, units, "case", title)


def measures_table(cases: Cases, units: str, label: str, title: str = "") -> Grid:
    """Return a row for each of several solutions, and below them the name of the worst in each column.

    Args:
        cases: the solutions by name, of one design each.
        units: ``metric`` or ``us``.
        label: heading of the names.
        title: of the table.
    """
    table = Grid(title)
    table.column(label, left=True, label=True)
    table.column("status", left=True, label=True)
    for measure in cases.measures:
        table.column(f"{measure.column.heading}\n{measure.column.unit_text(units)}")
    for k, (name, solution) in enumerate(cases.solutions.items()):
        cells = (
            measure.column.shown(float(cases.numbers[measure.column.name][k, 0]), units) for measure in cases.measures
        )
        table.row([name, status_words(solution.status[0]), *cells])
    worst = {name: str(states[0]) for name, states in cases.worst.items()}
    cells = (worst.get(measure.column.name, "") for measure in cases.measures)
    table.row(["worst", worst["status"], *cells])
    return table


def case_findings(cases: Cases, units: str) -> Iterator[tuple[Severity, str, str]]:
    """Yield severity, beginning and rest of a line for the failures and warnings that cases have to tell.

    What several segments share is said once.

    Args:
        cases: the states of one design.
        units: ``metric`` or ``us``.
    """
    for name in cases.names:
        concerned = (finding for finding in cases.findings(name) if finding.severity in CONCERNED)
        for text, alike in alike_by(concerned, partial(_case_text, cases, name, units)):
            severity, code = alike[0].severity, alike[0].code
            yield severity, f"{severity} {code}", f"  {name}: {subjects_of(alike)}: {text}"


def _case_text(cases: Cases, name: str, units: str, finding: Finding) -> str:
    """Return what a finding says, and in which other states it holds."""
    return f"{finding.message(0, units)}{_elsewhere(cases, name, finding)}"


def _elsewhere(cases: Cases, name: str, finding: Finding) -> str:
    """Return in which other states a warning holds too, in parentheses; empty for a failure, which each state tells."""
    states = cases.states_with(finding)
    others = [state for state in states if state not in (name, cases.main)]
    parts = ["worse than at the design point"] if cases.main in states else []
    parts += [f"also in {', '.join(others)}"] if others else []
    return f" ({'; '.join(parts)})" if parts and finding.severity != Severity.FAILURE else ""


def cases_document(cases: Cases, results: Callable[[SolvedChute], dict[str, Any]]) -> dict[str, Any]:
    """Return the states but the one shown in full as objects by name, and the names of the worst of several.

    Args:
        cases: the states of one design.
        results: gives what a document says about a solution.
    """
    compared = cases.numbers.items()
    states = {
        name: {"compared": first({key: values[k] for key, values in compared}, COMPARED), **results(solution)}
        for k, (name, solution) in enumerate(cases.solutions.items())
        if name != cases.main
    }
    worst = {key: str(cases.worst[key][0]) or None if key in cases.worst else None for key in WORST}
    return {"cases": states, "worst_cases": worst if states else None}
