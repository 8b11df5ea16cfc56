"""``chutecalc aim``: which values of some keys give what is wanted."""

from __future__ import annotations

from collections.abc import Sequence

import typer

from chutecalc.cli.options import JOBS, LIBRARY, names_of, with_groups
from chutecalc.cli.specs import read_chute
from chutecalc.cli.study import (
    ARGUMENTS,
    CASE,
    COLUMNS,
    TAKE,
    WRITE,
    StudyOutputs,
    check_writing,
    number_of,
    spec_and_keys,
    write_solution,
)
from chutecalc.errors import ExitStatus, UsageError

EXAMPLES = (
    "chutecalc aim chute.toml radius=1:4 --target exit_velocity_m_s=3.7",
    "chutecalc aim chute.toml segments.hood.radius_m=1:3 segments.hood.to_slope_deg=60:85"
    " --target exit_velocity_m_s=6 --target segments.spoon.impact_incidence_deg=10 --write",
)
PAGE = "aiming.md"


@with_groups
def aim(
    arguments: list[str] = ARGUMENTS,
    targets: list[str] = typer.Option(
        [], "--target", metavar="COLUMN=VALUE", help="What is wanted: a column of a sweep. One for each key."
    ),
    *,
    case: str | None = CASE,
    columns: str | None = COLUMNS,
    write: bool = WRITE,
    take: int | None = TAKE,
    jobs: int | None = JOBS,
    library: str | None = LIBRARY,
    outputs: StudyOutputs,
) -> int:
    """Find the values of keys that give what is wanted.

    All solutions within the bounds are found. There must be as many keys as targets. Each solution meets its targets
    to 1e-9. Without any, the design that comes closest is shown, and the exit status is 1.
    """
    from chutecalc.spec.operating import DESIGN_POINT
    from chutecalc.studies.aim.aim import find_aim
    from chutecalc.studies.aim.report import print_aim
    from chutecalc.studies.found_report import found_dataset
    from chutecalc.studies.keys import read_keys

    spec, given = spec_and_keys(arguments)
    wanted = read_targets(targets)
    outputs.check([spec, library])
    check_writing(spec, write, take)
    chute = read_chute(spec, library=library)
    found = find_aim(chute, read_keys(given, chute), wanted, case or DESIGN_POINT, names_of(columns), jobs)
    outputs.write(found_dataset("aim", found))
    if not outputs.to_standard_output:
        from chutecalc.output.printer import Printer

        print_aim(Printer(outputs.units), found)
    write_solution(found, write, take, quiet=outputs.to_standard_output is not None)
    return ExitStatus.OK if found.count else ExitStatus.FAILS


def read_targets(texts: Sequence[str]) -> dict[str, float]:
    """Return the values of targets by the names of their columns.

    Args:
        texts: ``COLUMN=VALUE`` each.

    Raises:
        UsageError: one is not written so, or a column is given twice.

    >>> read_targets(["exit_velocity_m_s=4"])
    {'exit_velocity_m_s': 4.0}
    """
    found: dict[str, float] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals):
            raise UsageError(f"--target takes COLUMN=VALUE, such as exit_velocity_m_s=4, not {text!r}")
        if name in found:
            raise UsageError(f"--target {name} is given twice. Keep one of them.")
        found[name] = number_of("--target", text, value)
    return found
