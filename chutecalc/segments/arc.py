"""The base class of circular arcs."""

from typing import ClassVar

import numpy as np
from pydantic import Field

from chutecalc.design import VERTICAL, Contact
from chutecalc.fields.quantities import Length, Slope
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.motion import FLOOR
from chutecalc.segments.base import Context
from chutecalc.segments.guide import Guide


class Arc(Guide):
    """A circular arc."""

    radius_m: Length = Field(description="radius of the guiding surface")
    to_slope_deg: Slope = Field(description="slope at its end, below horizontal")
    from_slope_deg: Slope = Field(
        None, description="slope at its start, below horizontal; tangent to what comes before it if not given"
    )

    placed: ClassVar[dict[str, str]] = {**Guide.placed, "from_slope_deg": "from_slope_deg"}

    def arc(self, context: Context, side: float) -> Contact:
        """Return an arc that begins at its own slope, or tangent to what comes before it.

        Args:
            context: what the numbers follow from, beside this table.
            side: sign of the surface, ``FLOOR`` or ``ROOF`` of :mod:`chutecalc.physics.motion`.
        """
        exit_ = in_si(self.to_slope_deg, "angle")
        entry = context.tangent if self.from_slope_deg is None else in_si(self.from_slope_deg, "angle")
        if entry is not None:  # what begins tangent to a falling stream is known only when it is solved
            wrong, problem, remedy = self.check_turn(entry, exit_)
            context.faults.note(wrong, (*context.location, "to_slope_deg"), self.to_slope_deg, problem, remedy)
        radius = in_si(self.radius_m, "length")
        contact = self.contact(context, side, entry, exit_, radius=radius)
        # Until it is solved, a falling stream is taken as steeper than a floor, hence a spoon, and flatter than a roof.
        wrong, problem, remedy = self.check_bend(contact, side * VERTICAL if entry is None else entry, radius)
        if entry is None and side == FLOOR:
            remedy += ", or give from_slope_deg if it is a crest"
        context.faults.note(wrong, (*context.location, "radius_m"), self.radius_m, problem, remedy)
        return contact

    def check_bend(self, contact: Contact, entry: Array, radius: Array) -> tuple[Mask, str, str]:
        """Return the mask of designs bent so tightly that the inner wall has no length, with problem and remedy.

        Opposite to the guiding surface, at the height D of a closed section, a wall is 1 - κ σ D times as long.

        Args:
            contact: the arc in numbers.
            entry: slope at its start, rad below horizontal.
            radius: of the guiding surface, m.
        """
        height = np.zeros(1)
        for section in (contact.section, contact.end_section):
            if section is not None and section.closed:
                height = np.maximum(height, section.wall_height)
        inwards = np.where(entry > contact.exit_slope, contact.side, -contact.side)  # the sign of κ σ
        problem = f"leaves the inner wall of the bend no length: the section is {height.flat[0]:.6g} m high"
        return radius <= inwards * height, problem, "give a larger radius or a smaller section"

    def check_turn(self, entry: Array, exit_: Array) -> tuple[Mask, str, str]:
        """Return the mask of designs whose arc does not turn as it has to, with problem and remedy.

        Args:
            entry, exit_: slopes at its start and end, rad below horizontal.
        """
        problem = f"leaves the arc no length: it begins at {degrees(entry)} too"
        return exit_ == entry, problem, "give another slope"


def degrees(slope: Array) -> str:
    """Return the first of some slopes as text in degrees.

    Args:
        slope: rad, shape (1,) or (designs,).

    >>> degrees(np.array([np.pi / 4]))
    '45°'
    """
    return f"{np.degrees(slope.flat[0]):z.6g}°"
