"""Text that fits: how wide it is, lines of a width, and columns of a legend."""

import textwrap
from collections.abc import Sequence

from matplotlib.textpath import TextPath

from chutecalc.output.plots.style import SMALL
from chutecalc.printable import printable

CHARACTER_WIDTH = 0.6
"""Width of a character over its height, about."""
LEGEND_LINE = 6.0
"""Width of a line, and of the gaps beside it and its label, in a legend; over the size of its letters."""
LINE_HEIGHT = 0.17
"""Height of a line of small text, inches."""
POINTS = 72.0
"""Points in an inch."""


def width_of(text: str, size: float = SMALL) -> float:
    """Return the width of a line of text, points.

    Args:
        text: without line breaks.
        size: of its letters, points.
    """
    return float(TextPath((0.0, 0.0), printable(text), size=size).get_extents().width) if text.strip() else 0.0


def fitted(text: str, width: float, size: float = SMALL, most: int = 0, indent: str = "") -> str:
    """Return text in lines that fit into a width.

    Args:
        text: the text.
        width: of the lines, inches.
        size: of its letters, points.
        most: number of lines from which on the rest is cut off; 0 for no bound.
        indent: what stands before all lines but the first.

    >>> fitted("one two three", 0.6, most=1)
    'one two …'
    """
    characters = max(8, int(width * POINTS / (CHARACTER_WIDTH * size)))
    bound = most or None
    return "\n".join(textwrap.wrap(text, characters, subsequent_indent=indent, max_lines=bound, placeholder=" …"))


def legend_columns(labels: Sequence[str], width: float) -> int:
    """Return how many columns of labels, each with its line beside it, fit on a picture.

    Args:
        labels: the labels, of one line or several.
        width: of the picture, inches.
    """
    widest = max((width_of(line) for label in labels for line in label.split("\n")), default=0.0)
    return max(1, int(width * POINTS / (widest + LEGEND_LINE * SMALL)))


def legend_rows(labels: Sequence[str], columns: int) -> int:
    """Return how many lines of text a legend takes.

    Args:
        labels: the labels.
        columns: number of columns, which it fills one after the other.
    """
    deep = -(-len(labels) // columns)
    return max(
        sum(label.count("\n") + 1 for label in labels[first : first + deep]) for first in range(0, len(labels), deep)
    )
