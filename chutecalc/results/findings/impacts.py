"""How the stream meets segments."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.motion import FLOOR, ROOF
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.edges import Edge
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS

ALIGN = "align the surface with the stream"
BED = (
    "the bed of its own material takes that in place of a liner, and settles as steep as it will; expect dust and"
    " degradation, and see that the velocity left suits what comes after"
)
"""What to do where a surface is struck, and where that is a bed of the material itself."""


@criterion(
    "steep_impact",
    Severity.WARNING,
    Severity.NOTE,
    summary="the stream strikes a surface at a steep angle; a note where that is a bed of its own material",
    limit=f"incidence > {LIMITS['max_impact_angle_deg'].text}",
    source=LIMITS["max_impact_angle_deg"].source,
)
def steep_impact(scene: Scene) -> Iterator[Case]:
    """Find impacts steeper than the limit, 20° by default (rule of thumb), of the stream or of its steepest edge.

    Args:
        scene: the segment with the stream along it.
    """
    arrival, limit = scene.contact.arrival, scene.limit("max_impact_angle_deg")
    incidence, source = np.degrees(arrival.incidence), scene.source("max_impact_angle_deg")
    severity, advice = (Severity.NOTE, BED) if scene.segment.own_material else (Severity.WARNING, ALIGN)
    steep = (incidence > limit) & (arrival.status <= Status.STALL)
    stream = {
        "incidence_deg": incidence,
        "limit_deg": limit,
        "velocity_m_s": arrival.velocity,
        "after_m_s": arrival.impact.velocity_after,
        "pressure_kpa": arrival.impact.pressure / 1000.0,
    }
    slows = f"(limit {{limit_deg}}, {source}), which slows it from {{velocity_m_s}} to {{after_m_s}} and loads the"
    slows += f" surface with {{pressure_kpa}}; {advice}"
    for surface, side in _surfaces(scene):
        told = np.zeros(scene.designs, dtype=bool)
        for edge, mask, angle in _steepest_edges(scene, incidence, limit):
            own = "free surface" if edge.leaves else f"{edge.name} edge"
            template = f"the stream strikes {surface} at {{incidence_deg}}, its {own} at {{edge_deg}} {slows}"
            s, numbers = scene.solved.entry.distance, stream | {"edge_deg": angle}
            yield Case(side & mask & steep, s, template, numbers, severity, badness=angle)
            own += f" of the stream that leaves {edge.leaves}" if edge.leaves else ""
            template = f"the {own} strikes {surface} at {{incidence_deg}} (limit {{limit_deg}}, {source}), with"
            template += f" {{velocity_m_s}}; {advice}" + (" there too" if advice == ALIGN else "")
            numbers = {"incidence_deg": angle, "limit_deg": limit, "velocity_m_s": edge.numbers["landing_velocity_m_s"]}
            yield Case(side & mask & ~steep, edge.s_m, template, numbers, severity, badness=angle)
            told = told | mask
        template = f"the stream strikes {surface} at {{incidence_deg}} {slows}"
        s = scene.solved.entry.distance
        yield Case(side & steep & ~told, s, template, stream, severity, badness=incidence)


def _surfaces(scene: Scene) -> list[tuple[str, Mask]]:
    """Return what the stream strikes, in words, each with the designs in which it does."""
    side = scene.contact.side
    if not scene.segment.closed:
        return [("the surface", np.ones(1, dtype=bool))]
    return [("the roof", side == ROOF), ("the floor", side == FLOOR)]


def _steepest_edges(scene: Scene, incidence: Array, limit: Array) -> Iterator[tuple[Edge, Mask, Array]]:
    """Yield edges that strike more steeply than the limit, than the stream that is solved, and than all other edges.

    Each with a mask of the designs in which it does, and its incidence, deg.
    """
    angles = [
        np.where(edge.number == scene.solved.number, edge.numbers["incidence_deg"], np.nan) for edge in scene.edges
    ]
    for edge, angle in zip(scene.edges, angles, strict=True):
        yield edge, (angle > np.fmax(limit, incidence)) & (angle >= np.fmax.reduce(angles)), angle
