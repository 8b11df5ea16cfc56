"""Where a quantity is least and largest along a part of the way, found between its samples too."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.along import Numbers, Part
from chutecalc.physics.arrays import Array, Mask

SAMPLES = np.linspace(0.0, 1.0, 65)
FEW = SAMPLES[::4]
"""Enough to begin with where nothing else is read from the samples."""
ROUNDS, GRID = 2, np.linspace(0.0, 1.0, 17)  # each round leaves an eighth of the bracket around an extreme
BETWEEN = np.linspace(0.0, 1.0, 9)  # from FEW to what SAMPLES have


class Extreme(NamedTuple):
    """Where a quantity is least or largest along a part, shape (designs,)."""

    value: Array
    share: Array
    """Of the part's way."""


LEAST, LARGEST = -1.0, 1.0
Wanted = tuple[str, float]
"""A column's name, and ``LEAST`` or ``LARGEST``."""


def extremes(part: Part, sampled: Numbers, wanted: Sequence[Wanted], samples: Array = SAMPLES) -> dict[Wanted, Extreme]:
    """Extremes of quantities along a part, found between its samples too.

    Args:
        part: of the way.
        sampled: its columns at the samples.
        wanted: which.
        samples: ``SAMPLES`` or ``FEW``; with the second, two extremes less than a sixteenth apart may pass as one.

    Returns:
        One for each. Inside, it is that of the parabola through three places 5e-4 of the way apart: for what varies
        smoothly, right to about 1e-11 of its variation. What grows without bound towards a stop, as depth does, is
        taken up to the last place before it.
    """
    signs = np.array([sign for _, sign in wanted])[:, None]
    values = np.stack([sampled[name] for name, _ in wanted], axis=1) * signs  # (places, wanted, designs)
    best, low, high = _best(values, np.broadcast_to(samples[:, None, None], values.shape))
    settled = _at_an_end(values)
    open_ = np.flatnonzero(~settled.all(axis=1)).tolist()
    rounds = [*([BETWEEN] if samples is FEW else []), *[GRID] * ROUNDS]
    for places in rounds if open_ else ():
        grid = low[open_] + (high - low)[open_] * places[:, None, None]
        columns = part.at(grid.reshape(-1, grid.shape[2]), {wanted[item][0] for item in open_})
        finer = [columns[wanted[item][0]].reshape(grid.shape)[:, k] for k, item in enumerate(open_)]
        found, low[open_], high[open_] = _best(np.stack(finer, axis=1) * signs[open_], grid)
        for field, new in zip(best, found, strict=True):
            field[open_] = np.where(settled[open_], field[open_], new)
    return {
        item: Extreme(item[1] * best.value[k] + 0.0, best.share[k])  # + 0: no -0
        for k, item in enumerate(wanted)
    }


def _at_an_end(values: Array) -> Mask:
    """Whether the largest value along the first axis is plainly at an end: the parabola there has its top beyond it.

    Also where there are no values at all.
    """
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    inward = np.where(top == 0, 1, -1)
    last = len(values) - 1
    near = np.stack([np.clip(top + k * inward, 0, last) for k in range(3)])
    first, second, third = np.take_along_axis(values, near, axis=0)
    slope, bend = second - first, third - 2.0 * second + first
    plain = (slope < 0.0) & (slope - 0.5 * bend <= 0.25 * slope)  # down from the end on, and not by the bend alone
    settled: Mask = ((top == 0) | (top == last)) & plain | np.isnan(values).all(axis=0)
    return settled


def _best(values: Array, shares: Array) -> tuple[Extreme, Array, Array]:
    """The largest along the first axis, by the parabola through it and its neighbours, and the bracket of those.

    Beside a kink there is no parabola: where the second difference next to it is another one, the value itself counts.
    """
    top = np.where(np.isnan(values), -np.inf, values).argmax(axis=0)
    left, right = np.maximum(top - 1, 0), np.minimum(top + 1, len(values) - 1)
    near = np.stack([left, top, right])
    x, f = np.take_along_axis(shares, near, axis=0), np.take_along_axis(values, near, axis=0)
    inside = (left < top) & (top < right) & np.isfinite(f[0]) & np.isfinite(f[2])
    f = np.where(inside, f, f[1])
    bend = f[2] - 2.0 * f[1] + f[0]  # equally spaced
    shift = np.where(bend < 0.0, 0.5 * (f[0] - f[2]) / np.where(bend < 0.0, bend, 1.0), 0.0)
    beside = top + np.where(shift < 0.0, -2, 2)
    there = (beside >= 0) & (beside < len(values))
    outer = np.take_along_axis(values, np.clip(beside, 0, len(values) - 1)[None], axis=0)[0]
    next_bend = outer - 2.0 * np.where(shift < 0.0, f[0], f[2]) + f[1]
    shift = np.where(there & ~(np.abs(next_bend - bend) <= 0.5 * np.abs(bend)), 0.0, shift)
    value = f[1] - 0.25 * (f[0] - f[2]) * shift
    return Extreme(value, x[1] + shift * (x[2] - x[1])), x[0], x[2]
