"""The steel of a chute from the side, to scale, with its points and its key dimensions."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure

from chutecalc.output.plots.belts import draw_feed, draw_receiver
from chutecalc.output.plots.labels import Label, place_labels
from chutecalc.output.plots.layout import SIDE, SIDE_ALONE, page
from chutecalc.output.plots.marks import belt_labels
from chutecalc.output.plots.side import draw_surfaces, set_scale
from chutecalc.output.plots.style import INK, PALE, lay_out, styled
from chutecalc.output.plots.traces import extent
from chutecalc.output.plots.view import view
from chutecalc.physics.arrays import Array
from chutecalc.results.columns import COLUMNS
from chutecalc.results.drawn import DrawnSegment, Position
from chutecalc.results.solved import SolvedChute


def draw_steel(
    solution: SolvedChute, segments: Sequence[DrawnSegment], points: Mapping[str, Position], units: str
) -> Figure:
    """Draws the surfaces of a chute: letters at their ends, the radius of each arc, the length of each straight.

    Args:
        solution: solution of one design.
        segments: what is drawn of it.
        points: their ends by letters.
        units: ``metric`` or ``us``.
    """

    def long(metres: Array) -> Array:
        lengths: Array = COLUMNS["x_m"].converted(metres, units)
        return lengths

    with styled():
        seen = view(solution)
        lines = [*(line for steel in seen.surfaces for line in (steel.path, steel.top)), *seen.feed, *seen.received]
        figure, axes = page("", extent(lines), units, arrangements=SIDE_ALONE)
        side = axes[SIDE]
        draw_surfaces(side, seen.surfaces, units)
        draw_feed(side, [long(line) for line in seen.feed])
        draw_receiver(side, [long(line) for line in seen.received], solution.design.receiver)
        ends = long(np.array([*points.values()]).T)
        side.plot(*ends, marker="o", markersize=3.5, color=INK, linestyle="", zorder=3.0, gid="points")
        for segment in segments:
            if segment.centre and segment.radius and segment.radius < seen.size:
                legs = long(np.array([segment.start, segment.centre, segment.end]).T)
                side.plot(*legs, color=PALE, linewidth=0.5, linestyle=(0, (6, 3)), zorder=0.5, gid="radius")
        set_scale(side)
        lay_out(figure)
        letters = [
            Label(name, float(x), float(z), (-0.7, 0.7), leads=True, boxed=True)
            for name, (x, z) in zip(points, ends.T, strict=True)
        ]
        dimensions = [_dimension(each, units) for each in segments]
        place_labels(side, [*letters, *dimensions, *belt_labels(solution, seen, units)], [long(line) for line in lines])
        return figure


def _dimension(segment: DrawnSegment, units: str) -> Label:
    """Return the name of a segment with its radius or length and its slopes, beside its middle."""
    length = COLUMNS["x_m"]
    first, last = (f"{np.degrees(slope):.4g}°" for slope in segment.slopes)
    if segment.radius:
        text = f"{segment.name}: R {length.shown(segment.radius, units)} {length.unit_text(units)}, {first} to {last}"
    else:
        text = f"{segment.name}: {length.shown(segment.length, units)} {length.unit_text(units)} at {first}"
    middle = 0.5 * sum(segment.slopes)
    x, z = (0.5 * (one + other) for one, other in zip(segment.start, segment.end, strict=True))
    if segment.radius and segment.centre:
        outwards = np.array([x, z]) - segment.centre
        x, z = segment.centre + segment.radius * outwards / np.hypot(*outwards)
    away = -segment.side * np.array([np.sin(middle), np.cos(middle)])
    x, z = (float(COLUMNS["x_m"].converted(np.array(each), units)) for each in (x, z))
    return Label(text, x, z, (float(away[0]), float(away[1])))
