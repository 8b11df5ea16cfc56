"""``chutecalc check``: whether standard designs still come out as they did."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from chutecalc.errors import AllSpecsError, ExitStatus, SpecError

if TYPE_CHECKING:
    from chutecalc.studies.regression.designs import Designs
    from chutecalc.studies.regression.regression import Verdict


def check(
    paths: list[str] = typer.Argument(None, metavar="PATH", help="Specs, or folders of them; none: this folder."),
    update: bool = typer.Option(False, "--update", help="Write the baselines that are missing or no longer hold."),
    junit: str | None = typer.Option(None, metavar="FILE", help="Write the verdicts as JUnit XML, for CI systems."),
    json: str | None = typer.Option(
        None, metavar="FILE", help="Write them with all that drifted; - for standard output."
    ),
    rtol: float = typer.Option(1e-10, help="Relative error allowed to the velocity, 1e-13 to 1e-3."),
    debug: bool = typer.Option(False, "--debug", help="Show where the program itself fails."),
) -> int:
    """Solve standard designs and compare them with their baselines, number by number.

    The baseline of spoon.toml is spoon.baseline.toml beside it. Ends with status 0 where all is as it was, 1 where
    anything is not or a design has no baseline, 2 where a spec or the command is wrong.
    """
    from chutecalc.output.files import check_targets, open_whole
    from chutecalc.output.table import Printer
    from chutecalc.studies.regression.baseline import baseline_path
    from chutecalc.studies.regression.designs import find_designs
    from chutecalc.studies.regression.regression import OK
    from chutecalc.studies.regression.report import check_document, print_verdicts, write_check, write_junit
    from chutecalc.studies.regression.write import write_baseline

    designs = find_designs(paths or ["."])
    specs = [chute.source for chute in designs.chutes]
    check_targets([junit, json], [*specs, *(str(baseline_path(Path(spec))) for spec in specs)])
    with ExitStack() as outputs:
        junit_stream = outputs.enter_context(open_whole(junit))
        json_stream = outputs.enter_context(open_whole(json))
        verdicts = _verdicts(designs, rtol, update)
        written = [str(write_baseline(item.spec, item.document)) for item in verdicts if item.document]
        if junit_stream:
            write_junit(junit_stream, verdicts)
        if json_stream:
            write_check(json_stream, check_document(verdicts, rtol))
    if "-" not in (junit, json):
        print_verdicts(Printer(), verdicts, written)
    well = all(item.outcome == OK or item.document for item in verdicts)
    return ExitStatus.OK if well else ExitStatus.FAILS


def _verdicts(designs: Designs, rtol: float, update: bool) -> list[Verdict]:
    """The verdicts on all designs, and on the baselines that have none."""
    from chutecalc.output.progress import with_progress
    from chutecalc.studies.regression.regression import check as judged
    from chutecalc.studies.regression.regression import without_spec

    found = list(with_progress(judged(designs.chutes, rtol, update), len(designs.chutes), "designs"))
    if errors := [item for item in found if isinstance(item, SpecError)]:
        raise AllSpecsError(errors)
    return [item for item in found if not isinstance(item, SpecError)] + [
        without_spec(path) for path in designs.orphaned
    ]
