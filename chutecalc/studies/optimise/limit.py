"""What is to be best, and the limits that it has to keep."""

import re
from typing import NamedTuple

import numpy as np

from chutecalc.errors import UsageError

SUBJECT = re.compile(r"\s*([\w.]+)\s*(<=|>=)\s*(\S+)\s*")
NO_FAILURE, NO_WARNINGS = "no failure", "no warnings"
"""Names of the limits that are of no column."""


class Objective(NamedTuple):
    """A column that is to be small or large."""

    column: str
    sign: float
    """1 where it is minimised, -1 where it is maximised."""


class Limit(NamedTuple):
    """A limit of a column."""

    column: str
    sign: float
    """1 for an upper limit, -1 for a lower one."""
    value: float

    @property
    def text(self) -> str:
        """The limit as it is written."""
        return f"{self.column}{'<=' if self.sign > 0 else '>='}{self.value:.12g}"

    @property
    def scale(self) -> float:
        """What violations are a share of."""
        return abs(self.value) or 1.0


def read_limit(text: str) -> Limit:
    """Return the limit that a text states.

    Args:
        text: ``COLUMN<=VALUE`` or ``COLUMN>=VALUE``, in the unit of the column.

    Raises:
        UsageError: it is written otherwise.

    >>> read_limit("max_depth_m <= 0.3")
    Limit(column='max_depth_m', sign=1.0, value=0.3)
    """
    found = SUBJECT.fullmatch(text)
    try:
        value = float(found[3]) if found else np.nan
    except ValueError:
        value = np.nan
    if found is None or not np.isfinite(value):
        raise UsageError(f"a limit is COLUMN<=VALUE or COLUMN>=VALUE, such as 'max_depth_m<=0.3', not {text!r}")
    return Limit(found[1], 1.0 if found[2] == "<=" else -1.0, value)
