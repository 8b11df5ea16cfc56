"""The small chart of a sweep: columns over its parameter."""

import numpy as np

from chutecalc.output.chart import CHARTED, chart_lines, terminal_width
from chutecalc.output.dataset import Block
from chutecalc.output.table import Printer
from chutecalc.studies.sweep.block import TEXT
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of


def print_sweep_chart(printer: Printer, sweep: Sweep, block: Block) -> None:
    """Print the first two columns of numbers of a sweep over its first parameter.

    Args:
        printer: where to print, and in which units.
        sweep: a sweep over one parameter, or parallel lists.
        block: all its rows.
    """
    width = terminal_width(printer)
    x_name = next(each.name for each in sweep.parameters if len(each.values) > 1)
    order = np.argsort(block[x_name], kind="stable")
    numbers = [name for name in sweep.columns if name not in TEXT and np.isfinite(block[name]).any()]
    for name in numbers[: len(CHARTED)] if width else ():
        column = column_of(sweep, name)
        values = column.converted(block[name][order], printer.units)
        printer.text()
        for line in chart_lines(block[x_name][order], values, column, width, printer.units, column_of(sweep, x_name)):
            printer.text(line)
