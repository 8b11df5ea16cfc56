"""With ``CHUTECALC_NO_SKIPS=1`` a skip is a failure, unless the platform is its reason: CI is not to skip unnoticed."""

import os

import pytest

NO_SKIPS = "CHUTECALC_NO_SKIPS"
EXPECTED = (
    "the slow solver needs 80-bit numbers",
    "the program in place of LAMMPS is a script",
    "signals are others there",
    "programs are elsewhere in a venv there",
    "no device that is always full on this system",
    "no file can have such a name here",
    "there are no named pipes",
    "no affinity on this system",
    "mutants run in forked processes",
)
"""How the reasons begin that are fine everywhere: what a platform does not have."""


def judge(report: pytest.TestReport | pytest.CollectReport) -> None:
    """Turn a skip without an accepted reason into a failure."""
    if os.environ.get(NO_SKIPS, "0") in {"", "0"} or report.outcome != "skipped" or hasattr(report, "wasxfail"):
        return
    reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    reason = reason.removeprefix("Skipped: ")
    if not reason.startswith(EXPECTED):
        report.outcome = "failed"
        report.longrepr = f"{report.nodeid}\nskipped, and {NO_SKIPS} is set: {reason}"
