"""What the stream does to the receiving belt."""

from functools import cached_property

import numpy as np

from chutecalc.design import Design, Receiver
from chutecalc.physics.arrays import Array, Numbers
from chutecalc.physics.belt import Loading, components, loading
from chutecalc.results.column import FormulaColumn
from chutecalc.solver.segment_solution import Ends

NORMAL_COSINE = 1e-9
"""The cosine of the angle between stream and belt below which the stream has no velocity along the belt."""


class Transfer:
    """A stream that lands on a belt."""

    def __init__(self, design: Design, belt: Receiver, ends: Ends) -> None:
        """Take the belts and the stream where it lands on them.

        Args:
            design: the chutes.
            belt: that receives their streams.
            ends: how the designs end.
        """
        self.design, self.belt, self.ends = design, belt, ends
        self.velocity, self.slope = ends.landing_velocity, ends.landing_slope

    @cached_property
    def loading(self) -> Loading:
        """What the stream does to the belt."""
        design, belt = self.design, self.belt
        return loading(
            velocity=self.velocity,
            slope=self.slope,
            belt_velocity=belt.velocity,
            belt_slope=belt.slope,
            friction=belt.friction,
            plan_angle=belt.plan_angle,
            density=design.density,
            mass_rate=design.mass_rate,
            gravity=design.gravity,
        )

    @property
    def matching_slope(self) -> Array:
        """Slope next to the present one at which the stream has the belt's velocity, rad; NaN where none does.

        v (cos a cos a_b cos ψ + sin a sin a_b) = v r cos(a - a_p) with r and a_p of the heading's projection.
        """
        forward, down = self._heading
        ratio = self.belt.velocity / (self.velocity * np.hypot(forward, down))
        turn = np.arccos(np.where(ratio <= 1.0, ratio, np.nan))
        best = np.arctan2(down, forward)
        return best + np.where(self.slope >= best, turn, -turn)

    @property
    def matching_velocity(self) -> Array:
        """Velocity at the present slope that has the belt's velocity along it, m/s; NaN where none does."""
        forward, down = self._heading
        cosine = forward * np.cos(self.slope) + down * np.sin(self.slope)
        return np.where(cosine <= NORMAL_COSINE, np.nan, self.belt.velocity / cosine)

    @property
    def matching_velocity_into(self) -> Array:
        """Velocity into the belt at the matching slope, m/s; NaN where there is none."""
        belt = self.belt
        return components(self.velocity, self.matching_slope, belt.slope, belt.plan_angle)[1]

    @property
    def _heading(self) -> tuple[Array, Array]:
        """Components of the belt's heading in the plane of the chute, forward and down."""
        return np.cos(self.belt.slope) * np.cos(self.belt.plan_angle), np.sin(self.belt.slope)


# fmt: off
RECEIVER_COLUMNS = {
    column.name: column
    for column in (
        FormulaColumn("velocity_along_m_s", "along belt", "", "velocity along the belt",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_along,
                      equation="v (cos a cos a_b cos ψ + sin a sin a_b)", page="belts"),
        FormulaColumn("velocity_into_m_s", "into belt", "", "velocity into the belt, normal to it",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_into,
                      equation="v |sin a cos a_b − cos a sin a_b cos ψ|", page="belts"),
        FormulaColumn("velocity_across_m_s", "across belt", "", "velocity across the belt, with the plan angle's sign",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_across,
                      equation="v cos a sin ψ", page="belts"),
        FormulaColumn("velocity_ratio", "belt ratio", "", "velocity along the belt over the belt's",
                      "number", "", 4, formula=lambda on: on.loading.velocity_ratio,
                      equation="velocity_along/V_b", page="belts"),
        FormulaColumn("impact_pressure_kpa", "belt impact", "", "impact pressure on the belt",
                      "pressure", "kpa", 3, "psf", 1, formula=lambda on: on.loading.impact_pressure / 1000.0,
                      equation="ρ velocity_into²", page="belts"),
        FormulaColumn("wear_w_m2", "belt wear", "", "friction power per area of the belt",
                      "power", "w_m2", 1, formula=lambda on: on.loading.wear,
                      equation="μ_b p |s|, s the slip along and across", page="belts"),
        FormulaColumn("acceleration_length_m", "belt slip", "", "distance over which the belt accelerates the stream",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.loading.acceleration_length,
                      equation="V_b T + (f |s| s_x + γ (|s|² + s_x²)/2)/(2 (f² − γ²))", page="belts"),
        FormulaColumn("acceleration_power_kw", "belt power", "", "power that accelerates the stream",
                      "power", "kw", 3, formula=lambda on: on.loading.acceleration_power / 1000.0,
                      equation="ṁ V_b (V_b − velocity_along)", page="belts"),
        FormulaColumn("landed_velocity_m_s", "landed", "", "velocity along the belt after the friction of the impact",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.loading.velocity_after_impact,
                      equation="velocity_along, less the share along s of μ_b velocity_into off the slip",
                      page="belts"),
        FormulaColumn("landed_wear_w_m2", "landed wear", "", "friction power per area of the belt at that velocity",
                      "power", "w_m2", 1, formula=lambda on: on.loading.wear_after_impact,
                      equation="as wear_w_m2, with that slip", page="belts"),
        FormulaColumn("landed_acceleration_length_m", "landed slip", "",
                      "distance over which the belt accelerates it from then on",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.loading.length_after_impact,
                      equation="as acceleration_length_m, with that slip", page="belts"),
        FormulaColumn("matching_slope_deg", "matching slope", "",
                      "slope at which the stream would have the belt's velocity along it",
                      "angle", "deg", 2, formula=lambda on: np.degrees(on.matching_slope),
                      equation="velocity_along = V_b at v", page="belts"),
        FormulaColumn("matching_velocity_m_s", "matching", "",
                      "velocity at which the stream would have the belt's velocity along it",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.matching_velocity,
                      equation="velocity_along = V_b at a", page="belts"),
        FormulaColumn("matching_velocity_into_m_s", "matching into", "", "velocity into the belt at the matching slope",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda on: on.matching_velocity_into,
                      equation="velocity_into at v and that slope", page="belts"),
        FormulaColumn("landing_x_m", "landing x", "", "horizontal position where the stream lands on the belt",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.ends.landing_x),
        FormulaColumn("landing_z_m", "landing z", "", "height where the stream lands on the belt",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.ends.landing_z),
        FormulaColumn("landing_slope_deg", "landing slope", "", "slope of the stream where it lands on the belt",
                      "angle", "deg", 2, formula=lambda on: np.degrees(on.ends.landing_slope)),
        FormulaColumn("clearance_m", "belt clearance", "",
                      "least distance of the drawn surfaces above the belt, normal to it",
                      "length", "m", 3, "ft", 2, formula=lambda on: on.ends.clearance),
    )
}
# fmt: on
"""What a stream does to the receiving belt, by name; each formula takes a :class:`Transfer`."""


def receiver_numbers(design: Design, ends: Ends) -> Numbers:
    """Return the receiver columns by name.

    Args:
        design: the chutes.
        ends: how they end.

    Returns:
        Arrays of shape (designs,), NaN for designs that fail; empty where the chute has no receiver.
    """
    if design.receiver is None:
        return {}
    transfer = Transfer(design, design.receiver, ends)
    with np.errstate(all="ignore"):
        return {name: column.formula(transfer) for name, column in RECEIVER_COLUMNS.items()}
