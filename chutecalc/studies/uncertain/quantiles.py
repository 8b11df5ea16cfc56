"""Quantile functions of uncertain numbers, and the values that points of a unit cube stand for."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy import stats
from scipy.special import ndtr, ndtri

from chutecalc.api.scatter import Scatter, bounds_of
from chutecalc.api.uncertain_keys import UncertainKey, UncertainKeys
from chutecalc.physics.arrays import Array


class Quantiles(NamedTuple):
    """The distribution of one uncertain number, cut off at the bounds of its key.

    A number that may not leave low..high has the quantile function Q(F(low) + u [F(high) - F(low)]), with Q and F
    those of the distribution without bounds: what lay outside is spread over the inside in proportion.
    """

    base: Any
    """Distribution of SciPy."""
    below: float
    """Probability of the distribution below the least value that the key takes."""
    within: float
    """Probability between the least and the greatest value."""
    low: float
    """Least value that the key takes, in its unit."""
    high: float
    """Greatest value that the key takes."""
    read: Callable[[Array], Array]
    """Turns numbers of the distribution into values of the key."""

    @property
    def outside(self) -> float:
        """Share of the distribution that is cut off, because the key does not take it."""
        return max(1.0 - self.within, 0.0)

    def __call__(self, shares: Any) -> Array:
        r"""Return the values below which these shares of all values lie.

        Args:
            shares: between 0 and 1, of any shape.

        >>> import chutecalc
        >>> text = chutecalc.STARTER + '[uncertainty]\n"flow.rate_t_h" = { uniform = [800, 1200] }'
        >>> quantiles_of(chutecalc.parse(text).uncertain.keys[0])([0.0, 0.25]).tolist()
        [800.0, 900.0]
        """
        values = self.read(self.base.ppf(self.below + np.asarray(shares) * self.within))
        return np.clip(values, self.low, self.high)  # rounding, no more


def quantiles_of(key: UncertainKey) -> Quantiles:
    """Return the distribution of an uncertain number.

    Args:
        key: the number.
    """
    low, high = bounds_of(key.parameter)
    base, read, write = _DISTRIBUTIONS[key.scatter.kind](key.scatter, key.parameter.value_in_unit, key.parameter.unit)
    below = float(base.cdf(write(low)))
    return Quantiles(base, below, float(base.cdf(write(high))) - below, low, high, read)


class Joint:
    """The distribution of all uncertain numbers together.

    Correlated keys have a Gaussian copula: z = Q_N(u) is made z L^T, with L L^T the correlation, and N(z) takes the
    place of u. So the correlation is that of normal numbers behind the keys, and exactly that of keys that are normal.

    Args:
        keys: what is uncertain.
    """

    def __init__(self, keys: UncertainKeys) -> None:
        self.quantiles = tuple(quantiles_of(key) for key in keys.keys)
        self._factor = None if keys.are_independent else np.linalg.cholesky(keys.correlation)

    def __call__(self, points: Array) -> Array:
        """Return the values of all keys at points of the unit cube.

        Args:
            points: shape (samples, keys), inside the unit cube.

        Returns:
            Values in the units of the keys, shape (samples, keys).
        """
        if self._factor is not None:
            points = ndtr(ndtri(points) @ self._factor.T)
        return np.stack([own(shares) for own, shares in zip(self.quantiles, points.T, strict=True)], axis=-1)


_Made = tuple[Any, Callable[[Array], Array], Callable[[float], float]]


def _same(value: Any) -> Any:
    return value


def _normal(scatter: Scatter, centre: float, unit: str) -> _Made:
    return stats.norm(centre, scatter.numbers[0]), _same, _same


def _uniform(scatter: Scatter, centre: float, unit: str) -> _Made:
    low, high = scatter.numbers
    return stats.uniform(low, high - low), _same, _same


def _triangular(scatter: Scatter, centre: float, unit: str) -> _Made:
    low, mode, high = scatter.numbers
    return stats.triang((mode - low) / (high - low), low, high - low), _same, _same


def _shear_test(scatter: Scatter, centre: float, unit: str) -> _Made:
    """Return Student's t of the slope; the key is its angle, and what a case adds to that."""
    slope, error, freedom, added = scatter.numbers
    one = np.degrees(1.0) if unit == "deg" else 1.0  # a radian in the unit of the key

    def slope_at(angle: float) -> float:
        return float(np.tan(np.clip((angle - added) / one, 0.0, 0.5 * np.pi)))  # no friction is below 0

    return stats.t(freedom, slope, error), lambda tangent: np.arctan(tangent) * one + added, slope_at


_DISTRIBUTIONS: dict[str, Callable[[Scatter, float, str], _Made]] = {
    "normal": _normal,
    "uniform": _uniform,
    "triangular": _triangular,
    "shear_test": _shear_test,
}
