"""An optimum for people."""

import numpy as np

from chutecalc.output.grid import Grid
from chutecalc.output.printer import COLOURS, Printer
from chutecalc.output.table import heading
from chutecalc.results.finding import Severity
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.found_report import cell_text, found_table, outcome_text
from chutecalc.studies.optimise.borders import Edge
from chutecalc.studies.optimise.optimum import Optimum

MARGINS = {"stall": "min_velocity_m_s>=1", "choke": "max_fill<=0.6", "contact_lost": "min_pressure_kpa>=0.1"}
"""A limit that keeps away from a failure, by its status."""


def print_optimum(printer: Printer, found: Optimum) -> None:
    """Print what is best, which limits decide, how flat it is, and how near failures are; or a front.

    Args:
        printer: where to print, and in which units.
        found: the optimum.
    """
    chute, units = found.chute, printer.units
    printer.text(chute.spec.title or chute.source, style="bold")
    wanted = ", ".join(f"{'least' if each.sign > 0 else 'largest'} {each.column}" for each in found.objectives)
    printer.prose(f"{chute.source}: {wanted}, subject to {', '.join(found.subject)}{_states(found)}")
    printer.text()
    if not found.feasible:
        printer.prose(
            "no design within the bounds keeps all limits; this one comes closest:", style=COLOURS[Severity.FAILURE]
        )
        printer.text()
    printer.table(found_table(found, units))
    printer.text()
    if not found.feasible:
        printer.table(_violations(found))
        return
    if found.answers:
        printer.table(_keys(found))
        printer.text()
    if any(found.binding):
        printer.table(_binding(found))
    else:
        printer.text("no limit decides")
    _print_edges(printer, found)


def _states(found: Optimum) -> str:
    """Return which states count, as text; nothing for the spec as written where it has no others."""
    if len(found.states) > 1:
        return f", worst of {', '.join(found.states)}"
    (state,) = found.states
    return "" if not found.chute.cases else ", design point alone" if state == DESIGN_POINT else f", case {state} alone"


def _violations(found: Optimum) -> Grid:
    """Return the limits that are violated, the worst first."""
    table = Grid("limits violated, the worst first")
    for text in ("limit", "state"):
        table.column(text, left=True, label=True)
    table.column("value", left=True, words=True)
    table.column("beyond\nlimit by")
    for each in found.violations:
        by = "" if np.isnan(each.by) else f"{each.by:.4g}".replace("inf", "∞")
        table.row([each.limit, each.state, _value(each.value), by])
    return table


def _value(value: float | str) -> str:
    """Return the value of a column, or how a design ends."""
    return outcome_text(value) if isinstance(value, str) else f"{value:z.6g}".replace("inf", "∞")


def _binding(found: Optimum) -> Grid:
    """Return the limits that decide, a row for each state in which they do."""
    table = Grid("limits that decide")
    several = found.count > 1
    for text in [*(["solution"] if several else []), "limit", "state"]:
        table.column(text, left=text != "solution", label=True)
    table.column("value", left=True, words=True)
    table.column(_one_more(found))
    for number, own in enumerate(found.binding, 1):
        for each in own:
            change = "" if np.isnan(each.change_per_unit) else f"{each.change_per_unit:z.4g}"
            for row, (state, value) in enumerate(each.values.items()):
                first = row == 0
                cells = [each.limit if first else "", state, _value(value), change if first else ""]
                table.row([*([f"{number}"] if several else []), *cells])
    return table


def _one_more(found: Optimum) -> str:
    """Return the heading of changes of the objective."""
    return f"1 more changes\n{found.objectives[0].column} by"


def _keys(found: Optimum) -> Grid:
    """Return what is said of each key."""
    table = Grid("keys at the optimum")
    table.column("key", left=True, label=True)
    table.column("best")
    table.column("on bound", left=True)
    table.column(_one_more(found))
    table.column("within 1 %\nof the best", left=True)
    if any(answer.fails for answer in found.answers.values()):
        table.column("fails", left=True)
    for name, answer in found.answers.items():
        column = found.columns[name]
        reach = [cell_text(column, value, "metric") for value in answer.range]
        span = " to ".join(reach) if answer.range and isinstance(answer.range[0], float) else ", ".join(reach)
        change = "" if np.isnan(answer.change_per_unit) else f"{answer.change_per_unit:z.4g}"
        fails = [", ".join(_fails(found, edge) for edge in answer.fails)] * ("fails" in table.columns[-1].heading)
        words = heading(column, "metric").replace("\n", " ")
        table.row([words, cell_text(column, answer.value, "metric"), answer.bound, change, span, *fails])
    return table


def _fails(found: Optimum, edge: Edge) -> str:
    """Return where a key makes the design fail, and how."""
    side = "below" if edge.value < found.answers[edge.key].value else "above"
    return f"{side} {cell_text(found.columns[edge.key], edge.value, 'metric')}: {outcome_text(edge.status)}"


def _print_edges(printer: Printer, found: Optimum) -> None:
    """Print how near the nearest failure is, where one decides, and what keeps away from it."""
    edges = [(number, each.edge) for number, own in enumerate(found.binding) for each in own if each.edge]
    if edges:
        printer.text()
    for number, edge in edges:
        column, best = found.columns[edge.key], float(found.values[edge.key][number])
        unit, change = column.unit_text("metric"), edge.value - best
        share = f" ({100.0 * change / abs(best):+.1g} %)" if best else ""
        which = f"solution {number + 1}" if found.count > 1 else "this design"
        printer.prose(
            f"{which} is at the edge of a failure: {column.heading} {f'{change:+.1g} {unit}'.strip()}{share} gives"
            f" {outcome_text(edge.status)} in {', '.join(edge.states)}"
        )
    margins = dict.fromkeys(f"--subject '{MARGINS[edge.status]}'" for _, edge in edges if edge.status in MARGINS)
    if edges:
        printer.prose(f"keep a margin: limit what leads to it{', such as ' if margins else ''}{', '.join(margins)}")
