"""``chutecalc dem``: compare the friction law with discrete-element beds."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.dem_options import CaseOptions, EngineOptions, PourOptions, TroughOptions
from chutecalc.cli.options import LIBRARY, with_groups
from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ExitStatus, UsageError
from chutecalc.printable import printable

if TYPE_CHECKING:
    from chutecalc.dem.campaign import Campaign
    from chutecalc.dem.request import Beds
    from chutecalc.dem.study import Study

EXAMPLES = (
    "chutecalc dem --beta 45 --particle-friction 0.75",
    "chutecalc dem chute.toml --segment spoon --seeds 3 --plot spoon.svg",
)
PAGE = "dem.md"


class DemOutputs(Outputs):
    """Outputs of the check."""

    picture = "wall pressures, equivalent friction and some beds"


@with_groups
def dem(
    spec: str | None = typer.Argument(None, metavar="SPEC", help="A chute, for the section of one of its segments."),
    segment: str | None = typer.Option(None, metavar="NAME", help="Take the section at the end of this segment."),
    *,
    trough: TroughOptions,
    wall_friction: float = typer.Option(
        25.0, min=0, max=89, metavar="DEG", help="Wall friction angle for μ_e. The walls of the beds have none."
    ),
    pour: PourOptions,
    folders: CaseOptions,
    engine: EngineOptions,
    library: str | None = LIBRARY,
    outputs: DemOutputs,
) -> int:
    """Compare the friction law with beds of particles in LAMMPS.

    LAMMPS pours particles into a trough and measures the load on each of its walls. Data files have a row for each bed.
    JSON has means, fits and failures as well.
    """
    from chutecalc.dem.campaign import Campaign
    from chutecalc.dem.export import study_dataset
    from chutecalc.dem.request import groups
    from chutecalc.dem.store import Store
    from chutecalc.dem.study import Study

    folders.check(outputs)
    outputs.check([spec, library])
    how = pour.read()
    beds = _beds(spec, segment, trough, wall_friction, library)
    campaign = Campaign(groups(beds, how), Store(folders.folder))
    if folders.write is not None:
        return _write(campaign)
    if folders.read is None:
        _run(campaign, engine)
    study = Study(campaign, beds.wall_friction, beds.vertical_ratio)
    outputs.write(study_dataset(study))
    if outputs.plot:
        from chutecalc.dem.plot import draw_study

        outputs.draw(draw_study(study))
    _print(study, outputs)
    return ExitStatus.OK if study.sound else ExitStatus.FAILS


def _beds(
    spec: str | None, segment: str | None, trough: TroughOptions, wall_friction: float, library: str | None
) -> Beds:
    """Return the beds of a chute's section or, without a spec, of troughs between two chamfers.

    Raises:
        UsageError: the options do not fit together.
    """
    from chutecalc.dem.request import paper_beds

    if spec is None:
        if segment is not None:
            raise UsageError("--segment names a segment of a spec: give the spec too")
        return paper_beds(trough.beta, trough.base, trough.chamfer, trough.area, trough.delta, wall_friction)
    if trough.given:
        raise UsageError("the spec defines --beta, --base, --chamfer, --area and --delta: remove them")
    from chutecalc.api.load import load
    from chutecalc.dem.chute_section import section_of

    return section_of(load(spec, library=library), segment)


def _write(campaign: Campaign) -> int:
    """Write the cases that are needed next, and say how to run them."""
    needed = campaign.write()
    folder = printable(str(campaign.store.folder))
    typer.echo(f"wrote {len(needed)} cases to {folder}", err=True)
    if needed:
        typer.echo(
            "Run in each of their folders:  lmp -in in.lammps   or   mpirun -np 8 lmp -in in.lammps\n"
            f"Then repeat this command: it writes the next cases where beds were not level. --read {folder} reports"
            " the results.",
            err=True,
        )
    return ExitStatus.OK


def _run(campaign: Campaign, options: EngineOptions) -> None:
    """Run the cases that are needed, after a line that says how long they take."""
    from chutecalc.dem.campaign import expected_seconds
    from chutecalc.dem.engine import Engine
    from chutecalc.output.progress import progress
    from chutecalc.runtime import cores
    from chutecalc.workers import pool_of

    if not any(campaign.outcome(group).needed for group in campaign.groups):
        return
    engine = Engine(options.mpi, options.lmp)
    by_default = None if options.dask else max(cores() // options.mpi, 1)
    pool = pool_of(options.jobs or by_default, options.dask)
    count, seconds = expected_seconds(campaign)
    minutes = max(round(seconds / pool.at_once / options.mpi / 60), 1)
    typer.echo(
        f"{count} cases, {pool.at_once} at once: about {minutes} min. A second call continues from"
        f" {printable(str(campaign.store.folder))}",
        err=True,
    )
    with progress("cases", slow=True) as show:
        campaign.run(engine, pool, show)


def _print(study: Study, outputs: DemOutputs) -> None:
    """Print the tables. If data go to standard output, print failures to standard error instead."""
    from chutecalc.dem.report import failures, print_study
    from chutecalc.output.printer import Printer

    if not outputs.to_standard_output:
        print_study(Printer(), study)
        return
    for line in failures(study):
        print(printable(line), file=sys.stderr)
