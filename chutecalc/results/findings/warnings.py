"""What strains the design, or the model. Where a limit is a rule of thumb of the field, the message says practice."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Receiver, Status
from chutecalc.physics.arrays import Array
from chutecalc.physics.motion import FLOOR
from chutecalc.physics.pressure import greatest_wall_friction
from chutecalc.physics.wall import wall_friction
from chutecalc.results.extremes import LARGEST, LEAST, extremes
from chutecalc.results.findings.finding import NOTE, WARNING, Finding, Scene, finding
from chutecalc.results.trajectory import Numbers
from chutecalc.solver.leg import TANGENT

DECELERATION_MARGIN = 1.25
CUT_OFF = np.radians(5.0)
THICKEST = 1.0
THICKEST_ON_ARC = 0.1
SLOWEST_FROUDE = 2.0
MOST_MISSING = 0.10
STEEPEST_IMPACT = np.radians(20.0)
ROUNDING = 1e-12


def inadmissible_friction(scene: Scene) -> Iterator[Finding]:
    """The wall friction angle is more than atan(sin δ) (Paper, section 6), or that bounds a yield locus."""
    internal = scene.part.design.internal_friction
    if internal is None:
        return
    bound, worst, impact = np.sin(internal), scene.worst["wall_friction", LARGEST], scene.contact.arrival.impact
    numbers = {
        "greatest_deg": np.degrees(greatest_wall_friction(internal)),
        "internal_friction_deg": np.degrees(internal),
    }
    wall = scene.segment.wall
    if wall.changes:
        template = (
            "the yield locus shows more friction than the material's own, {greatest_deg} = atan(sin"
            " {internal_friction_deg}), somewhere on the way; the material's own is used there"
        )
        least = bound * (1.0 - ROUNDING)
        along = worst.value >= least
        mask = along | ((impact.pressure > 0.0) & (wall_friction(wall, impact.stress) >= least))
        s = np.where(along, scene.place(worst.share), scene.part.leg.entry.distance)
        yield from finding(scene, "inadmissible_friction", WARNING, mask, s, template, **numbers)
        return
    template = (
        "a wall friction of {friction_deg} is more than the material can show on any wall, {greatest_deg} ="
        " atan(sin {internal_friction_deg}); the angle given is used"
    )
    numbers["friction_deg"] = np.degrees(np.arctan(wall.slopes[0]))
    mask = np.isfinite(worst.value) & (wall.slopes[0] > bound * (1.0 + ROUNDING))
    s = scene.part.leg.entry.distance
    yield from finding(scene, "inadmissible_friction", WARNING, mask, s, template, **numbers)


def outside_locus(scene: Scene) -> Iterator[Finding]:
    """The floor bears less or more than the rows of the yield locus were measured at."""
    if scene.segment.measured is None:
        return
    impact = scene.contact.arrival.impact
    low, high = (rows / 1000.0 for rows in scene.segment.measured)
    struck = np.where(impact.pressure > 0.0, impact.stress / 1000.0, np.nan)
    least = np.fmin(scene.worst["wall_stress_kpa", LEAST].value, struck)
    most = np.fmax(scene.worst["wall_stress_kpa", LARGEST].value, struck)
    below, above = least < low * (1.0 - ROUNDING), most > high * (1.0 + ROUNDING)
    template = (
        "the floor bears {least_kpa} to {most_kpa}, and the yield locus was measured from {first_kpa} to {last_kpa}:"
        " outside of that friction is extrapolated"
    )
    s = np.where(below, scene.place(scene.worst["wall_stress_kpa", LEAST].share), scene.part.leg.entry.distance)
    numbers = {"least_kpa": least, "most_kpa": most, "first_kpa": low, "last_kpa": high}
    yield from finding(scene, "outside_locus", WARNING, below | above, s, template, **numbers)


def decelerating(scene: Scene) -> Iterator[Finding]:
    """On a straight the stream comes near, or falls below, the velocity from which on friction wins.

    Where the section stays, that is decided where the stream is slowest; along a taper the balance moves.
    """
    if scene.segment.deflects or scene.segment.radius is not None:
        return
    worst = scene.worst["velocity_m_s", LEAST]
    if scene.segment.end_section is not None:
        margins = scene.part.at(scene.shares, ["balance_margin"])
        worst = extremes(scene.part, margins, scene.shares, [("balance_margin", LEAST)])["balance_margin", LEAST]
    velocity, critical, friction = scene.at(worst.share, "velocity_m_s", "balance_m_s", "wall_friction")
    friction = np.where(velocity > 0.0, friction, scene.sampled["wall_friction"][0])  # not that of a heap at rest
    slope, s = np.degrees(scene.contact.surface.slope), scene.place(worst.share)
    flat = np.isinf(critical) & np.isfinite(velocity)
    template = (
        "the slope of {slope_deg} is flatter than the friction angle at any velocity (the wall's is {friction_deg}):"
        " the stream decelerates"
    )
    angle = np.degrees(np.arctan(friction))
    yield from finding(scene, "decelerating", WARNING, flat, s, template, slope_deg=slope, friction_deg=angle)
    margin = velocity / critical
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
        velocity_m_s=velocity,
        margin=margin,
        critical_velocity_m_s=critical,
        slope_deg=slope,
    )


def steep_impact(scene: Scene) -> Iterator[Finding]:
    """The stream strikes the surface at more than 20° (practice)."""
    arrival = scene.contact.arrival
    template = (
        "the stream strikes at {incidence_deg} (limit 20°, practice): of {velocity_m_s} it keeps {after_m_s}, and"
        " presses with {pressure_kpa}"
    )
    yield from finding(
        scene,
        "steep_impact",
        WARNING,
        (arrival.incidence > STEEPEST_IMPACT) & (arrival.status <= Status.STALL),
        scene.part.leg.entry.distance,
        template,
        incidence_deg=np.degrees(arrival.incidence),
        velocity_m_s=arrival.velocity,
        after_m_s=arrival.impact.after,
        pressure_kpa=arrival.impact.pressure / 1000.0,
    )


def flown_past(scene: Scene) -> Iterator[Finding]:
    """A flight goes past the segment to one further on."""
    template = "the stream flies past the segment, {gap_m} from its end, and on to what follows"
    mask, gap = scene.part.leg.status == Status.PASSED, scene.contact.arrival.gap
    yield from finding(scene, "flown_past", WARNING, mask, scene.part.leg.start.distance, template, gap_m=gap)


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
    thick, deep = scene.worst["thickness", LARGEST], scene.worst["depth_m", LARGEST]
    template = "the depth reaches {thickness} of the stream's width (limit 1): too thick for one mean velocity"
    mask = thick.value > THICKEST
    yield from finding(scene, "thick_stream", WARNING, mask, scene.place(thick.share), template, thickness=thick.value)
    share = deep.value * np.abs(scene.contact.surface.curvature)
    template = "the depth of {depth_m} reaches {share} of the radius (limit 0.1): too thick for one mean velocity"
    mask, s = share > THICKEST_ON_ARC, scene.place(deep.share)
    yield from finding(scene, "thick_stream", WARNING, mask, s, template, depth_m=deep.value, share=share)


def slow_stream(scene: Scene) -> Iterator[Finding]:
    """The Froude number falls below 2: the neglected pressure gradient changes dv/ds by about K/Fr²."""
    froude = scene.worst["froude", LEAST]
    template = (
        "the Froude number falls to {froude} (limit 2): the pressure left out along the stream changes dv/ds by ~1/Fr²"
    )
    mask = froude.value < SLOWEST_FROUDE
    yield from finding(scene, "slow_stream", WARNING, mask, scene.place(froude.share), template, froude=froude.value)


def missing_load(scene: Scene) -> Iterator[Finding]:
    """The paper's law lays more than a tenth of the weight on the centre section by way of correction."""
    if scene.part.design.equilibrium:
        return
    missing = scene.worst["missing_load", LARGEST]
    friction, even = scene.at(missing.share, "equivalent_friction", "equilibrium_friction")
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
    worst = scene.worst["above_top_m", LARGEST]
    (top,) = scene.at(worst.share, "top_m")
    template = "the depth of {depth_m} passes the drawn top of the section at {top_m}; the walls go on vertically there"
    numbers = {"depth_m": worst.value + top, "top_m": top}
    yield from finding(scene, "above_chamfer", NOTE, worst.value > 0.0, scene.place(worst.share), template, **numbers)


