"""What is to be best, and what counts as a limit beside those of columns."""

from typing import NamedTuple

NO_FAILURE, NO_WARNINGS = "no failure", "no warnings"
"""Names of the limits that are of no column."""


class Objective(NamedTuple):
    """A column that is to be small or large."""

    column: str
    sign: float
    """1 where it is minimised, -1 where it is maximised."""
