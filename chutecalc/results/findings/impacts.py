"""How the stream meets segments."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS


@criterion(
    "steep_impact",
    Severity.WARNING,
    summary="the stream strikes a surface at a steep angle",
    limit=f"incidence > {LIMITS['max_impact_angle_deg'].text}",
    source=LIMITS["max_impact_angle_deg"].source,
)
def steep_impact(scene: Scene) -> Iterator[Case]:
    """Find impacts steeper than the limit, 20° by default (rule of thumb), and of the edges those that are steeper yet.

    Args:
        scene: the segment with the stream along it.
    """
    arrival, limit = scene.contact.arrival, scene.limit("max_impact_angle_deg")
    incidence = np.degrees(arrival.incidence)
    source = scene.source("max_impact_angle_deg")
    template = (
        f"the stream strikes the surface at {{incidence_deg}} (limit {{limit_deg}}, {source}), which slows it from"
        " {velocity_m_s} to {after_m_s} and loads the surface with {pressure_kpa}; align the surface with the stream"
    )
    yield Case(
        (incidence > limit) & (arrival.status <= Status.STALL),
        scene.solved.entry.distance,
        template,
        {
            "incidence_deg": incidence,
            "limit_deg": limit,
            "velocity_m_s": arrival.velocity,
            "after_m_s": arrival.impact.velocity_after,
            "pressure_kpa": arrival.impact.pressure / 1000.0,
        },
        badness=incidence,
    )
    for edge in scene.edges:
        own = edge.numbers["incidence_deg"]
        which = f"free surface of the stream that leaves {edge.leaves}" if edge.leaves else f"{edge.name} edge"
        template = (
            f"the {which} strikes the surface at {{incidence_deg}} (limit {{limit_deg}}, rule of thumb), with"
            " {velocity_m_s}; align the surface with the stream there too"
        )
        yield Case(
            (edge.number == scene.solved.number) & (own > limit) & ~(own <= incidence),
            edge.s_m,
            template,
            {"incidence_deg": own, "limit_deg": limit, "velocity_m_s": edge.numbers["landing_velocity_m_s"]},
            badness=own,
        )
