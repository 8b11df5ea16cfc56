"""The best design: differential evolution on Deb's rule, then a polish of the best points."""

from itertools import islice, product

import numpy as np
from scipy.optimize import differential_evolution
from scipy.stats.qmc import Sobol

from chutecalc.physics.arrays import Array
from chutecalc.studies.optimise.polish import polished
from chutecalc.studies.optimise.problem import FEASIBLE, Problem

FIRST = 1024
"""Quasi-random designs to begin with; of as many choices, all are solved."""
POPULATION, LEAST, GENERATIONS = 12, 24, 120
"""Designs of a generation for each key, at least, and most generations."""
CORNERS = 256
"""Most corners of the bounds, with each choice, that join them: many a best design lies there."""
POLISHED, CHOICES = 5, 8
"""Points that are polished, and most choices of which the best point is among them."""
SETTLING = 120
"""Most steps of the direct search at the end."""


def best_place(problem: Problem, seed: int = 0, known: Array | None = None, generations: int = GENERATIONS) -> Array:
    """Return the place of the best design, or of the one that violates least where none is feasible.

    Args:
        problem: what is wanted.
        seed: of what is random.
        known: places that are worth a look, in the units of the keys, shape (designs, keys).
        generations: most generations of the evolution.

    Returns:
        In the units of the keys, shape (keys,).
    """
    every = problem.all_choices(FIRST)
    if every is not None:
        rows = problem.rows(every)
        problem.check_values(rows)
        return np.asarray(every[problem.merit(rows).argmin()])
    keys = len(problem.keys)
    sample = problem.low + Sobol(keys, seed=seed).random(FIRST) * (problem.high - problem.low)
    sample[:, ~problem.continuous] = problem.low[~problem.continuous] + np.floor(
        (sample - problem.low) / (problem.high - problem.low) * (problem.high - problem.low + 1.0)
    )[:, ~problem.continuous].clip(0.0, problem.high[~problem.continuous])
    sample = np.concatenate([*([] if known is None else [known]), _corners(problem), sample])
    rows = problem.rows(sample)
    problem.check_values(rows)
    sizes = np.abs(rows.worst[np.isfinite(rows.worst)])
    problem.unit = float(np.median(sizes)) or 1.0 if sizes.size else 1.0
    merit = problem.merit(rows)
    order = np.argsort(merit, kind="stable")
    count = max(LEAST, POPULATION * keys)
    begin = sample[np.concatenate([order[: count // 2], order[count // 2 :: max(1, len(order) // count)]])[:count]]
    result = differential_evolution(
        lambda places: _merit(problem, np.atleast_2d(places.T)),
        list(zip(problem.low, problem.high, strict=True)),
        init=begin,
        integrality=~problem.continuous,
        maxiter=generations,
        tol=1e-5,
        polish=False,
        updating="deferred",
        vectorized=True,
        seed=np.random.default_rng(seed),
    )
    ends = np.concatenate([result.x[None], result.population, sample[order[:count]]])
    found = problem.clipped(ends)
    merit = _merit(problem, found)
    order = np.argsort(merit, kind="stable")
    starts = _distinct(problem, found[order]) if merit[order[0]] < FEASIBLE else found[order[:1]]
    found = np.concatenate([starts, *(polished(problem, start)[None] for start in starts)])
    merit = _merit(problem, found)
    best = np.asarray(found[merit.argmin()])
    return settled(problem, best, seed) if merit.min() < FEASIBLE else best


def settled(problem: Problem, place: Array, seed: int = 0) -> Array:
    """Return a design refined by direct search, which sees failures and warnings too.

    It tries steps along random directions at right angles to each other, and halves them where none is better.

    Args:
        problem: what is wanted.
        place: of the design, in the units of the keys, shape (keys,).
        seed: of the directions.
    """
    keys, width = np.flatnonzero(problem.continuous), problem.high - problem.low
    random, step, merit = np.random.default_rng(seed), 1e-3, _merit(problem, place[None])[0]
    for _ in range(SETTLING):
        if not keys.size or step < 1e-9:
            break
        axes = np.linalg.qr(random.normal(size=(len(keys), len(keys))))[0]
        directions = np.concatenate([axes, -axes, np.eye(len(keys)), -np.eye(len(keys))])
        tried = np.repeat(place[None], len(directions), axis=0)
        tried[:, keys] += step * directions * width[keys]
        tried = problem.clipped(tried)
        found = _merit(problem, tried)
        if found.min() < merit:
            place, merit, step = tried[found.argmin()], found.min(), 2.0 * step
        else:
            step *= 0.5
    return place


def _merit(problem: Problem, places: Array) -> Array:
    return problem.merit(problem.rows(places))


def _corners(problem: Problem) -> Array:
    """Return the corners of the bounds, with each choice."""
    ends = zip(problem.low, problem.high, problem.continuous, strict=True)
    axes = ((low, high) if own else np.arange(high + 1.0) for low, high, own in ends)
    return np.array(list(islice(product(*axes), CORNERS)))


def _distinct(problem: Problem, places: Array) -> Array:
    """Return the best places that are apart, by another choice or by a tenth of the bounds, and the best of choices."""
    width = np.where(problem.continuous, 0.1 * (problem.high - problem.low), 0.5)
    kept: list[Array] = []
    for place in places:
        if all((np.abs(place - other) > width).any() for other in kept):
            kept.append(place)
        if len(kept) == POLISHED:
            break
    choices: list[Array] = []
    for place in places:
        if all((np.abs(place - other) > width)[~problem.continuous].any() for other in choices):
            choices.append(place)
        if len(choices) == CHOICES:
            break
    return np.unique(np.array([*kept, *choices]), axis=0)
