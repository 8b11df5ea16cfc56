"""Measurements of a bed at rest: its area, its surface, the load on each wall, and whether it can be trusted."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.dem.case import Case
from chutecalc.physics.arrays import Array

BALANCE, SIDES, REST, LEVEL = 1e-3, 1e-2, 1e-7, 0.05
"""Limits of the checks: vertical wall force over the weight less 1; sideways force over the push of one side; kinetic
energy of a particle over m g d; unevenness over depth."""

FURTHEST = 1e4
"""A particle further than that from the trough, m, is none."""
MOST_WEIGHTS = 1e6
"""Nor is a force of so many times the weight of the bed one of a wall."""


class Check(NamedTuple):
    """A condition that every bed must meet."""

    name: str
    """``balance``, ``sides``, ``rest`` or ``level``."""
    value: float
    """Measured, a ratio."""
    allowed: float
    """Largest magnitude allowed, a ratio."""

    @property
    def passed(self) -> bool:
        """Whether the bed meets it; NaN does not."""
        return abs(self.value) <= self.allowed


class Bed:
    """A measured bed.

    Args:
        case: How it was made.
        forces: Force of each wall of the trough on the bed, x and z, N, shape (walls, 2).
        kinetic_energy: Mean kinetic energy of a particle, J.
        positions: Centres of the particles, x across, y along and z up, m, shape (particles, 3).

    >>> from chutecalc.dem.pour import column
    >>> case = Case(base=0.1, lengths=(), inclinations=(), area=0.005, friction=0.75, pour="rain", seed=1)
    >>> weight = case.count * case.mass * case.acceleration
    >>> forces = weight * np.array([[0.0, 1.0], [0.2, 0.0], [-0.2, 0.0]])  # of the floor, left and right walls
    >>> bed = Bed(case, forces, kinetic_energy=0.0, positions=column(case))
    >>> round(bed.ratio, 12), {name: round(load, 12) for name, load in bed.by_name.items()}
    (1.4, {'floor': 1.0, 'side wall': 0.2})
    """

    def __init__(self, case: Case, forces: Array, kinetic_energy: float, positions: Array) -> None:
        self.case, self.forces, self.kinetic_energy, self.positions = case, forces, kinetic_energy, positions

    @property
    def weight(self) -> float:
        """Weight of the bed under its body force, N."""
        return self.case.count * self.case.mass * self.case.acceleration

    @cached_property
    def _filling(self) -> tuple[float, float]:
        """Fit the solid fraction of the interior, and the area at the floor that it leaves void.

        The solids below a height, plotted over the area of the section below it, lie on a line between the layers that
        the floor orders and the loose surface.
        """
        slope, start = np.polyfit(*self._interior, 1)
        return float(slope), float(-start / slope)

    @cached_property
    def _interior(self) -> tuple[Array, Array]:
        """Area of the section below each particle of the interior, and the solids below it over the slice, m²."""
        heights = np.sort(self.positions[:, 2])
        top = heights[int(0.99 * len(heights)) - 1]
        inner = (heights > 0.25 * top) & (heights < 0.75 * top)
        below = (np.arange(len(heights)) + 0.5) * self.case.particle_volume / self.case.slice
        return self.case.trough.area_below(heights[inner]), below[inner]

    @property
    def is_possible(self) -> bool:
        """Whether it can be a bed: no particle and no force is too far or too large for one, and the interior has some.

        Others are those of a damaged file, of which nothing can be measured.
        """
        if not ((np.abs(self.positions) < FURTHEST).all() and (np.abs(self.forces) < MOST_WEIGHTS * self.weight).all()):
            return False
        area, _ = self._interior
        return np.unique(area).size > 1 and 0.0 < self.solid_fraction < 1.0

    @property
    def solid_fraction(self) -> float:
        """Solid fraction of the interior, a ratio of volumes."""
        return self._filling[0]

    @property
    def area(self) -> float:
        """Flow area of the bed, m²: where all particles would end if the interior's solid fraction held up to there."""
        filling, void = self._filling
        return self.case.count * self.case.particle_volume / self.case.slice / filling + void

    @cached_property
    def depth(self) -> float:
        """Depth of a level bed of that area, m."""
        return float(self.case.trough.wetting(self.area).depth[0])

    @cached_property
    def surface(self) -> tuple[Array, Array]:
        """Surface across the trough, x and z, m: means along the chute of the highest particles in square cells."""
        d = self.case.diameter
        half = 0.5 * float(self.case.trough.wetting(self.area).width[0])
        edges = np.linspace(-half, half, max(round(2.0 * half / d), 4) + 1)
        rows = max(int(self.case.slice / d), 1)
        column = np.digitize(self.positions[:, 0], edges) - 1
        row = (self.positions[:, 1] / self.case.slice * rows).astype(int) % rows
        inside = (column >= 0) & (column < len(edges) - 1)
        highest = np.full((len(edges) - 1, rows), -np.inf)
        np.maximum.at(highest, (column[inside], row[inside]), self.positions[inside, 2] + 0.5 * d)
        full = np.isfinite(highest)
        means = np.where(full, highest, 0.0).sum(axis=1) / np.maximum(full.sum(axis=1), 1)
        return 0.5 * (edges[1:] + edges[:-1]), np.where(full.any(axis=1), means, np.nan)

    @property
    def unevenness(self) -> float:
        """Height of the outer half of the surface above the inner half, over the depth, a ratio.

        A diameter at each edge is left out: no particle fills the corner between surface and wall.
        """
        x, z = self.surface
        half = x[-1] + 0.5 * (x[1] - x[0])
        outer = (np.abs(x) > 0.5 * half) & (np.abs(x) < half - self.case.diameter)
        inner = np.abs(x) <= 0.5 * half
        return float((np.nanmean(z[outer]) - np.nanmean(z[inner])) / self.depth)

    @cached_property
    def loads(self) -> Array:
        """Normal load on each wall over the weight, a ratio, in the order of the trough's walls, shape (walls,)."""
        normals = np.array([wall.normal for wall in self.case.trough.walls])
        return np.asarray((self.forces * normals).sum(axis=1) / self.weight)

    @property
    def ratio(self) -> float:
        """N_t/N, the sum of all normal loads over the weight, a ratio (Paper Eq 10)."""
        return float(self.loads.sum())

    @property
    def by_name(self) -> dict[str, float]:
        """Load on one wall over the weight, by the wall's name: the mean of left and right."""
        walls = self.case.trough.walls
        return {
            name: float(np.mean([load for load, wall in zip(self.loads, walls, strict=True) if wall.name == name]))
            for name in dict.fromkeys(wall.name for wall in walls)
        }

    @property
    def pressure_ratios(self) -> dict[str, float]:
        """Pressure ratio K of each wall by its name, (N_w/W) A/∫ζ dl with the depth ζ below the surface.

        For chamfers without a top this is (2 N_c/W)(B + C cos β)/C. A wall that the bed does not reach has none.
        """
        thrusts = {wall.name: wall.thrust(self.depth) for wall in self.case.trough.walls}
        return {name: load * self.area / thrusts[name] for name, load in self.by_name.items() if thrusts[name] > 0.0}

    @property
    def checks(self) -> tuple[Check, ...]:
        """Checks: the walls carry the weight and push equally from both sides; the bed is at rest and level."""
        across, up = self.forces.sum(axis=0)
        push = 0.5 * float(np.abs(self.forces[:, 0]).sum())
        return (
            Check("balance", float(up / self.weight - 1.0), BALANCE),
            Check("sides", float(across / push), SIDES),
            Check("rest", self.kinetic_energy / (self.case.mass * self.case.acceleration * self.case.diameter), REST),
            Check("level", self.unevenness, LEVEL),
        )

    @property
    def failed(self) -> tuple[Check, ...]:
        """The checks that fail."""
        return tuple(check for check in self.checks if not check.passed)
