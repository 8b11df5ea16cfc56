"""Samples a chute whose numbers are uncertain, and works out what they say."""

from collections.abc import Callable, Iterable

import numpy as np

from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.tolerance import check_tolerance
from chutecalc.physics.arrays import Array
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.limit import read_limit
from chutecalc.studies.uncertain.beyond import exceeded, warned
from chutecalc.studies.uncertain.importance import indices, tornado
from chutecalc.studies.uncertain.quantiles import Joint
from chutecalc.studies.uncertain.result import Uncertainty
from chutecalc.studies.uncertain.sampling import REPLICATES, cubes, sample_count
from chutecalc.studies.uncertain.solved_rows import WARNINGS, Rows, RowSolver
from chutecalc.studies.uncertain.state import state_and_keys
from chutecalc.studies.uncertain.statistics import FAILS, FAILURES, STATUSES, chance_to_end, summary
from chutecalc.studies.uncertain.wanted import wanted_columns
from chutecalc.workers import pool_of

SAMPLES = 16_384
"""Samples of a study by default."""
FOR_INDICES = 256
"""Samples of each replicate, at most, from which Sobol indices are estimated: each of them is solved keys + 2 times."""


def uncertain(
    chute: Chute,
    samples: int = SAMPLES,
    seed: int = 1,
    columns: Iterable[str] = (),
    limits: Iterable[str] = (),
    margins: bool = False,
    warnings: bool = False,
    case: str = DESIGN_POINT,
    rtol: float = 1e-10,
    jobs: int | None = None,
    dask: str | None = None,
    show: Callable[[int, int], None] = lambda done, total: None,
) -> Uncertainty:
    r"""Return how sure the exit of a chute is, if the numbers in ``[uncertainty]`` of its spec are as uncertain.

    Args:
        chute: of one design, with a table ``[uncertainty]``.
        samples: number of samples, rounded up to a power of two.
        seed: of the scrambled Sobol points; the same seed gives the same samples.
        columns: names of columns, as those of a sweep; by default those of the exit and of a receiving belt.
        limits: ``COLUMN<=VALUE`` or ``COLUMN>=VALUE``, of which the chance that each is exceeded is told.
        margins: whether to add the columns that tell how near the chute is to each failure: least velocity, fill, least
            normal acceleration, and how far from the end of a segment the stream lands.
        warnings: whether to tell the chance of each warning among the findings.
        case: operating state of the spec, ``design`` for the spec as written.
        rtol: relative tolerance, as in :func:`chutecalc.solve`.
        jobs: number of threads; one for each core by default. Numbers do not depend on it.
        dask: address of a Dask scheduler whose workers solve the samples instead.
        show: is told how many designs are solved, and of how many.

    Returns:
        Samples as arrays, with means, quantiles, chances of failure and of limits that are exceeded, Sobol indices, and
        each key alone at its ends.

    Raises:
        SpecError: the table has faults.
        UsageError: there is no such table, case or column, too few samples, or no sample has the column of a limit.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"liners.ceramic.friction_deg" = 2')
    >>> found = chutecalc.uncertain(spoon, samples=1024)
    >>> found.summaries["exit_velocity_m_s"].quantiles.round(2).tolist(), found.chances["stall"].share
    ([6.03, 6.22, 6.41], 0.0)
    """
    check_chute(chute)
    check_tolerance(rtol)
    state, keys = state_and_keys(chute, case)
    bounds = [read_limit(text) for text in limits]
    names = wanted_columns(state, columns, margins, bounds)
    count = sample_count(samples) // REPLICATES
    alone = _why_no_indices(len(keys.keys), keys.are_independent)
    few = 0 if alone else min(count, FOR_INDICES)
    total = REPLICATES * (count + few * (len(keys.keys) + 1))
    done = 0

    def solved(rows: int) -> None:
        nonlocal done
        done += rows
        show(done, total)

    solver = RowSolver(state, keys, names, rtol, pool_of(jobs, dask))
    joint = Joint(keys)
    one, other = np.empty((REPLICATES, count, len(keys.keys))), np.empty((REPLICATES, few, len(keys.keys)))
    for replicate, cube in enumerate(cubes(2 * len(keys.keys), count, seed)):
        one[replicate] = joint(cube[:, : len(keys.keys)])
        other[replicate] = joint(cube[:few, len(keys.keys) :])
    told = RowSolver(state, keys, [*names, WARNINGS], rtol, pool_of(jobs, dask)) if warnings else solver
    rows = told(one.reshape(-1, len(keys.keys)), solved)
    matters, none = ({}, alone) if alone else indices(solver, one[:, :few], other, _first(rows, few), solved)
    return Uncertainty(
        chute=state,
        case=case,
        keys=keys,
        seed=seed,
        rtol=rtol,
        values=_by_path(one, keys.paths),
        ends=rows.ends,
        columns=rows.columns,
        summaries={name: summary(values) for name, values in rows.columns.items()},
        chances={status: chance_to_end(rows.ends, status) for status in (STATUSES[0], FAILS, *FAILURES, STATUSES[-1])},
        exceeded=exceeded(rows, bounds, state.source),
        warned=warned(rows) if warnings else None,
        indices=matters,
        no_indices=none,
        tornado=tornado(solver, keys, joint),
    )


def _why_no_indices(count: int, independent: bool) -> str:
    """Return why keys have no Sobol indices, or empty text."""
    if count == 1:
        return "one key alone explains all of it"
    return "" if independent else "keys that are correlated have none of their own"


def _first(rows: Rows, count: int) -> Rows:
    """Return the first samples of each replicate."""
    those = np.arange(len(rows.ends)).reshape(REPLICATES, -1)[:, :count].ravel()
    return Rows(rows.ends[those], {name: values[those] for name, values in rows.columns.items()}, {})


def _by_path(values: Array, paths: tuple[str, ...]) -> dict[str, Array]:
    """Return the samples of each key."""
    return {path: np.ascontiguousarray(values[..., k]).ravel() for k, path in enumerate(paths)}
