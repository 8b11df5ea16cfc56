"""``chutecalc dem``: the discrete-element check of the friction law."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import IO, TYPE_CHECKING

import typer

from chutecalc.errors import ExitStatus, UsageError

if TYPE_CHECKING:
    from chutecalc.dem.campaign import Campaign
    from chutecalc.dem.study import Study
    from chutecalc.dem.wanted import Beds

CASES = "dem-cases"


def dem(
    spec: str | None = typer.Argument(None, metavar="[SPEC]", help="A chute, for the section of one of its segments."),
    segment: str | None = typer.Option(None, metavar="NAME", help="The segment of SPEC, where it ends."),
    beta: str | None = typer.Option(None, metavar="DEG", help="Chamfer angles, 30,45 or 15:90:15, the default."),
    particle_friction: str = typer.Option("0.75,0.9", metavar="LIST", help="Friction coefficients between particles."),
    pour: str = typer.Option("rain", help="gentle (0.3 m/s), rain (1 m/s), freefall, a list of them, or all."),
    seeds: int = typer.Option(1, min=1, max=100, help="Beds of each kind, for the scatter."),
    base: float | None = typer.Option(None, min=0, max=100, metavar="M", help="Width of the floor, 0.5; 0 for a vee."),
    chamfer: float | None = typer.Option(None, min=1e-3, metavar="M", help="Length of a chamfer; without it no top."),
    area: str | None = typer.Option(None, metavar="M2", help="Area wanted of the bed, 0.05, or several."),
    body_force: str = typer.Option("1", metavar="G", help="Body force of the pour, or several, in g."),
    raise_to: float = typer.Option(0.0, min=0, max=100, metavar="G", help="Raise it on the resting bed, in g."),
    diameter: float = typer.Option(0.01, min=1e-4, max=1, metavar="M", help="Of the particles."),
    slice_: float = typer.Option(0.05, "--slice", min=1e-3, max=10, metavar="M", help="Length of trough, periodic."),
    wall_friction: float = typer.Option(25.0, min=0, max=89, metavar="DEG", help="For μ_e; the beds' walls have none."),
    delta: float | None = typer.Option(None, min=0, max=89, metavar="DEG", help="Compare with this δ too."),
    cases: str = typer.Option(CASES, metavar="DIR", help="Where cases are kept; a second call goes on from there."),
    write: str | None = typer.Option(None, metavar="DIR", help="Only write the cases to run next, for a cluster."),
    read: str | None = typer.Option(None, metavar="DIR", help="Only show what has been run there."),
    jobs: int | None = typer.Option(None, min=1, help="Cases at once; as many as there are cores."),
    mpi: int = typer.Option(1, min=1, help="Processes of each case, through mpirun."),
    lmp: str = typer.Option("lmp", metavar="PROGRAM", help="LAMMPS' executable."),
    csv: str | None = typer.Option(None, metavar="FILE", help="Write a row for each bed; - for standard output."),
    json: str | None = typer.Option(None, metavar="FILE", help="Write everything; - for standard output."),
    plot: str | None = typer.Option(None, metavar="FILE", help="Draw it: svg, png or pdf."),
    debug: bool = typer.Option(False, "--debug", help="Show where the program itself fails."),
) -> int:
    """Pour beds of particles with LAMMPS and compare their wall loads with the friction law.

    Ends with status 1 where a case crashed or failed a check; 3 where LAMMPS is missing.
    """
    from chutecalc.dem.campaign import Campaign
    from chutecalc.dem.store import Store
    from chutecalc.dem.study import Study
    from chutecalc.dem.wanted import Wanted, groups, numbers, paper_beds, pours
    from chutecalc.output.files import check_targets, open_whole

    outputs = (csv, json, plot)
    _check_folders(write, read, any(outputs))
    check_targets(outputs, [spec] if spec else [])
    if plot:
        _picture_format(plot)
    frictions = numbers(particle_friction, "--particle-friction", 0.0, 10.0)
    forces = numbers(body_force, "--body-force", 0.01, 100.0)
    wanted = Wanted(frictions, pours(pour), seeds, forces, raise_to, diameter, slice_)
    if spec is None:
        if segment is not None:
            raise UsageError("--segment names a segment of a spec: give the spec too")
        beds = paper_beds(beta, base, chamfer, area, delta, wall_friction)
    else:
        if (beta, base, chamfer, area, delta) != (None,) * 5:
            raise UsageError("--beta, --base, --chamfer, --area and --delta are what the spec says: leave them out")
        beds = _beds_of(spec, segment)
    campaign = Campaign(groups(beds, wanted), Store(write or read or cases))
    if write is not None:
        return _write(campaign)
    with ExitStack() as stack:
        rows, document = stack.enter_context(open_whole(csv)), stack.enter_context(open_whole(json))
        picture = stack.enter_context(open_whole(plot, "wb"))
        if read is None:
            _run(campaign, jobs, mpi, lmp)
        study = Study(campaign, beds.wall_friction, beds.vertical_ratio)
        _write_files(study, rows, document, picture, plot)
    _print(study, "-" in outputs)
    return ExitStatus.OK if study.sound else ExitStatus.FAILS


def _check_folders(write: str | None, read: str | None, outputs: bool) -> None:
    """That what is asked of the folders goes together."""
    if write is not None and read is not None:
        raise UsageError("--write and --read: give one of them, then the other in a second call")
    if write is not None and outputs:
        raise UsageError("--write runs nothing, so there is nothing to put into files: leave them out")
    if read is not None and not Path(read).is_dir():
        raise UsageError(f"--read {read}: there is no such folder. Give the one that --write or --cases named")


def _beds_of(spec: str, segment: str | None) -> Beds:
    """The bed that a real chute asks for."""
    from chutecalc.api.chute import load
    from chutecalc.dem.chute_section import section_of

    return section_of(load(spec), segment)


def _picture_format(plot: str) -> str:
    """The format of a picture, once it is known that it can be drawn."""
    from chutecalc.output.plots.save import picture_format

    return picture_format(plot)


def _write_files(
    study: Study, csv: IO[str] | None, json: IO[str] | None, picture: IO[bytes] | None, plot: str | None
) -> None:
    """Writes what is asked for."""
    if csv or json:
        from chutecalc.dem.export import write_csv, write_json

        for stream, writer in ((csv, write_csv), (json, write_json)):
            if stream:
                writer(stream, study)
    if plot and picture:
        from chutecalc.dem.plot import draw_study
        from chutecalc.output.plots.save import save

        save(draw_study(study), picture, _picture_format(plot))


def _write(campaign: Campaign) -> int:
    """Writes the cases that are needed next, and says how to run them."""
    needed = campaign.write()
    typer.echo(f"{len(needed)} cases written to {campaign.store.folder}", err=True)
    if needed:
        typer.echo(
            "Run in each of their folders:  lmp -in in.lammps   or   mpirun -np 8 lmp -in in.lammps\n"
            f"then call this again, also for the next round: --write goes on where beds were not level, "
            f"--read {campaign.store.folder} shows them",
            err=True,
        )
    return ExitStatus.OK


def _run(campaign: Campaign, jobs: int | None, mpi: int, lmp: str) -> None:
    """Runs what is needed; says before how long that takes."""
    from chutecalc.dem.campaign import expected_seconds
    from chutecalc.dem.engine import Engine
    from chutecalc.output.progress import progress
    from chutecalc.runtime import cores

    if not any(campaign.outcome(group).needed for group in campaign.groups):
        return
    engine = Engine(mpi, lmp)
    at_once = jobs or max(cores() // mpi, 1)
    count, seconds = expected_seconds(campaign)
    typer.echo(
        f"{count} cases, {at_once} at once: about {max(round(seconds / at_once / mpi / 60), 1)} min. They are kept in"
        f" {campaign.store.folder}: a second call goes on from there",
        err=True,
    )
    with progress("cases", slow=True) as told:
        campaign.run(engine, at_once, told)


def _print(study: Study, data: bool) -> None:
    """The tables; where data went to standard output only what failed, on standard error."""
    import sys

    from chutecalc.dem.report import failures, print_study
    from chutecalc.output.table import Printer

    if not data:
        print_study(Printer(), study)
        return
    for line in failures(study):
        print(line, file=sys.stderr)
