"""Roots of functions of several keys: starts from a coarse batch, refined together."""

from collections.abc import Callable

import numpy as np

from chutecalc.physics.arrays import Array, Index

POINTS = {2: 49, 3: 17}
"""Points of the grid along each of so many keys."""
SOBOL = 4096
"""Quasi-random points for more keys."""
MOST_STARTS = 128
STEP = 1e-6
"""Half of the distance over which differences are taken, as a share of the bounds."""
ITERATIONS = 60
LEAST_DAMPING = 1e-15
"""Of squares of slopes that are scaled to 1: what is less is rounding, and no way to go."""

Residuals = Callable[[Array], Array]
"""Residuals of designs, shape (designs, targets), from numbers from 0 to 1, shape (designs, keys); NaN for failures."""


def refined_roots(residuals: Residuals, keys: int) -> Array:
    """Return where several functions of as many numbers come closest to zero, each start refined to its end.

    Args:
        residuals: the functions.
        keys: number of numbers.

    Returns:
        Points, shape (starts, keys): roots, and places from which there is no way on.
    """
    points, starts = _grid(residuals, keys) if keys in POINTS else _scattered(residuals, keys)
    return refined(residuals, points[starts]) if len(starts) else points[:0]


def refined(residuals: Residuals, points: Array) -> Array:
    """Refine points together by the method of Levenberg and Marquardt, within the bounds.

    Args:
        residuals: the functions.
        points: where to begin, shape (starts, keys).
    """
    points, values = points.copy(), residuals(points)
    size = np.linalg.norm(values, axis=1)
    damping = np.full(len(points), 1e-3)
    slopes = np.zeros((len(points), values.shape[1], points.shape[1]))
    moved = np.isfinite(size)
    on = moved.copy()
    for _ in range(ITERATIONS):
        if not on.any():
            break
        slopes[moved] = differences(residuals, points[moved], values[moved])
        on &= np.isfinite(slopes).all(axis=(1, 2))
        here = np.flatnonzero(on)
        trial = np.clip(points[here] + _step(slopes[here], values[here], damping[here]), 0.0, 1.0)
        found = residuals(trial) if here.size else values[:0]
        better = np.linalg.norm(found, axis=1) < size[here]
        won, lost = here[better], here[~better]
        points[won], values[won] = trial[better], found[better]
        size[won] = np.linalg.norm(values[won], axis=1)
        damping[won] = np.maximum(0.1 * damping[won], LEAST_DAMPING)
        damping[lost] *= 8.0
        moved = np.zeros(len(points), dtype=bool)
        moved[won] = True
        on[here] &= (damping[here] < 1e6) & (size[here] > 0.0)
        moved &= on
    return points


def _step(slopes: Array, values: Array, damping: Array) -> Array:
    """Return the damped step of each point, shape (points, keys); none along what changes nothing."""
    scale = np.linalg.norm(slopes, axis=1, keepdims=True)
    scale = np.maximum(scale, 1e-6 * scale.max(axis=2, keepdims=True))
    scale[scale == 0.0] = 1.0
    left, size, right = np.linalg.svd(slopes / scale, full_matrices=False)
    along = np.einsum("nij,ni->nj", left, values) * size / (size**2 + damping[:, None])
    step: Array = -np.einsum("njk,nj->nk", right, along) / scale[:, 0]
    return step


def differences(residuals: Residuals, points: Array, values: Array) -> Array:
    """Return the slopes of the residuals, shape (points, targets, keys), from one batch.

    Args:
        residuals: the functions.
        points: where, shape (points, keys).
        values: residuals there, shape (points, targets).
    """
    count, keys = points.shape
    beside = np.repeat(points[:, None, :], 2 * keys, axis=1)
    for key in range(keys):
        beside[:, 2 * key, key] = np.maximum(points[:, key] - STEP, 0.0)
        beside[:, 2 * key + 1, key] = np.minimum(points[:, key] + STEP, 1.0)
    found = residuals(beside.reshape(-1, keys)).reshape(count, 2 * keys, values.shape[1])
    slopes = np.empty((count, values.shape[1], keys))
    for key in range(keys):
        low, high = found[:, 2 * key], found[:, 2 * key + 1]
        below, above = beside[:, 2 * key, key], beside[:, 2 * key + 1, key]
        here = points[:, key]  # differences to one side where a design fails on the other
        below, low = np.where(np.isnan(low).any(axis=1), here, below), np.where(np.isnan(low), values, low)
        above, high = np.where(np.isnan(high).any(axis=1), here, above), np.where(np.isnan(high), values, high)
        with np.errstate(invalid="ignore", divide="ignore"):
            slopes[:, :, key] = (high - low) / (above - below)[:, None]
    return slopes


def _grid(residuals: Residuals, keys: int) -> tuple[Array, Index]:
    """Return a grid, and its points from which to start.

    Those are the best corner of each cell over which all residuals change sign, and points better than all around.
    """
    from scipy.ndimage import minimum_filter

    axis, shape = np.linspace(0.0, 1.0, POINTS[keys]), (POINTS[keys],) * keys
    points = np.stack(np.meshgrid(*[axis] * keys, indexing="ij"), axis=-1).reshape(-1, keys)
    values = residuals(points)
    size = _size(values)
    least = np.isfinite(size) & (size <= minimum_filter(size.reshape(shape), 3).ravel())
    corners = _corners(np.arange(len(points)).reshape(shape))
    there = np.isfinite(size[corners]).sum(axis=1) > 1
    ends = [np.where(np.isnan(values[corners]), fill, values[corners]) for fill in (np.inf, -np.inf)]
    crossed = there & ((ends[0].min(axis=1) <= 0.0) & (ends[1].max(axis=1) >= 0.0)).all(axis=1)
    best = np.take_along_axis(corners, size[corners].argmin(axis=1)[:, None], axis=1)[:, 0]
    starts = np.unique(np.concatenate([best[crossed], np.flatnonzero(least)]))
    return points, starts[np.argsort(size[starts], kind="stable")][:MOST_STARTS]


def _corners(numbers: Index) -> Index:
    """Return the numbers of the corners of each cell of a grid, shape (cells, corners)."""
    windows = np.lib.stride_tricks.sliding_window_view(numbers, (2,) * numbers.ndim)
    return windows.reshape(-1, 2**numbers.ndim)


def _size(values: Array) -> Array:
    """Return the norm of the residuals of each point, infinite where one fails."""
    return np.where(np.isnan(values).any(axis=1), np.inf, np.linalg.norm(values, axis=1))


def _scattered(residuals: Residuals, keys: int) -> tuple[Array, Index]:
    """Return quasi-random points, and those from which to start: the best, and those better than all around them."""
    from scipy.spatial import cKDTree
    from scipy.stats.qmc import Sobol

    points = Sobol(keys, seed=0).random(SOBOL)
    values = residuals(points)
    size = _size(values)
    around = cKDTree(points).query(points, 2 * keys + 1)[1]
    least = np.isfinite(size) & (size <= size[around].min(axis=1))
    order = np.argsort(size, kind="stable")
    order = order[np.isfinite(size[order])]
    return points, np.concatenate([order[least[order]], order[~least[order]]])[:MOST_STARTS]
