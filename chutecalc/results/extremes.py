"""Where a column is least and largest along a part of the trajectory, found between its samples too."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index, Mask, Numbers
from chutecalc.results.part import Part

HALVING_ROUNDS, SIDE_SHARES = 2, np.linspace(0.0, 1.0, 9)
"""Each round of a subdivision leaves an eighth of the bracket around an extreme."""
PARABOLA_REACHES = 1.0 / 16.0, 1.0 / 1024.0
"""Shares of the bracket at which three points around the peak of the last parabola are apart."""


class Extreme(NamedTuple):
    """The least or largest value of a column along a part."""

    value: Array
    """Least or largest value in the column's unit, shape (designs,)."""
    share: Array
    """Position as a share of the length travelled, dimensionless, shape (designs,)."""


LEAST, LARGEST = -1.0, 1.0
ExtremeOf = tuple[str, float]
"""A column's name, and ``LEAST`` or ``LARGEST``."""
Evaluate = Callable[[Array], Array]
Search = Callable[[Evaluate, Array, Array, Array, Array, Array], tuple[Extreme, Mask]]
"""A search for an extreme: takes how to evaluate columns, the peak of a parabola, the bracket around it (low, middle,
high) and the largest sample; returns the extreme and a mask of where it can be trusted."""


def extremes(part: Part, sampled: Numbers, shares: Array, extremes_of: Sequence[ExtremeOf]) -> dict[ExtremeOf, Extreme]:
    """Find extremes of columns along a part, between its samples too.

    Args:
        part: of the trajectory.
        sampled: its columns at the samples, each of shape (samples, designs).
        shares: of the samples, dimensionless, as :func:`~chutecalc.results.sampled.sample_shares` gives them: between
            neighbours all is smooth.
        extremes_of: pairs of a column's name and ``LEAST`` or ``LARGEST``.

    Returns:
        An extreme for each. Inside the part it is that of the parabola through three points less than a hundredth of a
        panel apart: for what varies smoothly, right to about 1e-11 of its variation. What grows without bound towards
        the end is infinite there.
    """
    none = np.full(sampled[extremes_of[0][0]].shape[1], np.nan)
    limits = part.limits({name for name, _ in extremes_of})
    absent = {name for name, limit in limits.items() if np.isnan(limit).all() and np.isnan(sampled[name]).all()}
    found = {item: Extreme(none, np.zeros_like(none)) for item in extremes_of if item[0] in absent}
    there = [item for item in extremes_of if item[0] not in absent]
    return found | _present(part, sampled, limits, shares, there) if there else found


def _present(
    part: Part, sampled: Numbers, limits: Numbers, shares: Array, extremes_of: Sequence[ExtremeOf]
) -> dict[ExtremeOf, Extreme]:
    """Return the extremes of columns that exist; ``limits`` as of :meth:`chutecalc.results.part.Part.limits`."""
    signs = np.array([sign for _, sign in extremes_of])[:, None]

    def evaluate(items: Sequence[int], at: Array) -> Array:
        """Return columns of the shape of ``at``, points, items, designs, with the sign of the extreme."""
        known = part.at(at.reshape(-1, at.shape[2]), {extremes_of[item][0] for item in items})
        found = [known[extremes_of[item][0]].reshape(at.shape)[:, k] for k, item in enumerate(items)]
        found = [np.where(at[:, k] == 1.0, limits[extremes_of[item][0]], found[k]) for k, item in enumerate(items)]
        stacked: Array = np.stack(found, axis=1) * signs[items]
        return stacked

    each = shares[:, None] if shares.ndim == 1 else shares
    values = np.stack([np.where(each == 1.0, limits[name], sampled[name]) for name, _ in extremes_of], axis=1)
    values = values * signs  # (samples, extremes, designs)
    each = np.broadcast_to(each[:, None], values.shape)
    best, bracket, peak = _best(values, each)
    settled = _at_an_end(values, each, peak)
    largest = np.take_along_axis(values, peak[None], axis=0)[0]
    searches: tuple[Search, ...] = (_by_parabolas, _by_subdivision)
    for search in searches:
        items = np.flatnonzero(~settled.all(axis=1)).tolist()
        if items:
            low, middle, high = (edge[items] for edge in bracket)
            found, good = search(partial(evaluate, items), best.share[items], low, middle, high, largest[items])
            for field, new in zip(best, found, strict=True):
                field[items] = np.where(settled[items] | ~good, field[items], new)
            settled[items] |= good
    return {
        item: Extreme(item[1] * best.value[k] + 0.0, best.share[k])  # + 0: no -0
        for k, item in enumerate(extremes_of)
    }


