"""What leaves each of many variants of a chute, without what lies between: the fast way through a large batch."""

from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from chutecalc.api.chute import Chute, check_tolerance
from chutecalc.design import select
from chutecalc.errors import SpecError, UsageError
from chutecalc.results.columns import COLUMNS
from chutecalc.results.exits import NOT_AT_EXIT, Exits, at_ends
from chutecalc.runtime import cores

CHUNK = 16384
"""Designs solved together: enough that NumPy's calls cost nothing, few enough for the cache and for an even share."""
USUAL = ("velocity_m_s", "depth_m", "slope_deg")


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
    names = [columns] if isinstance(columns, str) else list(columns)
    unknown = [name for name in names if name not in COLUMNS or name in NOT_AT_EXIT]
    if unknown:
        which = ", ".join(unknown)
        raise UsageError(
            f"there is no column {which} at an exit; chutecalc columns lists what there is, and time takes a solution"
        )
    if jobs is not None and jobs < 1:
        raise UsageError(f"jobs has to be 1 or more, not {jobs}")
    edges = range(0, chute.count, CHUNK)

    def solved(first: int) -> Exits:
        count = min(CHUNK, chute.count - first)
        design = select(chute.design, slice(first, first + count)) if len(edges) > 1 else chute.design
        return at_ends(design, rtol, names, count)

    try:
        if len(edges) == 1:
            chunks = [solved(0)]
        else:
            with ThreadPoolExecutor(min(jobs or cores(), len(edges))) as pool:
                chunks = list(pool.map(solved, edges))
    except SpecError as error:
        raise SpecError(error.faults, chute.source, error.designs if len(edges) == 1 else None) from None
    return chunks[0] if len(chunks) == 1 else _joined(chunks)


def _joined(chunks: list[Exits]) -> Exits:
    """One after the other."""
    codes, errors, found, belts = zip(*chunks, strict=True)
    numbers = ({name: np.concatenate([part[name] for part in parts]) for name in parts[0]} for parts in (found, belts))
    return Exits(np.concatenate(codes), np.concatenate(errors), *numbers)
