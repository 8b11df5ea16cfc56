"""The picture of an uncertain chute: what each key does alone, and bands of velocity and depth along the chute."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from chutecalc.output.plots.style import INK, PALE, SMALL, TITLE, label_axes, mathematical, styled
from chutecalc.output.plots.text import fitted
from chutecalc.results.columns import COLUMNS
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
        ends = ", ".join(
            f"{100 * own.share:.3g} % {status.replace('_', ' ')}" for status, own in result.chances.items() if own.share
        )
        text = f"{result.count:,} samples: {ends}; bands from {found.samples} of them that do not fail"
        figure.supxlabel(text, x=0.01, ha="left", fontsize=SMALL)
        return figure


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
        fails = [STATUSES[code].replace("_", " ") for code in alone.ends[k] if code]
        if fails:
            axes.annotate(", ".join(fails), (1.0, place), xycoords=("axes fraction", "data"), ha="right", color=INK)
    labels = [f"{_short(result.keys.paths[k])}\n{alone.values[k, 0]:.5g} to {alone.values[k, 1]:.5g}" for k in order]
    axes.set_yticks(range(len(order)), labels)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel(mathematical(column.label(units)))
    axes.set_title("each key alone at its 5 % (dark) and 95 % (light) quantile")


def _short(path: str) -> str:
    """Return the last parts of a key path, which tell keys apart."""
    return ".".join(path.split(".")[-2:])


def _draw_band(axes: Axes, found: Bands, name: str, units: str) -> None:
    """Draw the band of a column along the chute, segment by segment."""
    column, distance = COLUMNS[name], COLUMNS["s_m"]
    s = distance.converted(found.s_m, units)
    low, middle, high = column.converted(found.quantiles[name], units)
    segments = np.array(found.segment)
    for segment in dict.fromkeys(found.segment):
        own = (segments == segment) & np.isfinite(middle)
        axes.fill_between(s[own], low[own], high[own], color=BAND, linewidth=0.0, gid=f"band {segment}")
        axes.plot(s[own], middle[own], color=INK, gid=f"median {segment}")
    top, known = axes.get_ylim()[1], middle[np.isfinite(middle)]
    axes.set_ylim(0.0, min(top, MOST_SHOWN * float(known.max())) if known.size else top)
    label_axes(axes, distance, column, units)
