"""The numeric description of a chute, which the solver reads.

Everything is SI and radians. Numbers are arrays of length 1 or n, never 0-dimensional, so one description stands for
one design or for many; a length of 1 is shared by all of them and stays short until a varied number meets it.
"""

from typing import NamedTuple

from chutecalc.design.belts import Belt, Receiver
from chutecalc.design.records import length, select, stretched
from chutecalc.design.segments import VERTICAL, Contact, Fall, Segment
from chutecalc.design.status import Status
from chutecalc.physics.arrays import Array

__all__ = [
    "VERTICAL",
    "Belt",
    "Contact",
    "Design",
    "Fall",
    "Receiver",
    "Segment",
    "Status",
    "length",
    "select",
    "stretched",
]


class Design(NamedTuple):
    """A chute, or n of them in parallel arrays."""

    mass_rate: Array
    density: Array
    lump: Array | None
    """Size of the largest lump, m, or None."""
    gravity: Array
    internal_friction: Array | None
    """δ, rad; None where the spec gives a pressure ratio alone."""
    vertical_ratio: Array
    """Pressure ratio K_v at vertical walls."""
    momentum_factor: Array
    """Momentum factor α_m."""
    longitudinal_ratio: Array
    """Longitudinal pressure ratio K_l."""
    equilibrium: bool
    """Whether wall pressures are scaled until they carry the weight, instead of the paper's friction law."""
    inlet_position: tuple[Array, Array]
    inlet_velocity: Array
    inlet_slope: Array
    belt: Belt | None
    receiver: Receiver | None
    limits: tuple[Array, ...]
    """Limits of findings, in the order of :data:`chutecalc.spec.limits.LIMITS`; infinite where there is none."""
    segments: tuple[Segment, ...]

    @property
    def volume_rate(self) -> Array:
        """Volume rate Q = ṁ/ρ, m³/s."""
        return self.mass_rate / self.density

    def __repr__(self) -> str:
        """Return how many designs there are, and their segments.

        >>> import chutecalc
        >>> chutecalc.parse(chutecalc.STARTER).design
        <Design of 1: fall, spoon>
        """
        return f"<Design of {length(self)}: {', '.join(segment.name for segment in self.segments)}>"
