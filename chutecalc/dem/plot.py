"""The picture of the check: pressures and equivalent friction as in Figure 11 of the paper, beds as in Figure 10."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.figure import Figure, SubFigure

from chutecalc.dem.bed import Bed
from chutecalc.dem.point import Point
from chutecalc.dem.report import delta_text, series_title
from chutecalc.dem.study import Series, Study
from chutecalc.dem.trough import Trough
from chutecalc.output.plots.style import INK, MARKS, PALE, SMALL, STROKES, colours, mathematical, styled
from chutecalc.physics.pressure import pressure_ratio

WIDTH, HEIGHT = 9.0, 5.6
"""Size of the picture, inches."""
BED_SHARE = 0.24
"""Share of the height for beds."""
MOST_BEDS = 3
"""Most beds drawn."""


def draw_study(study: Study) -> Figure:
    """Draw K of each wall over its inclination, μ_e, and up to three beds.

    Args:
        study: the results. Only beds that pass all checks are drawn.
    """
    series = [one for one in study.series if one.points]
    with styled():
        figure = Figure(figsize=(WIDTH, HEIGHT))
        upper, lower = np.asarray(figure.subfigures(2, 1, height_ratios=(1.0 - BED_SHARE, BED_SHARE))).tolist()
        pressure, friction = upper.subplots(1, 2)
        by_slope = len({point.case.slope_label for one in series for point in one.points}) > 1
        for one, colour, number in zip(series, colours(len(series)), range(len(series)), strict=True):
            mark, stroke = MARKS[number % len(MARKS)], STROKES[number % len(STROKES)]
            _pressures(pressure, one, colour, mark, stroke)
            _frictions(friction, study, one, colour, mark, stroke, by_slope)
        pressure.set(xlabel="inclination of the wall, °", ylabel="pressure ratio K", xlim=(0, 92), ylim=(0, None))
        friction.set(xlabel="chamfer angle β, °" if by_slope else "depth of the bed, m")
        label = mathematical(f"equivalent friction μ_e at φ = {math.degrees(study.wall_friction):.4g}°")
        friction.set_ylabel(label, parse_math=True)
        friction.ticklabel_format(axis="y", useOffset=False)
        if not by_slope:  # a few depths, perhaps one: something to see them against
            friction.axhline(math.tan(study.wall_friction), color=PALE, label="tan φ of the wall")
        if series:
            pressure.plot([], [], "o", color=INK, label="beds, mean and scatter of seeds")
            pressure.plot([], [], "-", color=INK, label="law with the fitted δ")
            pressure.legend(loc="lower left")
            upper.legend(*friction.get_legend_handles_labels(), loc="outside lower center", ncols=2)
            _beds(lower, _pictured(series))
    return figure


def _pressures(axes: Axes, series: Series, colour: str, mark: str, stroke: Any) -> None:
    """Draw K of each wall, and the curve of the law with the fitted δ."""
    for point in series.points:
        for wall in point.trough.walls:
            if wall.side == 1 and wall.name in point.walls:
                _, pressure = point.walls[wall.name]
                scatter = np.nan_to_num(pressure.scatter)
                axes.errorbar(math.degrees(wall.inclination), pressure.mean, scatter, fmt=mark, color=colour, capsize=2)
    inclinations = np.linspace(0.0, math.pi / 2, 91)
    curve = pressure_ratio(inclinations, series.fits["paper"].vertical_ratio)
    axes.plot(np.degrees(inclinations), curve, color=colour, linestyle=stroke)


def _frictions(axes: Axes, study: Study, series: Series, colour: str, mark: str, stroke: Any, by_slope: bool) -> None:
    """Draw μ_e of the beds, and of the law at the areas of the beds."""
    friction, ratio = math.tan(study.wall_friction), series.fits["paper"].vertical_ratio

    def abscissa(point: Point) -> float:
        return math.degrees(point.case.inclinations[0]) if by_slope else point.depth.mean

    points = sorted(series.points, key=abscissa)
    x = [abscissa(point) for point in points]
    mean, scatter = np.array([point.ratio for point in points]).T * friction
    areas = [point.area.mean for point in points]
    troughs = [point.trough for point in points]
    if by_slope and all(len(point.case.inclinations) == 1 for point in points):  # a curve instead of a few chords
        base, lengths = points[0].case.base, points[0].case.lengths
        finer = np.linspace(x[0], x[-1], 91)
        areas = np.interp(finer, x, areas).tolist()
        troughs = [Trough(base, lengths, (math.radians(slope),)) for slope in finer]
    else:
        finer = np.array(x)
    law = [friction * trough.load(area, ratio, "paper").ratio for trough, area in zip(troughs, areas, strict=True)]
    axes.errorbar(x, mean, np.nan_to_num(scatter), fmt=mark, color=colour, capsize=2)
    label = f"{series_title(series)}, δ {delta_text(series.fits['paper'])}"
    axes.plot(finer, law, color=colour, linestyle=stroke, label=label)


def _pictured(series: Sequence[Series]) -> list[Bed]:
    """Return the beds to draw: of the first series, spread over its troughs."""
    points = series[0].points if series else ()
    chosen = np.unique(np.linspace(0, len(points) - 1, min(MOST_BEDS, len(points))).round().astype(int))
    return [points[number].beds[0] for number in chosen]


def _beds(figure: SubFigure, beds: Sequence[Bed]) -> None:
    """Draw beds beside each other, at one scale."""
    half = max(float(np.abs(bed.positions[:, 0]).max()) + bed.case.diameter for bed in beds)
    top = max(float(bed.positions[:, 2].max()) + bed.case.diameter for bed in beds)
    for axes, bed in zip(np.atleast_1d(figure.subplots(1, len(beds))), beds, strict=True):
        _bed(axes, bed)
        axes.set(xlim=(-half, half), ylim=(-0.05 * top, top), xticks=[], yticks=[], aspect="equal", frame_on=False)


def _bed(axes: Axes, bed: Bed) -> None:
    """Draw particles in their trough, seen along the chute, the nearer ones lighter."""
    order = np.argsort(-bed.positions[:, 1])
    positions, d = bed.positions[order], bed.case.diameter
    shade = 0.55 + 0.4 * (1.0 - positions[:, 1] / bed.case.slice)
    axes.add_collection(
        EllipseCollection(
            np.full(len(positions), d),
            np.full(len(positions), d),
            np.zeros(len(positions)),
            units="xy",
            offsets=positions[:, [0, 2]],
            transOffset=axes.transData,
            facecolors=[str(round(value, 2)) for value in shade],
            edgecolors="0.25",
            linewidths=0.2,
            rasterized=True,
        )
    )
    top = float(positions[:, 2].max()) + d
    half = float(np.abs(positions[:, 0]).max()) + d
    lines = []
    for wall in bed.case.trough.walls:
        across, up = math.cos(wall.inclination), math.sin(wall.inclination)
        x, z = wall.foot
        length = min(wall.length, (top - z) / up if up > 0.0 else math.inf)
        start = (x - 0.5 * wall.length, z) if wall.side == 0 else (x, z)
        end = (x + 0.5 * wall.length, z) if wall.side == 0 else (x + wall.side * length * across, z + length * up)
        lines.append([start, end])
    axes.add_collection(LineCollection(lines, colors=INK, linewidths=1.5))
    axes.plot([-half, half], [bed.depth] * 2, ":", color=INK, linewidth=1.0)
    axes.set_title(
        f"β = {bed.case.slope_label}°, {bed.case.pour}, {bed.depth:.3f} m deep", loc="center", fontsize=SMALL
    )
