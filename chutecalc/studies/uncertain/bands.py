"""Quantiles of the stream along a chute, for each way that samples take through it."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from chutecalc.api.solve import solve
from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.sampling import REPLICATES
from chutecalc.studies.uncertain.statistics import SHARES

SAMPLES = 1024
"""Samples of each replicate, at most, from which bands are made: all of a study of the usual size."""
BLOCK = 2048
"""Samples that are solved together, so that memory does not grow with all their stations."""
POINTS = 21
"""Stations of each segment."""
LEAST = 0.02
"""Share of the samples from which on a way has bands: fewer do not tell quantiles."""
ONWARDS = "to the exit"
"""Name of the flight from the last surface to the mouth of a closed section, of two stations."""
COLUMNS = ("velocity_m_s", "depth_m")
"""Columns that have bands."""


class Bands(NamedTuple):
    """Quantiles along a chute, at stations that are the same share of a segment in all samples of one way.

    Samples take different ways if some of them leave a surface that others follow, or land elsewhere.
    """

    segment: tuple[str, ...]
    """Name of the segment of each station."""
    way: tuple[int, ...]
    """Number of the way that it belongs to, from 0; the commonest comes first."""
    s_m: Array
    """Median distance from the inlet, m, shape (stations,)."""
    quantiles: Numbers
    """By column, those of :data:`SHARES`, shape (shares, stations); NaN where there is no such column."""
    shares: tuple[float, ...]
    """Share of the samples that take each way. Ways of less than 2 % have no bands."""
    samples: int
    """Number of samples."""


class _Way(NamedTuple):
    """Samples that visit the same segments and flights."""

    segment: list[str]
    s: Array
    """Median distance of each station, m."""
    quantiles: Numbers
    share: float


def bands(result: Outcome, points: int = POINTS) -> Bands:
    """Return quantiles of velocity and depth along a chute, over samples that do not fail.

    Args:
        result: the study.
        points: stations of each segment.
    """
    some = np.arange(result.count).reshape(REPLICATES, -1)[:, :SAMPLES].ravel()
    chosen = some[result.ok[some]]
    if not chosen.size:
        return Bands((), (), np.empty(0), {name: np.empty((len(SHARES), 0)) for name in COLUMNS}, (), 0)
    segment, table = _stations(result, chosen, points)
    ways = list(_ways(segment, table, points))
    return Bands(
        tuple(name for way in ways for name in way.segment),
        tuple(number for number, way in enumerate(ways) for _ in way.segment),
        np.concatenate([way.s for way in ways]),
        {name: np.concatenate([way.quantiles[name] for way in ways], axis=1) for name in COLUMNS},
        tuple(way.share for way in ways),
        len(chosen),
    )


def _stations(result: Outcome, chosen: Index, points: int) -> tuple[list[str], Numbers]:
    """Return the segment of each station, and columns of shape (samples, stations): the last one is the exit."""
    blocks: dict[str, list[Array]] = {name: [] for name in ("s_m", *COLUMNS)}
    segment: list[str] = []
    for first in range(0, len(chosen), BLOCK):
        own = chosen[first : first + BLOCK]
        solution = solve(result.chute.vary({path: values[own] for path, values in result.values.items()}), result.rtol)
        table = solution.stations(points, None, ["segment", *blocks])
        segment = np.broadcast_to(table["segment"], table["s_m"].shape)[0].tolist()
        for name, parts in blocks.items():
            parts.append(np.concatenate([table[name], solution.exit[name][:, None]], axis=1))
    return segment, {name: np.concatenate(parts) for name, parts in blocks.items()}


def _ways(segment: list[str], table: Numbers, points: int) -> Iterator[_Way]:
    """Yield the ways that samples take, the commonest first: at least one, and no rare ones."""
    known: Mask = np.isfinite(table["s_m"][:, :-1]).reshape(len(table["s_m"]), -1, points)
    visited = np.asarray(known.any(axis=2))
    parts, which, counts = np.unique(visited, axis=0, return_inverse=True, return_counts=True)
    for place, way in enumerate(np.argsort(-counts, kind="stable").tolist()):
        share = counts[way] / len(visited)
        if place and share < LEAST:
            return
        own: Mask = which.ravel() == way
        there = np.append(np.repeat(parts[way], points), True)
        s = np.median(table["s_m"][own][:, there], axis=0)
        names = [name for name, is_one in zip(segment, there, strict=False) if is_one]
        columns = {name: np.quantile(table[name][own][:, there], SHARES, axis=0) for name in COLUMNS}
        if s[-1] > s[-2] * (1.0 + 1e-9):  # beyond the last surface, to the mouth
            s, names = np.concatenate([s[:-1], s[-2:]]), [*names, ONWARDS, ONWARDS]
            columns = {name: np.concatenate([each[:, :-1], each[:, -2:]], axis=1) for name, each in columns.items()}
            columns["depth_m"][:, -2:] = np.nan
        else:
            s, columns = s[:-1], {name: each[:, :-1] for name, each in columns.items()}
        yield _Way(names, s, columns, float(share))
