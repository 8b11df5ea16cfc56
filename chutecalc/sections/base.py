"""What all cross-section shapes have in common."""

from typing import Any, ClassVar

import numpy as np
from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Length
from chutecalc.fields.quantity import in_si
from chutecalc.fields.table import Table
from chutecalc.physics import section
from chutecalc.physics.arrays import Array, Mask

UNBOUNDED = np.array([np.inf])
"""A length without end, m."""


class Section(Table):
    """A cross-section."""

    shape: str
    wall_height_m: Length = Field(None, description="of the walls above the floor; deeper than that chokes")

    example: ClassVar[str] = ""
    """TOML of such a section, below its header; the starter shows it."""
    adjustable: ClassVar[tuple[str, ...]] = ()
    """Keys whose values :meth:`adjusted` gives; none where the shape has no such method."""

    def build(self, location: Location, faults: GeometryFaults) -> section.Section:
        """Return the section in numbers.

        Args:
            location: of the section in the spec's data.
            faults: collects what is wrong with its geometry.
        """
        raise NotImplementedError

    def is_like(self, other: "Section") -> bool:
        """Whether the section differs from another one in numbers only, so that a segment may taper between them."""
        return type(self) is type(other) and self.model_fields_set == other.model_fields_set

    def adjusted(self, drawn: Any, keep: str) -> tuple[dict[str, Array], Mask]:
        """Return the values that hold the section's overall width, or also its depth, at another chamfer angle.

        Args:
            drawn: the same section at the angle of the spec.
            keep: ``width`` or ``depth``.

        Returns:
            Values of the keys :attr:`adjustable`, in m and of length 1 or n, and which designs can be built.
        """
        raise NotImplementedError

    @property
    def wall_height(self) -> Array:
        """Height of the walls above the floor, m, of length 1 or n; infinite where none is given."""
        return length_or_unbounded(self.wall_height_m)


def length_or_unbounded(value: Any) -> Array:
    """Return an optional length in m, of length 1 or n; infinite where it is not given."""
    return UNBOUNDED if value is None else in_si(value, "length")
