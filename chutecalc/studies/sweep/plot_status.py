"""How pictures of sweeps show designs that fail: a mark or a hatching for each status."""

from typing import Any, NamedTuple

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from chutecalc.design import Status
from chutecalc.output.plots.style import INK, SHADE
from chutecalc.results.described import status_words


class Look(NamedTuple):
    """How one status is shown."""

    marker: str
    hatch: str


LOOKS = {
    Status.LABELS[Status.STALL]: Look("x", "////"),
    Status.LABELS[Status.CHOKE]: Look("+", "++"),
    Status.LABELS[Status.CONTACT_LOST]: Look("2", "\\\\\\\\"),
    Status.LABELS[Status.MISSED]: Look("|", "||||"),
    Status.IMPOSSIBLE_LABEL: Look(".", ".."),
}
"""Looks by status, for all that a design may end with but ``ok``."""


def failed(block: Any) -> list[str]:
    """Return the statuses of designs that fail or are impossible, in the order of :data:`LOOKS`.

    Args:
        block: rows of a sweep.

    >>> failed({"status": np.array(["ok", "choke", "stall"])})
    ['stall', 'choke']
    """
    return [status for status in LOOKS if (np.asarray(block["status"]) == status).any()]


def handles(block: Any, lines: bool) -> list[Any]:
    """Return what a legend shows for the designs that fail.

    Args:
        block: rows of a sweep.
        lines: whether they are marked above lines; else hatched.
    """
    if lines:
        return [
            Line2D([], [], color=INK, marker=LOOKS[status].marker, linestyle="", label=status_words(status))
            for status in failed(block)
        ]
    look: dict[str, Any] = {"facecolor": SHADE, "edgecolor": INK, "linewidth": 0.5}
    return [Patch(hatch=LOOKS[status].hatch, label=status_words(status), **look) for status in failed(block)]
