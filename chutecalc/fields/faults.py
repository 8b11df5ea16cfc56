"""What is wrong with numbers of a spec that are right one by one and do not go together."""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Mask

Location = tuple[str | int, ...]
"""Where something stands in a spec's data: keys, and numbers of list items from 0."""

ALL_DESIGNS = np.ones(1, dtype=bool)
"""All designs."""


class LocatedFault(NamedTuple):
    """A fault at a location of the spec's data."""

    location: Location
    problem: str
    remedy: str
    value: Any


class GeometryError(Exception):
    """A spec whose keys and values are right one by one, and do not go together."""

    def __init__(self, faults: list[LocatedFault], designs: Mask) -> None:
        """All faults, and a mask of the designs that have them, of length 1 or n."""
        self.faults, self.designs = faults, designs
        super().__init__(f"{len(faults)} faults of geometry")


class GeometryFaults:
    """Collects faults, and which designs have them, on the way along a spec."""

    def __init__(self) -> None:
        self.found: list[LocatedFault] = []
        self.designs: Mask = ~ALL_DESIGNS

    def note(self, designs: Mask, location: Location, value: Any, problem: str, remedy: str) -> None:
        """Notes a fault where there are designs that have it."""
        if designs.any():
            self.found.append(LocatedFault(location, problem, remedy, value))
            self.designs = self.designs | designs

    def raise_any(self) -> None:
        """Raises all faults.

        Raises:
            GeometryError: there are any.
        """
        if self.found:
            raise GeometryError(self.found, self.designs)
