"""``chutecalc sweep``: many designs, a row each; without a spec the friction study of the paper."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import typer

from chutecalc.cli.options import DASK, JOBS, LIBRARY, RTOL, StationOptions, names_of, with_groups
from chutecalc.cli.specs import read_chute
from chutecalc.cli.sweep_options import BestOptions, Keep, StudyOptions, SweepOutputs
from chutecalc.errors import UsageError

if TYPE_CHECKING:
    from chutecalc.studies.sweep.sweep import Sweep

CONFIRMED_ABOVE = 10_000_000
"""Designs above which a user is asked whether so many are meant."""
EXAMPLES = (
    "chutecalc sweep radius=2:4:0.5 phi=20:30:5 chute.toml --csv designs.csv",
    "chutecalc sweep beta delta=30,40,50 --keep width --plot friction.svg",
)
PAGE = "sweeps.md"


@with_groups
def sweep(
    arguments: list[str] = typer.Argument(
        ...,
        metavar="PARAMETER... [SPEC]",
        help="Parameters, such as beta, radius=1:4:0.5, rate=500,1000, segments.1.drop_m=1:3:#21 or"
        " segments.2.liner=steel,ceramic, and a spec (.toml, or - for standard input).",
    ),
    keep: Keep = typer.Option(Keep.BASE, help="What stays constant in a section while beta varies."),
    parallel: bool = typer.Option(False, "--zip", help="Pair the lists element by element instead of combining them."),
    columns: str | None = typer.Option(
        None,
        metavar="NAMES",
        help="Columns, separated by commas: a name from chutecalc columns after exit_, max_ or min_; receiver_"
        " and a column of the receiving belt; segments.NAME. and a column of that segment; error_estimate;"
        " findings; or warnings.",
    ),
    *,
    best: BestOptions,
    stations: StationOptions,
    study: StudyOptions,
    resume: bool = typer.Option(False, "--resume", help="Continue an interrupted sweep from its FILE.part."),
    yes: bool = typer.Option(False, "--yes", help=f"Do not ask for confirmation above {CONFIRMED_ABOVE:,} designs."),
    jobs: int | None = JOBS,
    dask: str | None = DASK,
    rtol: float = RTOL,
    library: str | None = LIBRARY,
    outputs: SweepOutputs,
) -> int:
    """Vary parameters of a chute and report a row for each design.

    With --points or --stations there is a row for each station instead. Without a spec, report the equivalent friction
    over the chamfer angle, as in the paper (parameters beta and delta).
    """
    specs = [argument for argument in arguments if argument == "-" or argument.endswith(".toml")]
    given = [argument for argument in arguments if argument not in specs]
    if len(specs) > 1:
        raise UsageError(f"a sweep takes one spec, not {len(specs)}: {', '.join(specs)}")
    if not specs:
        other: dict[str, Any] = {"zip": parallel, "columns": columns, "resume": resume, "chart": outputs.chart}
        _refuse(vars(best) | vars(stations) | other, "needs a spec: the friction study does not have it")
        from chutecalc.cli.friction import read_angles, run_friction_study

        return run_friction_study(outputs, keep=keep.value, **read_angles(given), **study.inputs())
    _refuse(vars(study), "belongs to the friction study: with a spec, vary phi or base, or change the spec")
    if not given:
        raise UsageError("nothing is varied: add a parameter, such as beta, rate=500,1000 or segments.1.drop_m=1:3:0.5")
    from chutecalc.cli.sweep_run import SweepRun, check_resumed
    from chutecalc.studies.sweep.parameters import read_parameters
    from chutecalc.studies.sweep.sweep import Sweep
    from chutecalc.studies.sweep.table import MOST_SHOWN
    from chutecalc.workers import pool_of

    if resume:
        check_resumed(outputs)
    outputs.check([*specs, library])
    chute = read_chute(specs[0], library=library)
    parameters = read_parameters(given, chute)
    names = names_of(columns)
    task = Sweep(
        chute,
        parameters,
        parallel=parallel,
        keep=keep,
        columns=names,
        top=best.read(),
        points=stations.points,
        spacing=stations.stations,
        rtol=rtol,
    )
    if not (names or task.profiles or outputs.files or outputs.plot or task.count > MOST_SHOWN):
        task.columns.append("findings")  # a hundred times the work of the others: for short tables only
    outputs.check_drawn(task)
    if task.count > CONFIRMED_ABOVE and not yes:
        _confirm(task)
    return SweepRun(task, outputs, resume, pool_of(jobs, dask)).run()


def _refuse(options: dict[str, Any], reason: str) -> None:
    """Refuse options that were given, whatever their value, where they do not fit.

    Raises:
        UsageError: the options, and the reason.
    """
    given = [f"--{name}" for name, value in options.items() if value is not None and value is not False]
    if given:
        raise UsageError(f"{', '.join(given)} {reason}")


def _confirm(sweep: Sweep) -> None:
    """Ask whether so many designs are meant.

    Raises:
        UsageError: they are not, or there is no terminal to ask on.
    """
    lists = " × ".join(f"{len(parameter.values):,} {parameter.name}" for parameter in sweep.parameters)
    if not (sys.stdin and sys.stdin.isatty() and sys.stderr.isatty()):
        raise UsageError(f"{lists}: {sweep.count:,} designs. Add --yes if so many are meant.")
    with suppress(typer.Abort):  # no answer is none
        if typer.confirm(f"{lists}: {sweep.count:,} designs. Continue?", err=True):
            return
    raise UsageError("nothing was solved")
