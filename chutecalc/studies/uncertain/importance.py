"""Which uncertain keys matter: Sobol indices, and each key alone at its ends."""

from typing import NamedTuple

import numpy as np
from scipy.stats import sobol_indices

from chutecalc.api.uncertain_keys import UncertainKeys
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.studies.uncertain.quantiles import Joint
from chutecalc.studies.uncertain.sampling import REPLICATES, error_of
from chutecalc.studies.uncertain.solved_rows import Rows, RowSolver, Show
from chutecalc.studies.uncertain.statistics import FAILS, Ends

ENDS = (0.05, 0.95)
"""Quantiles at which each key stands alone."""
FEWEST_FAILURES = 20
"""Failing samples below which nothing is said of what makes them fail."""
SAME = 1e-8
"""Share of a column by which it varies at least: the error of the solver is 1e-10, unless another one is asked for."""


class Indices(NamedTuple):
    """Sobol indices of the keys: shares of the variance of a column, or of failure as 0 or 1."""

    first: Array
    """First order: what a key explains alone, shape (keys,)."""
    first_error: Array
    """Standard errors."""
    total: Array
    """Total order: what would be left if all other keys were known."""
    total_error: Array
    """Standard errors."""


class Tornado(NamedTuple):
    """Each key alone at its 5 % and its 95 % quantile, all others as the spec has them."""

    values: Array
    """Values of the keys there, shape (keys, 2)."""
    ends: Ends
    """How the chute ends there, as :data:`~chutecalc.studies.uncertain.statistics.STATUSES`, shape (keys, 2)."""
    columns: Numbers
    """Columns there by name, shape (keys, 2): NaN where the chute fails."""
    spec: dict[str, float]
    """Columns of the spec as written."""

    def order(self, name: str) -> list[int]:
        """Return the numbers of the keys, the one that changes a column most first, and before it those that fail.

        Args:
            name: of the column.
        """
        with np.errstate(invalid="ignore"):  # between two infinite ends
            width = np.abs(np.diff(self.columns[name], axis=1)[:, 0])
        return [int(k) for k in np.argsort(-np.where(np.isnan(width), np.inf, width), kind="stable")]


def tornado(solver: RowSolver, keys: UncertainKeys, joint: Joint) -> Tornado:
    """Solve the chute with each key alone at its ends.

    Args:
        solver: of rows.
        keys: what is uncertain.
        joint: their distributions.
    """
    ends = np.array([own(ENDS) for own in joint.quantiles])
    count = len(keys.keys)
    rows = np.tile([key.parameter.value_in_unit for key in keys.keys], (2 * count + 1, 1))
    for k in range(count):
        rows[[2 * k + 1, 2 * k + 2], k] = ends[k]
    solved = solver(rows)
    columns = {name: values[1:].reshape(count, 2) for name, values in solved.columns.items()}
    spec = {name: float(values[0]) for name, values in solved.columns.items()}
    return Tornado(ends, solved.ends[1:].reshape(count, 2), columns, spec)


def indices(solver: RowSolver, one: Array, other: Array, solved: Rows, show: Show) -> tuple[dict[str, Indices], str]:
    """Return the Sobol indices of each column, or of failure where any sample fails, and why there are none.

    Saltelli's estimators as SciPy has them, from all replicates together; the errors from each for itself.

    Args:
        solver: of rows.
        one: values of the keys in their units, shape (replicates, samples, keys).
        other: as many in their units, independent of those.
        solved: rows of ``one``.
        show: is told of rows that were solved.
    """
    count = one.shape[-1]
    mixed = np.stack([one] * count)
    for k in range(count):
        mixed[k, ..., k] = other[..., k]
    rest = solver(np.concatenate([other[None], mixed]).reshape(-1, count), show)
    ends = np.concatenate([solved.ends, rest.ends])
    fails = int(np.count_nonzero(ends))
    columns = {name: np.concatenate([solved.columns[name], rest.columns[name]]) for name in solver.columns}
    if 0 < fails < FEWEST_FAILURES:
        return {}, f"{fails} of {len(ends):,} samples for them fail, which is too few to tell what makes them fail"
    if fails:
        columns = {FAILS: (ends > 0).astype(float)}
    shape = (2 + count, REPLICATES, -1)
    found = {name: _of(values.reshape(shape)) for name, values in columns.items() if _varies(values)}
    return found, "" if found else "no column exists in all samples and varies"


def _varies(values: Array) -> bool:
    """Return whether a column exists in all samples and has a variance that is more than rounding."""
    return bool(np.isfinite(values).all() and np.ptp(values) > SAME * np.abs(values).max())


def _of(values: Array) -> Indices:
    """Return the indices of a column: values of one set of points, of the other, and of the mixed sets."""

    def estimated(part: Array) -> Array:
        flat = part.reshape(len(part), 1, -1)
        found = sobol_indices(func={"f_A": flat[0], "f_B": flat[1], "f_AB": flat[2:]}, n=flat.shape[-1])
        return np.stack([found.first_order, found.total_order])

    (first, total) = estimated(values)
    first_error, total_error = error_of(np.stack([estimated(values[:, r]) for r in range(REPLICATES)]))
    return Indices(first, first_error, total, total_error)
