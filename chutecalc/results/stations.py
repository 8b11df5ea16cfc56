"""The stream at stations along each part of its trajectory: a number of them, or at a spacing."""

from collections.abc import Sequence
from functools import lru_cache
from reprlib import repr as short
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
MOST_STATIONS = 2_000_000
"""Of all parts together: a table of more would need gigabytes."""


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
    if points is not None and not (isinstance(points, int | np.integer) and 2 <= points <= MOST_STATIONS):
        raise UsageError(f"points must be a whole number from 2 to {MOST_STATIONS:,}, not {short(points)}")
    if spacing is not None and not (isinstance(spacing, int | float | np.number) and 0.0 < spacing < np.inf):
        raise UsageError(f"spacing must be a length greater than 0 m, and finite, not {short(spacing)}")
    check_columns(names, AT_STATION, " at a station")
    if spacing is None:
        points = points or DEFAULT_POINTS
        _check_number(points * len(parts), f"{points} points on each of {len(parts)} parts", "fewer")
        shares = [_even(points)] * len(parts)
    else:
        travelled = [_travelled(part) for part in parts]
        length = sum(_furthest(*own) for own in travelled)
        _check_number(length / spacing, f"a spacing of {spacing:g} m", "a larger one")
        shares = [_spaced(*own, spacing) for own in travelled]
    blocks = [_on_part(part, own, count, names) for part, own in zip(parts, shares, strict=True)]
    return {name: np.concatenate([block[name] for block in blocks], axis=1) for name in names}


def _check_number(number: float, what: str, instead: str) -> None:
    """Raise an error about too many stations."""
    if number > MOST_STATIONS:
        raise UsageError(f"{what} makes {number:.0f} stations, more than {MOST_STATIONS}: take {instead}")


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


def _spaced(start: Array, length: Array, spacing: float) -> Array:
    """Return shares at multiples of a spacing and at both ends, (stations, designs); NaN past a design's end."""
    travelled = spacing * np.arange(int(_furthest(start, length) / spacing) + 1)[:, None] - start
    slack = 1e-12 * (start + length)
    inside = (travelled > slack) & (travelled < length - slack)
    shares = np.where(inside, travelled / np.where(length > 0.0, length, 1.0), np.nan)
    ends = np.where(np.isnan(length), np.nan, np.array([[0.0], [1.0]]))
    return np.concatenate([ends[:1], shares, ends[1:]])


def _travelled(part: Part) -> tuple[Array, Array]:
    """Return where each design enters a part, from its drawn start, and the length that it travels there, m."""
    begin, end = part.span()
    scale = 1.0 if part.contact is None else part.contact.surface.length
    return begin * scale, (end - begin) * scale


def _furthest(start: Array, length: Array) -> float:
    """Return how far from its drawn start any design leaves a part, m; 0 where none is on it."""
    return float(np.nan_to_num(start + length).max())
