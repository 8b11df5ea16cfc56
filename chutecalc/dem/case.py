"""A case: one bed of equal spheres poured into a trough, with the properties of its particles and contacts."""

import hashlib
import json
import math
from dataclasses import asdict, dataclass
from typing import NamedTuple

import numpy as np

from chutecalc.dem.trough import Trough

GRAVITY = 9.80665
"""Standard gravity, m/s²."""
DENSITY = 2500.0
"""Density of a particle, kg/m³. It cancels: loads are reported over the weight."""
STIFFNESS = 4.0e3
"""Stiffness of a contact, N/m, for spheres of 10 mm under 1 g: it compresses the lowest layer of the paper's bed by
0.003 of a diameter. It is scaled with m g/d, so that all particles are equally hard."""
RESTITUTION = 0.3
"""Coefficient of restitution of a contact."""
STEPS_A_COLLISION = 20
"""Time steps during one collision."""
LOOSE = 0.1
"""Solid fraction of the falling column."""
METHOD = 1
"""Version of the method. Increase it when a case would give other results: stored results of other versions are then
not used."""


class Pour(NamedTuple):
    """A way to pour the particles."""

    speed: float
    """Terminal speed, m/s, with which the particles start. Infinite: they fall freely, from rest."""
    filling: float
    """Its contribution to the expected solid fraction."""


POURS = {
    "gentle": Pour(speed=0.3, filling=-0.04),
    "rain": Pour(speed=1.0, filling=0.0),
    "freefall": Pour(speed=math.inf, filling=0.04),
}
"""The pours by name."""
PACKING = ((0.35, 0.75, 0.9), (0.56, 0.47, 0.445))
"""Coefficients of particle friction and the solid fractions of rained beds without rotation. They only set the number
of particles."""


@dataclass(frozen=True)
class Case:
    """One run of LAMMPS.

    >>> case = Case(
    ...     base=0.5, lengths=(math.inf,), inclinations=(math.pi / 4,), area=0.05, friction=0.75, pour="rain", seed=1
    ... )
    >>> case.count, f"{case.time_step:.2g} s"
    (2244, '6.8e-05 s')
    """

    base: float
    """Width of the trough's floor, m; 0 for a vee."""
    lengths: tuple[float, ...]
    """Lengths of the drawn facets on one side, m, as in :class:`chutecalc.dem.trough.Trough`."""
    inclinations: tuple[float, ...]
    """Inclinations of these facets, rad."""
    area: float
    """Target area of the bed, m². The area of the bed that results is measured."""
    friction: float
    """Coefficient of friction between particles."""
    pour: str
    """Name of the pour, in :data:`POURS`."""
    seed: int
    """Seed of the particles' positions before the pour."""
    body_force: float = 1.0
    """Body force under which the bed is poured, in g."""
    raised_to: float = 0.0
    """Body force to which the resting bed is raised before it is measured, in g; 0 to leave it."""
    spread: float = 0.0
    """Spread e of the rain, a ratio: its density is 1 + e (2 |ξ| - 1) from the middle, ξ = 0, to the edge, |ξ| = 1."""
    diameter: float = 0.01
    """Diameter of the particles, m."""
    slice: float = 0.05
    """Length of the periodic trough along the chute, m."""

    @property
    def trough(self) -> Trough:
        """The trough that the bed is poured into."""
        return Trough(self.base, self.lengths, self.inclinations)

    @property
    def particle_volume(self) -> float:
        """Volume of a particle, m³."""
        return math.pi * self.diameter**3 / 6.0

    @property
    def mass(self) -> float:
        """Mass of a particle, kg."""
        return DENSITY * self.particle_volume

    @property
    def count(self) -> int:
        """Number of particles that the target area is expected to take."""
        filling = float(np.interp(self.friction, *PACKING)) + POURS[self.pour].filling
        return round(self.area * self.slice * filling / self.particle_volume)

    @property
    def acceleration(self) -> float:
        """Body acceleration under which the bed is measured, m/s²."""
        return GRAVITY * (self.raised_to or self.body_force)

    @property
    def stiffness(self) -> float:
        """Normal stiffness of a contact, N/m."""
        return STIFFNESS * self.body_force * (self.diameter / 0.01) ** 2

    def damping(self, effective_mass: float) -> float:
        """Compute the damping coefficient of a contact from the restitution, γ = 2 λ √(k/m)/√(π² + λ²) with λ = -ln e.

        Args:
            effective_mass: m of the collision, kg: half a particle's mass between two, its whole mass on a wall.

        Returns:
            γ, 1/s, per effective mass.
        """
        loss = -math.log(RESTITUTION)
        return 2.0 * loss * math.sqrt(self.stiffness / effective_mass) / math.hypot(math.pi, loss)

    @property
    def time_step(self) -> float:
        """Time step, s: a twentieth of the duration of a collision of two particles."""
        mass = 0.5 * self.mass
        frequency = math.sqrt(self.stiffness / mass - 0.25 * self.damping(mass) ** 2)
        return math.pi / frequency / STEPS_A_COLLISION

    @property
    def slope_label(self) -> str:
        """Inclinations of the drawn walls in degrees, as text."""
        return " ".join(f"{math.degrees(inclination):g}" for inclination in self.inclinations) or "90"

    @property
    def name(self) -> str:
        """Name of the case's folder: the main parameters and a digest of all of them."""
        digest = hashlib.sha256(json.dumps([METHOD, asdict(self)], sort_keys=True).encode()).hexdigest()[:10]
        return f"b{self.slope_label.replace(' ', '-')}_f{self.friction:g}_{self.pour}_s{self.seed}_{digest}"
