"""What ends a stream on its way."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.findings.finding import FAILURE, WARNING, Finding, Scene, finding
from chutecalc.physics.arrays import Array
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.section import excess_friction, take_facet, wetted_facet
from chutecalc.solver.chain import Leg


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
    beyond, place = scene.spread(stretch.beyond), scene.spread(stretch.place)
    stops = beyond < 1.0
    numbers = {"wall_height_m": scene.segment.section.wall_height, "velocity_m_s": leg.exit.velocity}
    begin = (
        "the chute chokes: at {velocity_m_s} the depth passes the wall height of {wall_height_m}; between higher walls"
    )
    s = leg.exit.distance
    further = (beyond - place) * scene.contact.surface.length
    template = f"{begin} the stream would stop {{further_m}} further on"
    yield from finding(scene, "choke", FAILURE, choked & stops, s, template, **numbers, further_m=further)
    template = f"{begin} it would run on to the end of the segment"
    yield from finding(scene, "choke", FAILURE, choked & ~stops, s, template, **numbers)


def contact_lost(scene: Scene) -> Iterator[Finding]:
    """The normal acceleration falls to 0; a warning where a fall takes the stream up."""
    leg, surface = scene.part.leg, scene.contact.surface
    lost = leg.status == Status.CONTACT_LOST
    numbers = {
        "velocity_m_s": leg.exit.velocity,
        "slope_deg": np.degrees(leg.exit.slope),
        "balance_m_s": np.sqrt(scene.contact.slide.gravity * np.cos(leg.exit.slope) / np.abs(surface.curvature)),
    }
    begin = (
        "the stream leaves the surface at {velocity_m_s} and a slope of {slope_deg} (v² = R g cos a at {balance_m_s})"
    )
    s = leg.exit.distance
    caught = f"{begin}; the fall after it takes it up"
    yield from finding(scene, "contact_lost", WARNING, lost & scene.caught, s, caught, **numbers)
    alone = f"{begin}; nothing catches it"
    yield from finding(scene, "contact_lost", FAILURE, lost & ~scene.caught, s, alone, **numbers)


def missed(scene: Scene) -> Iterator[Finding]:
    """A flight does not meet the segment that should catch it."""
    leg, gap = scene.part.leg, scene.contact.arrival.gap
    lost = leg.status == Status.MISSED
    numbers = {"velocity_m_s": leg.start.velocity, "slope_deg": np.degrees(leg.start.slope)}
    begin = "the stream flies off at {velocity_m_s} and {slope_deg}, and misses the segment"
    s = leg.start.distance
    passing = f"{begin}: it passes {{gap_m}} from the segment's end"
    yield from finding(scene, "missed", FAILURE, lost & np.isfinite(gap), s, passing, **numbers, gap_m=gap)
    yield from finding(scene, "missed", FAILURE, lost & ~np.isfinite(gap), s, begin, **numbers)


def fallen_short(leg: Leg, designs: int) -> Iterator[Finding]:
    """A fall that ends above what the stream reaches: it left a rising segment too low."""
    lost = np.broadcast_to(leg.status == Status.MISSED, designs)
    if lost.any():
        template = "the stream leaves the segment before too low to come down to where the fall ends"
        s = np.broadcast_to(leg.start.distance, designs)
        yield Finding("missed", FAILURE, leg.segment.name, lost, s, template, {})


def _steepest_impact(scene: Scene) -> Array:
    """The incidence, in degrees, from which on an impact on the segment leaves no velocity: tan i = 1/μ_e."""
    slide = scene.contact.slide
    area = slide.flow / scene.contact.arrival.velocity
    excess, _ = excess_friction(take_facet(slide.facets, wetted_facet(slide.facets, area)), area)
    return np.degrees(np.arctan(1.0 / equivalent_friction(slide.friction, excess)))
