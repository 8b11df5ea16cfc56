"""Where a quantity is least and largest along a part of the way, found between its samples too."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.along import Numbers, Part
from chutecalc.physics.arrays import Array, Mask

ROUNDS, SIDE = 2, np.linspace(0.0, 1.0, 9)  # each round leaves an eighth of the bracket around an extreme


class Extreme(NamedTuple):
    """Where a quantity is least or largest along a part, shape (designs,)."""

    value: Array
    share: Array
    """Of the part's way."""


LEAST, LARGEST = -1.0, 1.0
Wanted = tuple[str, float]
"""A column's name, and ``LEAST`` or ``LARGEST``."""


def extremes(part: Part, sampled: Numbers, shares: Array, wanted: Sequence[Wanted]) -> dict[Wanted, Extreme]:
    """Extremes of quantities along a part, found between its samples too.

    Args:
        part: of the way.
        sampled: its columns at those samples.
        shares: of its way, as :meth:`chutecalc.along.Part.shares` gives them: between neighbours all is smooth.
        wanted: which.

    Returns:
        One for each. Inside, it is that of the parabola through three places less than a hundredth of a panel apart:
        for what varies smoothly, right to about 1e-11 of its variation. What grows without bound towards the end is
        infinite there.
    """
    signs = np.array([sign for _, sign in wanted])[:, None]
    limits = part.limits({name for name, _ in wanted})

    def toward(at: Array, name: str, column: Array) -> Array:
        return np.where(at == 1.0, limits[name], column)

    each = shares[:, None] if shares.ndim == 1 else shares
    values = np.stack([toward(each, name, sampled[name]) for name, _ in wanted], axis=1)
    values = values * signs  # (places, wanted, designs)
    each = np.broadcast_to(each[:, None], values.shape)
    best, bracket = _best(values, each)
    settled = _at_an_end(values, each)
    open_ = np.flatnonzero(~settled.all(axis=1)).tolist()
    for _ in range(ROUNDS if open_ else 0):
        low, top, high = (edge[open_] for edge in bracket)
        grid = np.concatenate([low + (top - low) * SIDE[:-1, None, None], top + (high - top) * SIDE[:, None, None]])
        finer = part.at(grid.reshape(-1, grid.shape[2]), {wanted[item][0] for item in open_})
        columns = [finer[wanted[item][0]].reshape(grid.shape)[:, k] for k, item in enumerate(open_)]
        columns = [toward(grid[:, k], wanted[item][0], columns[k]) for k, item in enumerate(open_)]
        found, narrower = _best(np.stack(columns, axis=1) * signs[open_], grid)
        for edge, new in zip(bracket, narrower, strict=True):
            edge[open_] = new
        for field, new in zip(best, found, strict=True):
            field[open_] = np.where(settled[open_], field[open_], new)
    return {
        item: Extreme(item[1] * best.value[k] + 0.0, best.share[k])  # + 0: no -0
        for k, item in enumerate(wanted)
    }


def _at_an_end(values: Array, shares: Array) -> Mask:
    """Whether the largest value along the first axis is plainly at an end: the parabola there has its top beyond it.

    Also where there are no values at all, or one without bound.
    """
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    inward = np.where(top == 0, 1, -1)
    last = len(values) - 1
    near = np.stack([np.clip(top + k * inward, 0, last) for k in range(3)])
    f, x = np.take_along_axis(values, near, axis=0), np.take_along_axis(shares, near, axis=0)
    with np.errstate(all="ignore"):
        slopes = np.diff(f, axis=0) / np.abs(np.diff(x, axis=0))
        at_end = slopes[0] - (slopes[1] - slopes[0]) * np.abs(x[1] - x[0]) / np.abs(x[2] - x[0])
        plain = (slopes[0] < 0.0) & (at_end <= 0.25 * slopes[0])  # down from the end on, and not by the bend alone
    settled: Mask = ((top == 0) | (top == last)) & plain | np.isnan(values).all(axis=0) | np.isinf(f[0])
    return settled


def _best(values: Array, shares: Array) -> tuple[Extreme, tuple[Array, Array, Array]]:
    """The largest along the first axis, by the parabola through it and its neighbours, and where those three are.

    Beside a kink there is no parabola: where the second difference on either side is another one, the value itself
    counts.
    """
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    last = len(values) - 1
    near = np.clip(top + np.arange(-2, 3)[:, None, None], 0, last)
    x, f = np.take_along_axis(shares, near, axis=0), np.take_along_axis(values, near, axis=0)
    with np.errstate(all="ignore"):
        slopes = np.diff(f, axis=0) / np.diff(x, axis=0)
        bends = np.diff(slopes, axis=0) / (x[2:] - x[:-2])
        bend = bends[1]
        # the parabola f2 + m (x - x2) + bend (x - x2)²
        shift = -0.5 * (slopes[1] + bend * (x[2] - x[1])) / bend
        smooth = np.isfinite(shift) & (bend < 0.0) & (x[1] <= x[2] + shift) & (x[2] + shift <= x[3])
        for beside in (bends[0], bends[2]):
            smooth &= ~np.isfinite(beside) | (np.abs(beside - bend) <= 0.5 * np.abs(bend))
        shift = np.where(smooth, shift, 0.0)
        value = np.where(smooth, f[2] - bend * shift**2, f[2])
    return Extreme(value, x[2] + shift), (x[1], x[2] + 0.0, x[3])
