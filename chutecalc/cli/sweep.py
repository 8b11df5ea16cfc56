"""``chutecalc sweep``: many designs, a row each; without a spec the paper's friction study."""

from __future__ import annotations

import sys
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import typer

from chutecalc.cli.run import Units, read_chute
from chutecalc.errors import UsageError
from chutecalc.output.extras import require_extra

if TYPE_CHECKING:
    from chutecalc.studies.sweep.block import Top
    from chutecalc.studies.sweep.sweep import Sweep

MEANT = 10_000_000
"""Designs that a person can have meant."""
MOST_DRAWN = 1_000_000
STUDY_BARE = {"beta": "0:90:5", "delta": "30:55:5"}


class Keep(StrEnum):
    """What stays while the chamfer angle varies."""

    BASE = "base"
    WIDTH = "width"
    DEPTH = "depth"


def sweep(
    arguments: list[str] = typer.Argument(
        ...,
        metavar="ARG...",
        help="Parameters, such as beta, radius=1:4:0.5, rate=500,1000 or segments.1.drop_m=1:3:#21, and a spec (.toml,"
        " or - for standard input). Without a spec: the paper's friction study over beta and delta.",
    ),
    keep: Keep = typer.Option(Keep.BASE, help="What stays of a section while beta varies."),
    parallel: bool = typer.Option(False, "--zip", help="Take the lists side by side, not in all combinations."),
    columns: str | None = typer.Option(
        None,
        metavar="NAMES",
        help="Columns, between commas: exit_, max_ or min_ before a name of chutecalc columns,"
        " receiver_…, error_estimate, findings.",
    ),
    top: int | None = typer.Option(None, min=1, metavar="N", help="The N best rows only, with --by."),
    by: str | None = typer.Option(None, metavar="COLUMN:max|min", help="What is best, e.g. exit_velocity_m_s:max."),
    points: int | None = typer.Option(None, min=2, help="Rows are stations: so many along each segment."),
    stations: float | None = typer.Option(None, metavar="D", help="Rows are stations, every D metres."),
    csv: str | None = typer.Option(None, metavar="FILE", help="Write the rows; - for standard output."),
    parquet: str | None = typer.Option(None, metavar="FILE", help="Write the rows (extra parquet)."),
    json: str | None = typer.Option(None, metavar="FILE", help="Write the rows, and what was asked; - as above."),
    plot: str | None = typer.Option(
        None, metavar="FILE", help="Draw lines over one parameter, contours over two: .svg, .png or .pdf."
    ),
    chart: bool = typer.Option(False, "--chart", help="Show a small chart over one parameter too."),
    resume: bool = typer.Option(False, "--resume", help="Go on from the FILE.part of a sweep that was ended."),
    yes: bool = typer.Option(False, "--yes", help=f"Do not ask, also above {MEANT:,} designs."),
    jobs: int | None = typer.Option(None, min=1, help="Threads; as many as there are cores without it."),
    phi: float | None = typer.Option(None, help="Friction study: wall friction angle, degrees (25)."),
    base: float | None = typer.Option(None, help="Friction study: width between square corners, m (0.5)."),
    area: float | None = typer.Option(None, help="Friction study: flow area, m² (0.05)."),
    units: Units = typer.Option(Units.METRIC, help="Units of tables, charts and pictures."),
    rtol: float = typer.Option(1e-10, help="Relative error allowed to the velocity, 1e-13 to 1e-3."),
    debug: bool = typer.Option(False, "--debug", help="Show where the program itself fails."),
) -> int:
    """Vary parameters of a chute: a row for each design.

    Without a spec: the equivalent friction over the chamfer angle, as in the paper. Ends with status 0 whatever the
    rows say.
    """
    specs = [argument for argument in arguments if argument == "-" or argument.endswith(".toml")]
    given = [argument for argument in arguments if argument not in specs]
    if len(specs) > 1:
        raise UsageError(f"a sweep takes one spec, not {len(specs)}: {', '.join(specs)}")
    study = {"--phi": phi, "--base": base, "--area": area}
    if not specs:
        other: dict[str, Any] = {"--zip": parallel, "--columns": columns, "--top": top, "--by": by, "--points": points}
        other |= {"--stations": stations, "--parquet": parquet, "--chart": chart, "--resume": resume}
        _refuse(other, "goes with a spec: the friction study has its own rows, with --csv, --json and --plot")
        return _friction_study(given, keep, study, csv, json, plot, units)
    _refuse(study, "belongs to the friction study: with a spec, vary phi or base, or change the spec")
    if not given:
        raise UsageError("nothing is varied: add a parameter, such as beta, rate=500,1000 or segments.1.drop_m=1:3:0.5")
    from chutecalc.cli.sweep_run import SweepRun
    from chutecalc.output.files import check_openable, check_targets
    from chutecalc.studies.sweep.parameters import read_parameters
    from chutecalc.studies.sweep.sweep import Sweep
    from chutecalc.studies.sweep.table import MOST_SHOWN

    if points is not None and stations is not None:
        raise UsageError("--points and --stations both say where the stations are: give one of them")
    targets = {"csv": csv, "parquet": parquet, "json": json, "plot": plot}
    check_targets(list(targets.values()), specs)
    _check_extras(parquet, plot, chart)
    for target in targets.values():
        check_openable(target)
    chute = read_chute(specs[0])
    parameters = read_parameters(given, chute)
    names = [name.strip() for name in columns.split(",")] if columns else []
    asked = Sweep(chute, parameters, parallel, keep, names, _top(top, by), points, stations, rtol)
    if not (names or asked.profiles or any(targets.values()) or asked.count > MOST_SHOWN):
        asked.columns.append("findings")  # a hundred times the work of all others, so by itself for few designs alone
    _check_drawn(asked, plot, chart)
    if asked.count > MEANT and not yes:
        _ask(asked)
    return SweepRun(asked, targets, chart, resume, jobs, units).run()