def _by_parabolas(
    evaluate: Evaluate, share: Array, low: Array, middle: Array, high: Array, largest: Array
) -> tuple[Extreme, Mask]:
    """Search by three points around the peak of the last parabola; trusted where the next peak lies between them."""
    for step in PARABOLA_REACHES:
        reach = step * (high - low)
        share = np.clip(share, low + reach, high - reach)
        at = np.stack([share - reach, share, share + reach])
        found, bend = _parabola(evaluate(at), at)
        share = np.clip(np.where(np.isfinite(found.share), found.share, middle), low, high)
    good: Mask = (bend < 0.0) & (np.abs(found.share - at[1]) <= reach) & (found.value >= largest)
    return found, good


def _by_subdivision(
    evaluate: Evaluate, share: Array, low: Array, middle: Array, high: Array, largest: Array
) -> tuple[Extreme, Mask]:
    """Search by many points between the neighbours of the largest sample, twice: works beside a kink too."""
    for _ in range(HALVING_ROUNDS):
        at = np.concatenate(
            [low + (middle - low) * SIDE_SHARES[:-1, None, None], middle + (high - middle) * SIDE_SHARES[:, None, None]]
        )
        found, (low, middle, high), _ = _best(evaluate(at), at)
    return found, np.ones(share.shape, dtype=bool)


def _at_an_end(values: Array, shares: Array, peak: Index) -> Mask:
    """Return whether the largest value along the first axis is plainly at an end: the parabola peaks beyond it.

    Also where there are no values at all, one without bound, or a constant.
    """
    inward = np.where(peak == 0, 1, -1)
    last = (shares < shares[-1]).sum(axis=0)  # what a design has too few of repeats its end
    neighbours = np.stack([np.clip(peak + k * inward, 0, last) for k in range(3)])
    f, x = np.take_along_axis(values, neighbours, axis=0), np.take_along_axis(shares, neighbours, axis=0)
    with np.errstate(all="ignore"):
        slopes = np.diff(f, axis=0) / np.abs(np.diff(x, axis=0))
        at_end = slopes[0] - (slopes[1] - slopes[0]) * np.abs(x[1] - x[0]) / np.abs(x[2] - x[0])
        plain = (slopes[0] < 0.0) & (at_end <= 0.25 * slopes[0])  # down from the end on, and not by the bend alone
    alike = f[0] == np.fmin.reduce(values, axis=0)
    settled: Mask = ((peak == 0) | (peak == last)) & plain | ~np.isfinite(f[0]) | alike
    return settled


def _best(values: Array, shares: Array) -> tuple[Extreme, tuple[Array, Array, Array], Index]:
    """Return the largest value along the first axis by the parabola through its neighbours, its bracket and index.

    Beside a kink there is no parabola: where the second differences on either side disagree, the sample itself counts.
    """
    peak = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    last = len(values) - 1
    neighbours = np.clip(peak + np.arange(-2, 3)[:, None, None], 0, last)
    x, f = np.take_along_axis(shares, neighbours, axis=0), np.take_along_axis(values, neighbours, axis=0)
    with np.errstate(all="ignore"):
        slopes = np.diff(f, axis=0) / np.diff(x, axis=0)
        bends = np.diff(slopes, axis=0) / (x[2:] - x[:-2])
        found, bend = _parabola(f[1:4], x[1:4])
        smooth = np.isfinite(found.share) & (bend < 0.0) & (x[1] <= found.share) & (found.share <= x[3])
        for beside in (bends[0], bends[2]):
            smooth &= ~np.isfinite(beside) | (np.abs(beside - bend) <= 0.5 * np.abs(bend))
    value, share = np.where(smooth, found.value, f[2]), np.where(smooth, found.share, x[2])
    return Extreme(value, share), (x[1], x[2] + 0.0, x[3]), peak


def _parabola(f: Array, x: Array) -> tuple[Extreme, Array]:
    """Return the peak of the parabola through three points, f1 + m (x - x1) + bend (x - x1)², and its bend."""
    with np.errstate(all="ignore"):
        slopes = np.diff(f, axis=0) / np.diff(x, axis=0)
        bend = (slopes[1] - slopes[0]) / (x[2] - x[0])
        shift = -0.5 * (slopes[0] + bend * (x[1] - x[0])) / bend
        return Extreme(np.fmax(f[1] - bend * shift**2, f[1]), x[1] + shift), bend
