"""Pictures of optima: the neighbourhood over two keys, or the front of two objectives."""

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from chutecalc.errors import UsageError
from chutecalc.output.plots.style import INK, mathematical, styled
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.optimise.optimum import Optimum
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.plot import draw_sweep
from chutecalc.studies.sweep.solved_blocks import solve_block
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import column_of

GRID, LINE = 33, 201
"""Values of each of two keys of a picture, and of a single one."""
REACH = 0.25
"""Distance from the best, as a share of the bounds, up to which the neighbourhood goes."""


def draw_optimum(found: Optimum, units: str = "metric") -> Figure:
    """Draw the objective around the best design over the first two keys of numbers, or a front.

    Args:
        found: the optimum.
        units: ``metric`` or ``us``.
    """
    return _front(found, units) if len(found.objectives) > 1 else _neighbourhood(found, units)


def _neighbourhood(found: Optimum, units: str) -> Figure:
    """Draw a sweep around the best design in its worst state, which is marked."""
    sweep, best = neighbourhood(found)
    block = solve_block(sweep, 0)
    figure = draw_sweep(sweep, block, units)
    axes = figure.axes[0]
    name = found.objectives[0].column
    value = column_of(sweep, name).converted(found.worst[name][0], units)
    axes.plot(
        best[0], best[1] if len(best) > 1 else value, "o", color=INK, markerfacecolor="white", clip_on=False, gid="best"
    )
    return figure


def neighbourhood(found: Optimum) -> tuple[Sweep, list[float]]:
    """Return the grid of designs around the best one, over its first two keys of numbers, in its worst state.

    Args:
        found: an optimum of one objective.

    Returns:
        The sweep, and where the best design lies in it.

    Raises:
        UsageError: no key is a number.
    """
    varied = [key for key in found.keys if key.is_continuous][:2]
    if not varied:
        raise UsageError("a picture of an optimum needs a key with bounds, KEY=LOW:HIGH")
    count = LINE if len(varied) == 1 else GRID
    parameters, best = [], []
    for key in varied:
        (low, high), value = key.bounds, float(found.values[key.name][0])
        reach = REACH * (high - low)
        values = np.linspace(max(low, value - reach), min(high, value + reach), count)
        parameters.append(Parameter(key.name, key.parameter.paths, values))
        best.append(value)
    objective = found.objectives[0]
    values = objective.sign * found.outcome[objective.column][:, 0]
    state = found.states[int(np.nan_to_num(values, nan=-np.inf).argmax())]
    drawn = found.chute.put(found.changes())
    return Sweep(drawn if state == DESIGN_POINT else drawn.cases[state], parameters, columns=[objective.column]), best


def _front(found: Optimum, units: str) -> Figure:
    """Draw the designs of a front, one objective over the other."""
    with styled():
        figure = Figure(figsize=(6.0, 4.0))
        axes = figure.add_subplot()
        first, second = (found.columns[each.column] for each in found.objectives)
        x, y = (column.converted(found.worst[column.name], units) for column in (first, second))
        _points(axes, x, y)
        axes.set_xlabel(mathematical(first.label(units)))
        axes.set_ylabel(mathematical(second.label(units)))
        axes.set_title(found.chute.spec.title or found.chute.source, loc="left")
        return figure


def _points(axes: Any, x: Any, y: Any) -> None:
    """Draw numbered points joined by a line."""
    axes.plot(x, y, "o-", color=INK, gid="front")
    for number, place in enumerate(zip(x, y, strict=True), 1):
        axes.annotate(str(number), place, xytext=(4, 4), textcoords="offset points")
