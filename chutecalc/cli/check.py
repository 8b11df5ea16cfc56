"""``chutecalc check``: compare standard designs with their baselines."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from chutecalc.cli.options import LIBRARY, RTOL, with_groups
from chutecalc.cli.outputs import Outputs
from chutecalc.errors import AllSpecsError, ExitStatus, SpecError
from chutecalc.output.files import open_whole
from chutecalc.output.targets import STANDARD_STREAM

if TYPE_CHECKING:
    from chutecalc.studies.regression.designs import Designs
    from chutecalc.studies.regression.verdict import Verdict

EXAMPLES = (
    "chutecalc check specs --junit check.xml",
    "chutecalc check specs/spoon.toml --update",
)
PAGE = "checks.md"


@with_groups
def check(
    paths: list[str] = typer.Argument(None, metavar="PATH...", help="Specs, or folders of them. Default: this folder."),
    update: bool = typer.Option(False, "--update", help="Write the baselines that are missing or no longer hold."),
    junit: str | None = typer.Option(
        None, metavar="FILE", help="Write the verdicts as JUnit XML, for CI; - for standard output."
    ),
    rtol: float = RTOL,
    library: str | None = LIBRARY,
    *,
    outputs: Outputs,
) -> int:
    """Compare standard designs with their baselines, number by number.

    The baseline of spoon.toml is spoon.baseline.toml beside it. Data files have a row for each number that drifted, and
    one for each design without drift, whose columns after tolerance are empty.
    """
    from chutecalc.output.printer import Printer
    from chutecalc.studies.regression.designs import find_designs
    from chutecalc.studies.regression.record import baseline_path
    from chutecalc.studies.regression.report import check_dataset, print_verdicts, write_junit
    from chutecalc.studies.regression.verdict import OK
    from chutecalc.studies.regression.write import hold_baselines, write_baseline

    designs = find_designs(paths or ["."], library)
    specs = [chute.source for chute in designs.chutes]
    outputs.check([*specs, library, *(str(baseline_path(Path(spec))) for spec in specs)], junit=junit)
    if update:
        hold_baselines(specs)
    verdicts = _verdicts(designs, rtol, update)
    written = [str(write_baseline(verdict.spec, verdict.document)) for verdict in verdicts if verdict.document]
    if junit:
        with open_whole(junit) as stream:
            write_junit(stream, verdicts)
    outputs.write(check_dataset(verdicts, rtol))
    if junit != STANDARD_STREAM and not outputs.to_standard_output:
        print_verdicts(Printer(), verdicts, written)
    passed = all(verdict.outcome == OK or verdict.document for verdict in verdicts)
    return ExitStatus.OK if passed else ExitStatus.FAILS


def _verdicts(designs: Designs, rtol: float, update: bool) -> list[Verdict]:
    """Return the verdicts on all designs, and on baselines without a spec.

    Raises:
        AllSpecsError: specs that cannot be solved.
    """
    from chutecalc.output.progress import with_progress
    from chutecalc.studies.regression.check import check as check_designs
    from chutecalc.studies.regression.verdict import without_spec

    checked = check_designs(designs.chutes, rtol, update)
    found = list(with_progress(checked, len(designs.chutes), "designs"))
    if errors := [item for item in found if isinstance(item, SpecError)]:
        raise AllSpecsError(errors)
    return [item for item in found if not isinstance(item, SpecError)] + [
        without_spec(path) for path in designs.orphaned
    ]
