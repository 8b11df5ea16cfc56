"""The stream at stations along each part of its trajectory: a number of them, or at a spacing."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from chutecalc.design import stretched
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.results.column_names import check_columns
from chutecalc.results.columns import AT_STATION
from chutecalc.results.part import Part

DEFAULT_POINTS = 101
"""Stations of a part by default."""
MOST_STATIONS = 1_000_000


def at_stations(
    parts: Sequence[Part], count: int, points: int | None, spacing: float | None, names: Sequence[str]
) -> dict[str, Any]:
    """Return the columns at all stations; see :meth:`chutecalc.Solution.stations`.

    Args:
        parts: of the trajectory.
        count: number of designs.
        points: number of stations on each part.
        spacing: instead, distance between stations, m.
        names: of the columns.

    Raises:
        UsageError: both are given, one is out of range, or a name is unknown.
    """
    if points is not None and spacing is not None:
        raise UsageError("points and spacing both set the stations: give one of them")
    if points is not None and not 2 <= points <= MOST_STATIONS:
        raise UsageError(f"points must be from 2 to {MOST_STATIONS}, not {points}")
    if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
        raise UsageError(f"spacing must be greater than 0 m, not {spacing:g}")
    check_columns(names, AT_STATION, " at a station")
    even = _even(points or DEFAULT_POINTS)
    blocks = [_on_part(part, even if spacing is None else _spaced(part, spacing), count, names) for part in parts]
    return {name: np.concatenate([block[name] for block in blocks], axis=1) for name in names}


@lru_cache(maxsize=8)
def _even(points: int) -> Array:
    """Return evenly spaced shares."""
    shares = np.linspace(0.0, 1.0, points)
    shares.flags.writeable = False
    return shares


def _on_part(part: Part, shares: Array, count: int, names: Sequence[str]) -> dict[str, Any]:
    """Return the columns at shares of one part, each of shape (designs, stations)."""
    shape = (count, len(shares))
    labels = {"segment": part.name, "kind": part.kind}
    numbers = part.at(shares, [name for name in names if name not in labels] or ["s_m"])
    return {
        name: np.full(shape, labels[name]) if name in labels else stretched(numbers[name].T, shape) for name in names
    }


def _spaced(part: Part, spacing: float) -> Array:
    """Return shares at multiples of a spacing and at both ends, (stations, designs); NaN past a design's end."""
    begin, end = part.span()
    scale = 1.0 if part.contact is None else part.contact.surface.length
    start, length = begin * scale, (end - begin) * scale
    longest = float(np.nan_to_num(start + length).max())
    if longest / spacing >= MOST_STATIONS:
        raise UsageError(f"a spacing of {spacing:g} m makes more than {MOST_STATIONS} stations: take a larger one")
    travelled = spacing * np.arange(int(longest / spacing) + 1)[:, None] - start
    slack = 1e-12 * (start + length)
    inside = (travelled > slack) & (travelled < length - slack)
    shares = np.where(inside, travelled / np.where(length > 0.0, length, 1.0), np.nan)
    ends = np.where(np.isnan(length), np.nan, np.array([[0.0], [1.0]]))
    return np.concatenate([ends[:1], shares, ends[1:]])
