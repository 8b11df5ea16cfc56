"""What ends a stream before it leaves the chute."""

from collections.abc import Iterator

import numpy as np

from chutecalc.core import state
from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.motion import ROOF
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene


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


@criterion(
    "choke",
    Severity.FAILURE,
    summary="the depth passes the height of the walls, a pipe or box runs full, or the stream jumps to a greater depth",
    limit="H > wall_height, fill > 1; with longitudinal pressure Fr² = K_l/α_m",
)
def choke(scene: Scene) -> Iterator[Case]:
    """Find depths above the height of the walls, closed sections that run full, and hydraulic jumps.

    Args:
        scene: the segment with the stream along it.
    """
    solved, stretch = scene.solved, scene.contact.end
    choked = solved.status == Status.CHOKE
    beyond, share, end = stretch.beyond_share, stretch.share, stretch.beyond_status
    wall_height = scene.segment.wall_height(share)
    numbers = {"wall_height_m": wall_height, "velocity_m_s": solved.exit.velocity}
    s = solved.exit.distance
    jumped = choked & (end == JUMPED) & (beyond == share)
    if jumped.any():
        yield _jump(scene, jumped)
        choked = choked & ~jumped
    if scene.segment.section.closed:
        template = (
            "the chute chokes: at {velocity_m_s} the stream fills the closed section up to its roof, {wall_height_m:in}"
            " above the floor; use a larger section, a steeper slope or a smaller rate"
        )
        entered = np.isfinite(solved.exit.distance)
        yield Case(choked & entered, s, template, numbers)
        template = (
            "the chute chokes: the stream that flies off at {velocity_m_s} needs more than the whole closed section,"
            " which is {wall_height_m:in} high; use a larger section or a smaller rate"
        )
        numbers = {"wall_height_m": scene.segment.wall_height(np.zeros(1)), "velocity_m_s": solved.start.velocity}
        yield Case(choked & ~entered, solved.start.distance, template, numbers)
        return
    begin = "the chute chokes: at {velocity_m_s} the depth exceeds the wall height of {wall_height_m:in};"
    further = (beyond - share) * scene.contact.surface.length
    for status, fate in (
        (
            Status.STALL,
            "make the slope steeper or reduce the wall friction; higher walls alone do not help, as the stream"
            " would stop {further_m} further on",
        ),
        (
            JUMPED,
            "make the slope steeper or reduce the wall friction; higher walls alone do not help, as the stream"
            " would jump to a greater depth {further_m} further on",
        ),
        (
            Status.CONTACT_LOST,
            "use a wider section; with higher walls the stream would leave the surface {further_m} further on",
        ),
    ):
        mask, template = choked & (end == status), f"{begin} {fate}"
        yield Case(mask, s, template, numbers | {"further_m": further})
    template = f"{begin} use a wider section or higher walls" + (
        "" if scene.segment.deflects else ", with which the stream would run on to the end of the segment"
    )
    yield Case(choked & (end == Status.OK), s, template, numbers)


@criterion(
    "contact_lost",
    Severity.FAILURE,
    Severity.WARNING,
    Severity.NOTE,
    summary="the stream leaves its surface; a warning where a later segment may catch it, a note inside a pipe",
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
    if scene.segment.closed:
        template = (
            "the stream leaves the wall at {velocity_m_s}, at a slope of {slope_deg}, and crosses the closed section to"
            " the other side"
        )
        crossing = {"velocity_m_s": solved.exit.velocity, "slope_deg": np.degrees(solved.exit.slope)}
        yield Case(lost & ~scene.falls_back, solved.exit.distance, template, crossing, Severity.NOTE)
        template = (
            "the stream leaves the wall at {velocity_m_s}, at a slope of {slope_deg}, and falls back out of the mouth"
            " that it came in through"
        )
        yield Case(scene.falls_back, solved.exit.distance, template, crossing)
        return
    weight = scene.design.gravity * np.cos(solved.exit.slope)
    numbers = {
        "velocity_m_s": solved.exit.velocity,
        "slope_deg": np.degrees(solved.exit.slope),
        "balance_m_s": np.sqrt(weight / np.abs(surface.curvature) / scene.design.momentum_factor),
        "radius_m": scene.design.momentum_factor * solved.exit.velocity**2 / weight,
    }
    begin = (
        "the stream leaves the surface at {velocity_m_s}, at a slope of {slope_deg}: there it would keep contact at "
        + (
            "{balance_m_s} or more, or under a hood with a radius of {radius_m} or less"
            if scene.segment.side == ROOF
            else "{balance_m_s} or less, or on a radius of {radius_m} or more"
        )
    )
    s = solved.exit.distance
    belt = scene.design.receiver
    flies_on = scene.continues | (belt is not None and belt.at is not None) & np.isfinite(scene.exit_distance)
    off = np.abs(numbers["velocity_m_s"] / numbers["balance_m_s"] - 1.0)
    yield Case(lost & flies_on, s, f"{begin}; it flies on", numbers, Severity.WARNING, badness=off)
    alone = f"{begin}; no later segment catches it"
    yield Case(lost & ~flies_on, s, alone, numbers)


def _jump(scene: Scene, jumped: Mask) -> Case:
    """Return the case of streams that jump to a greater depth, where pressure along them outweighs momentum.

    The status is that of a choke: the depth would grow beyond any bound on a length of nothing.
    """
    solved = scene.solved
    template = (
        "the stream jumps to a greater depth, which the model does not follow: at {velocity_m_s} the Froude number is"
        " {froude}, and pressure along the stream outweighs its momentum, with K_l = {longitudinal_ratio} and α_m ="
        " {momentum_factor}; make the slope steeper, or neglect K_l"
    )
    numbers = {
        "velocity_m_s": solved.exit.velocity,
        "froude": scene.at(scene.contact.end.share, "froude")[0],
        "longitudinal_ratio": scene.design.longitudinal_ratio,
        "momentum_factor": scene.design.momentum_factor,
    }
    return Case(jumped, solved.exit.distance, template, numbers)


JUMPED = state.HAS_JUMPED
"""How a stream ends beyond a choke that jumps there."""


def _steepest_impact(scene: Scene) -> Array:
    """Return the incidence, deg, from which on an impact on the segment leaves no velocity: tan i = 1/μ_e."""
    return np.degrees(np.arctan(1.0 / scene.contact.arrival.impact.friction))
