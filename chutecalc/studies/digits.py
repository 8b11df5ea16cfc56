"""Found values with the digits that matter."""

from collections.abc import Callable
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Decimal

import numpy as np

from chutecalc.physics.arrays import Array, Mask

LEAST, MOST = 3, 17
"""Digits of a value, counted from the first of its scale: those tried first, and the most."""
TRIED = 64
"""Combinations of numbers rounded down and up, at most, for each number of digits."""


def rounded(values: Array, scales: Array, is_good: Callable[[Array], Mask]) -> Array:
    """Return numbers with as few digits as will do; the numbers themselves where no fewer do.

    Args:
        values: the numbers, shape (numbers,).
        scales: a number of the size that each may have, such as a bound; above 0, shape (numbers,).
        is_good: says of several roundings, shape (roundings, numbers), whether each will do.

    >>> rounded(np.array([0.500000000000002]), np.array([0.5]), lambda tried: tried[:, 0] <= 0.5).tolist()
    [0.5]
    >>> close = lambda tried: np.abs(tried[:, 0] - 2.67907602) < 1e-3
    >>> rounded(np.array([2.6790760197265713]), np.array([6.0]), close).tolist()
    [2.68]
    """
    up = np.random.default_rng(0).integers(0, 2, (TRIED, len(values))) > 0
    tried = []
    for digits in range(LEAST, MOST + 1):
        near, below, above = (_to(digits, values, scales, how) for how in (ROUND_HALF_EVEN, ROUND_FLOOR, ROUND_CEILING))
        tried += [near[None], np.unique(np.where(up, above, below), axis=0)]
    candidates = np.concatenate(tried)
    good = is_good(candidates)
    return np.asarray(candidates[good.argmax()]) if good.any() else values


def _to(digits: int, values: Array, scales: Array, how: str) -> Array:
    """Return numbers rounded in one way, to digits of their scale."""
    last = (Decimal(1).scaleb(Decimal(scale).adjusted() + 1 - digits) for scale in scales.tolist())
    return (
        np.array([float(Decimal(value).quantize(each, how)) for value, each in zip(values.tolist(), last, strict=True)])
        + 0.0
    )
