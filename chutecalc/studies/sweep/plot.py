"""The picture of a sweep: lines over one parameter, one for each value of a second, or contours over two."""

import re
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from chutecalc.fields.units import same_quantity
from chutecalc.output.dataset import Block
from chutecalc.output.plots.style import SMALL, TITLE, parts_of, styled
from chutecalc.output.plots.text import LINE_HEIGHT, fitted
from chutecalc.results.described import status_words
from chutecalc.spec.paths import value_at
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.plot_contours import draw_contours, finite
from chutecalc.studies.sweep.plot_lines import draw_lines, given
from chutecalc.studies.sweep.plot_status import handles
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of

MOST_LINES = 8
"""Most values of a second parameter that are drawn as lines; more are drawn as contours."""
MOST_PANELS = 6
"""Most columns that are drawn."""
WIDTH, HEIGHT = 4.6, 3.3
"""Size of a panel, inches."""
MOST_ROWS = 16
"""Most entries of the legend one below the other."""


def draw_sweep(sweep: Sweep, block: Block, units: str = "metric") -> Figure:
    """Draw the columns of a sweep.

    Args:
        sweep: a sweep over one or two parameters of several values, or parallel lists.
        block: all its rows.
        units: ``metric`` or ``us``. A varied quantity stays in the unit in which it was given.

    Returns:
        The figure: a panel for each column of numbers that varies, by the column's name.
    """
    with styled():
        varied = [each for each in sweep.parameters if len(each.values) > 1]
        numbers = [each for each in varied if isinstance(each, Parameter)]
        names = _varying(sweep, block)
        shown = names[:MOST_PANELS]
        across = 1 if len(shown) == 1 else 2
        down = -(-len(shown) // across)
        width = max(WIDTH * across, 6.0)
        title = fitted(picture_title(sweep), width, TITLE)
        figure = Figure(figsize=(width, HEIGHT * down + 0.6 + 1.5 * LINE_HEIGHT * title.count("\n")))
        panels = [figure.add_subplot(down, across, k + 1) for k in range(len(shown))]
        figure.suptitle(title, x=0.01, ha="left")
        lines = sweep.parallel or len(numbers) < 2 or min(len(each.values) for each in numbers) <= MOST_LINES
        for axes, name in zip(panels, shown, strict=True):
            axes.set_gid(name)
            (draw_lines if lines else draw_contours)(axes, sweep, varied, block, column_of(sweep, name), units)
        named = panels[0].get_legend_handles_labels()[0] if len(varied) > 1 and not sweep.parallel else []
        explained = [*named, *handles(block, lines)]
        if explained:
            figure.legend(handles=explained, loc="outside right upper", ncols=-(-len(explained) // MOST_ROWS))
        note = fitted(_note(sweep, block, len(shown), len(names)), width)
        figure.supxlabel(note, x=0.01, ha="left", fontsize=SMALL)
        return figure


def picture_title(sweep: Sweep) -> str:
    """Return the title of a spec without the parts that state what is varied, and what that is.

    Args:
        sweep: the sweep.

    >>> import chutecalc
    >>> chute = chutecalc.parse(chutecalc.STARTER.replace("Fall and spoon,", "Spoon: R = 3 m,"))
    >>> radius = "segments.spoon.radius_m"
    >>> picture_title(Sweep(chute, [Parameter(radius, (radius,), np.array([2.0, 3.0]))]))
    'Spoon, coal — varied: spoon radius'
    """
    title = sweep.chute.spec.title or sweep.chute.source
    held = [value for each in sweep.parameters for path in each.paths for value in _held(sweep, path)]
    parts = parts_of(title)
    kept = [part for part in parts if not any(_states(part, value) for value in held)]
    name = title if kept == parts else ", ".join(kept)
    varied = [column_of(sweep, each.name) for each in sweep.parameters if len(each.values) > 1]
    what = [f"{column.dimension} {column.heading}" if column.symbol else column.heading for column in varied]
    return " — ".join(filter(None, [name, f"varied: {', '.join(what)}"]))


def _held(sweep: Sweep, path: str) -> list[Any]:
    """Return the values that the spec has for a quantity that is varied, in whatever unit it is given."""
    table, _, key = path.rpartition(".")
    values = [value_at(sweep.chute.data, f"{table}.{name}") for name in same_quantity(key)]
    return [value for value in values if isinstance(value, int | float | str)]


def _states(part: str, value: Any) -> bool:
    """Return whether a part of a title states a value."""
    if isinstance(value, str):
        return value in part.split()
    numbers = re.findall(r"\d[\d,]*(?:\.\d+)?", part)
    return any(float(number.replace(",", "")) == value for number in numbers)


def _varying(sweep: Sweep, block: Block) -> list[str]:
    """Return the columns of numbers that vary, or else the first column."""
    numbers = [name for name in sweep.columns if name not in sweep.texts]
    differ = [name for name in numbers if np.ptp(finite(block[name])) > 1e-9 * np.abs(finite(block[name])).max()]
    found: list[str] = []
    for name in differ or numbers[:1]:
        if not any(np.array_equal(block[name], block[other], equal_nan=True) for other in found):
            found.append(name)
    return found


def _note(sweep: Sweep, block: Block, shown: int, count: int) -> str:
    """Return how the designs end, what does not vary, and what is not drawn, as text."""
    statuses, counts = np.unique(block["status"], return_counts=True)
    ends = ", ".join(f"{number:,} {status_words(status)}" for status, number in zip(statuses, counts, strict=True))
    single = [given(sweep, each, each.values.tolist()[0]) for each in sweep.parameters if len(each.values) == 1]
    constant = [f"constant {sweep.keep}"] if sweep.is_adjusted else []
    rest = [f"drawn are {shown} of {count} columns that vary: choose with --columns"] if count > shown else []
    return "; ".join([f"{sweep.count:,} designs: {ends}", *constant, *single, *rest])
