"""The base class of all cross-section shapes."""

from typing import Any, ClassVar

import numpy as np
from pydantic import Field

from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantities import Width
from chutecalc.fields.quantity import in_si
from chutecalc.fields.table import Table
from chutecalc.fields.wording import Unknown
from chutecalc.physics import section
from chutecalc.physics.arrays import Array, Mask

UNBOUNDED = np.array([np.inf])
"""Length of what has no end, m, shape (1,)."""


class Section(Table):
    """A cross-section.

    A shape derives from :class:`OpenSection` or :class:`ClosedSection`, with its value of ``shape`` as a ``Literal``,
    its keys, :attr:`example` and :meth:`build`.
    """

    shape: str

    example: ClassVar[str] = ""
    """TOML of such a section without its header, for the starter."""
    adjustable: ClassVar[tuple[str, ...]] = ()
    """Keys whose values :meth:`adjusted` returns; empty for a shape without that method."""

    def build(self, location: Location, faults: GeometryFaults) -> section.Section:
        """Return the section in numbers, in SI units.

        Args:
            location: of the section in the spec's data.
            faults: collects faults of its geometry.
        """
        raise NotImplementedError

    def is_like(self, other: "Section") -> bool:
        """Return whether the section differs from another one in numbers only: a segment may taper between them.

        Args:
            other: section of any shape.
        """
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


class OpenSection(Section):
    """A cross-section that is open at its top."""

    wall_height_m: Width = Field(
        None, description="height of the walls above the floor; a deeper stream chokes the chute"
    )

    @property
    def wall_height(self) -> Array:
        """Height of the walls above the floor, m, of length 1 or n; infinite where none is given."""
        return length_or_unbounded(self.wall_height_m)


class ClosedSection(Section):
    """A cross-section with a roof: the chute chokes where it runs full."""

    @classmethod
    def _unknown(cls, key: str) -> Unknown:
        if key.startswith("wall_height"):
            problem = "is only for open sections: this one is closed, and chokes where it runs full"
            return Unknown(problem, "remove it")
        return super()._unknown(key)


def length_or_unbounded(value: Any) -> Array:
    """Return an optional length in m, shape (1,) or (designs,); infinite if it is not given.

    Args:
        value: in m, or None.

    >>> length_or_unbounded(None).tolist(), length_or_unbounded(0.4).tolist()
    ([inf], [0.4])
    """
    return UNBOUNDED if value is None else in_si(value, "length")
