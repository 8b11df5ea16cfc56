"""The numbers of an impact: what happens where a stream strikes a segment."""

from typing import Any

import numpy as np

from chutecalc.physics.arrays import Numbers
from chutecalc.results.column import FormulaColumn

# fmt: off
IMPACT_COLUMNS = {
    column.name: column
    for column in (
        FormulaColumn("incidence_deg", "incidence", "i", "angle between the stream and the surface",
                      "angle", "deg", 2, formula=lambda arrival, slip: np.degrees(arrival.incidence)),
        FormulaColumn("velocity_before_m_s", "before", "", "velocity before the impact",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda arrival, slip: arrival.velocity),
        FormulaColumn("velocity_after_m_s", "after", "", "velocity along the surface after the impact",
                      "velocity", "m_s", 3, "fpm", 1, formula=lambda arrival, slip: arrival.impact.velocity_after,
                      equation="v (cos i − μ_e sin i)", page="flight-and-impact"),
        FormulaColumn("pressure_kpa", "pressure", "p", "impact pressure on the surface",
                      "pressure", "kpa", 3, "psf", 1, formula=lambda arrival, slip: arrival.impact.pressure / 1000.0,
                      equation="ρ v² sin² i, or ρ v² sin i · H/length on a shorter segment",
                      page="flight-and-impact"),
        FormulaColumn("footprint_m", "footprint", "", "length of surface that is struck",
                      "length", "m", 3, "ft", 2, formula=lambda arrival, slip: arrival.impact.footprint,
                      equation="H/sin i, at most the length of the segment", page="flight-and-impact"),
        FormulaColumn("wear_w_m2", "wear", "", "friction power per area of the footprint",
                      "power", "w_m2", 1, formula=lambda arrival, slip: arrival.impact.wear * slip,
                      equation="μ p times the mean of the velocities along the surface, times slip_ratio",
                      page="flight-and-impact"),
    )
}
# fmt: on
"""Numbers by name; each formula takes the arrival on the segment and the slip ratio of its liner."""


def impact_of(arrival: Any, slip_ratio: Any) -> Numbers:
    """Return the numbers of each design's impact.

    Args:
        arrival: how the stream meets the segment, :class:`chutecalc.solver.segment_solution.Arrival`.
        slip_ratio: slip velocity at the wall over mean velocity, dimensionless, shape (designs,).

    Returns:
        Arrays of shape (designs,), NaN for designs that do not strike it; empty where none does.
    """
    struck = arrival.incidence > 0.0
    if not struck.any():
        return {}
    return {
        name: np.where(struck, column.formula(arrival, slip_ratio), np.nan) for name, column in IMPACT_COLUMNS.items()
    }
