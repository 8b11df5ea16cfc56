"""Names of segments above a panel: level where there is room, else upright, side by side, with a line to each."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes

from chutecalc.output.plots.style import PALE, SMALL
from chutecalc.output.plots.text import width_of
from chutecalc.physics.arrays import Array

UPRIGHT = 1.25 * SMALL
"""Room that a name takes which stands upright, points."""
APART = 4.0
"""Least distance between names, points."""
NEAR = 1.0
"""If a name is farther from its segment than this, points, lines lead from the upright names to their segments."""
CLOSE, ABOVE = 3.0, 9.0
"""Height of names above the panel, without such lines and with them, points."""


class Heading(NamedTuple):
    """The name of a segment."""

    name: str
    middle: float
    """Of the segment, in the units of the axes."""
    room: float
    """Length of the segment on the page, points."""


def write_headings(panel: Axes, headings: Sequence[Heading], width: float) -> None:
    """Write names above a panel.

    Args:
        panel: the panel, with its limits.
        headings: the names, along the stream.
        width: of the panel, points.
    """
    if not headings:
        return
    low, high = panel.get_xlim()
    wanted = np.array([(heading.middle - low) / (high - low) * width for heading in headings])
    level = [width_of(heading.name) < 0.95 * heading.room for heading in headings]
    widths = [width_of(heading.name) + APART for heading in headings]
    for flat in (level, [False] * len(headings)):
        sizes = np.where(flat, widths, UPRIGHT)
        if sizes.sum() <= width:
            break
    places = apart(wanted, sizes, width)
    moved = bool((np.abs(places - wanted) > NEAR).any())
    for heading, place, middle, is_flat in zip(headings, places.tolist(), wanted.tolist(), flat, strict=True):
        look: dict[str, Any] = {"rotation": 0.0 if is_flat else 90.0}
        high = CLOSE
        if moved and not is_flat:
            high = ABOVE
            look["arrowprops"] = {"arrowstyle": "-", "color": PALE, "linewidth": 0.5, "shrinkA": 0.0, "shrinkB": 0.0}
        panel.annotate(
            heading.name,
            (heading.middle, 1.0),
            xycoords=panel.get_xaxis_transform(),
            xytext=(place - middle, high),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize=SMALL,
            **look,
        )


def apart(wanted: Array, sizes: Array, width: float) -> Array:
    """Return places near the wanted ones at which things in a row do not overlap.

    Args:
        wanted: places of their middles, ascending, in points.
        sizes: of the things, points.
        width: of the row, from 0, points.

    Returns:
        Their middles: those that touch stand together, with the least sum of squared distances from the wanted places.

    >>> apart(np.array([10.0, 10.0, 50.0]), np.array([8.0, 8.0, 8.0]), 60.0).tolist()
    [6.0, 14.0, 50.0]
    """
    before = np.cumsum(sizes) - 0.5 * sizes
    runs: list[list[float]] = []  # of each run of things that touch: sum of the places of its start, and how many
    for start in (wanted - before).tolist():
        runs.append([start, 1.0])
        while len(runs) > 1 and runs[-2][0] / runs[-2][1] > runs[-1][0] / runs[-1][1]:
            total, count = runs.pop()
            runs[-1] = [runs[-1][0] + total, runs[-1][1] + count]
    starts = np.concatenate([np.full(int(count), total / count) for total, count in runs])
    places: Array = np.clip(starts, 0.0, max(width - float(sizes.sum()), 0.0)) + before
    return places
