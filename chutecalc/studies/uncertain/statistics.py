"""What samples say: means, quantiles and chances, each with the error that comes from their number."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from chutecalc.design import Status
from chutecalc.physics.arrays import Array
from chutecalc.studies.uncertain.sampling import REPLICATES, error_of

SHARES = (0.05, 0.5, 0.95)
"""Shares of all samples below the quantiles that are reported."""
STATUSES = (*Status.LABELS, Status.IMPOSSIBLE_LABEL)
"""How a sample may end, by number."""
Ends = NDArray[np.int8]
"""How samples end, by those numbers."""
FAILURES = tuple(STATUSES[code] for code in (Status.STALL, Status.CHOKE, Status.CONTACT_LOST, Status.MISSED))
"""How a chute may fail."""
FAILS = "fails"
"""Name of all outcomes but ok together."""
RULE_OF_THREE = 3.0
"""Of N samples none fails with a probability of 5 % if 3 in N fail: ln 0.05 = -3.0."""


class Summary(NamedTuple):
    """A column over all samples that do not fail, in the unit of the column."""

    mean: float
    error: float
    """Standard error of the mean."""
    deviation: float
    """Standard deviation."""
    quantiles: Array
    """Values below which the shares :data:`SHARES` of the samples lie."""
    quantile_errors: Array
    """Standard errors of those."""


class Chance(NamedTuple):
    """The chance of an outcome."""

    share: float
    """Of all samples."""
    error: float
    """Its standard error."""
    at_most: float
    """Limit that the chance keeps with 95 % confidence: share + 2 errors; 3 in N where no sample ends so."""


def summary(values: Array) -> Summary:
    """Return what samples say of a column.

    Args:
        values: of all samples in the unit of the column, one replicate after the other; NaN where a sample fails.

    >>> found = summary(np.arange(256.0))
    >>> found.mean, found.quantiles.tolist()
    (127.5, [12.75, 127.5, 242.25])
    """
    known = values[np.isfinite(values)]
    if not known.size:
        nothing = np.full(len(SHARES), np.nan)
        return Summary(np.nan, np.nan, np.nan, nothing, nothing)
    replicates = [own[np.isfinite(own)] for own in values.reshape(REPLICATES, -1)]
    means = np.array([own.mean() if own.size else np.nan for own in replicates])
    quantiles = np.array([np.quantile(own, SHARES) if own.size else np.full(len(SHARES), np.nan) for own in replicates])
    return Summary(
        float(known.mean()),
        float(error_of(means)),
        float(known.std(ddof=1)) if known.size > 1 else 0.0,
        np.quantile(known, SHARES),
        error_of(quantiles),
    )


def chance(ends: Ends, status: str) -> Chance:
    """Return the chance of an outcome.

    Args:
        ends: number of each sample's status in :data:`STATUSES`, one replicate after the other.
        status: name of the outcome, or ``fails`` for all but ok.

    >>> chance(np.zeros(1024, dtype=np.int8), "stall").at_most
    0.0029296875
    """
    those = ends != Status.OK if status == FAILS else ends == STATUSES.index(status)
    share = float(those.mean())
    error = float(error_of(those.reshape(REPLICATES, -1).mean(axis=1)))
    return Chance(share, error, min(share + 2.0 * error, 1.0) if share else RULE_OF_THREE / len(ends))
