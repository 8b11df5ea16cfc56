"""``chutecalc run``: solve chutes and show them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.options import LIBRARY, RTOL, StationOptions, names_of, with_groups
from chutecalc.cli.outputs import Outputs
from chutecalc.cli.run_studies import RunStudies
from chutecalc.cli.specs import read_chutes
from chutecalc.errors import ExitStatus, UsageError
from chutecalc.output.files import open_whole

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute
    from chutecalc.output.run import StationsOf
    from chutecalc.results.cases import Cases

EXAMPLES = (
    "chutecalc run chute.toml --plot chute.svg",
    "chutecalc run chute.toml --band --plot chute.svg",
    "chutecalc run chute.toml --report chute.html --dxf chute.dxf",
    "chutecalc run chute.toml --set flow.rate_t_h=800 --points 21 --csv stations.csv",
)
PAGE = "running.md"


class RunOutputs(Outputs):
    """Outputs of a run."""

    picture = "the chute with its stream, or several chutes as lines"
    drawing = "one chute with its sections"
    reported = "one chute, or of several a comparison"
    charted = "velocity and depth"
    has_units = True


@with_groups
def run(
    specs: list[str] = typer.Argument(..., metavar="SPEC...", help="TOML files; - for standard input."),
    settings: list[str] = typer.Option(
        [], "--set", metavar="PATH=VALUE", help="Change a key, such as segments.spoon.radius_m=2.5. Repeatable."
    ),
    *,
    stations: StationOptions,
    columns: str | None = typer.Option(
        None, metavar="NAMES", help="Columns of tables and of stations in files, separated by commas."
    ),
    case: str | None = typer.Option(
        None, metavar="NAME", help="One operating state of [cases] alone; design for the spec as written."
    ),
    band: bool = typer.Option(
        False, "--band", help="Least and largest velocity and depth over the assumptions that the model leaves open."
    ),
    sensitivity: bool = typer.Option(
        False, "--sensitivity", help="Tell how much each number of the spec changes the exit velocity."
    ),
    strict: bool = typer.Option(False, "--strict", help="Exit with status 1 on warnings too."),
    rtol: float = RTOL,
    library: str | None = LIBRARY,
    outputs: RunOutputs,
) -> int:
    """Solve chutes and report the stream along each segment.

    Data files have a row for each station, 101 along each segment unless you choose with --points or --stations.
    JSON has all other results as well. `chutecalc columns` lists the columns that there are.
    """
    from chutecalc.api.cases import solve_cases
    from chutecalc.results.column_names import check_columns
    from chutecalc.results.columns import COLUMNS

    names = names_of(columns)
    check_columns(names, COLUMNS)
    outputs.check([*specs, library])
    chutes = read_chutes(specs, settings, library)
    if outputs.dxf and len(chutes) > 1:
        raise UsageError(f"--dxf draws one chute, not {len(chutes)}: give one spec")
    cases = [solve_cases(chute, rtol, case) for chute in chutes]
    stations_of = None
    if stations.given:
        from chutecalc.output.run import needed

        stations_of = partial(stations.of, columns=needed(names or list(COLUMNS)))
        for solution in (solution for states in cases for solution in states.solutions.values()):
            stations.of(solution, ["s_m"])  # before anything is written: there may be too many
    studies = RunStudies(chutes, cases, rtol, band=band, sensitivity=sensitivity)
    _write(chutes, cases, stations_of, studies, names or list(COLUMNS), outputs, settings)
    _print(cases, stations_of, studies, names, outputs)
    return _status(cases, strict)


def _write(
    chutes: Sequence[Chute],
    cases: Sequence[Cases],
    stations_of: StationsOf | None,
    studies: RunStudies,
    columns: Sequence[str],
    outputs: RunOutputs,
    settings: Sequence[str],
) -> None:
    """Write the files that a user asks for."""
    if outputs.files:
        from chutecalc.output.run import run_dataset

        outputs.write(run_dataset(cases, stations_of, columns, studies.document))
    if outputs.plot:
        from chutecalc.output.plots.run import draw_run

        outputs.draw(draw_run(cases, outputs.units, studies.bands[0] if studies.bands else None))
    if outputs.dxf:
        from chutecalc.output.dxf.drawing import draw, save

        with open_whole(outputs.dxf, "wb") as stream:
            save(draw(cases[0]), stream)
    if outputs.report:
        from chutecalc.api.report import write_solved

        write_solved(outputs.report, chutes, cases, studies.band, outputs.units, settings)


def _print(
    cases: Sequence[Cases],
    stations_of: StationsOf | None,
    studies: RunStudies,
    columns: Sequence[str],
    outputs: RunOutputs,
) -> None:
    """Print reports. If rows go to standard output, print findings to standard error instead."""
    from chutecalc.output.printer import Printer
    from chutecalc.output.report import print_case_findings, print_cases, print_findings, print_report
    from chutecalc.output.table import StreamTables
    from chutecalc.results.columns import IN_TABLES

    if data := outputs.to_standard_output:
        printer = Printer(outputs.units, sys.stderr)
        for states in cases if data.document is None else ():
            print_findings(printer, states.main_solution.findings())
            print_case_findings(printer, states)
        return
    printer, columns = Printer(outputs.units), columns or IN_TABLES
    stream_tables = StreamTables(columns, outputs.units)
    for number, states in enumerate(cases):
        if number:
            printer.text()
        band = studies.band_line(number, outputs.units)
        print_report(printer, states.main_solution, states.main, columns, band)
        if len(states.names) > 1:
            print_cases(printer, states)
        studies.print(printer, number)
        if stations_of:
            printer.text()
            printer.table(stream_tables.stations(stations_of(states.main_solution)))
        if outputs.chart:
            from chutecalc.output.chart import print_chart

            printer.text()
            print_chart(printer, states.main_solution)
    if len(cases) > 1:
        printer.text()
        printer.table(stream_tables.comparison([states.main_solution for states in cases]))


def _status(cases: Sequence[Cases], strict: bool) -> int:
    """Return 1 if a design fails in any state or, with ``strict``, has a warning; else 0."""
    from chutecalc.results.finding import Severity

    solutions = [solution for states in cases for solution in states.solutions.values()]
    fails = any(not solution.ok[0] for solution in solutions)
    found = (finding for solution in solutions for finding in solution.findings())
    warned = strict and any(finding.severity == Severity.WARNING for finding in found)
    return ExitStatus.FAILS if fails or warned else ExitStatus.OK
