"""How the stream meets segments."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.results.criterion import Case, Scene, criterion
from chutecalc.results.finding import Severity

STEEPEST_IMPACT = np.radians(20.0)


@criterion(
    "steep_impact",
    Severity.WARNING,
    summary="the stream strikes a surface at a steep angle",
    limit=f"incidence > {np.degrees(STEEPEST_IMPACT):g}°",
    source="rule of thumb",
)
def steep_impact(scene: Scene) -> Iterator[Case]:
    """Find impacts at more than 20° (rule of thumb).

    Args:
        scene: the segment with the stream along it.
    """
    arrival = scene.contact.arrival
    template = (
        "the stream strikes the surface at {incidence_deg} (rule of thumb: 20°), which slows it from {velocity_m_s} to"
        " {after_m_s} and loads the surface with {pressure_kpa}; align the surface with the stream"
    )
    yield Case(
        (arrival.incidence > STEEPEST_IMPACT) & (arrival.status <= Status.STALL),
        scene.solved.entry.distance,
        template,
        {
            "incidence_deg": np.degrees(arrival.incidence),
            "velocity_m_s": arrival.velocity,
            "after_m_s": arrival.impact.velocity_after,
            "pressure_kpa": arrival.impact.pressure / 1000.0,
        },
    )