def _friction_study(
    given: list[str],
    keep: Keep,
    study: dict[str, float | None],
    csv: str | None,
    json: str | None,
    plot: str | None,
    units: Units,
) -> int:
    """The study, over the angles given."""
    from chutecalc.cli.friction import run_friction_study
    from chutecalc.studies.sweep.parameters import split_argument

    angles: dict[str, Any] = {}
    for argument in given:
        name = argument.partition("=")[0].strip()
        if name not in STUDY_BARE:
            raise UsageError(
                f"{argument}: without a spec only beta and delta are varied; name a spec (.toml) for others"
            )
        if name in angles:
            raise UsageError(f"{name} is given twice: keep one of them")
        angles[name] = split_argument(argument, STUDY_BARE)[1].tolist()
    angles |= {name.removeprefix("--"): value for name, value in study.items() if value is not None}
    return run_friction_study(**angles, keep=keep.value, csv=csv, json=json, plot=plot, units=units)


def _refuse(options: dict[str, Any], why: str) -> None:
    """Options that were given, whatever their value, and do not fit."""
    given = [name for name, value in options.items() if value is not None and value is not False]
    if given:
        raise UsageError(f"{', '.join(given)} {why}")


def _check_extras(parquet: str | None, plot: str | None, chart: bool) -> None:
    """That what is asked for can be written, before anything is solved."""
    if parquet == "-":
        raise UsageError("--parquet writes a file: standard output takes --csv or --json")
    if parquet:
        require_extra("parquet")
    if plot:
        from chutecalc.output.plots.save import picture_format

        picture_format(plot)
    if chart:
        require_extra("chart")


def _check_drawn(sweep: Sweep, plot: str | None, chart: bool) -> None:
    """That the rows can be drawn."""
    option, most = ("--chart", 1) if chart else ("--plot", 2)
    if not (plot or chart):
        return
    if sweep.profiles or sweep.top:
        raise UsageError(f"{option} draws all designs: it does not go with --points, --stations or --top")
    varied = [parameter.name for parameter in sweep.parameters if len(parameter.values) > 1]
    if not varied or (len(varied) > most and not sweep.parallel):
        raise UsageError(
            f"{option} draws over {'one parameter' if most == 1 else 'one or two parameters'} of several"
            f" values, not {len(varied)}"
        )
    if sweep.count > MOST_DRAWN:
        raise UsageError(f"{option} draws at most {MOST_DRAWN:,} designs, not {sweep.count:,}")


def _top(top: int | None, by: str | None) -> Top | None:
    """What is best."""
    from chutecalc.studies.sweep.block import Top

    if top is None and by is None:
        return None
    name, _, way = (by or "").rpartition(":")
    if top is None or not name or way not in ("max", "min"):
        raise UsageError("the best rows are asked for with --top N --by COLUMN:max or COLUMN:min")
    return Top(top, name, way == "max")


def _ask(sweep: Sweep) -> None:
    """Whether so many designs are meant, where somebody can be asked."""
    if sys.stdin.isatty() and sys.stderr.isatty():
        lists = " × ".join(f"{len(parameter.values):,} {parameter.name}" for parameter in sweep.parameters)
        if not typer.confirm(f"{lists}: {sweep.count:,} designs. Go on?", err=True):
            raise UsageError("nothing was solved")
