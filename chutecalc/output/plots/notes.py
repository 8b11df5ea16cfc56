"""The lines of text below a chute: its outcome and its findings, with the numbers of their places."""

from collections import Counter
from collections.abc import Sequence

import numpy as np

from chutecalc.output.outcome import outcome
from chutecalc.output.plots.layout import VISIBLE
from chutecalc.output.plots.marks import Mark
from chutecalc.output.plots.text import fitted
from chutecalc.output.plots.traces import View
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.solved import SolvedChute

MOST_TOLD = 10
"""Most findings that a picture tells; the report has all of them."""
INDENT = "    "


def notes(solution: SolvedChute, seen: View, units: str, width: float) -> tuple[list[str], list[Mark]]:
    """Return the outcome and the worst findings as lines, one number for each place, and marks with these numbers.

    Args:
        solution: solution of one design.
        seen: its lines.
        units: ``metric`` or ``us``.
        width: of the lines, inches.
    """
    findings = by_weight(solution.findings())
    texts = [outcome(solution, units, VISIBLE)]
    numbered, marks = numbered_by_place(findings[:MOST_TOLD])
    for number, finding in numbered:
        ahead = f"{number}  " if number else INDENT
        where, message = finding.where(0, units), finding.message(0, units)
        texts.append(f"{ahead}{finding.severity} {finding.code}: {where}: {message}")
    if rest := Counter(finding.severity for finding in findings[MOST_TOLD:]):
        kinds = ", ".join(f"{count} {severity}{'s' if count > 1 else ''}" for severity, count in rest.items())
        texts.append(f"and {rest.total()} more without a number, {kinds}: see the report")
    depths = [trace.columns["depth_m"] for trace in seen.stream if trace.side]
    if any((depth > seen.deepest).any() for depth in depths):
        depth = COLUMNS["depth_m"]
        texts.append(f"the stream is drawn to a depth of {depth.shown(seen.deepest, units)} {depth.unit_text(units)}")
    return [line for text in texts for line in fitted(text, width, indent=INDENT).split("\n")], marks


def numbered_by_place(findings: Sequence[Finding]) -> tuple[list[tuple[str, Finding]], list[Mark]]:
    """Return findings of one design by their place, the first at each place with its number, and marks of the numbers.

    Args:
        findings: in the order in which places are numbered.
    """
    told, marks = [], []
    for number, alike in enumerate(_by_place(findings), 1):
        place = float(alike[0].s_m[0])
        if np.isfinite(place):
            marks.append(Mark(str(number), place))
        told += [(str(number) if np.isfinite(place) and not k else "", finding) for k, finding in enumerate(alike)]
    return told, marks


def by_weight(findings: Sequence[Finding]) -> list[Finding]:
    """Return findings of one design, the failures first, then the warnings, then the notes.

    Among those, the worst of each kind comes first, along the stream; then the second worst of each kind, and so on.

    Args:
        findings: in order along the stream.
    """
    turns: dict[int, int] = {}
    for code in dict.fromkeys(finding.code for finding in findings):
        alike = [finding for finding in findings if finding.code == code]
        worst_first = sorted(alike, key=lambda finding: -float(finding.badness[0]))
        turns |= {id(finding): turn for turn, finding in enumerate(worst_first)}
    rank = list(Severity).index
    return sorted(findings, key=lambda finding: (rank(finding.severity), turns[id(finding)]))


def _by_place(findings: Sequence[Finding]) -> list[list[Finding]]:
    """Return findings of one design by their place: first that of the first of them."""
    found: dict[float | str, list[Finding]] = {}
    for finding in findings:
        s = round(float(finding.s_m[0]), 6)
        found.setdefault(s if np.isfinite(s) else finding.subject, []).append(finding)
    return list(found.values())
