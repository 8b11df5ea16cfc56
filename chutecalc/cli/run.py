"""``chutecalc run``: solve chutes and show them."""

from __future__ import annotations

from contextlib import ExitStack
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import typer

from chutecalc.errors import AllSpecsError, ExitStatus, SpecError, UsageError
from chutecalc.output.extras import require_extra

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute
    from chutecalc.api.solution import Solution


STANDARD_INPUT = "standard input"


class Units(StrEnum):
    """What people are shown; files are always SI with degrees."""

    METRIC = "metric"
    US = "us"


def run(
    specs: list[str] = typer.Argument(..., metavar="SPEC...", help="TOML files; - for standard input."),
    settings: list[str] = typer.Option(
        [], "--set", metavar="PATH=VALUE", help="Change a key, e.g. segments.spoon.radius_m=2.5."
    ),
    points: int | None = typer.Option(None, min=2, help="Show so many stations along each segment."),
    stations: float | None = typer.Option(None, metavar="D", help="Show stations every D metres along each segment."),
    csv: str | None = typer.Option(
        None, metavar="FILE", help="Write the stations (101 a segment without the options above)."
    ),
    json: str | None = typer.Option(
        None, metavar="FILE", help="Write everything but the tables; - for standard output."
    ),
    plot: str | None = typer.Option(
        None, metavar="FILE", help="Draw the chute with its stream, or several as lines: .svg, .png or .pdf."
    ),
    chart: bool = typer.Option(False, "--chart", help="Show velocity and depth as a small chart too."),
    units: Units = typer.Option(Units.METRIC, help="Units of tables, charts and pictures."),
    rtol: float = typer.Option(1e-10, help="Relative error allowed to the velocity, 1e-13 to 1e-3."),
    strict: bool = typer.Option(False, "--strict", help="End with status 1 on warnings too."),
    debug: bool = typer.Option(False, "--debug", help="Show where the program itself fails."),
) -> int:
    """Solve chutes: velocity and depth along each segment, and what to mind.

    Ends with status 0 where all is well, 1 where a chute fails, 2 where a spec or the command is wrong.
    """
    from chutecalc.api.chute import solve
    from chutecalc.output.files import check_targets, open_whole

    if points is not None and stations is not None:
        raise UsageError("--points and --stations both say where the stations are: give one of them")
    check_targets([csv, json, plot], specs)
    _check_extras(plot, chart)
    chutes = _chutes(specs, settings)
    with ExitStack() as outputs:
        csv_stream = outputs.enter_context(open_whole(csv))
        json_stream = outputs.enter_context(open_whole(json))
        plot_stream = outputs.enter_context(open_whole(plot, "wb"))
        runs = [solve(chute, rtol) for chute in chutes]
        asked = points is not None or stations is not None
        tables = [run.stations(points, stations) for run in runs] if asked or csv_stream else []
        if csv_stream:
            from chutecalc.output.csv import write_stations

            write_stations(csv_stream, zip((chute.source for chute in chutes), tables, strict=True))
        if json_stream:
            from chutecalc.output.json import run_document, write_run

            shown = tables if asked else [None] * len(runs)
            write_run(json_stream, [run_document(*pair) for pair in zip(runs, shown, strict=True)])
        if plot and plot_stream:
            from chutecalc.output.plots.run import draw_run
            from chutecalc.output.plots.save import picture_format, save

            save(draw_run(runs, units), plot_stream, picture_format(plot))
    _print(runs, tables if asked else [], chart, units, csv, json)
    return _status(runs, strict)


def _check_extras(plot: str | None, chart: bool) -> None:
    """That what is asked for can be drawn, before anything is solved."""
    if plot:
        from chutecalc.output.plots.save import picture_format

        picture_format(plot)
    if chart:
        require_extra("chart")


def _chutes(specs: list[str], settings: list[str]) -> list[Chute]:
    """All chutes, with the settings in them; all faults of all of them."""
    changes = dict(_setting(text) for text in settings)
    chutes: list[Chute] = []
    errors: list[SpecError] = []
    for spec in _without_baselines(specs):
        try:
            chutes.append(read_chute(spec, changes))
        except SpecError as error:
            errors.append(error)
    if errors:
        raise AllSpecsError(errors)
    return chutes


def _without_baselines(specs: list[str]) -> list[str]:
    """The specs that a glob such as ``specs/*.toml`` means, which takes along the baselines beside them."""
    from chutecalc.spec.parse import BASELINE_SUFFIX

    return [spec for spec in specs if not spec.endswith(BASELINE_SUFFIX)] or specs


def read_chute(spec: str, changes: dict[str, Any] | None = None) -> Chute:
    """The chute of a file, or of what comes in by a pipe, with changes in it."""
    from chutecalc.api.chute import load, parse

    return parse(_standard_input(), STANDARD_INPUT, changes) if spec == "-" else load(spec, changes)


def _standard_input() -> str:
    """The spec that comes in by a pipe."""
    import sys

    from chutecalc.spec.parse import decode

    return decode(sys.stdin.buffer.read(), STANDARD_INPUT)


def _setting(text: str) -> tuple[str, Any]:
    """A ``PATH=VALUE``; the value as TOML reads it, else as text."""
    import tomllib

    path, equals, value = text.partition("=")
    if not (path and equals):
        raise UsageError(f"--set takes PATH=VALUE, such as segments.1.drop_m=2, not {text!r}")
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except tomllib.TOMLDecodeError:
        return path.strip(), value.strip()


def _print(
    runs: list[Solution],
    tables: list[dict[str, Any]],
    chart: bool,
    units: Units,
    csv: str | None,
    json: str | None,
) -> None:
    """The reports; where data goes to standard output, what matters of them on standard error."""
    import sys

    from chutecalc.output.table import Printer

    if json == "-":
        return
    if csv == "-":
        printer = Printer(units, sys.stderr)
        for solution in runs:
            printer.findings(solution.findings())
        return
    printer = Printer(units)
    for number, solution in enumerate(runs):
        if number:
            printer.text()
        printer.report(solution)
        if tables:
            printer.text()
            printer.stations(tables[number])
        if chart:
            from chutecalc.output.chart import print_chart

            printer.text()
            print_chart(printer, solution)
    if len(runs) > 1:
        printer.text()
        printer.comparison(runs)


def _status(runs: list[Solution], strict: bool) -> int:
    """0, or 1 where a design fails, or draws a warning under ``--strict``."""
    fails = any(solution.status[0] != "ok" for solution in runs)
    warned = strict and any(finding.severity == "warning" for solution in runs for finding in solution.findings())
    return ExitStatus.FAILS if fails or warned else ExitStatus.OK
