"""Where a margin, known at a panel's knots, first falls below zero."""

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.physics.roots import root_between
from chutecalc.solver.collocation import rule

ASIDE = 1e-3
"""Of a panel: over which a margin's slope and bend are taken near its lowest place."""
LEVEL = 1e-13
"""A margin within this of 0 is at its event: rounding in it is a few 1e-16."""


def first_crossing(margin: Array) -> Array:
    """The place in (0, 1) where each column first falls below zero, or should be cut to see whether it does.

    Args:
        margin: values at the knots of a panel, shape (N + 2, designs); the start is taken as not below.

    Returns:
        Shape (designs,), infinite where the margin stays positive; 0 where it starts at zero and goes below at once. A
        margin that dips towards zero between two knots gives the bottom of the dip: cut there, the two parts are
        monotone and nothing hides between their knots.
    """
    below = margin < -LEVEL
    below[0] = False
    crossed = below.any(axis=0)
    place = np.full(margin.shape[1], np.inf)
    if crossed.any():
        place[crossed] = _root(margin[:, crossed], below[:, crossed].argmax(axis=0))
        place[below[1] & (margin[0] <= LEVEL)] = 0.0
    clear = ~crossed
    if clear.any():
        place[clear] = _dip(margin[:, clear])
    return place


def evaluate(values: Array, at: Array) -> Array:
    """The polynomials through values at the knots, shape (N + 2, m), each at its own places, shape (..., m).

    A sum down the first axis adds row after row whatever the width, as long as there is a width to go along.
    """
    own = rule(len(values) - 2)
    places = np.broadcast_to(at, (2, *at.shape))
    knots, weights = (item.reshape(-1, *[1] * places.ndim) for item in (own.knots, own.weights))
    gaps = places - knots
    exact = gaps == 0.0
    terms = weights / np.where(exact, 1.0, gaps)
    hit = exact.any(axis=0)
    terms = np.where(hit, exact, terms)
    heights = values.reshape(len(values), *[1] * (places.ndim - 1), -1)
    top: Array = np.add.reduce(terms * heights)
    bottom: Array = np.add.reduce(terms)
    result: Array = top[0] / bottom[0]
    return result


def slope_at(values: Array, knot: int) -> Array:
    """Derivative of those polynomials at one of the knots, per panel width, shape (m,)."""
    own = rule(len(values) - 2)
    total = np.zeros(values.shape[1])
    for k in range(len(values)):
        if k != knot % len(values):
            total = total + own.weights[k] / own.weights[knot] / (own.knots[knot] - own.knots[k]) * (
                values[k] - values[knot]
            )
    return total


def _root(margin: Array, first: Index) -> Array:
    """The root between the last knot above zero and the first below, on the polynomial through the knots."""
    knots = rule(len(margin) - 2).knots
    columns = np.arange(margin.shape[1])
    above = np.maximum(margin[first - 1, columns], 0.0)
    ends = (knots[first - 1], knots[first], above, margin[first, columns])
    return root_between(lambda at, columns: evaluate(margin[:, columns], at), *ends)


def _dip(margin: Array) -> Array:
    """The bottom of an inner minimum near zero: of the parabola through the lowest knot and its neighbours, refined."""
    knots = rule(len(margin) - 2).knots
    columns = np.arange(margin.shape[1])
    low = margin[1:-1].argmin(axis=0) + 1
    x0, x1, x2 = knots[low - 1], knots[low], knots[low + 1]
    f0, f1, f2 = margin[low - 1, columns], margin[low, columns], margin[low + 1, columns]
    left, right = (f1 - f0) / (x1 - x0), (f2 - f1) / (x2 - x1)
    bend = (right - left) / (x2 - x0)
    inner = (left < 0.0) & (right > 0.0)
    vertex = 0.5 * (x0 + x1) - 0.5 * left / np.where(inner, bend, 1.0)
    bottom = f1 - bend * (x1 - vertex) ** 2
    near = bottom < 0.2 * (np.maximum(f0, f2) - f1)
    dips = np.flatnonzero(inner & near & (vertex > knots[1]) & (vertex < knots[-2]))
    place = np.full(margin.shape[1], np.inf)
    if dips.size:
        place[dips] = _lowest(margin[:, dips], vertex[dips], x0[dips], x2[dips])
    return place


def _lowest(margin: Array, place: Array, low: Array, high: Array) -> Array:
    """Where the polynomials are lowest, by Newton's method with differences, from near there; between two bounds."""
    for _ in range(3):
        before, here, after = evaluate(margin, place + np.array([[-ASIDE], [0.0], [ASIDE]]))
        bend = after - 2.0 * here + before
        step = np.where(bend > 0.0, 0.5 * ASIDE * (before - after) / np.where(bend > 0.0, bend, 1.0), 0.0)
        place = np.clip(place + step, low, high)
    return place
