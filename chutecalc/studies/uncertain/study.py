"""Samples a chute whose numbers are uncertain, and works out what they say."""

from collections.abc import Callable, Iterable

import numpy as np

from chutecalc.api.cases import state_of
from chutecalc.api.chute import Chute
from chutecalc.api.tolerance import check_tolerance
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep.checks import DEFAULT_ON_BELT
from chutecalc.studies.sweep.columns import row_columns
from chutecalc.studies.uncertain.importance import indices, tornado
from chutecalc.studies.uncertain.quantiles import Joint
from chutecalc.studies.uncertain.result import Uncertainty
from chutecalc.studies.uncertain.sampling import REPLICATES, cubes, sample_count
from chutecalc.studies.uncertain.solved_rows import Rows, RowSolver
from chutecalc.studies.uncertain.statistics import FAILS, FAILURES, STATUSES, chance, summary
from chutecalc.workers import pool_of

SAMPLES = 16_384
"""Samples of a study by default."""
FOR_INDICES = 256
"""Samples of each replicate, at most, from which Sobol indices are estimated: each of them is solved keys + 2 times."""
AT_EXIT = ("exit_velocity_m_s", "exit_depth_m")
"""Columns by default, beside those of a receiving belt: what the end of the chute tells, in microseconds a sample."""


def uncertain(
    chute: Chute,
    samples: int = SAMPLES,
    seed: int = 1,
    columns: Iterable[str] = (),
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
        case: operating state of the spec, ``design`` for the spec as written.
        rtol: relative tolerance, as in :func:`chutecalc.solve`.
        jobs: number of threads; one for each core by default. Numbers do not depend on it.
        dask: address of a Dask scheduler whose workers solve the samples instead.
        show: is told how many designs are solved, and of how many.

    Returns:
        Samples as arrays, with means, quantiles, chances of failure, Sobol indices, and each key alone at its ends.

    Raises:
        SpecError: the table has faults.
        UsageError: there is no such table, case or column, or too few samples.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[uncertainty]\n"liners.ceramic.friction_deg" = 2')
    >>> found = chutecalc.uncertain(spoon, samples=1024)
    >>> found.summaries["exit_velocity_m_s"].quantiles.round(2).tolist(), found.chances["stall"].share
    ([3.44, 3.88, 4.29], 0.0)
    """
    check_tolerance(rtol)
    state = _state(chute, case)
    keys, names = state.uncertain, _columns(columns, chute)
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
    rows = solver(one.reshape(-1, len(keys.keys)), solved)
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
        chances={status: chance(rows.ends, status) for status in (STATUSES[0], FAILS, *FAILURES, STATUSES[-1])},
        indices=matters,
        no_indices=none,
        tornado=tornado(solver, keys, joint),
    )


def _state(chute: Chute, case: str) -> Chute:
    """Return the chute in one of its operating states."""
    if chute.count != 1:
        raise UsageError(f"uncertain takes a chute of one design, not {chute.count}: use the chute before vary")
    if not any(key != "correlation" for key in chute.spec.uncertainty):
        remedy = 'add [uncertainty] with keys such as "flow.rate_t_h" = 100, for plus/minus 100'
        raise UsageError(f"{chute.source} does not say what is uncertain: {remedy}")
    return state_of(chute, case)


def _columns(columns: Iterable[str], chute: Chute) -> list[str]:
    """Return the columns asked for, which are numbers, or those by default."""
    names = list(columns) or [*AT_EXIT, *(DEFAULT_ON_BELT if chute.spec.receiver else ())]
    known = row_columns()
    if text := [name for name in names if name.endswith(".status") or (name in known and not known[name].dimension)]:
        raise UsageError(f"{text[0]} is no number: use columns such as exit_velocity_m_s")
    return names


def _why_no_indices(count: int, independent: bool) -> str:
    """Return why keys have no Sobol indices, or empty text."""
    if count == 1:
        return "one key alone has all of the variance"
    return "" if independent else "keys are correlated, so that the variance has no shares that belong to one key"


def _first(rows: Rows, count: int) -> Rows:
    """Return the first samples of each replicate."""
    those = np.arange(len(rows.ends)).reshape(REPLICATES, -1)[:, :count].ravel()
    return Rows(rows.ends[those], {name: values[those] for name, values in rows.columns.items()})


def _by_path(values: Array, paths: tuple[str, ...]) -> dict[str, Array]:
    """Return the samples of each key."""
    return {path: np.ascontiguousarray(values[..., k]).ravel() for k, path in enumerate(paths)}
