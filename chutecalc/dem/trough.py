"""The trough that a bed of particles rests in: a chute's section as planes, and what the friction law says of it."""

import math
from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Values, real
from chutecalc.physics.pressure import pressure_ratio
from chutecalc.physics.section import Polygon
from chutecalc.physics.wetting import Wetting, area_at_depth, wetting

UPRIGHT = math.pi / 2


class Wall(NamedTuple):
    """One plane of a trough; x counts from the middle to the right, z from the floor up."""

    name: str
    """What it is, the same for the left and the right one."""
    side: int
    """-1 left, 1 right, 0 for the floor."""
    inclination: float
    """ψ to the floor, rad."""
    foot: tuple[float, float]
    """x and z of its lower end, m; of the floor its middle."""
    length: float
    """Along the section, m; infinite where it has no top."""

    @property
    def normal(self) -> tuple[float, float]:
        """The unit normal into the trough, x and z."""
        return -self.side * math.sin(self.inclination), math.cos(self.inclination)

    def thrust(self, depth: float) -> float:
        """∫ ζ dl over this wall at a depth of the bed, m²: its load at K = 1 over unit weight."""
        if self.side == 0:
            return self.length * depth
        sine = math.sin(self.inclination)
        below = max(depth - self.foot[1], 0.0)
        wetted = min(self.length, below / sine)
        return wetted * (below - 0.5 * wetted * sine)


class Load(NamedTuple):
    """What the friction law says of a bed, over its weight."""

    walls: dict[str, float]
    """Normal load on one wall of each name."""
    ratio: float
    """N_t/N, all normal loads together: 1 + χ."""
    missing_load: float
    """m, the share that hydrostatic pressures leave uncarried."""


class Trough:
    """A symmetric section of flat walls as a trough of planes without end.

    Args:
        base: width of the floor, m; 0 for a vee.
        lengths, inclinations: of the drawn facets of one side, from the centre outwards, m and rad. The last length may
            be infinite. Above a drawn top the walls go on upright, as in every section of chutecalc.

    The planes of a section whose facets never flatten outwards bound a convex space, so each may go on without end.

    >>> vee = Trough(0.0, (math.inf,), (math.radians(60.0),))
    >>> [wall.side for wall in vee.walls], round(vee.load(0.1, 0.2, "equilibrium").ratio, 12)
    ([-1, 1], 2.0)
    """

    def __init__(self, base: float, lengths: tuple[float, ...], inclinations: tuple[float, ...]) -> None:
        drawn: list[tuple[float, float]] = []
        for length, inclination in zip(lengths, inclinations, strict=True):
            if inclination == 0.0:
                base += 2.0 * length
                continue
            if drawn and inclination == drawn[-1][1]:  # one plane, drawn in two parts
                length += drawn.pop()[0]
            drawn.append((math.inf if inclination == UPRIGHT else length, inclination))
        self.base = base
        self.lengths = tuple(length for length, _ in drawn)
        self.inclinations = tuple(inclination for _, inclination in drawn)

    @classmethod
    def of(cls, section: Polygon) -> "Trough":
        """The trough of a section of one design."""
        return cls(
            float(section.base[0]),
            tuple(float(length[0]) for length in section.lengths),
            tuple(float(inclination[0]) for inclination in section.inclinations),
        )

    @cached_property
    def walls(self) -> tuple[Wall, ...]:
        """The floor, where there is one, and the left and right walls from the centre outwards."""
        walls = [Wall("floor", 0, 0.0, (0.0, 0.0), self.base)] if self.base > 0.0 else []
        facets = list(zip(self.lengths, self.inclinations, strict=True))
        if not facets or math.isfinite(facets[-1][0]):
            facets.append((math.inf, UPRIGHT))
        sloped = sum(inclination < UPRIGHT for _, inclination in facets)
        x, z = 0.5 * self.base, 0.0
        for number, (length, inclination) in enumerate(facets, 1):
            name = "chamfer" if sloped == 1 else f"facet {number}"
            if inclination == UPRIGHT:
                name = "side wall"
            walls += [Wall(name, side, inclination, (side * x, z), length) for side in (-1, 1)]
            if math.isfinite(length):
                x, z = x + length * math.cos(inclination), z + length * math.sin(inclination)
        return tuple(walls)

    @cached_property
    def section(self) -> Polygon:
        """As a cross-section."""
        lengths, inclinations = (
            tuple(np.array([value]) for value in values) for values in (self.lengths, self.inclinations)
        )
        return Polygon(np.array([self.base]), lengths, inclinations, np.array([np.inf]))

    def wetting(self, area: Values, vertical_ratio: float = 1.0, equilibrium: bool = False) -> Wetting:
        """How beds of these areas, m², lie in the trough."""
        return wetting(self.section, np.array([vertical_ratio]), np.atleast_1d(real(area)), equilibrium)

    def area_below(self, height: Values) -> Array:
        """Area of the trough below heights, m²."""
        return area_at_depth(self.section, np.atleast_1d(real(height)))

    def load(self, area: float, vertical_ratio: float, law: str) -> Load:
        """What each wall carries of a bed by the general law.

        Args:
            area: of the bed, m².
            vertical_ratio: K_v.
            law: ``paper``, which lays the missing load on the floor, or ``equilibrium``, which scales all pressures.

        Returns:
            The loads. In a vee there is no floor, and those of the paper's law do not add up to the weight.
        """
        wet = self.wetting(area, vertical_ratio, law == "equilibrium")
        depth, missing_load = float(wet.depth[0]), float(wet.missing_load[0])
        scale = 1.0 / (1.0 - missing_load) if law == "equilibrium" else 1.0
        walls = {
            wall.name: scale * float(pressure_ratio(wall.inclination, vertical_ratio)) * wall.thrust(depth) / area
            for wall in self.walls
        }
        if law == "paper" and "floor" in walls:
            walls["floor"] += missing_load
        return Load(walls, 1.0 + float(wet.excess[0]), missing_load)
