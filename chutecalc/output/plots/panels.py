"""Columns of a stream along it, a panel each."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from chutecalc.output.plots.headings import Heading, write_headings
from chutecalc.output.plots.layout import PANELS
from chutecalc.output.plots.looks import END, MISSED, STRUCK
from chutecalc.output.plots.marks import MOST_NAMED
from chutecalc.output.plots.style import INK, PALE, SHADE, SMALL
from chutecalc.output.plots.text import POINTS, width_of
from chutecalc.output.plots.traces import LOST, Trace, View, along
from chutecalc.output.plots.traces import STRUCK as STRUCK_COLUMNS
from chutecalc.results.columns import COLUMNS
from chutecalc.results.part import FLIGHT

HEADROOM = 1.06
"""Top of a panel over its largest value."""
CUT_OFF = 12.0
"""A panel ends at this multiple of the median of its values."""
IN_FLIGHT = "in flight"


def draw_panels(axes: Mapping[str, Axes], seen: View, units: str) -> None:
    """Draw the columns of a stream in the panels.

    Args:
        axes: axes by name.
        seen: the stream.
        units: ``metric`` or ``us``.
    """
    panels = [axes[name] for name in PANELS]
    for name, panel in zip(PANELS, panels, strict=True):
        panel.plot(*along(seen.stream, name, units), color=INK, gid=name)
        for trace in seen.stream:
            if trace.is_plate and name not in STRUCK_COLUMNS:
                panel.plot(*(values[:1] for values in along([trace], name, units)), **STRUCK)
        if seen.lost:
            panel.plot(*along([seen.lost], name, units), **MISSED)
        if seen.end:
            panel.plot(*along([seen.end], name, units), **END)


def limit(panel: Axes) -> None:
    """Limit a panel to its largest value, but cut off the peaks of a stream that nearly stops.

    A peak is far above what is usual on its own segment: short bends may lie far above all the rest.

    Args:
        panel: the panel, with all its lines.
    """
    lines = [np.asarray(line.get_ydata(), float) for line in panel.get_lines()]
    if not any(np.isfinite(values).any() for values in lines):
        panel.set_yticks([])
    known = [positive for values in lines if (positive := values[np.isfinite(values) & (values > 0.0)]).size]
    usual = max((float(np.median(values)) for values in known if len(values) > 1), default=np.inf)
    top = min(HEADROOM * max(float(values.max()) for values in known), CUT_OFF * usual) if known else 0.0
    panel.set_ylim(0.0, top if top > 0.0 else 1.0)


def mark_ends(axes: Mapping[str, Axes], stream: Sequence[Trace], units: str) -> None:
    """Mark the ends of segments and flights, shade the flights, and name the segments.

    Args:
        axes: axes by name, of a figure that is laid out.
        stream: traces of the stream, lost ones included.
        units: ``metric`` or ``us``.
    """
    panels = [axes[name] for name in PANELS]
    ends = [COLUMNS["s_m"].converted(trace.columns["s_m"][[0, -1]], units) for trace in stream]
    low, high = ends[0][0], max(ends[-1][1], panels[0].dataLim.x1)  # a case may go on further
    if not high > low:
        panels[0].set_xlim(low - 0.5, high + 0.5)
        return
    figure = panels[0].figure.figure
    room = panels[0].get_position().width * figure.get_figwidth() * POINTS
    for panel in panels:
        panel.set_xlim(low, high)
        for end in [end for _, end in ends if end < high] if len(ends) <= MOST_NAMED else ():
            panel.axvline(end, color=PALE, linewidth=0.7, zorder=1)
    named: list[Heading] = []
    for trace, (first, last) in zip(stream, ends, strict=True):
        share, middle = (last - first) / (high - low) * room, 0.5 * (first + last)
        if trace.side == 0.0:
            _shade(panels, first, last, share)
        if trace.kind not in (LOST, FLIGHT):
            named.append(Heading(trace.name, middle, share))
    if len(ends) <= MOST_NAMED:
        write_headings(panels[0], named, room)


def _shade(panels: Sequence[Axes], first: float, last: float, room: float) -> None:
    """Shade a flight, and say so where there is nothing else."""
    text: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": SMALL, "color": PALE}
    for panel, name in zip(panels, PANELS, strict=True):
        panel.axvspan(first, last, color=SHADE, linewidth=0.0, zorder=0.4, gid=IN_FLIGHT)
        if name != PANELS[0] and width_of(IN_FLIGHT) < 0.9 * room:
            panel.text(0.5 * (first + last), 0.5, IN_FLIGHT, transform=panel.get_xaxis_transform(), **text)
