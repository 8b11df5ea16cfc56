"""Roots of functions known by formula, many at once and each found as if it were alone."""

from collections.abc import Callable

import numpy as np

from chutecalc.physics.arrays import Array, Index, Mask


def root_between(
    function: Callable[[Array, Index], Array], low: Array, high: Array, f_low: Array, f_high: Array
) -> Array:
    """The root in each bracket across which a function changes sign, by the Illinois rule.

    Args:
        function: of places and of the numbers of the brackets they lie in, both of shape (k,).
        low, high: the brackets' ends, shape (m,).
        f_low, f_high: the function there.

    Returns:
        The roots to rounding, shape (m,); ``high`` where the function does not change its sign.

    >>> squares = np.array([2.0, 3.0, 9.0])
    >>> root_between(lambda x, k: x * x - squares[k], np.zeros(3), np.full(3, 2.0), -squares, 4.0 - squares).round(12)
    array([1.41421356, 1.73205081, 2.        ])
    """
    best = np.where(f_low == 0.0, low, high)
    open_ = np.flatnonzero(f_low * f_high < 0.0)
    low, high, f_low, f_high = low[open_], high[open_], f_low[open_], f_high[open_]
    last = np.zeros(len(open_))
    for _ in range(100):
        if not open_.size:
            break
        at = low + (high - low) * (f_low / (f_low - f_high))
        f = function(at, open_)
        best[open_] = at
        side = np.where((f > 0.0) == (f_low > 0.0), 1.0, -1.0)  # of the end that moves to the new place
        weight = np.where(side == last, 0.5, 1.0)  # an end that stays twice is pulled in
        step = np.where(side > 0.0, at - low, high - at)
        f_low, f_high = np.where(side > 0.0, f, weight * f_low), np.where(side > 0.0, weight * f_high, f)
        low, high = np.where(side > 0.0, at, low), np.where(side > 0.0, high, at)
        go_on = (f != 0.0) & (np.minimum(step, high - low) > 4e-16 * np.abs(at))
        open_, low, high, last = open_[go_on], low[go_on], high[go_on], side[go_on]
        f_low, f_high = f_low[go_on], f_high[go_on]
    return best


def falls_through_zero(coefficients: Array, horizon: Array) -> Array:
    """Places in (0, horizon) at which polynomials of degree 4 fall through zero, in order.

    Between the roots of its derivative a polynomial is monotone; those of its second derivative are in closed form,
    those of its first lie between them, and its own between those.

    Args:
        coefficients: in rising powers, shape (5, n).
        horizon: shape (n,), 0 or more.

    Returns:
        Shape (4, n), NaN where there is no root.

    >>> wave = np.array([[0.75], [-2.0], [1.0], [0.0], [0.0]])  # (x - 0.5) (x - 1.5)
    >>> float(np.nanmin(falls_through_zero(wave, np.array([9.0]))).round(12))
    0.5
    """
    first = coefficients[1:] * np.arange(1.0, 5.0)[:, None]
    second = first[1:] * np.arange(1.0, 4.0)[:, None]
    zero = np.zeros((1, len(horizon)))
    turns = np.clip(_quadratic_roots(second), 0.0, horizon)
    extremes, _ = _roots_in_order(first, np.concatenate([zero, turns, horizon[None]]))
    roots, falling = _roots_in_order(coefficients, np.concatenate([zero, extremes, horizon[None]]))
    return np.where(falling, roots, np.nan)


def polynomial(coefficients: Array, at: Array) -> Array:
    """Horner's rule, coefficients in rising powers along the first axis."""
    value: Array = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        value = value * at + coefficient
    return value


def _roots_in_order(coefficients: Array, knots: Array) -> tuple[Array, Mask]:
    """For each gap between knots, shape (knots, n): the root or the upper end, and where the polynomial falls."""
    values = polynomial(coefficients[:, None], knots)
    n = knots.shape[1]
    ends = (knots[:-1].ravel(), knots[1:].ravel(), values[:-1].ravel(), values[1:].ravel())
    roots = root_between(lambda at, gap: polynomial(coefficients[:, gap % n], at), *ends)
    return roots.reshape(-1, n), (values[:-1] > 0.0) & (values[1:] <= 0.0)


def _quadratic_roots(coefficients: Array) -> Array:
    """Both real roots of c0 + c1 x + c2 x², the smaller first, shape (2, n); anything where there are none."""
    c, b, a = coefficients
    half = -0.5 * (b + np.copysign(np.sqrt(np.maximum(b * b - 4.0 * a * c, 0.0)), b))
    one = np.where(half != 0.0, c / np.where(half != 0.0, half, 1.0), 0.0)
    other = np.where(a != 0.0, half / np.where(a != 0.0, a, 1.0), one)
    return np.stack([np.minimum(one, other), np.maximum(one, other)])
