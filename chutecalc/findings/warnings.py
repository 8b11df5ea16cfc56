"""What strains the design, or the model. Where a limit is a rule of thumb of the field, the message says practice."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.findings.finding import NOTE, WARNING, Finding, Scene, finding
from chutecalc.physics.friction import equilibrium_friction
from chutecalc.physics.motion import FLOOR
from chutecalc.physics.pressure import greatest_wall_friction
from chutecalc.solver.balance import critical_velocity

DECELERATION_MARGIN = 1.25
CUT_OFF = np.radians(5.0)
THICKEST = 1.0
THICKEST_ON_ARC = 0.1
SLOWEST_FROUDE = 2.0
MOST_MISSING = 0.10


def inadmissible_friction(scene: Scene) -> Iterator[Finding]:
    """The wall friction angle is more than atan(sin δ) (Paper, section 6)."""
    internal = scene.part.design.internal_friction
    if internal is None:
        return
    angle, greatest = np.arctan(scene.segment.wall_friction), greatest_wall_friction(internal)
    template = (
        "a wall friction of {friction_deg} is more than the material can show on any wall, {greatest_deg} ="
        " atan(sin {internal_friction_deg}); the angle given is used"
    )
    rounding = 1e-12
    yield from finding(
        scene,
        "inadmissible_friction",
        WARNING,
        angle > greatest * (1.0 + rounding),
        scene.part.leg.entry.distance,
        template,
        friction_deg=np.degrees(angle),
        greatest_deg=np.degrees(greatest),
        internal_friction_deg=np.degrees(internal),
    )


def decelerating(scene: Scene) -> Iterator[Finding]:
    """On a straight the stream comes near, or falls below, the velocity from which on friction wins."""
    if scene.segment.kind != "straight":
        return
    slowest = scene.worst["velocity_m_s"]
    critical = critical_velocity(scene.contact.slide)
    slope = np.degrees(scene.contact.surface.slope)
    s = scene.place(slowest.share)
    flat = np.isinf(critical) & np.isfinite(slowest.value)
    template = (
        "the slope of {slope_deg} is flatter than the wall friction angle, {friction_deg}: the stream decelerates"
    )
    angle = np.degrees(np.arctan(scene.segment.wall_friction))
    yield from finding(scene, "decelerating", WARNING, flat, s, template, slope_deg=slope, friction_deg=angle)
    margin = slowest.value / critical
    template = (
        "the stream runs at {velocity_m_s}, {margin} times the {critical_velocity_m_s} below which friction slows it"
        " to a stall on a slope of {slope_deg} (limit 1.25)"
    )
    yield from finding(
        scene,
        "decelerating",
        WARNING,
        (margin < DECELERATION_MARGIN) & ~flat,
        s,
        template,
        velocity_m_s=slowest.value,
        margin=margin,
        critical_velocity_m_s=critical,
        slope_deg=slope,
    )


def below_cut_off(scene: Scene) -> Iterator[Finding]:
    """The last spoon ends flatter than the equivalent friction angle + 5° (practice)."""
    surface = scene.contact.surface
    if not (scene.last and surface.side == FLOOR):
        return
    needed = np.arctan(scene.sampled["equivalent_friction"][-1]) + CUT_OFF
    slope = surface.slope + surface.turn
    template = (
        "the spoon ends at {slope_deg}, flatter than the {needed_deg} at which it clears itself"
        " (equivalent friction angle + 5°, practice)"
    )
    mask = (scene.part.leg.status == Status.OK) & (surface.turn < 0.0) & (slope < needed)
    yield from finding(
        scene,
        "below_cut_off",
        WARNING,
        mask,
        scene.part.leg.exit.distance,
        template,
        slope_deg=np.degrees(slope),
        needed_deg=np.degrees(needed),
    )


def thick_stream(scene: Scene) -> Iterator[Finding]:
    """The depth is more than the free surface's width, or more than a tenth of the radius."""
    thick, deep = scene.worst["thickness"], scene.worst["depth_m"]
    template = "the depth reaches {thickness} of the stream's width (limit 1): too thick for one mean velocity"
    mask = thick.value > THICKEST
    yield from finding(scene, "thick_stream", WARNING, mask, scene.place(thick.share), template, thickness=thick.value)
    share = deep.value * np.abs(scene.contact.surface.curvature)
    template = "the depth of {depth_m} reaches {share} of the radius (limit 0.1): too thick for one mean velocity"
    mask, s = share > THICKEST_ON_ARC, scene.place(deep.share)
    yield from finding(scene, "thick_stream", WARNING, mask, s, template, depth_m=deep.value, share=share)


def slow_stream(scene: Scene) -> Iterator[Finding]:
    """The Froude number falls below 2: the neglected pressure gradient changes dv/ds by about K/Fr²."""
    froude = scene.worst["froude"]
    template = (
        "the Froude number falls to {froude} (limit 2): the pressure left out along the stream changes dv/ds by ~1/Fr²"
    )
    mask = froude.value < SLOWEST_FROUDE
    yield from finding(scene, "slow_stream", WARNING, mask, scene.place(froude.share), template, froude=froude.value)


def missing_load(scene: Scene) -> Iterator[Finding]:
    """The paper's law lays more than a tenth of the weight on the centre section by way of correction."""
    missing, wall = scene.worst["missing_load"], scene.segment.wall_friction
    share = np.broadcast_to(missing.share, (1, len(missing.share)))
    friction = scene.part.at(share)["equivalent_friction"][0]
    even = equilibrium_friction(wall, friction / np.where(wall > 0.0, wall, np.inf) - 1.0, missing.value)
    template = (
        "hydrostatic wall pressures leave {missing_load} of the weight uncarried (limit 0.1): laid on the centre"
        " section, as here, μ_e is {equivalent_friction}; spread over all walls {equilibrium_friction}"
    )
    yield from finding(
        scene,
        "missing_load",
        WARNING,
        missing.value > MOST_MISSING,
        scene.place(missing.share),
        template,
        missing_load=missing.value,
        equivalent_friction=friction,
        equilibrium_friction=even,
    )


def above_chamfer(scene: Scene) -> Iterator[Finding]:
    """The depth passes the drawn top of the section."""
    table, deep = scene.contact.slide.facets, scene.worst["depth_m"]
    if not scene.segment.section.lengths or table.drawn[-1, 0] > 0.0:
        return
    top = table.height[-1]
    template = "the depth of {depth_m} passes the top of the chamfers at {top_m}; the walls go on vertically there"
    mask, s = deep.value > top, scene.place(deep.share)
    yield from finding(scene, "above_chamfer", NOTE, mask, s, template, depth_m=deep.value, top_m=top)


def geometry_follows_flow(scene: Scene) -> Iterator[Finding]:
    """A curve tangent to a stream that does not fall vertically: its drawn slope changes with the flow."""
    if scene.segment.entry_slope is not None:
        return
    slope = np.degrees(scene.contact.surface.slope)
    template = "drawn tangent to the stream, from {slope_deg}, the curve changes with the flow; from_slope_deg fixes it"
    s = scene.part.leg.start.distance
    yield from finding(scene, "geometry_follows_flow", NOTE, np.isfinite(slope), s, template, slope_deg=slope)
