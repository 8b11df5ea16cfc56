"""Beds made up of points, whose density and wall forces are known, in place of what LAMMPS would say."""

import math

import numpy as np

from chutecalc.dem.bed import Bed
from chutecalc.dem.case import Case

RIGHT_ANGLE = math.pi / 2


def case(**changes):
    """Return a bed of the paper's Figure 5 at β = 45°, or what is changed of it."""
    known = {
        "base": 0.5,
        "lengths": (math.inf,),
        "inclinations": (math.pi / 4,),
        "area": 0.05,
        "friction": 0.75,
        "pour": "rain",
        "seed": 1,
    }
    return Case(**(known | changes))


def points(case, tilt=0.0, seed=5):
    """Points evenly over the area of a case, below a surface that rises by the share ``tilt`` of the depth outwards.

    The surface is that of :attr:`Bed.unevenness`: outer half of the width against the inner half.
    """
    random = np.random.default_rng(seed)
    wet = case.trough.wetting(case.area)
    depth, width = float(wet.depth[0]), float(wet.width[0])
    found = np.empty((0, 3))
    while len(found) < case.count:
        some = random.uniform((-width / 2, 0.0, 0.0), (width / 2, case.slice, 1.5 * depth), (20 * case.count, 3))
        x, z = some[:, 0], some[:, 2]
        inside = z < depth * (1.0 + 2.0 * tilt * (2.0 * np.abs(x) / width - 0.5))
        for wall in case.trough.walls:
            across, up = wall.normal
            inside &= (x - wall.foot[0]) * across + (z - wall.foot[1]) * up >= 0.0
        found = np.concatenate([found, some[inside]])
    return found[: case.count]


def bed(case, vertical_ratio=0.2, law="equilibrium", tilt=0.0, noise=0.0, kinetic_energy=0.0):
    """Return a bed whose walls carry what a law says at the area that the bed shows.

    ``noise`` is a share by which the left walls carry more than the right ones.
    """
    positions = points(case, tilt)
    empty = Bed(case, np.zeros((len(case.trough.walls), 2)), kinetic_energy, positions)
    loads = case.trough.load(empty.area, vertical_ratio, law).walls
    forces = [
        loads[wall.name] * empty.weight * (1.0 - noise * wall.side) * np.array(wall.normal)
        for wall in case.trough.walls
    ]
    return Bed(case, np.array(forces), kinetic_energy, positions)
