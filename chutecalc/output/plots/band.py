"""The band of a chute's own assumptions in the panels of its picture."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes

from chutecalc.output.band import band_lines
from chutecalc.output.plots.layout import PANELS
from chutecalc.output.plots.style import PALE
from chutecalc.output.plots.text import fitted
from chutecalc.results.band import COLUMNS as BANDED
from chutecalc.results.band import Band
from chutecalc.results.columns import COLUMNS
from chutecalc.results.stations import DEFAULT_POINTS


def draw_band(axes: Mapping[str, Axes], band: Band, units: str) -> None:
    """Fill the panels that have a band between the least and the largest of all variants.

    Args:
        axes: axes by name.
        band: of the chute that is drawn.
        units: ``metric`` or ``us``.
    """
    for s, ranges in band.along(np.linspace(0.0, 1.0, DEFAULT_POINTS)):
        at = COLUMNS["s_m"].converted(s, units)
        for name in PANELS:
            if name in BANDED:
                least, largest = (COLUMNS[name].converted(values, units) for values in ranges[name])
                axes[name].fill_between(
                    at, least, largest, color=PALE, alpha=0.5, linewidth=0.0, zorder=1.5, gid=f"{name} band"
                )
                axes[name].plot(at, largest, color=PALE, linewidth=0.5, zorder=1.5)  # which the panel has to hold


def band_notes(band: Band, units: str, width: float) -> list[str]:
    """Return lines of text on the band.

    Args:
        band: of the chute that is drawn.
        units: ``metric`` or ``us``.
        width: of the lines, inches.
    """
    texts = (f"band {text}" for text in band_lines(band, units))
    return [line for text in texts for line in fitted(text, width, indent="    ").split("\n")]
