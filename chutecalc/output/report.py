"""Reports on a chute for its designer."""

from collections.abc import Iterable, Sequence

from chutecalc.output.cases import case_findings, cases_table
from chutecalc.output.inlet import inlet_lines
from chutecalc.output.loads import loads_table
from chutecalc.output.outcome import flow_line, impact_lines, outcome
from chutecalc.output.printer import COLOURS, Printer
from chutecalc.output.receiver import receiver_lines
from chutecalc.output.table import StreamTables
from chutecalc.output.told import against_each_other, told
from chutecalc.results.cases import Cases
from chutecalc.results.columns import IN_TABLES
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.operating import DESIGN_POINT


def print_report(
    printer: Printer,
    solution: SolvedChute,
    case: str = DESIGN_POINT,
    columns: Sequence[str] = IN_TABLES,
    band: str = "",
) -> None:
    """Print a chute: its title and flow, its segments, its outcome and findings.

    Args:
        printer: where to print, and in which units.
        solution: solution of one design.
        case: name of its operating state.
        columns: names of the columns of its segments.
        band: line on the band of the model at the exit; empty for none.
    """
    units = printer.units
    state = "" if case == DESIGN_POINT else f", case {case}"
    printer.text(f"{solution.spec.title or solution.source}{state}", style="bold")
    printer.text(flow_line(solution, units))
    printer.text()
    printer.table(StreamTables(columns, units).segments(solution.trajectory.rows))
    printer.text()
    printer.text(outcome(solution, units), style="" if solution.ok[0] else COLOURS[Severity.FAILURE])
    if band:
        printer.text(f"band  {band}")
    for lines in (impact_lines, inlet_lines, receiver_lines):
        for line in lines(solution, units):
            printer.text(line)
    loads = loads_table(solution.segments, units)
    if loads.rows:
        printer.text()
        printer.table(loads)
        printer.text()
    print_findings(printer, solution.findings())


def print_findings(printer: Printer, findings: Sequence[Finding]) -> None:
    """Print findings, a line each; what several segments share is said once.

    Findings that ask for changes that undo each other are set against each other below.

    Args:
        printer: where to print, and in which units.
        findings: findings of one design.
    """
    for each in told(findings, printer.units):
        printer.text(f"{each.severity} {each.code}", f"  {each.where}: {each.message}", COLOURS[each.severity])
    for line in against_each_other(findings):
        printer.text("against each other", f"  {line}")


def print_cases(printer: Printer, cases: Cases) -> None:
    """Print the operating states of a chute, and what goes wrong in them beside the findings of the design point.

    Args:
        printer: where to print, and in which units.
        cases: the states of one design.
    """
    printer.text()
    printer.table(cases_table(cases, printer.units))
    found = list(case_findings(cases, printer.units))
    if found:
        printer.text()
    _print_lines(printer, found)


def print_case_findings(printer: Printer, cases: Cases) -> None:
    """Print what goes wrong in cases beside the findings of the design point, a line each.

    Args:
        printer: where to print, and in which units.
        cases: the states of one design.
    """
    _print_lines(printer, case_findings(cases, printer.units))


def _print_lines(printer: Printer, lines: Iterable[tuple[Severity, str, str]]) -> None:
    """Print lines that begin in the colour of their severity."""
    for severity, begin, rest in lines:
        printer.text(begin, rest, COLOURS[severity])
