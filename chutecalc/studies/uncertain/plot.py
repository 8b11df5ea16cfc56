"""The picture of an uncertain chute: what each key does alone, and bands of velocity and depth along the chute."""

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from chutecalc.output.plots.style import INK, PALE, SHADE, SMALL, STROKES, TITLE, label_axes, mathematical, styled
from chutecalc.output.plots.text import fitted
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import status_words
from chutecalc.studies.uncertain.bands import Bands, bands
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.report import columns_of
from chutecalc.studies.uncertain.statistics import STATUSES

WIDTH, HEIGHT = 10.0, 5.0
"""Size of the picture, inches."""
LOW, HIGH, BAND = "#31688e", "#7ad151", "0.8"
"""Colours of a key at its 5 % and its 95 % quantile, and of a band."""
MOST_SHOWN = 4.0
"""Greatest value that is shown, over the greatest median: towards a stall a depth grows without bound."""
HATCHES = ("////", "....", "xx")
"""Of the bands of ways through the chute, from the second on."""
FLIGHT: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": SMALL, "color": PALE}
"""Look of the words where the stream flies."""
LEAST_SHADED = 0.12
"""Share of the chute from which on a flight has room for these words."""
MOST_BARS = 12
"""Keys that are drawn, those that matter most."""


def draw_uncertainty(result: Outcome, units: str = "metric") -> Figure:
    """Draw what each key does alone to the first column, and the bands of velocity and depth.

    Args:
        result: the study.
        units: ``metric`` or ``us``.

    Returns:
        The figure: axes ``tornado``, ``velocity`` and ``depth``.
    """
    with styled():
        figure = Figure(figsize=(WIDTH, HEIGHT))
        title = result.chute.spec.title or result.chute.source
        figure.suptitle(fitted(f"{title}: how sure", WIDTH, TITLE), x=0.01, ha="left")
        axes = figure.subplot_mosaic([["tornado", "velocity"], ["tornado", "depth"]])
        _draw_tornado(axes["tornado"], result, units)
        found = bands(result)
        for name, column in (("velocity", "velocity_m_s"), ("depth", "depth_m")):
            _draw_band(axes[name], found, column, units)
        axes["velocity"].set_title("along the chute: median, and from 5 to 95 %")
        axes["depth"].sharex(axes["velocity"])
        if len(found.shares) > 1:
            axes["velocity"].legend(handles=_handles(found), loc="best")
        figure.supxlabel(fitted(_note(result, found), WIDTH), x=0.01, ha="left", fontsize=SMALL)
        return figure


def _note(result: Outcome, found: Bands) -> str:
    """Return how samples end, and which of them the bands are made from, as text."""
    ends = ", ".join(
        f"{100 * own.share:.3g} % {status.replace('_', ' ')}" for status, own in result.chances.items() if own.share
    )
    count = int(result.ok.sum())
    of = "all" if found.samples == count else f"the first {found.samples:,}"
    differ = "" if found.samples == count else ", so that last digits differ from those of the report"
    rest = 1.0 - sum(found.shares)
    ways = f"; {100 * rest:.2g} % of these take other ways through the chute, not drawn" if 1e-9 < rest < 1.0 else ""
    return f"{result.count:,} samples: {ends}; bands from {of} that do not fail{differ}{ways}"


def _handles(found: Bands) -> list[Patch]:
    """Return what a legend shows for several ways through the chute."""
    texts = [f"{100 * share:.3g} % of the samples go this way" for share in found.shares]
    return [
        Patch(**_fill(number), linestyle=STROKES[number % len(STROKES)], label=text)
        for number, text in enumerate(texts)
    ]


def _fill(way: int) -> dict[str, Any]:
    """Return the look of the band of a way: the commonest is filled, others are hatched."""
    look = {"facecolor": BAND} if way == 0 else {"facecolor": "none", "hatch": HATCHES[(way - 1) % len(HATCHES)]}
    return {**look, "edgecolor": INK if way else BAND, "linewidth": 0.3 if way else 0.0}


def _draw_tornado(axes: Axes, result: Outcome, units: str) -> None:
    """Draw a bar for each key from the column at its 5 % quantile to that at its 95 % quantile."""
    name, column = next(iter(columns_of(result).items()))
    alone = result.tornado
    order = alone.order(name)[:MOST_BARS]
    spec = column.converted(alone.spec[name], units)
    axes.axvline(spec, color=PALE, linewidth=1.0, gid="spec")
    for place, k in enumerate(order):
        for end, colour in enumerate((LOW, HIGH)):
            value = column.converted(alone.columns[name][k, end], units)
            if np.isfinite(value) and np.isfinite(spec):
                axes.barh(place, value - spec, left=spec, color=colour, height=0.7, gid=f"bar {end}")
        fails = [status_words(STATUSES[code]) for code in alone.ends[k] if code]
        if fails:
            axes.annotate(", ".join(fails), (1.0, place), xycoords=("axes fraction", "data"), ha="right", color=INK)
    labels = [f"{_short(result.keys.paths[k])}\n{alone.values[k, 0]:.5g} to {alone.values[k, 1]:.5g}" for k in order]
    axes.set_yticks(range(len(order)), labels)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel(mathematical(column.label(units)), parse_math=True)
    axes.set_title("each key alone at its 5 % (dark) and 95 % (light) quantile")


def _short(path: str) -> str:
    """Return the last parts of a key path, which tell keys apart."""
    return ".".join(path.split(".")[-2:])


def _draw_band(axes: Axes, found: Bands, name: str, units: str) -> None:
    """Draw the bands of a column along the chute, segment by segment, those of each way for themselves."""
    column, distance = COLUMNS[name], COLUMNS["s_m"]
    s = distance.converted(found.s_m, units)
    low, middle, high = column.converted(found.quantiles[name], units)
    empty = np.ones(len(s), dtype=bool)
    for way, segment, own in _pieces(found):
        if np.isfinite(middle[own]).all() and s[own][-1] > s[own][0]:
            empty[own] = False
            axes.fill_between(s[own], low[own], high[own], **_fill(way), gid=f"band {segment}")
            axes.plot(s[own], middle[own], color=INK, linestyle=STROKES[way % len(STROKES)], gid=f"median {segment}")
    if len(found.shares) == 1:
        _shade(axes, s, empty)
    top, known = axes.get_ylim()[1], middle[np.isfinite(middle)]
    axes.set_ylim(0.0, min(top, MOST_SHOWN * float(known.max())) if known.size else top)
    label_axes(axes, distance, column, units)


def _pieces(found: Bands) -> Iterator[tuple[int, str, slice]]:
    """Yield the way, the segment and the stations of each piece of a band: a segment may be visited twice."""
    pairs = list(zip(found.way, found.segment, strict=True))
    first = 0
    for (way, segment), piece in itertools.groupby(pairs):
        count = len(list(piece))
        yield way, segment, slice(first, first + count)
        first += count


def _shade(axes: Axes, s: Array, empty: Mask) -> None:
    """Shade where there is no band, since the stream flies."""
    first = 0
    for is_empty, run in itertools.groupby(empty.tolist()):
        last = first + len(list(run)) - 1
        if is_empty and s[last] > s[first]:
            axes.axvspan(s[first], s[last], color=SHADE, linewidth=0.0, zorder=0.4, gid="in flight")
            if s[last] - s[first] > LEAST_SHADED * (s[-1] - s[0]):
                middle = 0.5 * (s[first] + s[last])
                axes.text(middle, 0.5, "in flight", **FLIGHT, transform=axes.get_xaxis_transform())
        first = last + 1
