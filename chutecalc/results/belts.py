"""What the stream does to the receiving belt."""

from functools import cached_property

import numpy as np

from chutecalc.design import Design, Receiver
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.physics.belt import Loading, loading
from chutecalc.results.column import FormulaColumn

NORMAL_COSINE = 1e-9
"""The cosine of the angle between stream and belt below which the stream has no velocity along the belt."""


class Transfer:
    """A stream that lands on a belt."""

    def __init__(self, design: Design, belt: Receiver, velocity: Array, slope: Array) -> None:
        """Take the belts and the stream at the exit.

        Args:
            design: the chutes.
            belt: that receives their streams.
            velocity: of the streams at their exits, m/s, shape (designs,).
            slope: theirs there, below horizontal, rad, likewise.
        """
        self.design, self.belt, self.velocity, self.slope = design, belt, velocity, slope

    @cached_property
    def loading(self) -> Loading:
        """What the stream does to the belt."""
        design = self.design
        return loading(self.velocity, self.slope, *self.belt, design.density, design.mass_rate, design.gravity)

    @property
    def matching_slope(self) -> Array:
        """Exit slope next to the present one at which the stream has the belt's velocity, rad; NaN where none does."""
        ratio = self.belt.velocity / self.velocity
        turn = np.arccos(np.where(self.velocity >= self.belt.velocity, ratio, np.nan))
        return self.belt.slope + np.where(self.slope >= self.belt.slope, turn, -turn)

    @property
    def matching_velocity(self) -> Array:
        """Exit velocity at the present slope that has the belt's velocity along it, m/s; infinite where none does."""
        cosine = np.cos(self.slope - self.belt.slope)
        return np.where(cosine <= NORMAL_COSINE, np.inf, self.belt.velocity / cosine)


# fmt: off
RECEIVER_COLUMNS = {
    column.name: column
    for column in (
        FormulaColumn("velocity_along_m_s", "along belt", "", "velocity along the belt",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_along),
        FormulaColumn("velocity_across_m_s", "onto belt", "", "velocity onto the belt",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_across),
        FormulaColumn("velocity_ratio", "belt ratio", "", "velocity along the belt over the belt's",
                      "number", "", 4, formula=lambda on: on.loading.velocity_ratio),
        FormulaColumn("impact_pressure_kpa", "belt impact", "", "impact pressure on the belt",
                      "pressure", "kpa", 3, "psf", 1, formula=lambda on: on.loading.impact_pressure / 1000.0),
        FormulaColumn("wear_w_m2", "belt wear", "", "friction power per area of the belt",
                      "power", "w_m2", 1, formula=lambda on: on.loading.wear),
        FormulaColumn("acceleration_length_m", "belt slip", "", "distance over which the belt accelerates the stream",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.loading.acceleration_length),
        FormulaColumn("acceleration_power_kw", "belt power", "", "power that accelerates the stream",
                      "power", "kw", 3, formula=lambda on: on.loading.acceleration_power / 1000.0),
        FormulaColumn("landed_velocity_m_s", "landed", "", "velocity along the belt after the friction of the impact",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_after_impact),
        FormulaColumn("landed_acceleration_length_m", "landed slip", "",
                      "distance over which the belt accelerates it from then on",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.loading.length_after_impact),
        FormulaColumn("matching_slope_deg", "matching slope", "",
                      "exit slope at which the stream has the belt's velocity",
                      "angle", "deg", 2, formula=lambda on: np.degrees(on.matching_slope)),
        FormulaColumn("matching_velocity_m_s", "matching", "",
                      "exit velocity at which the stream has the belt's velocity",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.matching_velocity),
    )
}
# fmt: on
"""What a stream does to the receiving belt, by name; each formula takes a :class:`Transfer`."""
RECEIVER_NEEDS = ("velocity_m_s", "slope_deg")
"""Columns at the exit that the receiver columns follow from."""


def receiver_numbers(design: Design, end: Numbers) -> Numbers:
    """Return the receiver columns by name.

    Args:
        design: the chutes.
        end: the columns ``RECEIVER_NEEDS`` at their exits, each of shape (designs,).

    Returns:
        Arrays of shape (designs,), NaN for designs that fail; empty where the chute has no receiver.
    """
    if design.receiver is None:
        return {}
    transfer = Transfer(design, design.receiver, end["velocity_m_s"], np.radians(end["slope_deg"]))
    with np.errstate(all="ignore"):
        return {name: column.formula(transfer) for name, column in RECEIVER_COLUMNS.items()}
