"""The stream at stations: at so many places on each part of the way, or at a spacing."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from chutecalc.design import stretched
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.part import Part

USUAL = 101
"""Stations of a part where nothing is said."""
MOST = 1_000_000


def at_stations(
    parts: Sequence[Part], count: int, points: int | None, spacing: float | None, names: Sequence[str]
) -> dict[str, Any]:
    """The columns at all stations; see :meth:`chutecalc.Solution.stations`.

    Args:
        parts: of the way.
        count: how many designs there are.
        points, spacing: where the stations are.
        names: of the columns.

    Raises:
        UsageError: what they are asked for makes no sense.
    """
    if points is not None and spacing is not None:
        raise UsageError("stations go by points or by spacing, not by both")
    if points is not None and not 2 <= points <= MOST:
        raise UsageError(f"points has to be from 2 to {MOST}, not {points}")
    if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
        raise UsageError(f"the spacing of stations has to be greater than 0 m, not {spacing:g}")
    unknown = [name for name in names if name not in COLUMNS or name == "spec"]
    if unknown:
        raise UsageError(f"there is no column {', '.join(unknown)}; chutecalc columns lists what there is")
    even = _even(points or USUAL)
    blocks = [_on_part(part, even if spacing is None else _spaced(part, spacing), count, names) for part in parts]
    return {name: np.concatenate([block[name] for block in blocks], axis=1) for name in names}


@lru_cache(maxsize=8)
def _even(points: int) -> Array:
    """Shares so many, the same for all."""
    shares = np.linspace(0.0, 1.0, points)
    shares.flags.writeable = False
    return shares


def _on_part(part: Part, shares: Array, count: int, names: Sequence[str]) -> dict[str, Any]:
    """The columns at shares of one part, each of shape (designs, stations)."""
    shape = (count, len(shares))
    labels = {"segment": part.name, "kind": part.kind}
    numbers = part.at(shares, [name for name in names if name not in labels] or ["s_m"])
    return {
        name: np.full(shape, labels[name]) if name in labels else stretched(numbers[name].T, shape) for name in names
    }


def _spaced(part: Part, spacing: float) -> Array:
    """Shares of the way at multiples of a spacing and at its ends, (places, designs); NaN past a design's end."""
    begin, end = part.ends()
    scale = 1.0 if part.contact is None else part.contact.surface.length
    first, way = begin * scale, (end - begin) * scale
    longest = float(np.nan_to_num(first + way).max())
    if longest / spacing >= MOST:
        raise UsageError(f"a spacing of {spacing:g} m makes more than {MOST} stations on {longest:.6g} m")
    travelled = spacing * np.arange(int(longest / spacing) + 1)[:, None] - first
    slack = 1e-12 * (first + way)
    inside = (travelled > slack) & (travelled < way - slack)
    shares = np.where(inside, travelled / np.where(way > 0.0, way, 1.0), np.nan)
    ends = np.where(np.isnan(way), np.nan, np.array([[0.0], [1.0]]))
    return np.concatenate([ends[:1], shares, ends[1:]])
