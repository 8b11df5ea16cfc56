"""Placed segments for people and as a document."""

from collections.abc import Callable
from typing import Any

from chutecalc.output.dataset import document_head, number
from chutecalc.output.grid import Grid
from chutecalc.studies.place.placement import PlacedSegment, Placement

COLUMNS: dict[str, Callable[[PlacedSegment], str]] = {
    "start x\nm": lambda one: f"{one.start_m[0]:.3f}",
    "start z\nm": lambda one: f"{one.start_m[1]:.3f}",
    "slope\n°": lambda one: f"{next(iter(one.slopes.values())):z.2f}",
    "strike x\nm": lambda one: f"{one.x_m:z.3f}",
    "strike z\nm": lambda one: f"{one.z_m:z.3f}",
    "share": lambda one: f"{one.share:z.3f}",
    "incidence\n°": lambda one: f"{one.incidence_deg:z.2f}",
    "before\nm/s": lambda one: f"{one.velocity_m_s:.3f}",
    "after\nm/s": lambda one: f"{one.velocity_after_m_s:.3f}",
}
"""Headings of the columns of the table, and the text of each."""


def placement_table(placement: Placement) -> Grid:
    """Return a row for each placed segment: where it starts, and how the stream strikes it.

    Args:
        placement: the placed segments.
    """
    table = Grid()
    table.column("segment", left=True, label=True)
    for heading in COLUMNS:
        table.column(heading)
    edges = list(dict.fromkeys(name for each in placement.segments for name in each.edges))
    for name in edges:
        table.column(f"{name} edge\n°")
    for each in placement.segments:
        beside = (_edge(each, name) for name in edges)
        table.row([each.name, *(text(each) for text in COLUMNS.values()), *beside])
    return table


def _edge(placed: PlacedSegment, name: str) -> str:
    """Return the incidence of an edge as text."""
    incidence = placed.edges.get(name)
    return "" if incidence is None else "misses" if incidence != incidence else f"{incidence:z.2f}"


def placement_document(placement: Placement) -> dict[str, Any]:
    """Return the placed segments as a document: what to write into the spec, and how the stream then strikes.

    Args:
        placement: the placed segments.
    """
    solution: dict[str, Any] = {}
    outcome: dict[str, Any] = {}
    for each in placement.segments:
        path = f"segments.{each.name}"
        solution |= {f"{path}.start_m": list(each.start_m)} | {f"{path}.{key}": at for key, at in each.slopes.items()}
        numbers = {
            "impact_x_m": each.x_m,
            "impact_z_m": each.z_m,
            "impact_share": each.share,
            "impact_incidence_deg": each.incidence_deg,
            "impact_velocity_m_s": each.velocity_m_s,
            "impact_velocity_after_m_s": each.velocity_after_m_s,
            **{f"{name}_edge_incidence_deg": incidence for name, incidence in each.edges.items()},
        }
        outcome |= {f"{path}.{name}": number(value) for name, value in numbers.items()}
    return {**document_head(), "solutions": [solution], "outcome": [outcome]}
