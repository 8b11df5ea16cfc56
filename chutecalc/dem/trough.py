"""The trough that a bed rests in: the section of a chute as planes, with the loads that the friction law gives."""

import math
from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Values, real
from chutecalc.physics.pressure import pressure_ratio
from chutecalc.physics.section import Polygon
from chutecalc.physics.wetting import Wetting, area_at_depth, wetting

UPRIGHT = math.pi / 2
"""Inclination of a vertical wall, rad."""


class Wall(NamedTuple):
    """One plane of a trough; x points from the middle to the right, z up from the floor."""

    name: str
    """``floor``, ``chamfer``, ``facet N`` or ``side wall``; left and right share it."""
    side: int
    """-1 for left, 1 for right, 0 for the floor."""
    inclination: float
    """Inclination ψ to the floor, rad."""
    foot: tuple[float, float]
    """x and z of the lower end, m; of the floor its middle."""
    length: float
    """Length along the section, m; infinite where the wall has no top."""

    @property
    def normal(self) -> tuple[float, float]:
        """Unit normal into the trough, x and z, dimensionless."""
        return -self.side * math.sin(self.inclination), math.cos(self.inclination)

    def thrust(self, depth: float) -> float:
        """Compute ∫ ζ dl over the wall, its normal load at K = 1 per unit weight and length.

        Args:
            depth: Depth of the bed, m.

        Returns:
            The integral, m².

        >>> floor, left, right = Trough(0.5, (), ()).walls
        >>> floor.thrust(0.2), round(left.thrust(0.2), 12)
        (0.1, 0.02)
        """
        if self.side == 0:
            return self.length * depth
        sine = math.sin(self.inclination)
        below = max(depth - self.foot[1], 0.0)
        wetted = min(self.length, below / sine)
        return wetted * (below - 0.5 * wetted * sine)


class Load(NamedTuple):
    """The loads of a bed by a friction law, over its weight."""

    walls: dict[str, float]
    """Normal load on one wall by its name, a ratio."""
    ratio: float
    """N_t/N = 1 + χ, the sum of all normal loads, a ratio."""
    missing_load: float
    """Share m of the weight that hydrostatic pressures do not carry."""


class Trough:
    """A symmetric section of flat walls as a trough of unbounded planes.

    The planes of a section whose facets never flatten outwards bound a convex space, so each may be unbounded.

    Args:
        base: Width of the floor, m; 0 for a vee.
        lengths: Lengths of the drawn facets of one side, m, from the centre outwards. The last may be infinite. Above a
            drawn top the walls are vertical, as in every section of chutecalc.
        inclinations: Inclinations of these facets to the floor, rad, in [0, π/2], not falling.

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
        """Return the trough of a section.

        Args:
            section: A section of one design.
        """
        return cls(
            float(section.base[0]),
            tuple(float(length[0]) for length in section.lengths),
            tuple(float(inclination[0]) for inclination in section.inclinations),
        )

    @cached_property
    def walls(self) -> tuple[Wall, ...]:
        """The floor, if there is one, then the left and right walls from the centre outwards."""
        floor = Wall("floor", side=0, inclination=0.0, foot=(0.0, 0.0), length=self.base)
        walls = [floor] if self.base > 0.0 else []
        facets = list(zip(self.lengths, self.inclinations, strict=True))
        if not facets or math.isfinite(facets[-1][0]):
            facets.append((math.inf, UPRIGHT))
        sloped = sum(inclination < UPRIGHT for _, inclination in facets)
        x, z = 0.5 * self.base, 0.0
        for number, (length, inclination) in enumerate(facets, 1):
            name = "chamfer" if sloped == 1 else f"facet {number}"
            if inclination == UPRIGHT:
                name = "side wall"
            walls += [Wall(name, side, inclination, foot=(side * x, z), length=length) for side in (-1, 1)]
            if math.isfinite(length):
                x, z = x + length * math.cos(inclination), z + length * math.sin(inclination)
        return tuple(walls)

    @cached_property
    def section(self) -> Polygon:
        """The trough as a cross-section of one design."""
        lengths, inclinations = (
            tuple(np.array([value]) for value in values) for values in (self.lengths, self.inclinations)
        )
        return Polygon(
            base=np.array([self.base]), lengths=lengths, inclinations=inclinations, wall_height=np.array([np.inf])
        )

    def wetting(self, area: Values, vertical_ratio: float = 1.0, equilibrium: bool = False) -> Wetting:
        """Compute depth, width and excess friction of beds in the trough.

        Args:
            area: Areas of the beds, m², positive.
            vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].
            equilibrium: Whether to use the equilibrium law, as in :func:`chutecalc.physics.wetting.wetting`.
        """
        return wetting(self.section, np.array([vertical_ratio]), np.atleast_1d(real(area)), equilibrium)

    def area_below(self, height: Values) -> Array:
        """Compute the area of the trough below heights.

        Args:
            height: Heights above the floor, m, 0 or more.

        Returns:
            Areas, m², in the shape of ``height``.

        >>> float(Trough(0.5, (), ()).area_below(0.1)[0].round(12))
        0.05
        """
        return area_at_depth(self.section, np.atleast_1d(real(height)))

    def load(self, area: float, vertical_ratio: float, law: str) -> Load:
        """Compute the load of a bed on each wall by a friction law.

        Args:
            area: Area of the bed, m², positive.
            vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].
            law: ``paper``, which lays the missing load on the floor (Paper Eq 6), or ``equilibrium``, which scales all
                pressures.

        Returns:
            The loads. A vee has no floor: the loads of the paper's law then do not add up to the weight.

        >>> load = Trough(0.5, (math.inf,), (math.radians(45.0),)).load(0.05, 1.0 / 3.0, "paper")
        >>> round(math.tan(math.radians(25.0)) * load.ratio, 5)  # μ_e at φ = 25°, as in the paper's Figure 5
        0.48509
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
        return Load(walls, ratio=1.0 + float(wet.excess[0]), missing_load=missing_load)
