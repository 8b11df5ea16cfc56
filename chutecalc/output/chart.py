"""Small charts for terminals, such as velocity and depth along the stream of a run."""

import numpy as np

from chutecalc.output.printer import Printer
from chutecalc.physics.arrays import Array
from chutecalc.results.column import Column, Units
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

CHARTED = ("velocity_m_s", "depth_m")
"""Columns of a run's charts."""
MIN_WIDTH, MAX_WIDTH = 60, 120
"""Widths of a chart, characters. A narrower terminal has no chart, and a wider one is not filled."""
HEIGHT = 10
"""Height of a chart, lines."""
TICK_WIDTH, MARGIN = 10, 23
"""Width of the library's tick labels, and of everything beside a chart, characters."""
STEPS = np.array([1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0])
"""Steps of the ticks, times a power of ten."""
BLANKS = " \u2800"
"""The ordinary blank and that of Braille."""
CUT_OFF = 12.0
"""Values above this multiple of their median are cut off, as in pictures."""


def print_chart(printer: Printer, solution: SolvedChute) -> None:
    """Print velocity and depth along the stream.

    Args:
        printer: where to print, and in which units.
        solution: solution of one design.
    """
    width = terminal_width(printer)
    if not width:
        return
    stations = solution.stations(points=width)
    s = COLUMNS["s_m"].converted(stations["s_m"][0], printer.units)
    for name in CHARTED:
        values = COLUMNS[name].converted(stations[name][0], printer.units)
        if np.isfinite(values).any():
            for line in chart_lines(s, values, COLUMNS[name], width, printer.units, COLUMNS["s_m"]):
                printer.text(line)


def terminal_width(printer: Printer) -> int:
    """Return the width of a chart, characters. If the terminal is too narrow, say so and return 0.

    Args:
        printer: where the chart goes.
    """
    width = min(printer.width, MAX_WIDTH)
    if width < MIN_WIDTH:
        printer.text(f"no chart: it needs {MIN_WIDTH} columns, and the terminal has {width}")
        return 0
    return width


def chart_lines(x: Array, values: Array, column: Column, width: int, units: str, x_column: Column) -> list[str]:
    """Return the lines of one chart, without colour.

    Args:
        x: horizontal coordinates, in the units shown.
        values: vertical coordinates, in the units shown; NaN leaves a gap.
        column: the column of ``values``.
        width: width of the chart, characters.
        units: ``metric`` or ``us``.
        x_column: the column of ``x``.
    """
    import plotille

    known = np.isfinite(values)
    figure = plotille.Figure()
    figure.width, figure.height, figure.with_colors = width - MARGIN, HEIGHT, False
    x_words = (x_column.symbol or x_column.heading, x_column.unit_text(units))
    figure.x_label, figure.y_label = ", ".join(filter(None, x_words)), ""
    digits = column.us_digits if units == Units.US and column.us_unit else column.digits
    figure.x_ticks_fkt = lambda low, _: f"{low:z.1f}"
    figure.y_ticks_fkt = lambda low, _: f"{low:z{TICK_WIDTH}.{digits}f}"
    reached = x[np.isfinite(x)]
    low = 0.0 if x_column is COLUMNS["s_m"] else float(reached.min())
    figure.set_x_limits(low, max(float(reached.max()), low + 1e-9 * max(abs(low), 1.0)))
    bottom, top = -_top(-values[known]) if (values[known] < 0.0).any() else 0.0, _top(values[known])
    figure.set_y_limits(bottom, top)
    # The library draws a line dot by dot, those outside of the chart too: so no value lies far outside of it.
    values = np.clip(values, bottom - (top - bottom), top + (top - bottom))
    for run in np.split(np.arange(len(x)), np.flatnonzero(np.diff(known.astype(int))) + 1):
        if known[run[0]]:
            figure.plot(x[run].tolist(), values[run].tolist())
    first, *lines = figure.show(legend=False).splitlines()
    return [f"{'':{first.index('^')}}{column.label(units)}", *(line.rstrip(BLANKS) for line in lines)]


def _top(values: Array) -> float:
    """Return the upper end of the axis, a multiple of a round step; it is 0 or more."""
    above = values[values > 0.0]
    step = max(float(min(above.max(), CUT_OFF * np.median(above))) if above.size else 0.0, 1e-9) / HEIGHT
    power = 10.0 ** np.floor(np.log10(step))
    return float(HEIGHT * power * STEPS[np.searchsorted(STEPS, step / power * (1.0 - 1e-9))])
