"""Quantiles of the stream along a chute, over some of the samples."""

from typing import NamedTuple

import numpy as np

from chutecalc.api.solve import solve
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.sampling import REPLICATES
from chutecalc.studies.uncertain.statistics import SHARES

SAMPLES = 32
"""Samples of each replicate from which bands are made: 512, whose quantiles at 5 and 95 % are some per cent off."""
POINTS = 41
"""Stations of each segment."""
COLUMNS = ("velocity_m_s", "depth_m")
"""Columns that have bands."""


class Bands(NamedTuple):
    """Quantiles along a chute, at stations that are the same share of a segment in all samples."""

    segment: tuple[str, ...]
    """Name of the segment of each station."""
    s_m: Array
    """Median distance from the inlet, m, shape (stations,)."""
    quantiles: Numbers
    """By column, those of :data:`SHARES`, shape (shares, stations); NaN where there is no such column."""
    samples: int
    """Number of samples."""


def bands(result: Outcome, points: int = POINTS) -> Bands:
    """Return quantiles of velocity and depth along a chute, over samples that do not fail.

    Args:
        result: the study.
        points: stations of each segment.
    """
    some = np.arange(result.count).reshape(REPLICATES, -1)[:, :SAMPLES].ravel()
    chosen = some[result.ok[some]]
    if not chosen.size:
        return Bands((), np.empty(0), {name: np.empty((len(SHARES), 0)) for name in COLUMNS}, 0)
    varied = result.chute.vary({path: values[chosen] for path, values in result.values.items()})
    table = solve(varied, result.rtol).stations(points, None, ["segment", "s_m", *COLUMNS])
    known = np.isfinite(table["s_m"]).any(axis=0)
    return Bands(
        tuple(np.broadcast_to(table["segment"], (len(chosen), len(known)))[0, known].tolist()),
        np.nanmedian(table["s_m"][:, known], axis=0),
        {name: _quantiles(table[name][:, known]) for name in COLUMNS},
        len(chosen),
    )


def _quantiles(values: Array) -> Array:
    """Return the quantiles of each station that has any value."""
    found = np.full((len(SHARES), values.shape[1]), np.nan)
    there = np.isfinite(values).any(axis=0)
    found[:, there] = np.nanquantile(values[:, there], SHARES, axis=0)
    return found
