"""What is written on a drawing: its title, its conventions, and the table of setting-out points."""

from collections.abc import Sequence

import numpy as np
from ezdxf.enums import TextEntityAlignment as Align

from chutecalc.design import Contact
from chutecalc.output.dxf.layers import TEXT
from chutecalc.output.dxf.points import PER_METRE, Point
from chutecalc.output.dxf.sheet import LARGE, NORMAL, SMALL, Sheet
from chutecalc.output.plots.traces import Steel, View
from chutecalc.results.cases import Cases
from chutecalc.results.described import status_words
from chutecalc.spec.operating import DESIGN_POINT

UNITS = "Dimensions in mm, true to size. x to the right and z upwards from the spec's origin."
FACES = "Surfaces are the inner faces of the liners, which the stream slides on."
LINE = 1.6
"""Distance of lines of text, over its height."""
HEADINGS = (
    *("segment", "kind", "start x", "start z", "slope °", "end x", "end z", "slope °", "length"),
    *("radius", "centre x", "centre z"),
)
"""Headings of the table of setting-out points."""
NAMES, NUMBERS = 24.0, 17.0
"""Widths of its columns of text and of numbers, mm on paper."""
TABLE_WIDTH = 2 * NAMES + (len(HEADINGS) - 2) * NUMBERS


def title_lines(states: Cases, seen: View, scale: float) -> list[tuple[str, float]]:
    """Return the lines of the title with their heights, mm on paper.

    Args:
        states: a chute in all its operating states.
        seen: its lines.
        scale: of the drawing, as in 1:scale.
    """
    solution = states.main_solution
    state = "" if states.main == DESIGN_POINT else f", case {states.main}"
    project = solution.spec.project
    entries = [f"{name}: {value}" for name, value in project if value and name != "notes"]
    lines = [(f"{solution.spec.title or solution.source}{state}", LARGE)]
    lines += [(", ".join(entries), NORMAL)] if entries else []
    lines += [(line, SMALL) for line in (project.notes or "").splitlines()]
    lines += [(line, SMALL) for line in (f"Scale 1:{scale:g} on A3. {UNITS}", FACES)]
    if not solution.ok[0]:
        words = f"The chute fails (status {status_words(solution.status[0])}): the stream is drawn as far as it gets."
        lines.append((words, SMALL))
    drawn = {steel.name for steel in seen.surfaces}
    unknown = [each.name for each in solution.design.segments if isinstance(each, Contact) and each.name not in drawn]
    words = f"Not drawn, as the stream that places it does not get there: {', '.join(unknown)}."
    return [*lines, (words, SMALL)] if unknown else lines


def draw_title(sheet: Sheet, lines: Sequence[tuple[str, float]], corner: Point) -> None:
    """Write the title.

    Args:
        sheet: to draw on.
        lines: from :func:`title_lines`.
        corner: its lower left corner, mm.
    """
    x, y = corner
    for words, height in reversed(lines):
        sheet.text(words, (x, y), height)
        y += sheet.paper(LINE * height)


def title_height(lines: Sequence[tuple[str, float]]) -> float:
    """Return the height of the title, mm on paper.

    Args:
        lines: from :func:`title_lines`.
    """
    return LINE * sum(height for _, height in lines)


def draw_table(sheet: Sheet, surfaces: Sequence[Steel], corner: Point) -> None:
    """Write the table of setting-out points.

    Args:
        sheet: to draw on.
        surfaces: of the chute.
        corner: its upper left corner, mm.
    """
    y = corner[1]
    for row in (HEADINGS, *(_row(steel) for steel in surfaces)):
        x = corner[0]
        y -= sheet.paper(LINE * SMALL)
        for number, cell in enumerate(row):
            wide = sheet.paper(NAMES if number < 2 else NUMBERS)
            align = Align.LEFT if number < 2 else Align.RIGHT
            sheet.text(cell, (x if number < 2 else x + wide, y), SMALL, align)
            x += wide
        if row is HEADINGS:
            sheet.line((corner[0], y - sheet.paper(1.0)), (x, y - sheet.paper(1.0)), TEXT)
            y -= sheet.paper(1.0)


def table_height(surfaces: Sequence[Steel]) -> float:
    """Return the height of the table, mm on paper.

    Args:
        surfaces: of the chute.
    """
    return LINE * SMALL * (len(surfaces) + 1) + 2.0


def _row(steel: Steel) -> list[str]:
    """Return the cells of a segment."""
    drawn = steel.drawn
    ends = ((*place, slope) for place, slope in zip((drawn.start, drawn.end), drawn.slopes, strict=True))
    numbers = [each for x, z, slope in ends for each in (x * PER_METRE, z * PER_METRE, float(np.degrees(slope)))]
    lengths = [drawn.length, *([drawn.radius, *drawn.centre] if drawn.radius and drawn.centre else [])]
    numbers += [length * PER_METRE for length in lengths]
    return [drawn.name, drawn.kind, *(f"{number:z.1f}" for number in numbers)]
