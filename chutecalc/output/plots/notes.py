"""The lines of text below a chute: its outcome and its findings, numbered."""

import numpy as np

from chutecalc.output.outcome import outcome
from chutecalc.output.plots.marks import Mark
from chutecalc.output.plots.text import fitted
from chutecalc.output.plots.traces import View
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Finding
from chutecalc.results.solved import SolvedChute


def notes(solution: SolvedChute, seen: View, units: str, width: float) -> tuple[list[str], list[Mark]]:
    """Return the outcome and the findings as lines, numbered by kind, and marks with these numbers.

    Args:
        solution: solution of one design.
        seen: its lines.
        units: ``metric`` or ``us``.
        width: of the lines, inches.
    """
    lines, marks = [outcome(solution, units)], []
    found: dict[str, list[Finding]] = {}
    for finding in solution.findings():
        found.setdefault(finding.code, []).append(finding)
    for number, (code, alike) in enumerate(found.items(), 1):
        first, more = alike[0], len(alike) - 1
        others = f" and {more} more" if more else ""
        text = f"{number}  {first.severity} {code}: {first.where(0, units)}{others}: {first.message(0, units)}"
        lines += fitted(text, width, indent="    ").split("\n")
        if np.isfinite(first.s_m[0]):
            marks.append(Mark(str(number), float(first.s_m[0])))
    depths = [trace.columns["depth_m"] for trace in seen.stream if trace.side]
    if any((depth > seen.deepest).any() for depth in depths):
        depth = COLUMNS["depth_m"]
        lines.append(f"the stream is drawn to a depth of {depth.shown(seen.deepest, units)} {depth.unit_text(units)}")
    return lines, marks
