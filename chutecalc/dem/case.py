"""One case: a bed of equal spheres poured into a trough, and the numbers of its particles and contacts."""

import hashlib
import json
import math
from dataclasses import asdict, dataclass
from typing import NamedTuple

import numpy as np

from chutecalc.dem.trough import Trough

GRAVITY = 9.80665
DENSITY = 2500.0
"""Of a particle, kg/m³. Loads are told over the weight, so it cancels."""
STIFFNESS = 4.0e3
"""Of a contact, N/m, for spheres of 10 mm under 1 g: the lowest layer of the paper's bed is then pressed in by 0.003 of
its diameter. It goes with m g/d, so that all particles are equally hard."""
RESTITUTION = 0.3
STEPS_A_COLLISION = 20
LOOSE = 0.1
"""Solid fraction of the falling column."""
METHOD = 1
"""Counts up whenever the same case would come out otherwise: kept results of another method are not taken."""


class Pour(NamedTuple):
    """How the particles come down."""

    speed: float
    """Terminal speed, m/s, with which they start; infinite: they fall freely, from rest."""
    filling: float
    """What it adds to the expected solid fraction."""


POURS = {"gentle": Pour(0.3, -0.04), "rain": Pour(1.0, 0.0), "freefall": Pour(math.inf, 0.04)}
PACKING = ((0.35, 0.75, 0.9), (0.56, 0.47, 0.445))
"""Particle friction, and the solid fraction of rained beds without rotation: only for how many particles are needed."""


@dataclass(frozen=True)
class Case:
    """One run of LAMMPS."""

    base: float
    lengths: tuple[float, ...]
    inclinations: tuple[float, ...]
    """Of the trough, as in :class:`chutecalc.dem.trough.Trough`."""
    area: float
    """Target area of the bed, m²; what came out is measured."""
    friction: float
    """Coefficient between particles."""
    pour: str
    seed: int
    body_force: float = 1.0
    """Under which the bed is poured, in g."""
    raised_to: float = 0.0
    """Body force on the resting bed, in g, raised to before it is measured; 0: not raised."""
    spread: float = 0.0
    """e of the rain's density over the surface, 1 + e (2 |ξ| - 1) from the middle, ξ = 0, to the edge, |ξ| = 1."""
    diameter: float = 0.01
    slice: float = 0.05
    """Length of the periodic trough along the chute, m."""

    @property
    def trough(self) -> Trough:
        """What it is poured into."""
        return Trough(self.base, self.lengths, self.inclinations)

    @property
    def particle_volume(self) -> float:
        """m³."""
        return math.pi * self.diameter**3 / 6.0

    @property
    def mass(self) -> float:
        """Of a particle, kg."""
        return DENSITY * self.particle_volume

    @property
    def count(self) -> int:
        """How many particles."""
        filling = float(np.interp(self.friction, *PACKING)) + POURS[self.pour].filling
        return round(self.area * self.slice * filling / self.particle_volume)

    @property
    def acceleration(self) -> float:
        """Acceleration under which the bed is measured, m/s²."""
        return GRAVITY * (self.raised_to or self.body_force)

    @property
    def stiffness(self) -> float:
        """Of a contact, N/m."""
        return STIFFNESS * self.body_force * (self.diameter / 0.01) ** 2

    def damping(self, effective_mass: float) -> float:
        """γ of a contact that gives the restitution, 1/s: with λ = -ln e, γ = 2 λ √(k/m)/√(π² + λ²)."""
        loss = -math.log(RESTITUTION)
        return 2.0 * loss * math.sqrt(self.stiffness / effective_mass) / math.hypot(math.pi, loss)

    @property
    def time_step(self) -> float:
        """A twentieth of how long two particles are in contact when they collide, s."""
        mass = 0.5 * self.mass
        frequency = math.sqrt(self.stiffness / mass - 0.25 * self.damping(mass) ** 2)
        return math.pi / frequency / STEPS_A_COLLISION

    @property
    def slope_label(self) -> str:
        """Slopes of the drawn walls, deg, for people."""
        return " ".join(f"{math.degrees(inclination):g}" for inclination in self.inclinations) or "90"

    @property
    def name(self) -> str:
        """Of its folder: what people look for, and a digest of all of it."""
        digest = hashlib.sha256(json.dumps([METHOD, asdict(self)], sort_keys=True).encode()).hexdigest()[:10]
        return f"b{self.slope_label.replace(' ', '-')}_f{self.friction:g}_{self.pour}_s{self.seed}_{digest}"
