"""Numbers of a checked spec in SI, and the faults of those that are right one by one and do not go together."""

from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array, Mask
from chutecalc.spec.faults import PlacedFault
from chutecalc.spec.file import Place
from chutecalc.units import to_si

EVERY = np.ones(1, dtype=bool)
"""All designs."""


class GeometryError(Exception):
    """A spec whose keys and values are right one by one, and do not go together."""

    def __init__(self, faults: list[PlacedFault], designs: Mask) -> None:
        """All faults, and a mask of the designs that have them, of length 1 or n."""
        self.faults, self.designs = faults, designs
        super().__init__(f"{len(faults)} faults of geometry")


class GeometryFaults:
    """Collects faults, and which designs have them, on the way along a spec."""

    def __init__(self) -> None:
        self.found: list[PlacedFault] = []
        self.designs: Mask = ~EVERY

    def note(self, designs: Mask, place: Place, value: Any, problem: str, remedy: str) -> None:
        """Notes a fault where there are designs that have it."""
        if designs.any():
            self.found.append(PlacedFault(place, problem, remedy, value))
            self.designs = self.designs | designs

    def check(self) -> None:
        """Raises all faults.

        Raises:
            GeometryError: there are any.
        """
        if self.found:
            raise GeometryError(self.found, self.designs)


def in_si(value: Any, dimension: str) -> Array:
    """A number of the spec in SI, of length 1 or n."""
    if type(value) is float:  # most of them, for which NumPy's functions take five times as long
        return np.array([to_si(value, dimension)])
    values: Array = np.atleast_1d(
        np.multiply(to_si(value, dimension), 1.0)
    )  # an array, also of what only acts like one
    return values
