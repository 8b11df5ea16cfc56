"""Draws belts from the side: the one that the stream comes from, with its load, and the one that it goes to."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, FancyArrowPatch

from chutecalc.design import Receiver
from chutecalc.output.plots.belt_lines import is_end_on
from chutecalc.output.plots.flights import Line
from chutecalc.output.plots.style import LOAD, STEEL


def draw_feed(axes: Axes, lines: list[Line]) -> None:
    """Draw the belt that the stream comes from.

    Args:
        axes: axes to draw on.
        lines: from :mod:`~chutecalc.output.plots.belt_lines`, in the units of the axes; none without such a belt.
    """
    if not lines:
        return
    lower, upper, pulley = lines
    axes.fill(*np.concatenate([lower, upper[:, ::-1]], axis=1), color=LOAD, linewidth=0.0, zorder=0.8, gid="load")
    centre, radius = pulley.mean(axis=1), 0.5 * float(np.ptp(pulley[1]))
    axes.add_patch(Circle(tuple(centre), radius, facecolor="0.94", edgecolor=STEEL, zorder=0.85))
    axes.plot(*lower, color=STEEL, linewidth=1.2, gid="belt")
    axes.update_datalim(np.concatenate([upper, pulley], axis=1).T)


def draw_receiver(axes: Axes, lines: list[Line], receiver: Receiver | None) -> None:
    """Draw the belt that the stream goes to, as an arrow in its direction; seen end on, as a line across its width.

    Args:
        axes: axes to draw on.
        lines: from :mod:`~chutecalc.output.plots.belt_lines`, in the units of the axes; none without such a belt.
        receiver: the belt.
    """
    style = "|-|,widthA=0.3,widthB=0.3" if receiver is not None and is_end_on(receiver) else "-|>"
    look: dict[str, Any] = {"arrowstyle": style, "mutation_scale": 11.0, "shrinkA": 0.0, "shrinkB": 0.0}
    for line in lines:
        first, last = (tuple(line[:, end]) for end in (0, -1))
        axes.add_patch(FancyArrowPatch(first, last, color=STEEL, linewidth=1.6, zorder=0.85, gid="receiver", **look))
        axes.update_datalim(line.T)
