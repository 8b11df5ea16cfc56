"""``chutecalc uncertain``: how sure the exit is, if numbers of the spec are uncertain."""

from __future__ import annotations

import typer

from chutecalc.cli.options import DASK, JOBS, LIBRARY, RTOL, names_of, with_groups
from chutecalc.cli.outputs import Outputs
from chutecalc.cli.specs import read_chute
from chutecalc.errors import ExitStatus

EXAMPLES = (
    "chutecalc uncertain chute.toml --plot uncertain.svg",
    "chutecalc uncertain chute.toml --margins --limit 'max_depth_m<=0.3' --warnings",
    "chutecalc uncertain chute.toml --samples 1000000 --case wet --csv samples.csv",
)
PAGE = "uncertainty.md"


class UncertainOutputs(Outputs):
    """Outputs of a study of uncertainty."""

    picture = "what each key does alone, and bands of velocity and depth along the chute"
    has_units = True


@with_groups
def uncertain(
    spec: str = typer.Argument(..., metavar="SPEC", help="A spec with a table [uncertainty]; - for standard input."),
    samples: int = typer.Option(16_384, metavar="N", help="Number of samples, rounded up to a power of two."),
    seed: int = typer.Option(1, min=0, metavar="S", help="Seed: the same one gives the same samples."),
    columns: str | None = typer.Option(
        None,
        metavar="NAMES",
        help="Columns, separated by commas, as those of a sweep. Default: those of the exit and the receiving belt."
        " min_ and max_ take ten times as long.",
    ),
    limits: list[str] = typer.Option(
        [],
        "--limit",
        metavar="LIMIT",
        help="Tell how likely it is exceeded, such as 'max_depth_m<=0.3'. Repeatable.",
    ),
    *,
    margins: bool = typer.Option(
        False, "--margins", help="Add how near it is to failing: least velocity, fill, normal acceleration, landings."
    ),
    warnings: bool = typer.Option(False, "--warnings", help="Tell the chance of each warning among the findings."),
    case: str | None = typer.Option(
        None, metavar="NAME", help="One operating state of [cases]; the spec as written by default."
    ),
    jobs: int | None = JOBS,
    dask: str | None = DASK,
    rtol: float = RTOL,
    library: str | None = LIBRARY,
    outputs: UncertainOutputs,
) -> int:
    """Report how sure the exit of a chute is, how likely it fails or exceeds a limit, and which numbers matter.

    The table [uncertainty] of the spec says how uncertain its numbers are. Data files have a row for each sample, JSON
    what they say.
    """
    outputs.check([spec, library])
    chute = read_chute(spec, library=library)
    from chutecalc.output.printer import Printer
    from chutecalc.output.progress import progress
    from chutecalc.spec.operating import DESIGN_POINT
    from chutecalc.studies.uncertain.document import uncertainty_dataset
    from chutecalc.studies.uncertain.report import print_uncertainty
    from chutecalc.studies.uncertain.study import uncertain as study

    with progress("designs") as show:
        result = study(
            chute,
            samples,
            seed,
            names_of(columns),
            limits,
            margins=margins,
            warnings=warnings,
            case=case or DESIGN_POINT,
            rtol=rtol,
            jobs=jobs,
            dask=dask,
            show=show,
        )
    if outputs.files:
        outputs.write(uncertainty_dataset(result))
    if outputs.plot:
        outputs.draw(result.plot(outputs.units))
    if not outputs.to_standard_output:
        print_uncertainty(Printer(outputs.units), result)
    return ExitStatus.OK
