"""Findings in words, what several segments share said once."""

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from chutecalc.results.finding import Finding, Severity

OPPOSITES = {
    ("steeper", "flatter"): (
        "a steeper end",
        "a flatter one",
        "the slope alone cannot give both; keep the end steep enough to clear itself, and take velocity off before it:"
        " a lower drop, or the end nearer above the belt",
    ),
    ("faster", "slower"): (
        "a faster stream",
        "a slower one",
        "the velocity alone cannot give both; change the section, the slope of the end or the speed of the belt",
    ),
}
"""Changes that undo each other: in words, and what to do then."""


class Told(NamedTuple):
    """A finding in words."""

    severity: Severity
    code: str
    where: str
    """The segment and the distance along the stream; the names of several segments that it holds for alike."""
    message: str


def told(findings: Iterable[Finding], units: str) -> Iterator[Told]:
    """Yield the findings of one design in words, in their order, one line where segments differ by their names alone.

    Args:
        findings: of one design.
        units: ``metric`` or ``us``.
    """
    for message, alike in alike_by(findings, lambda finding: finding.message(0, units)):
        first, subjects = alike[0], subjects_of(alike)
        where = first.where(0, units) if subjects == first.subject else subjects
        yield Told(first.severity, first.code, where, message)


def alike_by(findings: Iterable[Finding], text: Callable[[Finding], str]) -> Iterator[tuple[str, list[Finding]]]:
    """Yield texts with the findings that they hold for: those of one code and severity with the same text, in order.

    Args:
        findings: of one design.
        text: returns the text of a finding.
    """
    found: dict[tuple[Severity, str, str], list[Finding]] = {}
    for finding in findings:
        found.setdefault((finding.severity, finding.code, text(finding)), []).append(finding)
    for (_, _, words), alike in found.items():
        yield words, alike


def subjects_of(findings: Iterable[Finding]) -> str:
    """Return what findings are about, each named once.

    Args:
        findings: of one design.
    """
    return ", ".join(dict.fromkeys(finding.subject for finding in findings))


def against_each_other(findings: Iterable[Finding]) -> Iterator[str]:
    """Yield a line for each segment whose findings ask for changes that undo each other.

    Args:
        findings: of one design.
    """
    asked: dict[str, dict[str, list[str]]] = {}
    for finding in findings:
        if finding.asks:
            codes = asked.setdefault(finding.segment, {}).setdefault(finding.asks, [])
            codes += [finding.code] if finding.code not in codes else []
    for segment, codes_of in asked.items():
        for (one, other), (first, second, advice) in OPPOSITES.items():
            if one in codes_of and other in codes_of:
                wishes = (f"{what} ({', '.join(codes_of[of])})" for what, of in ((first, one), (second, other)))
                yield f"{segment}: {' and '.join(wishes)} are both asked for; {advice}"
