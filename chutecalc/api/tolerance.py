"""The tolerances that the solver takes."""

import numpy as np

from chutecalc.errors import UsageError

TOLERANCES = (1e-13, 1e-3)
"""Least and greatest relative error allowed to the velocity."""


def check_tolerance(rtol: float) -> None:
    """Check that the solver takes a tolerance.

    Args:
        rtol: relative error allowed to the velocity, dimensionless.

    Raises:
        UsageError: it is out of range.
    """
    low, high = TOLERANCES
    if not isinstance(rtol, int | float | np.number) or not low <= rtol <= high:
        raise UsageError(f"rtol must be from {low:g} to {high:g}, not {rtol!r}")
