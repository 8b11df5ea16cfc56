"""The looks of what pictures of chutes are made of, for Matplotlib; their ``gid`` names them in the picture."""

from typing import Any

from chutecalc.output.plots.style import INK, PALE, STEEL

SURFACE: dict[str, Any] = {
    "color": STEEL,
    "linewidth": 3.0,
    "solid_capstyle": "butt",
    "zorder": 0.9,  # below the stream, which hides its inner half
    "gid": "surface",
}
ROOF: dict[str, Any] = {"color": STEEL, "linewidth": 1.4, "zorder": 0.9, "gid": "roof"}
WALLS: dict[str, Any] = {"color": PALE, "linewidth": 0.7, "linestyle": (0, (8, 2)), "zorder": 0.7, "gid": "walls"}
"""Looks of what is above a floor: the roof of a closed section, and the top of the walls of an open one."""
END: dict[str, Any] = {"marker": "X", "color": INK, "markersize": 8, "linestyle": "", "clip_on": False, "gid": "end"}
"""Look of the point where a stream ends before the chute does."""
STRUCK: dict[str, Any] = {
    "marker": "o",
    "color": "white",
    "markeredgecolor": INK,
    "markersize": 4.5,
    "linestyle": "",
    "zorder": 3.0,
    "gid": "impact",
}
"""Look of a point where the stream strikes a surface."""
MISSED: dict[str, Any] = {"color": INK, "linestyle": ":", "linewidth": 1.2, "gid": "missed"}
EDGE: dict[str, Any] = {"color": INK, "linewidth": 0.5}
