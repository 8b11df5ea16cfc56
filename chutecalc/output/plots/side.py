"""A chute from the side, to scale: its surfaces, and the stream at its depth, coloured by velocity."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch

from chutecalc.output.plots.style import INK, MAP, PALE, SMALL, STEEL
from chutecalc.output.plots.traces import Lines, Trace, deepest, extent, lost_flights, surfaces
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

SHORT = 0.08
"""Share of the picture below which a segment has no name in it. Marks closer than half of it are drawn together."""
ROOM = 0.09
"""Margin for names and numbers, over the greater side of the picture."""
SURFACE: dict[str, Any] = {
    "color": STEEL,
    "linewidth": 3.0,
    "solid_capstyle": "butt",
    "zorder": 0.9,  # below the stream, which hides its inner half
    "gid": "surface",
}
END: dict[str, Any] = {"marker": "X", "color": INK, "markersize": 8, "linestyle": "", "clip_on": False, "gid": "end"}
"""Look of the point where a stream ends before the chute does."""


class Mark(NamedTuple):
    """A number at a distance along the stream."""

    number: str
    s: float


def draw_stream(axes: Axes, solution: SolvedChute, stream: Sequence[Trace], marks: Sequence[Mark], units: str) -> None:
    """Draw the chute and the stream of its first design.

    Args:
        axes: axes to draw on.
        solution: solution of one design.
        stream: traces of its stream.
        marks: numbers to set beside the stream.
        units: ``metric`` or ``us``.
    """
    velocity = np.concatenate([part.columns["velocity_m_s"] for part in stream])
    column = COLUMNS["velocity_m_s"]
    shades = Normalize(*column.converted(np.array([velocity.min(), velocity.max()]), units))
    drawn = list(surfaces(solution))
    for part in stream:
        values = column.converted(part.columns["velocity_m_s"], units)
        draw = _draw_flight if part.side == 0.0 else _draw_band
        draw(axes, part, deepest(solution, stream), units).set(
            array=0.5 * (values[1:] + values[:-1]), cmap=MAP, norm=shades
        )
    for x, z in drawn:
        axes.plot(_long(x, units), _long(z, units), **SURFACE)
    for x, z in lost_flights(solution, drawn):
        axes.plot(_long(x, units), _long(z, units), color=INK, linestyle=":", gid="missed")
    _draw_pulley(axes, solution, units)
    size = float(extent(solution, stream).max())
    _name_segments(axes, stream, SHORT * size, units)
    _draw_marks(axes, stream, marks, SHORT * size, units)
    if not solution.ok[0]:
        end = stream[-1].columns
        axes.plot(_long(end["x_m"][-1:], units), _long(end["z_m"][-1:], units), **END)
    _frame(axes, shades, any(part.side == 0.0 for part in stream), units)


def _long(metres: Array, units: str) -> Array:
    """Return lengths in the unit of the picture."""
    converted: Array = COLUMNS["x_m"].converted(metres, units)
    return converted


def _draw_band(axes: Axes, part: Trace, depth: float, units: str) -> PolyCollection:
    """Draw the stream on a surface, with its depth normal to it."""
    at = part.columns
    height = np.minimum(at["depth_m"], depth)  # none where the stream has come to rest
    slope = np.radians(at["slope_deg"])
    foot = np.stack([at["x_m"], at["z_m"]], axis=1)
    normal = np.stack([np.sin(slope), np.cos(slope)], axis=1)
    top = foot + part.side * height[:, None] * normal
    foot, top = _long(foot, units), _long(top, units)
    cells = np.stack([foot[:-1], foot[1:], top[1:], top[:-1]], axis=1)
    band = PolyCollection(list(cells), edgecolors="face", linewidths=0.4, gid="stream")
    axes.add_collection(band)
    axes.plot(*top.T, color=INK, linewidth=0.4, gid="free surface")
    return band


def _draw_flight(axes: Axes, part: Trace, depth: float, units: str) -> LineCollection:
    """Draw the path of a stream in flight. The model has no depth there."""
    path = _long(np.stack([part.columns["x_m"], part.columns["z_m"]], axis=1), units)
    axes.plot(*path.T, color=INK, linewidth=3.0, solid_capstyle="butt", gid="path")
    line = LineCollection(
        list(np.stack([path[:-1], path[1:]], axis=1)), linewidths=1.8, capstyle="projecting", gid="flight"
    )
    axes.add_collection(line)
    return line


def _draw_pulley(axes: Axes, solution: SolvedChute, units: str) -> None:
    """Draw the head pulley and a piece of its belt."""
    belt = solution.design.belt
    if belt is None:
        return
    radius, incline = belt.lower_radius[0], belt.incline[0]
    centre = np.array([belt.centre[0][0], belt.centre[1][0]])
    top = centre + radius * np.array([-np.sin(incline), np.cos(incline)])
    back = top - 3.0 * radius * np.array([np.cos(incline), np.sin(incline)])
    axes.add_patch(Circle(tuple(_long(centre, units)), float(_long(radius, units)), facecolor="0.94", edgecolor=STEEL))
    axes.plot(*_long(np.stack([back, top]), units).T, color=STEEL, linewidth=1.2, gid="belt")


def _name_segments(axes: Axes, stream: Sequence[Trace], least: float, units: str) -> None:
    """Write names beside the middle of each trace that is long enough, on the side away from the stream."""
    for part in stream:
        at = part.columns
        if np.ptp(at["s_m"]) > least:
            _set_beside(axes, at, len(at["s_m"]) // 2, -part.side or 1.0, part.name, units)


def _draw_marks(axes: Axes, stream: Sequence[Trace], marks: Sequence[Mark], least: float, units: str) -> None:
    """Write the numbers, those of neighbours together."""
    at = {name: np.concatenate([part.columns[name] for part in stream]) for name in ("s_m", "x_m", "z_m", "slope_deg")}
    sides = np.concatenate([np.full(len(part.columns["s_m"]), part.side) for part in stream])
    groups: list[list[Mark]] = []
    for mark in sorted(marks, key=lambda mark: mark.s):
        if groups and mark.s - groups[-1][0].s < 0.5 * least:
            groups[-1].append(mark)
        else:
            groups.append([mark])
    box = {"boxstyle": "round,pad=0.25", "facecolor": "white", "edgecolor": INK, "linewidth": 0.7}
    for group in groups:
        station = int(np.abs(at["s_m"] - group[0].s).argmin())
        text = ", ".join(sorted(mark.number for mark in group))
        _set_beside(axes, at, station, -sides[station] or 1.0, text, units, distance=21.0, bbox=box)


def _set_beside(
    axes: Axes, at: Lines, station: int, side: float, text: str, units: str, distance: float = 9.0, **look: Any
) -> None:
    """Write text at a distance, in points, from a station of the stream, along the normal there."""
    slope = np.radians(at["slope_deg"][station])
    right, up = side * np.sin(slope), side * np.cos(slope)
    axes.annotate(
        text,
        (_long(at["x_m"][station], units), _long(at["z_m"][station], units)),
        xytext=(distance * right, distance * up),
        textcoords="offset points",
        ha="center" if abs(right) < 0.4 else "left" if right > 0.0 else "right",
        va="center" if abs(up) < 0.4 else "bottom" if up > 0.0 else "top",
        color=INK,
        fontsize=SMALL,
        **look,
    )


def _frame(axes: Axes, shades: Normalize, flies: bool, units: str) -> None:
    """Set the scale, and add colour bar and legend."""
    low, high = axes.dataLim.get_points()
    room = ROOM * (high - low).max()
    axes.update_datalim([low - room, high + room])
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.0)
    bands = [artist for artist in axes.collections if artist.get_array() is not None]
    bar = axes.figure.colorbar(bands[0], ax=axes, location="right", aspect=45, pad=0.01)
    column = COLUMNS["velocity_m_s"]
    bar.ax.set_title(f"{column.symbol}, {column.unit_text(units)}", fontsize=SMALL, loc="center")
    handles: list[Any] = [Line2D([], [], color=STEEL, linewidth=2.2, label="surface")]
    handles.append(Patch(facecolor=PALE, edgecolor=INK, linewidth=0.7, label="stream at its depth"))
    if flies:
        handles.append(Line2D([], [], color=INK, linewidth=3.0, label="in flight (path only)"))
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.2)
