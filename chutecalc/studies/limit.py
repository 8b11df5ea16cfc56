"""A limit of a column, as commands take it."""

import re
from typing import NamedTuple

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array, Mask

SUBJECT = re.compile(r"\s*([\w.]+)\s*(<=|>=)\s*(\S+)\s*")


class Limit(NamedTuple):
    """A limit of a column.

    Where the column has no value, the limit is kept: what there is not, such as the angle of an impact where the stream
    meets a segment along its slope, cannot be too much. An infinite value is compared as any other.
    """

    column: str
    sign: float
    """1 for an upper limit, -1 for a lower one."""
    value: float

    @property
    def text(self) -> str:
        """The limit as it is written."""
        return f"{self.column}{'<=' if self.sign > 0 else '>='}{self.value:.12g}"

    def is_exceeded(self, values: Array) -> Mask:
        """Return where values are beyond it; nowhere where there is none.

        Args:
            values: of the column, in its unit, of any shape.

        >>> read_limit("max_depth_m<=0.3").is_exceeded(np.array([0.2, 0.4, np.nan])).tolist()
        [False, True, False]
        """
        beyond: Mask = self.margin(values) < 0.0
        return beyond

    def margin(self, values: Array) -> Array:
        """Return how far values are within it, in the unit of the column: negative beyond it.

        Args:
            values: of the column, in its unit, of any shape.
        """
        return self.sign * (self.value - values)

    @property
    def scale(self) -> float:
        """What violations are a share of."""
        return abs(self.value) or 1.0


def check_column(source: str, column: str, exists: Mask, remedy: str) -> None:
    """Check that a column has a value in any of the designs that do not fail.

    Args:
        source: name of the spec.
        column: name of the column.
        exists: where there is a value, over designs that do not fail, shape (designs,).
        remedy: what to do where there is none.

    Raises:
        UsageError: there are designs, and none has a value.
    """
    if exists.size and not exists.any():
        raise UsageError(f"{source} has no {column} in any design that was tried: {remedy}")


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
