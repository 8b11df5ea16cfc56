"""The drawing of one chute."""

import io
from collections.abc import Sequence
from typing import IO, NamedTuple

import numpy as np
from ezdxf import options  # type: ignore[attr-defined]  # documented there

from chutecalc.output.dxf.layers import case_layer
from chutecalc.output.dxf.points import PER_METRE, Point
from chutecalc.output.dxf.sections import End, arranged, draw_end, ends
from chutecalc.output.dxf.sheet import Sheet
from chutecalc.output.dxf.side import AWAY, draw_side, draw_stream
from chutecalc.output.dxf.titles import TABLE_WIDTH, draw_table, draw_title, table_height, title_height, title_lines
from chutecalc.output.plots.traces import View
from chutecalc.output.plots.view import view
from chutecalc.results.cases import Cases

SCALES = (1, 2, 5, 10, 20, 25, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 100_000, 1_000_000)
"""Scales of drawings, as 1:n."""
PAPER = (400.0, 277.0)
"""What an A3 sheet has room for within its margins, mm."""
GAP = 3.0
"""Between the title, the pictures and the table, mm on paper."""
MARGIN = AWAY + 14.0
"""Room around the side view for coordinates, mm on paper."""


class Layout(NamedTuple):
    """Where things stand on a sheet: the side view left, the sections right, the title above, a table below; mm."""

    sections: list[tuple[End, Point]]
    """Each with the middle of its upper edge."""
    title: Point
    """Lower left corner of the title."""
    table: Point
    """Upper left corner of the table of setting-out points."""
    size: tuple[float, float]
    """Width and height of all."""


def draw(states: Cases) -> Sheet:
    """Draw a chute, to the largest scale at which it fits on a sheet.

    Args:
        states: the chute in all its operating states, of one design each.
    """
    solution = states.main_solution
    seen = view(solution)
    box = _box(seen)
    pairs = [ends(solution, steel, seen.size) for steel in seen.surfaces]
    scale = next((scale for scale in SCALES if _fits(_layout(states, seen, box, pairs, scale), scale)), SCALES[-1])
    layout, sheet = _layout(states, seen, box, pairs, scale), Sheet(scale)
    draw_side(sheet, solution, seen, box)
    names = [name for name in states.names if name != states.main]
    for number, (name, other) in enumerate(states.solutions.items()):
        if name != states.main:
            sheet.add_layer(layer := case_layer(name, names[: number - 1]))
            draw_stream(sheet, view(other), layer)
    for end, top in layout.sections:
        draw_end(sheet, end, top)
    draw_title(sheet, title_lines(states, seen, scale), layout.title)
    draw_table(sheet, seen.surfaces, layout.table)
    return sheet


def _layout(
    states: Cases, seen: View, box: tuple[Point, Point], pairs: Sequence[tuple[End, End]], scale: float
) -> Layout:
    """Return where things stand at a scale."""
    (left, bottom), (right, top) = box
    margin, gap = MARGIN * scale, GAP * scale
    head, foot = title_height(title_lines(states, seen, scale)) * scale + gap, table_height(seen.surfaces) * scale + gap
    room = max(top - bottom + 2.0 * margin, PAPER[1] * scale - head - foot)
    sections, (edge, lowest) = arranged(pairs, scale, (right + margin, top + margin), room)
    floor = min(bottom - margin, lowest)
    size = max(edge - left + margin, TABLE_WIDTH * scale), top + margin + head - floor + foot
    return Layout(sections, (left - margin, top + margin + gap), (left - margin, floor - gap), size)


def _fits(layout: Layout, scale: float) -> bool:
    """Return whether a layout fits on paper at its scale."""
    return layout.size[0] <= PAPER[0] * scale and layout.size[1] <= PAPER[1] * scale


def _box(seen: View) -> tuple[Point, Point]:
    """Return the lower left and the upper right corner of all lines, mm."""
    points = np.concatenate(seen.lines, axis=1) * PER_METRE
    low, high = np.nanmin(points, axis=1).tolist(), np.nanmax(points, axis=1).tolist()
    return (low[0], low[1]), (high[0], high[1])


def save(sheet: Sheet, stream: IO[bytes]) -> None:
    """Write a drawing, the same bytes each time.

    Args:
        sheet: the drawing.
        stream: where it goes.
    """
    for name in sorted(sheet.document.entitydb.dxf_types_in_use()):  # which ezdxf would add in the order of a set
        sheet.document.classes.add_class(name)
    text = io.StringIO()
    fixed = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        sheet.document.write(text)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    stream.write(text.getvalue().encode("utf-8"))
