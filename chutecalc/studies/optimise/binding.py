"""The limits that decide where an optimum lies: in the words of optimisation, those that bind."""

from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import nnls

from chutecalc.physics.arrays import Array, Index
from chutecalc.studies.optimise.borders import Edge, failure_edges
from chutecalc.studies.optimise.objective import NO_FAILURE, NO_WARNINGS
from chutecalc.studies.optimise.polish import Slopes
from chutecalc.studies.optimise.problem import FAILURE, Problem, Rows

CLOSE = 1e-5
"""Share of a limit, of the bounds or of the objective, within which a limit decides."""
BESIDE = 1e-4
"""Distance, as a share of the bounds, at which designs beside an optimum are looked at."""


class Binding(NamedTuple):
    """A limit that decides: without it there would be a better design."""

    limit: str
    """The limit as it is written, ``no failure`` or ``no warnings``."""
    values: dict[str, Any]
    """Value of its column by the states in which it decides; for a failure how a design beside ends, for warnings
    their codes."""
    change_per_unit: float
    """Change of the best objective for each unit by which the limit is raised; NaN where it is not known."""
    edge: Edge | None = None
    """Of no failure, the least change of one key that makes the design fail."""


class AtOptimum(NamedTuple):
    """What decides at an optimum."""

    binding: list[Binding]
    slopes: dict[str, float]
    """Change of the objective in its worst states for each unit of each continuous key, all others as they are."""
    edges: list[Edge]
    """Where keys make it fail, the nearest first."""


def binding(problem: Problem, place: Array) -> AtOptimum:
    """Return the limits that decide at an optimum, and the slope of the objective over each continuous key.

    The multipliers of the conditions of Karush, Kuhn and Tucker are those not negative that come closest to a balance
    of all slopes, by least squares. A limit holds in each state, so the derivative of the optimum by it is the sum of
    its multipliers over the states, however they are shared between these.

    Args:
        problem: what is wanted.
        place: of the optimum, in the units of the keys, shape (keys,).
    """
    here = Slopes(problem, place)
    keys = np.flatnonzero(problem.continuous)
    states = np.flatnonzero(here.values >= here.values.max() - CLOSE * np.abs(here.values).max())
    tight = np.flatnonzero(np.abs(here.margins) < CLOSE)
    share = ((place - problem.low) / (problem.high - problem.low))[keys]
    bounds = np.eye(len(keys))
    walls = np.concatenate([-bounds[:, share < CLOSE], bounds[:, share > 1.0 - CLOSE]], axis=1)
    slopes = np.concatenate([here.of_values[states].T, -here.of_margins[tight].T, walls], axis=1)
    ones = np.concatenate([np.ones(len(states)), np.zeros(slopes.shape[1] - len(states))])
    weight = 1.0 + np.abs(slopes).max(initial=0.0)
    target = np.append(np.zeros(len(keys)), weight)
    found, _ = nnls(np.vstack([slopes, weight * ones]), target) if not here.fails else (np.full(len(ones), np.nan), 0.0)
    edges = [] if here.fails else failure_edges(problem, place)
    borders = [*_failures(edges), *_warnings(problem, place)]
    multipliers = found[len(states) : len(states) + len(tight)] * problem.unit
    if borders:  # the balance lacks the slope of what begins to fail
        multipliers = np.full_like(multipliers, np.nan)
    sign = problem.objective.sign
    over = here.of_values[states].T @ found[: len(states)] * problem.unit * sign / (problem.high - problem.low)[keys]
    named = {problem.keys[key].name: float(value) + 0.0 for key, value in zip(keys, over, strict=True)}
    return AtOptimum([*_limits(problem, place, tight, multipliers), *borders], named, edges)


def _limits(problem: Problem, place: Array, tight: Index, multipliers: Array) -> list[Binding]:
    """Return the limits that decide, each with the sum of its multipliers over the states."""
    names, rows = problem.variants.states, problem.rows(place[None])
    found = []
    for number in np.unique(tight // len(names)):
        limit, own = problem.limits[number], tight // len(names) == number
        values = {names[k]: float(rows.block[limit.column][k, 0]) for k in tight[own] % len(names)}
        change = -problem.objective.sign * multipliers[own].sum() * limit.sign / limit.scale
        if change != 0.0:  # where it is 0 the limit is met, but something else decides
            found.append(Binding(limit.text, values, float(change)))
    return found


def _failures(edges: list[Edge]) -> list[Binding]:
    """Return that no failure decides, if a design beside the optimum fails."""
    near = [edge for edge in edges if edge.distance <= BESIDE]
    values = {state: edge.status for edge in reversed(near) for state in edge.states}
    return [Binding(NO_FAILURE, values, np.nan, near[0])] if near else []


def _warnings(problem: Problem, place: Array) -> list[Binding]:
    """Return that no warnings decides, if a design beside the optimum has some."""
    keys = np.flatnonzero(problem.continuous)
    if not problem.no_warnings or not keys.size:
        return []
    beside = np.repeat(place[None], 2 * len(keys), axis=0)
    for number, key in enumerate(keys):
        beside[2 * number : 2 * number + 2, key] += np.array([-1, 1]) * BESIDE * (problem.high - problem.low)[key]
    rows = problem.rows(np.concatenate([place[None], problem.clipped(beside)]))
    values = _codes(problem, rows)
    return [Binding(NO_WARNINGS, values, np.nan)] if rows.faults[0] == 0.0 and values else []


def _codes(problem: Problem, rows: Rows) -> dict[str, Any]:
    """Return the codes of warnings by the states in which they appear, of designs that do not fail."""
    stands = rows.faults < FAILURE
    found = {}
    for state, own in zip(problem.variants.states, rows.block["warnings"], strict=True):
        codes = dict.fromkeys(code for text in own[stands].tolist() for code in text.split())
        if codes:
            found[state] = " ".join(codes)
    return found
