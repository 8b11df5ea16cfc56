"""Small charts on a terminal, such as velocity and depth along the stream of a run."""

import numpy as np

from chutecalc.output.table import Printer
from chutecalc.physics.arrays import Array
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute

CHARTED = ("velocity_m_s", "depth_m")
NARROWEST, WIDEST = 60, 120
"""Columns of a terminal: with fewer there is no chart, and more are not used."""
PIPED = 80
"""Columns where there is no terminal."""
HEIGHT = 10
TICK, BESIDE = 10, 23
"""Columns of the library's tick labels, and of all that stands beside a chart."""
STEPS = np.array([1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0])
"""Of the ticks, times a power of ten."""
EMPTY = " \u2800"
"""A blank, and one of Braille."""
STEEP = 12.0
"""What is more than so many times its median is cut there, as in pictures."""


def print_chart(printer: Printer, solution: SolvedChute) -> None:
    """Prints velocity and depth along the stream, or that there is no room for them.

    Args:
        printer: to print with, in its units.
        solution: of one design.
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
    """Columns of a chart; 0, and a word on that, where there is no room."""
    width = min(printer.console.width, WIDEST) if printer.is_terminal else PIPED
    if width < NARROWEST:
        printer.text(f"no chart: it takes {NARROWEST} columns, and there are {width}")
        return 0
    return width


def chart_lines(s: Array, values: Array, column: Column, width: int, units: str, along: Column) -> list[str]:
    """The lines of one chart, without colour."""
    import plotille

    known = np.isfinite(values)
    figure = plotille.Figure()
    figure.width, figure.height, figure.with_colors = width - BESIDE, HEIGHT, False
    figure.x_label, figure.y_label = f"{along.symbol or along.heading}, {along.unit_text(units)}", ""
    digits = column.us_digits if units == "us" and column.us_unit else column.digits
    figure.x_ticks_fkt = lambda low, _: f"{low:.1f}"
    figure.y_ticks_fkt = lambda low, _: f"{low:{TICK}.{digits}f}"
    reached = s[np.isfinite(s)]
    low = 0.0 if along is COLUMNS["s_m"] else float(reached.min())
    figure.set_x_limits(low, max(float(reached.max()), low + 1e-9))
    figure.set_y_limits(0.0, _top(values[known]))
    for run in np.split(np.arange(len(s)), np.flatnonzero(np.diff(known.astype(int))) + 1):
        if known[run[0]]:
            figure.plot(s[run].tolist(), values[run].tolist())
    first, *lines = figure.show(legend=False).splitlines()
    return [f"{'':{first.index('^')}}{column.label(units)}", *(line.rstrip(EMPTY) for line in lines)]


def _top(values: Array) -> float:
    """The upper end of the axis: a round number of times its ticks."""
    step = max(float(min(values.max(), STEEP * np.median(values))), 1e-9) / HEIGHT
    power = 10.0 ** np.floor(np.log10(step))
    return float(HEIGHT * power * STEPS[np.searchsorted(STEPS, step / power * (1.0 - 1e-9))])
