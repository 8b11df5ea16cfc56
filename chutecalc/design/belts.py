"""The belts at both ends of a chute in numbers."""

from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.troughed_belt import BeltLoad


class Belt(NamedTuple):
    """The belt that the stream comes from; see :func:`chutecalc.physics.head_pulley.discharge`."""

    centre: tuple[Array, Array]
    """x and z of the centre of its head pulley, m."""
    velocity: Array
    """Belt velocity, m/s."""
    incline: Array
    """Incline of the belt, rad, positive uphill."""
    lower_radius: Array
    """Radius of the stream's lower edge on the pulley, m."""
    middle_radius: Array
    """Radius of the stream's centre line on the pulley, m."""
    friction: Array | None
    """Friction angle of the material on the belt, rad; None where none is given, and the belt holds the stream."""
    load: BeltLoad | None
    """The load on a belt whose width is given; else None."""

    @property
    def edge_radii(self) -> dict[str, Array]:
        """Radius on the pulley of the stream's lower edge, centre line and upper edge, m, by their names."""
        upper = 2.0 * self.middle_radius - self.lower_radius
        return {"lower": self.lower_radius, "middle": self.middle_radius, "upper": upper}


class Receiver(NamedTuple):
    """The belt that the stream goes to."""

    velocity: Array
    """Belt velocity, m/s."""
    slope: Array
    """Slope of the belt, rad below horizontal."""
    friction: Array
    """Friction coefficient of the material on the belt."""
    plan_angle: Array
    """Plan angle ψ between the headings of stream and belt, rad, seen from above."""
    at: tuple[Array, Array] | None
    """x and z of a point of its surface, m; None if that is where the last segment ends."""

    @property
    def slope_of_trace(self) -> Array:
        """Slope of the line in which its surface cuts the plane of the chute, rad: tan b = tan a_b cos ψ."""
        trace: Array = np.arctan2(np.sin(self.slope) * np.cos(self.plan_angle), np.cos(self.slope))
        return trace
