"""``chutecalc optimise``: the best values of some keys."""

from __future__ import annotations

import typer

from chutecalc.cli.options import JOBS, LIBRARY, names_of, with_groups
from chutecalc.cli.specs import read_chute
from chutecalc.cli.study import (
    ARGUMENTS,
    COLUMNS,
    TAKE,
    WRITE,
    StudyOutputs,
    check_writing,
    spec_and_keys,
    write_solution,
)
from chutecalc.errors import ExitStatus

EXAMPLES = (
    "chutecalc optimise chute.toml beta=20:85 --minimise max_depth_m",
    "chutecalc optimise chute.toml radius=1:4 segments.spoon.liner=ceramic,steel --maximise exit_velocity_m_s"
    " --subject 'max_depth_m<=0.3' --write",
)
PAGE = "aiming.md"


class OptimiseOutputs(StudyOutputs):
    """Outputs of an optimum."""

    picture = "the objective around the optimum, or the front"


@with_groups
def optimise(
    arguments: list[str] = ARGUMENTS,
    minimise: list[str] = typer.Option([], metavar="COLUMN", help="A column of a sweep that is to be small."),
    maximise: list[str] = typer.Option([], metavar="COLUMN", help="One that is to be large. Two in all make a front."),
    subject: list[str] = typer.Option(
        [], metavar="LIMIT", help="A limit in each state, such as 'max_depth_m<=0.3'. Repeatable."
    ),
    *,
    no_warnings: bool = typer.Option(False, "--no-warnings", help="Allow no warnings either."),
    case: str | None = typer.Option(
        None, metavar="NAME", help="The only operating state that counts. Default: the worst of all."
    ),
    points: int = typer.Option(9, min=2, metavar="N", help="Points of a front."),
    seed: int = typer.Option(0, min=0, metavar="N", help="Seed of what is random in the search."),
    columns: str | None = COLUMNS,
    write: bool = WRITE,
    take: int | None = TAKE,
    jobs: int | None = JOBS,
    library: str | None = LIBRARY,
    outputs: OptimiseOutputs,
) -> int:
    """Find the best values of keys, in the worst of all cases.

    What counts is the worst of the design point and of the spec's cases. A key is KEY=LOW:HIGH, or one of several
    values: KEY=LOW:HIGH:STEP, a list of numbers, of names, or true,false. No state may fail. Where no design within
    the bounds keeps all limits, the one that comes closest is shown with what it violates, and the exit status is 1.
    """
    from chutecalc.studies.found_report import found_dataset
    from chutecalc.studies.keys import read_keys
    from chutecalc.studies.limit import read_limit
    from chutecalc.studies.optimise.optimise import find_optimum, objectives_of
    from chutecalc.studies.optimise.report import print_optimum

    spec, given = spec_and_keys(arguments)
    wanted, limits = objectives_of(minimise, maximise), [read_limit(text) for text in subject]
    outputs.check([spec, library])
    check_writing(spec, write, take)
    chute = read_chute(spec, library=library)
    keys = read_keys(given, chute)
    found = find_optimum(chute, keys, wanted, limits, case, no_warnings, names_of(columns), points, seed, jobs)
    outputs.write(found_dataset("optimise", found))
    if outputs.plot:
        from chutecalc.studies.optimise.plot import draw_optimum

        outputs.draw(draw_optimum(found, outputs.units))
    if not outputs.to_standard_output:
        from chutecalc.output.printer import Printer

        print_optimum(Printer(outputs.units), found)
    write_solution(found, write and found.feasible, take, quiet=outputs.to_standard_output is not None)
    return ExitStatus.OK if found.feasible else ExitStatus.FAILS
