"""Initial positions of the particles: a dilute column that rains on the rising surface of the bed."""

import math

import numpy as np

from chutecalc.dem.case import GRAVITY, LOOSE, POURS, Case
from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array

TRIES = 2000
"""Positions drawn for a particle before giving up."""
FEWEST = 100
"""Smallest number of particles in a bed."""
MOST = 1_000_000
"""Largest number of particles in a bed. LAMMPS takes days for as many on a processor."""
SETTLED = 0.4
"""Time that a bed takes to come to rest after the pour, s under 1 g, roughly."""


def check_room(case: Case) -> None:
    """Check that a bed is large enough for its particles, and has no more of them than can be poured.

    Args:
        case: The case to check.

    Raises:
        UsageError: The bed has fewer than 100 particles or more than a million, or is less than 4 diameters wide or
            3 long.

    >>> check_room(Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1))
    """
    if case.count > MOST:
        raise UsageError(
            f"a bed of {case.area:g} m² has {case.count:.3g} particles of {1000 * case.diameter:g} mm, and at most"
            f" {MOST:,} are poured. Use a larger --diameter, a smaller --area or a shorter --slice"
        )
    wide, long = float(case.trough.wetting(case.area).width[0]) / case.diameter, case.slice / case.diameter
    if case.count < FEWEST or wide < 4.0 or long < 3.0:
        raise UsageError(
            f"a bed of {case.area:g} m² is too small for particles of {1000 * case.diameter:g} mm: it has"
            f" {case.count} of them and is {wide:.1f} diameters wide and {long:.1f} long. Use a smaller --diameter or a"
            " longer --slice"
        )


def _rising(case: Case) -> tuple[Array, Array]:
    """Compute the height of each particle in the column, and the width of the surface it will land on, m."""
    width = case.trough.wetting(case.area * (np.arange(case.count) + 0.5) / case.count).width
    room = LOOSE * case.slice * np.maximum(width, 2.0 * case.diameter)
    return case.diameter + np.cumsum(case.particle_volume / room), width


def steps(case: Case) -> int:
    """Estimate the number of time steps that a case takes.

    Args:
        case: The case.

    >>> steps(Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1))
    9480
    """
    top, speed = float(_rising(case)[0][-1]), POURS[case.pour].speed
    acceleration = GRAVITY * case.body_force
    falling = top / speed if math.isfinite(speed) else math.sqrt(2.0 * top / acceleration)
    return round((falling + SETTLED / math.sqrt(case.body_force)) / case.time_step)


def column(case: Case) -> Array:
    """Draw the initial positions of the particles, the lowest first.

    Each particle hangs at random over the surface of the bed that the particles below it will have formed, with the
    density 1 + e (2 |ξ| - 1) across that surface. The surface then rises evenly and the bed stays level while it grows;
    rain on the full width from the start would slide down the chamfers and overload them. A position that is taken is
    drawn again, which evens the density slightly.

    Args:
        case: The case, which gives trough, particles, seed and spread.

    Returns:
        Centres, x across, y along and z up, m, shape (particles, 3). No two are closer than a diameter, and none is in
        a wall.

    Raises:
        UsageError: A particle finds no free position.

    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> column(case).shape == (case.count, 3)
    True
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
    """Draw a position at a height, clear of the particles near it."""
    for _ in range(TRIES):
        position = np.array([reach * _across(random, case.spread), random.uniform(0.0, case.slice), height])
        apart = np.abs(near - position)
        apart[:, 1] = np.minimum(apart[:, 1], case.slice - apart[:, 1])  # periodic along the chute
        if (np.square(apart).sum(axis=1) >= case.diameter**2).all():
            return position
    raise UsageError(f"there is no room for all particles of {1000 * case.diameter:g} mm. Use a longer --slice")


def _across(random: np.random.Generator, spread: float) -> float:
    """Draw ξ from -1 to 1 with the density 1 + e (2 |ξ| - 1), by rejection."""
    while True:
        across = float(random.uniform(-1.0, 1.0))
        if random.uniform(0.0, 1.0 + abs(spread)) <= 1.0 + spread * (2.0 * abs(across) - 1.0):
            return across
