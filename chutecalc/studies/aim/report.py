"""An aim for people."""

from chutecalc.output.printer import COLOURS, Printer
from chutecalc.results.finding import Severity
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.aim.aim import Aim
from chutecalc.studies.found_report import found_table


def print_aim(printer: Printer, found: Aim) -> None:
    """Print what was wanted, and all solutions or the design that comes closest.

    Args:
        printer: where to print, and in which units.
        found: the aim.
    """
    chute, (state,) = found.chute, found.states
    printer.text(chute.spec.title or chute.source, style="bold")
    wanted = ", ".join(f"{name} = {value:.12g}" for name, value in found.targets.items())
    case = "" if state == DESIGN_POINT else f", case {state}"
    bounds = ", ".join("{} {:.6g} to {:.6g}".format(key.name, *key.bounds) for key in found.keys)
    printer.prose(f"{chute.source}{case}: {wanted} by {bounds}")
    printer.text()
    if found.count:
        printer.table(found_table(found, printer.units))
        printer.text()
        printer.text(f"{found.count} solution{'s' if found.count > 1 else ''} within the bounds")
        return
    printer.text("no solution within the bounds", style=COLOURS[Severity.FAILURE])
    printer.prose(f"designs tried: {found.tried}")
    if found.nearest is not None:
        printer.text("the nearest that can be had:")
        printer.text()
        printer.table(found_table(found.nearest, printer.units))