def geometry_follows_flow(scene: Scene) -> Iterator[Finding]:
    """A curve tangent to a stream that does not fall vertically: its drawn slope changes with the flow."""
    if scene.segment.entry_slope is not None:
        return
    slope = np.degrees(scene.contact.surface.slope)
    template = "drawn tangent to the stream, from {slope_deg}, the curve changes with the flow; from_slope_deg fixes it"
    s = scene.part.leg.start.distance
    mask = slope < 90.0 - np.degrees(TANGENT)
    yield from finding(scene, "geometry_follows_flow", NOTE, mask, s, template, slope_deg=slope)


def not_accelerated(belt: Receiver, received: Numbers, s: Array, segment: str) -> Iterator[Finding]:
    """The receiving belt cannot bring the stream to its velocity.

    Args:
        belt: that receives it.
        received: what the stream does to it, of :func:`chutecalc.results.belts.received`.
        s: where the stream leaves the chute, shape (designs,).
        segment: the last.
    """
    mask = np.isposinf(received["acceleration_length_m"])
    if not mask.any():
        return
    template = (
        "the belt never brings the stream from {velocity_along_m_s} to its own {belt_velocity_m_s}: friction on it is"
        " too small for its slope of {belt_slope_deg}"
    )
    numbers = {
        "velocity_along_m_s": received["velocity_along_m_s"],
        "belt_velocity_m_s": np.broadcast_to(belt.velocity, len(s)),
        "belt_slope_deg": np.broadcast_to(np.degrees(belt.slope), len(s)),
    }
    yield Finding("not_accelerated", WARNING, segment, mask, s, template, numbers)
