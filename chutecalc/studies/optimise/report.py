"""An optimum for people."""

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.output.printer import COLOURS, Printer
from chutecalc.output.table import heading
from chutecalc.results.finding import Severity
from chutecalc.studies.found_report import cell_text, found_table
from chutecalc.studies.optimise.optimise import Optimum


def print_optimum(printer: Printer, found: Optimum) -> None:
    """Print what is best, what binds there, and how flat it is; or the front of two objectives.

    Args:
        printer: where to print, and in which units.
        found: the optimum.
    """
    chute = found.chute
    printer.text(chute.spec.title or chute.source, style="bold")
    wanted = ", ".join(f"{'least' if each.sign > 0 else 'largest'} {each.column}" for each in found.objectives)
    subject = f", subject to {', '.join(limit.text for limit in found.limits)}" if found.limits else ""
    where = f", worst of {', '.join(found.states)}" if len(found.states) > 1 else ""
    printer.text(f"{chute.source}: {wanted}{where}{subject}")
    printer.text()
    if not found.feasible:
        printer.text("no feasible design within the bounds; this one lacks least:", style=COLOURS[Severity.FAILURE])
        printer.text()
    printer.table(found_table(found, printer.units))
    if not found.feasible:
        return
    printer.text()
    if found.answers:
        printer.table(_keys_table(found))
        printer.text()
    for number, bound in enumerate(found.binding, 1):
        point = f"solution {number}: " if found.count > 1 else ""
        for each in bound:
            state = f" in {each.state}" if len(found.states) > 1 and each.state else ""
            objective = found.objectives[0].column
            known = not np.isnan(each.price)
            price = f": {objective} changes by {each.price:.4g} for each 1 that it is moved up" if known else ""
            printer.text(f"{point}{each.limit} binds{state}{price}")
        if not bound and found.count == 1:
            printer.text("no limit binds")


def _keys_table(found: Optimum) -> Grid:
    """Return what is said of each key."""
    table = Grid("keys at the optimum")
    for text in ("key", "best", "on bound", "slope of\nobjective", "within 1 %\nof the best"):
        table.column(text, left=text in ("key", "on bound") or "within" in text, label=text == "key")
    for name, answer in found.answers.items():
        column = found.columns[name]
        reach = [cell_text(column, value, "metric") for value in answer.range]
        span = " to ".join(reach) if answer.range and isinstance(answer.range[0], float) else ", ".join(reach)
        slope = "" if np.isnan(answer.slope) else f"{answer.slope:z.4g}"
        words = heading(column, "metric").replace("\n", " ")
        table.row([words, cell_text(column, answer.value, "metric"), answer.bound, slope, span])
    return table
