"""Faults of geometry: numbers of a spec that are right one by one and do not go together."""

from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Mask

Location = tuple[str | int, ...]
"""Where something stands in a spec's data: keys, and indices of list items from 0."""

ALL_DESIGNS = np.ones(1, dtype=bool)
"""Mask of all designs, shape (1,)."""


class LocatedFault(NamedTuple):
    """A fault at a location of the spec's data: what is wrong, what to do, and the value given."""

    location: Location
    problem: str
    remedy: str
    value: Any


class GeometryError(Exception):
    """A spec whose keys and values are right one by one, and do not go together."""

    def __init__(self, faults: list[LocatedFault], designs: Mask) -> None:
        """Hold all faults of a spec.

        Args:
            faults: at least one.
            designs: mask of the designs that have any of them, shape (1,) or (designs,).
        """
        self.faults, self.designs = faults, designs
        super().__init__(f"{len(faults)} faults of geometry")


class GeometryFaults:
    """Collects faults, and which designs have them, while a spec is turned into numbers.

    Attributes:
        found: the faults, in the order in which they were noted.
        designs: mask of the designs that have any of them, shape (1,) or (designs,).
    """

    def __init__(self) -> None:
        self.found: list[LocatedFault] = []
        self.designs: Mask = ~ALL_DESIGNS

    def note(self, designs: Mask, location: Location, value: Any, problem: str, remedy: str) -> None:
        """Note a fault if there are designs that have it.

        Args:
            designs: mask of those designs, shape (1,) or (designs,).
            location: of the key at fault in the spec's data, by its documented name.
            value: that the spec gives there.
            problem: what is wrong, as the end of a sentence that begins with the key and its value.
            remedy: what to do, as an instruction.

        >>> faults = GeometryFaults()
        >>> faults.note(ALL_DESIGNS, ("flow", "rate_t_h"), 0.0, "is too small", "give more")
        >>> faults.found[0].location
        ('flow', 'rate_t_h')
        """
        if designs.any():
            self.found.append(LocatedFault(location, problem, remedy, value))
            self.designs = self.designs | designs

    def raise_any(self) -> None:
        """Raise all faults that were noted.

        Raises:
            GeometryError: There are any.
        """
        if self.found:
            raise GeometryError(self.found, self.designs)
