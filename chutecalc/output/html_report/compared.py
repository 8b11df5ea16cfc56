"""What a report that compares several chutes contains, as values for its template."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from markupsafe import Markup

from chutecalc.output.cases import measures_table
from chutecalc.output.catalogue import catalogue
from chutecalc.output.grid import Grid
from chutecalc.output.html_report.contents import head
from chutecalc.output.html_report.reported import Reported
from chutecalc.output.html_report.svg import inline_svg
from chutecalc.output.html_report.tables import NO_BREAK, given_inputs
from chutecalc.output.plots.run import draw_run
from chutecalc.output.told import told
from chutecalc.results.cases import Cases
from chutecalc.results.drawn import letter
from chutecalc.spec.inputs import Input

ABREAST = 5
"""Chutes beside each other in a table of inputs; more take further tables."""


def compared(chutes: Sequence[Reported], units: str) -> dict[str, Any]:
    """Return the values that the template of several chutes takes.

    Args:
        chutes: at least two.
        units: ``metric`` or ``us``.
    """
    named = {letter(number): chute for number, chute in enumerate(chutes)}
    solutions = {name: chute.states.main_solution for name, chute in named.items()}
    picture = inline_svg(
        draw_run([chute.states for chute in chutes], units),
        "comparison",
        "The paths of the streams from the side, and velocity, depth, pressure and wear along them.",
    )
    projects = [solution.spec.project for solution in solutions.values()]
    return {
        "project": projects[0] if all(each == projects[0] for each in projects) else None,
        "chutes": {name: head(chute, units) for name, chute in named.items()},
        "differs": list(differing_inputs(named)),
        "outcomes": measures_table(Cases(solutions), units, "chute"),
        "picture": Markup(picture),
        "findings": {name: list(told(solution.findings(), units)) for name, solution in solutions.items()},
    }


def differing_inputs(chutes: dict[str, Reported]) -> Iterator[Grid]:
    """Yield tables of the keys in which specs differ: a row for each key, a column for each chute.

    Args:
        chutes: by name.
    """
    given = {name: given_inputs(chute.states.main_solution) for name, chute in chutes.items()}
    texts = {
        path: [_with_unit(of[path]) if path in of else "–" for of in given.values()]
        for path in dict.fromkeys(path for of in given.values() for path in of)
    }
    differ = [path for path, each in texts.items() if len(set(each)) > 1]
    for first in range(0, len(chutes), ABREAST) if differ else ():
        some = slice(first, first + ABREAST)
        meanings = {path: next(of[path].meaning for of in given.values() if path in of) for path in differ}
        rows = ([path, *texts[path][some], meanings[path]] for path in differ)
        yield catalogue(["key", *[*chutes][some], "meaning"], rows)


def _with_unit(given: Input) -> str:
    """Return a value with its unit, as people write it."""
    return f"{given.text}{'' if given.unit == '°' else NO_BREAK}{given.unit}" if given.unit else given.text
