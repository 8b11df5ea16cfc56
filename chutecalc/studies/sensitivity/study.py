"""The derivative of what comes out by each number of a spec, all of them in one batch."""

from dataclasses import dataclass
from reprlib import repr as short

import numpy as np

from chutecalc.api.cases import state_of
from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.tolerance import check_tolerance
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.described import html_table
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sensitivity.numbers import numbers_of
from chutecalc.studies.sensitivity.slopes import positions, slopes, step_of
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.variants import Variants


@dataclass(frozen=True, repr=False, eq=False)
class Sensitivity:
    """Derivatives of a column by the numbers of a spec, those that matter most first; arrays of shape (keys,)."""

    source: str
    """Name of the spec."""
    column: str
    """Name of the column."""
    value: float
    """The column at the spec as written, in its unit."""
    paths: tuple[str, ...]
    """Key paths, in the units in which the spec gives them."""
    given: Array
    """Values of the keys."""
    derivative: Array
    """Units of the column per unit of the key: to one side where the chute fails, or cannot be built, right beside the
    spec on the other; NaN where it does on both."""
    error: Array
    """Estimated error of the derivative; NaN where the chute fails on any side."""
    smooth: Mask
    """Whether the slopes to both sides agree: not at a kink, nor next to a failure."""

    @property
    def per_unit(self) -> Array:
        """Per cent of the column per unit of the key."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return 100.0 * self.derivative / abs(self.value)

    @property
    def per_percent(self) -> Array:
        """Per cent of the column per 1 % of the key; 0 for a key of 0."""
        return 0.01 * self.per_unit * np.abs(self.given)

    def __repr__(self) -> str:
        """Return the column and the keys that matter most.

        >>> import chutecalc
        >>> chutecalc.sensitivity(chutecalc.parse(chutecalc.STARTER))
        <Sensitivity of exit_velocity_m_s to 11 keys: liners.ceramic.friction_deg, segments.spoon.radius_m, ...>
        """
        return f"<{self._described()}: {', '.join(self.paths[:2])}, ...>"

    def _repr_html_(self) -> str:
        """Return a table of the keys, for notebooks."""
        numbers = zip(self.paths, self.given, self.per_unit, self.per_percent, strict=True)
        rows = [(path, f"{given:.6g}", f"{unit:.4g}", f"{percent:.4g}") for path, given, unit, percent in numbers]
        return html_table(self._described(), ("key", "value", "% per unit", "% per 1 %"), rows)

    def _described(self) -> str:
        return f"Sensitivity of {self.column} to {len(self.paths)} keys"


def sensitivity(
    chute: Chute, column: str = "exit_velocity_m_s", case: str = DESIGN_POINT, rtol: float = 1e-10
) -> Sensitivity:
    """Return how much each number of a spec changes what comes out, by central differences.

    Args:
        chute: of one design. Its steel stands still while operating keys vary, and is drawn anew where others do.
        column: name of a column of numbers, as those of a sweep.
        case: operating state of the spec, ``design`` for the spec as written.
        rtol: relative tolerance, as in :func:`chutecalc.solve`.

    Returns:
        Keys, derivatives and their errors, sorted by the per cent of the column per 1 % of the key.

    Raises:
        UsageError: there is no such column or case, or the chute fails.

    >>> import chutecalc
    >>> found = chutecalc.sensitivity(chutecalc.parse(chutecalc.STARTER))
    >>> dict(zip(found.paths, found.per_unit.round(2).tolist()))["liners.ceramic.friction_deg"]
    -1.87
    """
    check_chute(chute)
    check_tolerance(rtol)
    if not isinstance(column, str):
        raise UsageError(f"column must be the name of one, such as exit_velocity_m_s, not {short(column)}")
    if chute.count != 1:
        raise UsageError(f"sensitivity takes a chute of one design, not {chute.count}: use the chute before vary")
    state = state_of(chute, case)
    keys = numbers_of(state)
    given = np.array([key.value_in_unit for key in keys])
    steps = np.array([step_of(key, rtol) for key in keys])
    at = np.stack([positions(key, step) for key, step in zip(keys, steps, strict=True)])
    rows = np.tile(given, (1 + at.size, 1))
    rows[1 + np.arange(at.size), np.repeat(np.arange(len(keys)), at.shape[1])] += (steps[:, None] * at).ravel()
    varied = [
        Parameter(key.path, (key.path,), np.array([value, value])) for key, value in zip(keys, given, strict=True)
    ]
    numbers = Variants(state, varied, [column], rtol=rtol)(list(rows.T))[column][0]
    if numbers.dtype.kind != "f":
        raise UsageError(f"{column} is no number: use a column such as exit_velocity_m_s")
    if not np.isfinite(numbers[0]):
        raise UsageError(f"{chute.source} has no {column}, since it fails: run tells where. There is no sensitivity")
    value = float(numbers[0])
    found = slopes(value, numbers[1:].reshape(at.shape), at, steps, rtol)
    matters = np.nan_to_num(np.abs(found.derivative), nan=np.inf)
    order = np.lexsort((-matters, -np.where(np.isinf(matters), np.inf, matters * np.abs(given))))
    paths = tuple(keys[k].path for k in order)
    derivative, error, smooth = found.derivative[order], found.error[order], found.smooth[order]
    return Sensitivity(chute.source, column, value, paths, given[order], derivative, error, smooth)
