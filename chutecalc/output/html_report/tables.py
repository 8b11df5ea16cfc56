"""Tables that only reports have: the inputs, the points and the dimensions of the steel, the limits in force."""

import re
from collections.abc import Mapping, Sequence

import numpy as np

from chutecalc.output.catalogue import catalogue
from chutecalc.output.grid import Grid
from chutecalc.results.columns import COLUMNS
from chutecalc.results.drawn import DrawnSegment, Position, letter_of
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.inputs import Input, inputs
from chutecalc.spec.limits import LIMITS

SHOWN_ELSEWHERE = ("title", "project", "format", "uncertainty")
"""Tables and keys at the top of a spec that the title block shows, or that reports do without."""
NO_BREAK = "\N{NO-BREAK SPACE}"
"""Stands between a number and its unit."""
NAMES = r"segments\.[^.]+\.name"
"""Keys that say nothing more than the paths of others."""


def given_inputs(solution: SolvedChute) -> dict[str, Input]:
    """Return what a spec gives beside its title block and how uncertain its numbers are, by path.

    Args:
        solution: solution of one design.
    """
    found = {each.path: each for each in inputs(solution.spec, solution.data)}
    return {
        path: each
        for path, each in found.items()
        if path.split(".")[0] not in SHOWN_ELSEWHERE and not re.fullmatch(NAMES, path)
    }


def inputs_table(solution: SolvedChute) -> Grid:
    """Return a row for each key of a spec, in its own unit.

    Args:
        solution: solution of one design.
    """
    rows = ((each.path, each.text, each.unit, each.meaning) for each in given_inputs(solution).values())
    return catalogue(("key", "value", "unit", "meaning"), rows)


def points_table(points: Mapping[str, Position], units: str) -> Grid:
    """Return a row for each point of the steel.

    Args:
        points: by letters.
        units: ``metric`` or ``us``.
    """
    length = COLUMNS["x_m"]
    table = Grid()
    table.column("point", left=True, label=True)
    for axis in ("x", "z"):
        table.column(f"{axis}\n{length.unit_text(units)}")
    for name, place in points.items():
        table.row([name, *(length.shown(each, units) for each in place)])
    return table


def steel_table(
    solution: SolvedChute, segments: Sequence[DrawnSegment], points: Mapping[str, Position], units: str
) -> Grid:
    """Return a row for each segment that has a place: its points, slopes, length, and the arc's radius and centre.

    Args:
        solution: solution of one design.
        segments: what is drawn of it.
        points: their ends by letters.
        units: ``metric`` or ``us``.
    """
    length, slope = COLUMNS["x_m"], COLUMNS["slope_deg"]
    table = Grid()
    for label in ("segment", "kind"):
        table.column(label, left=True, label=True)
    for word in ("from", "to"):
        table.column(word, left=True)
    for word in ("first slope", "last slope"):
        table.column(f"{word}\n{slope.unit_text(units)}")
    for word in ("length", "radius", "centre x", "centre z"):
        table.column(f"{word}\n{length.unit_text(units)}")
    for each in segments:
        ends = (letter_of(points, place) for place in (each.start, each.end))
        slopes = (slope.shown(float(np.degrees(angle)), units) for angle in each.slopes)
        arc = (each.radius, *each.centre) if each.radius and each.centre else ()
        table.row([each.name, each.kind, *ends, *slopes, *(length.shown(one, units) for one in (each.length, *arc))])
    return table


def limits_table(solution: SolvedChute, units: str) -> Grid:
    """Return a row for each limit: the value in force, the default where that is another, finding, source, meaning.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``; limits are in the unit of their key.
    """
    rows = []
    for limit in LIMITS.values():
        value = float(limit.of(solution.design.limits)[0])
        shown = limit.shown(None if np.isinf(value) else value).replace(" ", NO_BREAK)
        default = "" if shown == limit.text.replace(" ", NO_BREAK) else f" (default {limit.text})"
        rows.append((limit.key, shown + default, limit.finding, limit.source, limit.meaning))
    return catalogue(("limit", "in force", "finding", "source", "meaning"), rows)
