"""The style of pictures: readable in print, without colour, and by people with colour vision deficiency."""

import re
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import IO, Any

import matplotlib
import numpy as np
from matplotlib import style
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from chutecalc.output.plots.letters import make_printable, wide_fonts
from chutecalc.results.column import Column

MAP = "viridis"
"""Colour map, perceptually uniform: lightness grows with the values, also in print without colour."""
DARKEST, LIGHTEST = 0.0, 0.8
"""Range of the colour map that stands out as a line on white paper."""
INK, STEEL, PALE, LOAD, SHADE = "0.15", "0.35", "0.6", "0.82", "0.95"
"""Greys: of lines and text, surfaces, marks, a load that the model does not follow, and flights in panels."""
STROKES: tuple[Any, ...] = ("-", "--", "-.", ":", (0, (6, 1.5, 1, 1.5, 1, 1.5)), (0, (9, 2)))
MARKS = ("o", "s", "^", "D", "v", "P", "X", "<")
SMALL, TITLE = 7.5, 11.0
"""Sizes of letters, points."""
_STYLE = {
    "axes.axisbelow": True,
    "axes.grid": True,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 9.5,
    "figure.constrained_layout.use": True,
    "figure.titlesize": TITLE,
    "font.size": 8.5,
    "grid.color": "0.9",
    "grid.linewidth": 0.6,
    "hatch.linewidth": 0.5,
    "legend.fontsize": SMALL,
    "legend.frameon": False,
    "legend.handlelength": 3.0,
    "lines.linewidth": 1.5,
    "lines.markersize": 4.0,
    "pdf.fonttype": 42,  # text stays text
    "savefig.dpi": 200,
    "svg.hashsalt": "chutecalc",  # the same names each time
    "text.parse_math": False,  # a dollar sign in text of a user is a dollar sign
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
}


@contextmanager
def styled() -> Iterator[None]:
    """Set the style of all pictures, whatever the settings of the user. Draw and save in it.

    A letter that no font has is drawn as a box, without a warning.
    """
    families = {"font.family": ["sans-serif", *wide_fonts()]}
    with style.context(["default", _STYLE, families]), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing")
        yield


def lay_out(figure: Figure) -> None:
    """Lay out a figure without drawing it, so that positions and sizes on the page are known.

    Args:
        figure: the figure.
    """
    make_printable(figure)
    engine = figure.get_layout_engine()
    assert engine is not None
    engine.execute(figure)
    for axes in figure.axes:
        axes.apply_aspect()


class _RoundedLayout(ConstrainedLayoutEngine):
    """Matplotlib's layout, with axes at rounded places.

    Its solver adds in the order of addresses in memory. The last digits of what it finds change from run to run, and
    with them names in an SVG.
    """

    def execute(self, fig: Figure) -> None:
        super().execute(fig)
        for axes in fig.axes:
            axes.set_position(np.round(axes.get_position(original=True).bounds, 6).tolist())
            axes.set_in_layout(True)  # until the next execution; a place that is set takes axes out


def write(figure: Figure, stream: IO[bytes], ending: str, metadata: Mapping[str, Any]) -> None:
    """Write a figure in the style of all pictures.

    Args:
        figure: the figure.
        stream: where it goes.
        ending: its format, as the ending of a file.
        metadata: of the format, as Matplotlib takes them.
    """
    with styled():
        make_printable(figure)
        figure.set_layout_engine(_RoundedLayout())
        figure.savefig(stream, format=ending, metadata=dict(metadata))


def colours(count: int, name: str = MAP, darkest: float = DARKEST, lightest: float = LIGHTEST) -> list[str]:
    """Return colours that differ in lightness too.

    Args:
        count: number of colours.
        name: of the colour map.
        darkest, lightest: range of the map that is used, shares of its length.

    >>> colours(2)
    ['#440154', '#7ad151']
    """
    shares = np.linspace(darkest, lightest, count) if count != 1 else [darkest]
    return [to_hex(matplotlib.colormaps[name](share)) for share in shares]


def mathematical(text: str) -> str:
    r"""Return a label with its subscripts marked for Matplotlib.

    Args:
        text: a label, with subscripts after an underscore.

    >>> mathematical("equivalent friction μ_e")
    'equivalent friction μ$_{\\mathrm{e}}$'
    """
    return re.sub(r"_(\w+)", r"$_{\\mathrm{\1}}$", text)


def label_axes(axes: Axes, x: Column, y: Column, units: str) -> None:
    """Label both axes with name, symbol and unit.

    Args:
        axes: axes to label.
        x: column of the horizontal axis.
        y: column of the vertical axis.
        units: ``metric`` or ``us``.
    """
    axes.set_xlabel(mathematical(x.label(units)), parse_math=True)
    axes.set_ylabel(mathematical(y.label(units)), parse_math=True)


def parts_of(title: str) -> list[str]:
    """Return the parts of a title, which commas, colons and semicolons separate, with a space behind.

    Args:
        title: a title.

    >>> parts_of("Spoon: coal, 1,200 t/h")
    ['Spoon', 'coal', '1,200 t/h']
    """
    return [part.strip() for part in re.split(r"[,:;]\s+", title)]


def labels_of(titles: Sequence[str]) -> tuple[list[tuple[str, ...]], str]:
    """Return the parts in which titles differ, as labels, and the parts that all of them share, as text.

    Parts are separated by commas, colons and semicolons, with a space behind.

    Args:
        titles: titles of several chutes.

    >>> labels_of(["Spoon: R = 1 m, square", "Spoon: R = 2 m, square"])
    ([('R = 1 m',), ('R = 2 m',)], 'Spoon, square')
    """
    split = [parts_of(title) for title in titles]
    shared = [part for part in split[0] if all(part in title for title in split)]
    parts = [tuple(part for part in title if part not in shared) for title in split]
    if all(parts) and len(set(parts)) == len(parts):
        return parts, ", ".join(shared)
    return [(title,) for title in titles], ""


def looks(labels: Sequence[tuple[str, ...]]) -> list[dict[str, Any]]:
    """Return the look of each line of a family, for Matplotlib.

    The first part of a label sets colour and marker, the rest sets the stroke. If no label has a rest, or there are
    more rests than strokes, the whole label sets all three.

    Args:
        labels: label of each line, in parts.

    >>> pairs = looks([("R = 1 m", "square"), ("R = 1 m", "chamfered"), ("R = 2 m", "square")])
    >>> [look["linestyle"] for look in pairs], pairs[0]["color"] == pairs[1]["color"]
    (['-', '--', '-'], True)
    """
    if len({label[1:] for label in labels}) > len(STROKES):
        labels = [(", ".join(label),) for label in labels]
    firsts = list(dict.fromkeys(label[0] for label in labels))
    rests = list(dict.fromkeys(label[1:] for label in labels))
    shades = colours(len(firsts))
    return [
        {
            "color": shades[firsts.index(label[0])],
            "marker": MARKS[firsts.index(label[0]) % len(MARKS)],
            "linestyle": STROKES[(rests.index(label[1:]) if len(rests) > 1 else firsts.index(label[0])) % len(STROKES)],
        }
        for label in labels
    ]
