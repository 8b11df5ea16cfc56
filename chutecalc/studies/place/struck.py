"""How the stream strikes a segment, in one state of a chute."""

from dataclasses import dataclass
from math import degrees, nan

from chutecalc.design import Status
from chutecalc.results.solved import SolvedChute

MIDDLE = "middle"
"""Name of the edge of a stream from a belt that is solved."""


@dataclass(frozen=True)
class Struck:
    """How the stream strikes a segment."""

    x_m: float
    """Where the line of the stream that is solved strikes: x,"""
    z_m: float
    """z,"""
    share: float
    """and share of the segment's length from its start."""
    incidence_deg: float
    velocity_m_s: float
    """Velocity before the impact,"""
    velocity_after_m_s: float
    """and after it."""
    edges: dict[str, float]
    """Incidence of the other edges of the stream, degrees, by name (:class:`chutecalc.Edge`); NaN where one misses."""


def struck_by(solution: SolvedChute, number: int) -> Struck | None:
    """Return how the stream strikes a segment; None if it does not.

    Args:
        solution: of one design.
        number: of the segment, from 0.
    """
    first = next((solved for solved in solution.trajectory.segment_solutions if solved.number == number), None)
    if first is None or first.contact is None or first.contact.arrival.status.item() > Status.STALL:
        return None
    arrival, entry = first.contact.arrival, first.entry
    return Struck(
        x_m=entry.x.item(),
        z_m=entry.z.item(),
        share=arrival.share.item(),
        incidence_deg=degrees(arrival.incidence.item()),
        velocity_m_s=arrival.velocity.item(),
        velocity_after_m_s=arrival.impact.velocity_after.item(),
        edges={
            edge.name: nan if edge.misses.item() else edge.numbers["incidence_deg"].item()
            for edge in solution.edges
            if edge.target.item() == number and edge.name != MIDDLE
        },
    )
