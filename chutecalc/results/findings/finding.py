"""A finding, and the scene that its criterion judges."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from chutecalc.design import Contact
from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.column import Numbers, quantity_text
from chutecalc.results.extremes import LARGEST, LEAST, Extreme, Wanted
from chutecalc.results.part import Part
from chutecalc.solver.leg import ContactLeg

FAILURE, WARNING, NOTE = "failure", "warning", "note"


class Finding(NamedTuple):
    """One finding about some of the designs; arrays are of shape (designs,)."""

    code: str
    severity: str
    """``failure``, ``warning`` or ``note``."""
    segment: str
    mask: Mask
    """The designs that it is about."""
    s_m: Array
    """Where, m from the inlet along the stream."""
    template: str
    """The message, with names of ``numbers`` to fill in."""
    numbers: Numbers
    """What led to it; names end in their units."""

    def message(self, design: int = 0, units: str = "metric") -> str:
        """The finding in words for one design."""
        return self.template.format(
            **{name: quantity_text(name, float(values[design]), units) for name, values in self.numbers.items()}
        )


WORST: tuple[Wanted, ...] = (
    ("thickness", LARGEST),
    ("depth_m", LARGEST),
    ("froude", LEAST),
    ("missing_load", LARGEST),
    ("velocity_m_s", LEAST),
    ("wall_friction", LARGEST),
    ("above_top_m", LARGEST),
    ("wall_stress_kpa", LEAST),
    ("wall_stress_kpa", LARGEST),
)
"""Extremes along a part that decide a criterion."""


class Scene(NamedTuple):
    """One part of the way, with what its criteria ask for."""

    part: Part
    contact: ContactLeg
    segment: Contact
    sampled: Numbers
    shares: Array
    """Of the part's way, where it is sampled."""
    worst: dict[Wanted, Extreme]
    goes_on: Mask
    """Designs that have gone on to something after this part."""
    last: bool
    """The last contact segment."""
    designs: int

    def place(self, share: Array) -> Array:
        """S at a share of the part's way."""
        s = self.sampled["s_m"]
        place: Array = s[0] + share * (s[-1] - s[0])
        return place

    def at(self, share: Array, *names: str) -> list[Array]:
        """Columns at a share of the way, one for each design; at its end, what they tend to there."""
        there, limits = self.part.at(np.broadcast_to(share, (1, len(share))), names), self.part.limits(names)
        return [np.where(share == 1.0, limits[name], there[name][0]) for name in names]


def finding(
    scene: Scene, code: str, severity: str, mask: Mask, s: Array, template: str, **numbers: Array
) -> Iterator[Finding]:
    """The finding, where it is about any design."""
    if mask.any():
        mask, s, *values = (np.broadcast_to(item, scene.designs) for item in (mask, s, *numbers.values()))
        yield Finding(code, severity, scene.segment.name, mask, s, template, dict(zip(numbers, values, strict=True)))
