"""The small chart of a sweep: columns over its parameter."""

from dataclasses import replace

import numpy as np

from chutecalc.output.chart import CHARTED, chart_lines, terminal_width
from chutecalc.output.dataset import Block
from chutecalc.output.printer import Printer
from chutecalc.studies.sweep.axis import along, different, places
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of
from chutecalc.studies.sweep.text_parameter import TextParameter


def print_sweep_chart(printer: Printer, sweep: Sweep, block: Block) -> None:
    """Print the first two columns of numbers of a sweep over its first parameter.

    Args:
        printer: where to print, and in which units.
        sweep: a sweep over one parameter, or parallel lists.
        block: all its rows.
    """
    width = terminal_width(printer)
    parameter = along([each for each in sweep.parameters if len(each.values) > 1], sweep.parallel)
    x, x_column = places(parameter, block[parameter.name]), column_of(sweep, parameter.name)
    if isinstance(parameter, TextParameter):
        names = ", ".join(f"{place} {name}" for place, name in enumerate(different(parameter)))
        x_column = replace(x_column, heading=f"{x_column.heading}: {names}")
    order = np.argsort(x, kind="stable")
    numbers = [name for name in sweep.columns if name not in sweep.texts and np.isfinite(block[name]).any()]
    for name in numbers[: len(CHARTED)] if width else ():
        column = column_of(sweep, name)
        values = column.converted(block[name][order], printer.units)
        printer.text()
        for line in chart_lines(x[order], values, column, width, printer.units, x_column):
            printer.text(line)
