"""What ends a stream on its way."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array
from chutecalc.physics.motion import ROOF
from chutecalc.results.findings.finding import FAILURE, WARNING, Finding, Scene, finding
from chutecalc.solver.leg import Leg


def stall(scene: Scene) -> Iterator[Finding]:
    """The velocity falls to 0, inside the segment or at the impact on it."""
    leg, arrival = scene.part.leg, scene.contact.arrival
    at_impact = arrival.status == Status.STALL
    template = (
        "the stream stalls: it strikes at {incidence_deg} with {velocity_m_s}, and from {steepest_deg} on"
        " (cot of the equivalent friction) an impact leaves nothing"
    )
    yield from finding(
        scene,
        "stall",
        FAILURE,
        at_impact,
        leg.entry.distance,
        template,
        incidence_deg=np.degrees(arrival.incidence),
        velocity_m_s=arrival.velocity,
        steepest_deg=_steepest_impact(scene),
    )
    inside = (leg.status == Status.STALL) & ~at_impact
    template = "the stream stalls: its velocity falls to 0 after {way_m} on the segment, at a slope of {slope_deg}"
    yield from finding(
        scene,
        "stall",
        FAILURE,
        inside,
        leg.exit.distance,
        template,
        way_m=scene.part.length(),
        slope_deg=np.degrees(leg.exit.slope),
    )


def choke(scene: Scene) -> Iterator[Finding]:
    """The depth passes the height of the walls."""
    leg, stretch = scene.part.leg, scene.contact.stretch
    choked = leg.status == Status.CHOKE
    beyond, place, end = stretch.beyond, stretch.place, stretch.beyond_status
    wall_height = scene.segment.wall_height(place)
    numbers = {"wall_height_m": wall_height, "velocity_m_s": leg.exit.velocity}
    begin = (
        "the chute chokes: at {velocity_m_s} the depth passes the wall height of {wall_height_m}; between higher walls"
    )
    s = leg.exit.distance
    further = (beyond - place) * scene.contact.surface.length
    for status, fate in (
        (Status.STALL, "the stream would stop {further_m} further on"),
        (Status.CONTACT_LOST, "it would leave the surface {further_m} further on"),
    ):
        mask, template = choked & (end == status), f"{begin} {fate}"
        yield from finding(scene, "choke", FAILURE, mask, s, template, **numbers, further_m=further)
    template = f"{begin} it would run on to the end of the segment"
    yield from finding(scene, "choke", FAILURE, choked & (end == Status.OK), s, template, **numbers)


def contact_lost(scene: Scene) -> Iterator[Finding]:
    """The normal acceleration falls to 0; a warning where something follows that may catch the stream."""
    if scene.segment.deflects:
        return
    leg, surface = scene.part.leg, scene.contact.surface
    lost = leg.status == Status.CONTACT_LOST
    weight = scene.part.design.gravity * np.cos(leg.exit.slope)
    numbers = {
        "velocity_m_s": leg.exit.velocity,
        "slope_deg": np.degrees(leg.exit.slope),
        "balance_m_s": np.sqrt(weight / np.abs(surface.curvature)),
        "radius_m": leg.exit.velocity**2 / weight,
    }
    begin = (
        "the stream leaves the surface at {velocity_m_s} and a slope of {slope_deg}: there it keeps contact "
        + ("under a hood from {balance_m_s} on" if surface.side == ROOF else "up to {balance_m_s}")
        + ", or with a radius of {radius_m} at "
        + ("most" if surface.side == ROOF else "least")
    )
    s = leg.exit.distance
    yield from finding(scene, "contact_lost", WARNING, lost & scene.goes_on, s, f"{begin}; it flies on", **numbers)
    alone = f"{begin}; nothing catches it"
    yield from finding(scene, "contact_lost", FAILURE, lost & ~scene.goes_on, s, alone, **numbers)


def missed(scene: Scene) -> Iterator[Finding]:
    """A flight does not meet the segment that should catch it."""
    leg, gap = scene.part.leg, scene.contact.arrival.gap
    lost = leg.status == Status.MISSED
    numbers = {"velocity_m_s": leg.start.velocity, "slope_deg": np.degrees(leg.start.slope)}
    begin = "the stream flies off at {velocity_m_s} and {slope_deg}, and misses the segment: "
    s = leg.start.distance
    beyond = f"{begin}it passes {{gap_m}} beyond its end"
    yield from finding(scene, "missed", FAILURE, lost & (gap > 0.0), s, beyond, **numbers, gap_m=gap)
    short = f"{begin}it falls short, and is {{gap_m}} behind its surface where it passes its end"
    yield from finding(scene, "missed", FAILURE, lost & (gap <= 0.0), s, short, **numbers, gap_m=-gap)
    away = f"{begin}it never comes to it"
    yield from finding(scene, "missed", FAILURE, lost & np.isnan(gap), s, away, **numbers)


def fallen_short(leg: Leg, designs: int) -> Iterator[Finding]:
    """A fall that ends above what the stream reaches: it left a rising segment too low."""
    lost = np.broadcast_to(leg.status == Status.MISSED, designs)
    if lost.any():
        template = "the stream never comes to where the fall ends: it is too low, or too far, or falls straight down"
        s = np.broadcast_to(leg.start.distance, designs)
        yield Finding("missed", FAILURE, leg.segment.name, lost, s, template, {})


def _steepest_impact(scene: Scene) -> Array:
    """The incidence, in degrees, from which on an impact on the segment leaves no velocity: tan i = 1/μ_e."""
    return np.degrees(np.arctan(1.0 / scene.contact.arrival.impact.friction))
