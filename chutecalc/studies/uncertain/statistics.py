"""What samples say: means, quantiles and chances, each with the error that comes from their number."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Mask
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
    """Of the samples that count; NaN where none does."""
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
    scale = 0.5 * 2.0 ** float(np.frexp(np.abs(known).max())[1])  # a power of two, so that no square overflows
    known = known / scale
    replicates = [own[np.isfinite(own)] for own in values.reshape(REPLICATES, -1) / scale]
    means = np.array([own.mean() if own.size else np.nan for own in replicates])
    quantiles = np.array([np.quantile(own, SHARES) if own.size else np.full(len(SHARES), np.nan) for own in replicates])
    return Summary(
        float(known.mean()) * scale,
        float(error_of(means)) * scale,
        float(known.std(ddof=1)) * scale if known.size > 1 else 0.0,
        np.quantile(known, SHARES) * scale,
        error_of(quantiles) * scale,
    )


def chance(those: Mask, among: Mask) -> Chance:
    """Return the chance that a sample is one of some.

    Args:
        those: the samples, one replicate after the other.
        among: the samples that count.

    >>> half = np.arange(1024) % 2 == 0
    >>> chance(np.arange(1024) % 4 == 0, half), chance(~half, half).at_most
    (Chance(share=0.5, error=0.0, at_most=0.5), 0.005859375)
    """
    count = int(among.sum())
    if not count:
        return Chance(np.nan, np.nan, 1.0)
    found, counted = ((each & among).reshape(REPLICATES, -1).sum(axis=1) for each in (those, among))
    share = float(found.sum() / count)
    error = float(error_of(np.where(counted > 0, found / np.maximum(counted, 1), np.nan)))
    return Chance(share, error, min(share + 2.0 * error if share else RULE_OF_THREE / count, 1.0))


def chance_to_end(ends: Ends, status: str) -> Chance:
    """Return the chance of an outcome.

    Args:
        ends: number of each sample's status in :data:`STATUSES`, one replicate after the other.
        status: name of the outcome, or ``fails`` for all but ok.

    >>> chance_to_end(np.zeros(1024, dtype=np.int8), "stall").at_most
    0.0029296875
    """
    those = ends != Status.OK if status == FAILS else ends == STATUSES.index(status)
    return chance(those, np.ones(len(ends), dtype=bool))
