"""Impacts in the panels: pressure and wear where the stream strikes a surface, often the greatest of all."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from chutecalc.output.plots.cases import CaseLine
from chutecalc.output.plots.labels import Label, place_labels
from chutecalc.output.plots.looks import STRUCK as LOOK
from chutecalc.output.plots.panels import HEADROOM, IN_FLIGHT
from chutecalc.output.plots.traces import STRUCK, View
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS

REACH = 4.0
"""An axis reaches an impact of up to this multiple of what it holds already; beyond, it would squash all else."""
MOST_VALUED = 8
"""Of more impacts only the greatest has its value beside it, and those beyond the axis."""
SMALL_MARK = 3.5
"""Size of the mark of an impact in another operating state, points."""


def draw_impacts(axes: dict[str, Axes], seen: View, cases: Sequence[CaseLine], units: str) -> None:
    """Mark the impacts in the panels of pressure and wear; those far above all else at the edge of the panel.

    Args:
        axes: axes by name, with limits for all other lines.
        seen: the stream.
        cases: its other operating states.
        units: ``metric`` or ``us``.
    """
    drawn: list[tuple[View, dict[str, Any]]] = [(seen, LOOK)]
    for case in cases:
        small = {"marker": case.look["marker"], "markeredgecolor": case.look["color"], "markersize": SMALL_MARK}
        small |= {"gid": "case impact", "zorder": 2.9}
        drawn.append((case.seen, LOOK | small))
    for name in STRUCK:
        top = axes[name].get_ylim()[1]
        values = np.concatenate([_converted(view, name, units)[1] for view, _ in drawn])
        within = values[values <= REACH * top]
        top = max(top, HEADROOM * float(within.max())) if within.size else top
        axes[name].set_ylim(0.0, top)
        for view, look in drawn:
            s, own = _converted(view, name, units)
            edge = look | {"marker": "^", "gid": f"{look['gid']} beyond"}
            for those, mark in ((own <= top, look), (own > top, edge)):
                if those.any():
                    axes[name].plot(s[those], own[those].clip(max=top), **mark, clip_on=False)


def label_impacts(axes: dict[str, Axes], seen: View, units: str) -> None:
    """Write the values of the impacts beside their marks.

    Args:
        axes: axes by name, of a figure that is laid out.
        seen: the stream.
        units: ``metric`` or ``us``.
    """
    for name in STRUCK:
        s, values = _converted(seen, name, units)
        told = (values > axes[name].get_ylim()[1]) | (values == values.max(initial=0.0)) | (len(values) <= MOST_VALUED)
        shown = [COLUMNS[name].shown(value, units) for value in seen.impacts[name].tolist()]
        top = axes[name].get_ylim()[1]
        labels = [
            Label(f"{text} ↑" if value > top else text, at, min(value, top), (1.0, 0.0))
            for at, value, text, is_told in zip(s.tolist(), values.tolist(), shown, told, strict=True)
            if is_told
        ]
        place_labels(axes[name], labels, list(_taken(axes[name])))


def _converted(seen: View, name: str, units: str) -> tuple[Array, Array]:
    """Return places and values of impacts in the units of the picture."""
    return COLUMNS["s_m"].converted(seen.impacts["s_m"], units), COLUMNS[name].converted(seen.impacts[name], units)


def _taken(panel: Axes) -> Iterator[Array]:
    """Yield the lines of a panel, and one through each text."""
    low, high = panel.get_xlim()
    for line in panel.get_lines():
        x, y = (np.asarray(values, float) for values in line.get_data())
        if line.get_transform() == panel.transData:
            yield np.stack([x, y])
    for text in panel.texts:
        if text.get_text() == IN_FLIGHT:
            middle, half = text.get_position()[0], 0.06 * (high - low)
            yield np.array([[middle - half, middle + half], [0.5 * panel.get_ylim()[1]] * 2])
