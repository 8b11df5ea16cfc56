"""Derivatives from values beside a point, and whether they hold to both sides of it."""

from typing import NamedTuple

import numpy as np

from chutecalc.api.parameter import Parameter
from chutecalc.api.scatter import bounds_of
from chutecalc.fields.units import convert, first_unit, from_si
from chutecalc.physics.arrays import Array, Mask

CENTRAL, FORWARD = np.array([-1.0, -0.5, 0.5, 1.0]), np.array([0.25, 0.5, 0.75, 1.0])
"""Where a key is put, in steps from its value: to both sides of it, or to one side next to a bound."""
SMOOTH = 1e-3
"""Share of a derivative by which slopes of a smooth function may differ. By h^2 they do, those at a kink by 1."""
NOISE = 8.0
"""By how many times what the solver may have wrong a difference of values may be wrong."""


class Slopes(NamedTuple):
    """Derivatives by several keys; arrays of shape (keys,)."""

    derivative: Array
    """By the polynomial through all five points; by the half without failures where some fail; NaN without one."""
    error: Array
    """Its estimated error: how far the mean slope by the halves is from it, and what the solver allows; NaN where some
    fail."""
    smooth: Mask
    """Whether the slopes by the two halves agree."""


def step_of(key: Parameter, rtol: float) -> float:
    """Return the step of a key, in its unit.

    The error of a difference is about rtol/h + h^2, least at h = rtol^(1/3), as a share of the value; of a key that may
    be 0, such as a position, of one SI unit at least. From 0 the first of the values must be one that the key takes.

    Args:
        key: a number of a spec.
        rtol: relative tolerance of the solver.
    """
    dimension = key.quantity.dimension
    size, share = abs(key.value_in_unit), rtol ** (1.0 / 3.0)
    if not key.quantity.takes_zero:
        return float(size * share)
    one = float(convert(from_si(1.0, dimension), dimension, first_unit(dimension), key.unit))
    step = float(max(size, one) * share)
    return step if size else max(step, bounds_of(key)[0] / float(FORWARD[0]))


def positions(key: Parameter, step: float) -> Array:
    """Return where a key is put, in steps from its value: to one side where the other is out of bounds.

    Args:
        key: a number of a spec.
        step: in the unit of the key.
    """
    (low, high), value = bounds_of(key), key.value_in_unit
    if value - step < low:
        return FORWARD
    return -FORWARD[::-1] if value + step > high else CENTRAL


def slopes(value: float, beside: Array, at: Array, steps: Array, rtol: float) -> Slopes:
    """Return the derivatives of a function by several keys.

    All five points together give (4 D(h/2) - D(h)) / 3 of the central differences D, which is exact up to h^4. The
    two points of either half give a slope each, by a parabola, exact up to h^2; their mean differs from the first
    by 2/3 (D(h/2) - D(h)).

    Args:
        value: of the function at the point, in any unit.
        beside: its values in that unit with each key at its positions, shape (keys, 4); NaN where it fails.
        at: the positions, in steps, dimensionless, shape (keys, 4).
        steps: in the units of the keys, shape (keys,).
        rtol: relative tolerance of the values.

    >>> found = slopes(1.0, np.exp(0.1 * CENTRAL)[None], CENTRAL[None], np.array([0.1]), 1e-16)
    >>> abs(found.derivative - 1.0) < 1e-6, found.smooth
    (array([ True]), array([ True]))
    """
    change = beside - value
    whole, low, high = (
        np.array([_slope(own[part], places[part]) for own, places in zip(change, at, strict=True)]) / steps
        for part in (slice(None), slice(0, 2), slice(2, 4))
    )
    noise = NOISE * rtol * abs(value) / steps
    error = np.abs(whole - 0.5 * (low + high)) + noise
    smooth = np.abs(high - low) <= SMOOTH * np.abs(whole) + 2.0 * noise
    derivative = np.where(np.isfinite(whole), whole, np.where(np.isfinite(low), low, high))
    return Slopes(derivative, error, smooth)


def _slope(change: Array, places: Array) -> float:
    """Return the slope at 0 of the polynomial through the origin and some points."""
    return float(np.linalg.solve(np.vander(places, len(places) + 1, increasing=True)[:, 1:], change)[0])
