"""The report of ``chutecalc run``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from chutecalc.api.chute import Chute
    from chutecalc.cli.run_studies import RunStudies
    from chutecalc.results.cases import Cases


def report_run(
    file: str,
    chutes: Sequence[Chute],
    cases: Sequence[Cases],
    settings: Sequence[str],
    studies: RunStudies,
    units: str,
) -> None:
    """Write the report of a run.

    Args:
        file: its path.
        chutes: of one design each.
        cases: the same, solved in all their states.
        settings: keys changed for this run, ``PATH=VALUE``.
        studies: of the run, for the band.
        units: ``metric`` or ``us``.
    """
    from hashlib import sha256

    from chutecalc.output.html_report.reported import Reported
    from chutecalc.output.html_report.write import write_report

    reported = [
        Reported(states, sha256(chute.text.encode()).hexdigest(), tuple(settings), studies.band(number))
        for number, (chute, states) in enumerate(zip(chutes, cases, strict=True))
    ]
    write_report(file, reported, units)
