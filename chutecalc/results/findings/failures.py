"""What ends a stream before it leaves the chute."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Fall, Status
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.motion import ROOF
from chutecalc.results.criterion import Case, Scene, criterion
from chutecalc.results.finding import Severity
from chutecalc.solver.segment_solution import Point

LONGEST_FALL = 1e5
"""Height below which a fall has missed its end, m; as in ``core/fall.py``."""


@criterion(
    "stall", Severity.FAILURE, summary="the velocity falls to 0, on a segment or at the impact on it", limit="v = 0"
)
def stall(scene: Scene) -> Iterator[Case]:
    """Find streams whose velocity falls to 0, on the segment or at the impact on it.

    Args:
        scene: the segment with the stream along it.
    """
    solved, arrival = scene.solved, scene.contact.arrival
    at_impact = arrival.status == Status.STALL
    template = (
        "the stream stalls on impact: it strikes at {incidence_deg} and {velocity_m_s}, and an impact steeper than"
        " {steepest_deg} leaves no velocity along the surface; reduce the angle of impact or the wall friction"
    )
    yield Case(
        at_impact,
        solved.entry.distance,
        template,
        {
            "incidence_deg": np.degrees(arrival.incidence),
            "velocity_m_s": arrival.velocity,
            "steepest_deg": _steepest_impact(scene),
        },
    )
    inside = (solved.status == Status.STALL) & ~at_impact
    template = (
        "the stream stalls: its velocity falls to 0 after {travelled_m} on the segment, at a slope of {slope_deg}; make"
        " the slope steeper or reduce the wall friction"
    )
    yield Case(
        inside,
        solved.exit.distance,
        template,
        {"travelled_m": scene.part.length(), "slope_deg": np.degrees(solved.exit.slope)},
    )


@criterion("choke", Severity.FAILURE, summary="the depth passes the height of the walls", limit="H > wall_height")
def choke(scene: Scene) -> Iterator[Case]:
    """Find depths above the height of the walls.

    Args:
        scene: the segment with the stream along it.
    """
    solved, stretch = scene.solved, scene.contact.end
    choked = solved.status == Status.CHOKE
    beyond, share, end = stretch.beyond_share, stretch.share, stretch.beyond_status
    wall_height = scene.segment.wall_height(share)
    numbers = {"wall_height_m": wall_height, "velocity_m_s": solved.exit.velocity}
    begin = "the chute chokes: at {velocity_m_s} the depth exceeds the wall height of {wall_height_m:in};"
    s = solved.exit.distance
    further = (beyond - share) * scene.contact.surface.length
    for status, fate in (
        (
            Status.STALL,
            "make the slope steeper or reduce the wall friction; higher walls alone do not help, as the stream"
            " would stop {further_m} further on",
        ),
        (
            Status.CONTACT_LOST,
            "use a wider section; with higher walls the stream would leave the surface {further_m} further on",
        ),
    ):
        mask, template = choked & (end == status), f"{begin} {fate}"
        yield Case(mask, s, template, numbers | {"further_m": further})
    template = (
        f"{begin} use a wider section or higher walls, with which the stream would run on to the end of the segment"
    )
    yield Case(choked & (end == Status.OK), s, template, numbers)


@criterion(
    "contact_lost",
    Severity.FAILURE,
    Severity.WARNING,
    summary="the stream leaves its surface; a warning where a later segment may catch it",
    limit="n = 0",
)
def contact_lost(scene: Scene) -> Iterator[Case]:
    """Find streams that leave their surface, where the normal acceleration falls to 0.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.segment.deflects:
        return
    solved, surface = scene.solved, scene.contact.surface
    lost = solved.status == Status.CONTACT_LOST
    weight = scene.design.gravity * np.cos(solved.exit.slope)
    numbers = {
        "velocity_m_s": solved.exit.velocity,
        "slope_deg": np.degrees(solved.exit.slope),
        "balance_m_s": np.sqrt(weight / np.abs(surface.curvature)),
        "radius_m": solved.exit.velocity**2 / weight,
    }
    begin = (
        "the stream leaves the surface at {velocity_m_s}, at a slope of {slope_deg}: there it would keep contact at "
        + (
            "{balance_m_s} or more, or under a hood with a radius of {radius_m} or less"
            if surface.side == ROOF
            else "{balance_m_s} or less, or on a radius of {radius_m} or more"
        )
    )
    s = solved.exit.distance
    yield Case(lost & scene.continues, s, f"{begin}; it flies on", numbers, Severity.WARNING)
    alone = f"{begin}; no later segment catches it"
    yield Case(lost & ~scene.continues, s, alone, numbers)


@criterion(
    "missed",
    Severity.FAILURE,
    summary="a stream in flight does not meet the segment or the level that should catch it",
    in_falls=True,
)
def missed(scene: Scene) -> Iterator[Case]:
    """Find flights that do not meet the segment, and falls whose end is never reached.

    Args:
        scene: the segment with the stream along it.
    """
    solved = scene.solved
    lost = solved.status == Status.MISSED
    segment = scene.part.segment
    if isinstance(segment, Fall):
        yield from _never_ends(segment, solved.start, lost, scene.design.gravity)
        return
    gap = scene.contact.arrival.gap
    numbers = {"velocity_m_s": solved.start.velocity, "slope_deg": np.degrees(solved.start.slope)}
    begin = "the stream flies off at {velocity_m_s} and a slope of {slope_deg} and misses the segment: "
    s = solved.start.distance
    beyond = f"{begin}it passes {{gap_m}} beyond its end; make the segment longer or move it"
    yield Case(lost & (gap > 0.0), s, beyond, numbers | {"gap_m": gap})
    short = f"{begin}it falls short and passes the end {{gap_m}} behind the surface; move it towards the stream"
    yield Case(lost & (gap <= 0.0), s, short, numbers | {"gap_m": -gap})
    away = f"{begin}it never reaches it; check start_m and the slopes"
    yield Case(lost & np.isnan(gap), s, away, numbers)


def _never_ends(fall: Fall, start: Point, lost: Mask, gravity: Array) -> Iterator[Case]:
    """Yield the cases of falls to a level or a distance that the stream never reaches."""
    begin = "the stream never reaches the end of the fall: it "
    if fall.run is None:
        yield Case(lost, start.distance, f"{begin}is already below that level; increase drop_m")
        return
    forward = start.velocity * np.cos(start.slope)
    steep = (forward <= 0.0) | (0.5 * gravity * (fall.run / forward) ** 2 > LONGEST_FALL)
    template = f"{begin}falls straight down, or too steeply to get {{run_m}} away; give drop_m instead of run_m"
    yield Case(lost & steep, start.distance, template, {"run_m": fall.run})
    yield Case(lost & ~steep, start.distance, f"{begin}is already past that distance; increase run_m")


def _steepest_impact(scene: Scene) -> Array:
    """Return the incidence, deg, from which on an impact on the segment leaves no velocity: tan i = 1/μ_e."""
    return np.degrees(np.arctan(1.0 / scene.contact.arrival.impact.friction))
