"""What leaves each of many variants of a chute, without what lies between: the fast way through a large batch."""

import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from chutecalc.chute import Chute, check_tolerance
from chutecalc.columns import COLUMNS
from chutecalc.design import Design, select
from chutecalc.errors import SpecError, UsageError
from chutecalc.physics.arrays import Array, Index
from chutecalc.solution import Solution
from chutecalc.solver.chain import run_chain

CHUNK = 16384
"""Designs solved together: enough that NumPy's calls cost nothing, few enough for the cache and for an even share."""
USUAL = ("velocity_m_s", "depth_m", "slope_deg")
NOT_AT_EXIT = ("spec", "segment", "kind", "time_s")


class Exits:
    """The ends of n designs; arrays of shape (designs,), NaN in the numbers of those that fail."""

    def __init__(self, chunks: list[Solution], names: Iterable[str]) -> None:
        def joined(parts: list[Any]) -> Any:
            return np.concatenate(parts)

        self.codes: Index = joined([chunk.codes for chunk in chunks])
        """The :class:`~chutecalc.design.Status` of each design."""
        self.error_estimate: Array = joined([chunk.error_estimate for chunk in chunks])
        """Of the last velocity, relative; after a stall of its place, as a share of the segment."""
        exits = [chunk.exit_columns(names) for chunk in chunks]
        self.exit: dict[str, Array] = {name: joined([numbers[name] for numbers in exits]) for name in exits[0]}
        """The stream at the end of the chute, by column name."""
        belts = [chunk.receiver for chunk in chunks]
        self.receiver: dict[str, Array] = {name: joined([numbers[name] for numbers in belts]) for name in belts[0]}
        """What it does to the belt there, as :attr:`chutecalc.solution.Solution.receiver`."""


def exits(chute: Chute, rtol: float = 1e-10, columns: Iterable[str] = USUAL, jobs: int | None = None) -> Exits:
    """The stream at the end of each of many variants, and nothing else.

    A third of the time of :func:`chutecalc.solve` and a fraction of its memory; take a million designs a hundred
    thousand at a time. The last digits may differ from those of ``solve``, within the error allowed; they do not
    depend on the batch, its order, or ``jobs``.

    Args:
        chute: from :func:`chutecalc.load`, :func:`chutecalc.parse` or :meth:`Chute.vary`.
        rtol: as of :func:`chutecalc.solve`.
        columns: names of columns, without time, which takes the whole way.
        jobs: threads; as many as there are cores where that is not given.

    Raises:
        UsageError: ``rtol`` or ``jobs`` out of range, or a name that is no column's.
        SpecError: as :func:`chutecalc.solve`.

    >>> import chutecalc
    >>> variants = chutecalc.parse(chutecalc.STARTER).vary({"segments.spoon.radius_m": [2.0, 3.0]})
    >>> chutecalc.exits(variants).exit["velocity_m_s"].round(3)
    array([3.578, 3.878])
    """
    check_tolerance(rtol)
    names = list(columns)
    unknown = [name for name in names if name not in COLUMNS or name in NOT_AT_EXIT]
    if unknown:
        raise UsageError(f"there is no column {', '.join(unknown)} at an exit; chutecalc columns lists what there is")
    if jobs is not None and jobs < 1:
        raise UsageError(f"jobs has to be 1 or more, not {jobs}")
    edges = range(0, chute.count, CHUNK)

    def solved(first: int) -> Solution:
        count = min(CHUNK, chute.count - first)
        return _ends(select(chute.design, slice(first, first + count)), rtol, count)

    try:
        with ThreadPoolExecutor(min(jobs or os.cpu_count() or 1, len(edges))) as pool:
            return Exits(list(pool.map(solved, edges)), names)
    except SpecError as error:
        raise SpecError(error.faults, chute.source) from None


def _ends(design: Design, rtol: float, count: int) -> Solution:
    """A solution that knows the ends of segments alone."""
    legs, ends = run_chain(design, rtol, complete=False)
    return Solution(design, tuple(legs), ends, rtol, count)
