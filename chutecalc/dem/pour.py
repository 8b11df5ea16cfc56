"""Where the particles hang before they come down: a dilute column that rains on the rising surface."""

import math

import numpy as np

from chutecalc.dem.case import GRAVITY, LOOSE, POURS, Case
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array

TRIES = 2000
FEWEST = 100
"""Particles."""
SETTLED = 0.4
"""Time that a bed takes to rest after the pour, s under 1 g, about."""


def check_room(case: Case) -> None:
    """That a bed is large enough to be one.

    Raises:
        UsageError: it is a few particles wide, long or in all.
    """
    wide, long = float(case.trough.wetting(case.area).width[0]) / case.diameter, case.slice / case.diameter
    if case.count < FEWEST or wide < 4.0 or long < 3.0:
        raise UsageError(
            f"a bed of {case.area:g} m² is too small for particles of {1000 * case.diameter:g} mm: {case.count} of them"
            f", {wide:.1f} diameters wide, {long:.1f} along. Give a smaller --diameter, or a longer --slice"
        )


def _rising(case: Case) -> tuple[Array, Array]:
    """Height of each particle in the column, and the width of the surface that it is meant for, m."""
    width = case.trough.wetting(case.area * (np.arange(case.count) + 0.5) / case.count).width
    room = LOOSE * case.slice * np.maximum(width, 2.0 * case.diameter)
    return case.diameter + np.cumsum(case.particle_volume / room), width


def steps(case: Case) -> int:
    """Time steps that a case takes, about."""
    top, speed = float(_rising(case)[0][-1]), POURS[case.pour].speed
    acceleration = GRAVITY * case.body_force
    falling = top / speed if math.isfinite(speed) else math.sqrt(2.0 * top / acceleration)
    return round((falling + SETTLED / math.sqrt(case.body_force)) / case.time_step)


def column(case: Case) -> Array:
    """Centres of the particles at the start, the lowest first.

    Each is meant for the bed that those below it will have made: it hangs somewhere over that bed's surface, with the
    density 1 + e (2 |ξ| - 1) across it. The surface rises evenly, so the bed stays level while it grows; rain on the
    full width from the start would slide down the chamfers and overload them. A position that is taken is drawn again,
    which evens the density a little.

    Args:
        case: whose trough, particles, seed and spread are taken.

    Returns:
        x across, y along and z up, m, shape (particles, 3); no two nearer than a diameter, none in a wall.

    Raises:
        UsageError: particles that find no room.
    """
    d = case.diameter
    heights, width = _rising(case)
    reach = np.maximum(0.5 * (width - d), 0.5 * d)
    random = np.random.default_rng(case.seed)
    positions = np.empty((case.count, 3))
    lowest = 0
    for number, height in enumerate(heights):
        while lowest < number and height - positions[lowest, 2] >= d:
            lowest += 1
        positions[number] = _free_position(random, case, float(reach[number]), float(height), positions[lowest:number])
    return positions


def _free_position(random: np.random.Generator, case: Case, reach: float, height: float, near: Array) -> Array:
    """A position at a height that is clear of the particles near it."""
    for _ in range(TRIES):
        position = np.array([reach * _across(random, case.spread), random.uniform(0.0, case.slice), height])
        apart = np.abs(near - position)
        apart[:, 1] = np.minimum(apart[:, 1], case.slice - apart[:, 1])  # periodic along the chute
        if (np.square(apart).sum(axis=1) >= case.diameter**2).all():
            return position
    raise UsageError(f"the particles of {1000 * case.diameter:g} mm find no room: give a longer --slice")


def _across(random: np.random.Generator, spread: float) -> float:
    """ξ from -1 to 1 with the density 1 + e (2 |ξ| - 1), by rejection."""
    while True:
        across = float(random.uniform(-1.0, 1.0))
        if random.uniform(0.0, 1.0 + abs(spread)) <= 1.0 + spread * (2.0 * abs(across) - 1.0):
            return across
