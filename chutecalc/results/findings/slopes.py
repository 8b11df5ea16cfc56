"""Whether slopes keep the stream moving."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.motion import FLOOR
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.extremes import LARGEST, LEAST, extremes
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS

BED = (
    "on a bed of its own material it leaves material until the bed is steep enough: draw the bed as steep as it will"
    " settle, and see what falls from it"
)
"""What happens, and what to do, where the surface is the material itself."""


@criterion(
    "decelerating",
    Severity.WARNING,
    summary="on a straight the stream comes near or falls below the velocity at which friction slows it",
    limit=f"v < {LIMITS['min_velocity_margin'].text} v_c",
    needs=[("velocity_m_s", LEAST), ("wall_friction", LARGEST)],
)
def decelerating(scene: Scene) -> Iterator[Case]:
    """Find straights on which the stream comes near, or falls below, the velocity at which friction slows it.

    Where the section is constant, the slowest point decides; along a taper the critical velocity changes.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.segment.deflects or scene.segment.radius is not None:
        return
    worst, bed = scene.extreme("velocity_m_s", LEAST), scene.segment.own_material
    if scene.segment.end_section is not None:
        shares, least_margin = scene.sampled.shares, ("balance_margin", LEAST)
        margins = scene.part.at(shares, ["balance_margin"])
        worst = extremes(scene.part, margins, shares, [least_margin])[least_margin]
    velocity, critical, friction = scene.at(worst.share, "velocity_m_s", "balance_m_s", "wall_friction")
    at_entry = scene.sampled.columns["wall_friction"][0]  # quoted for a stalled stream, rather than that of a heap
    friction = np.where(velocity > 0.0, friction, at_entry)
    slope, s = np.degrees(scene.contact.surface.slope), scene.distance(worst.share)
    flat = np.isinf(critical) & np.isfinite(velocity)
    template = (
        "the slope of {slope_deg} is flatter than the equivalent friction angle at any velocity (wall friction"
        " {friction_deg}), so the stream decelerates; "
        + (BED if bed else "make the slope steeper or reduce the friction")
    )
    angle = np.degrees(np.arctan(friction))
    yield Case(flat, s, template, {"slope_deg": slope, "friction_deg": angle}, badness=angle - slope)
    numbers = {"critical_velocity_m_s": critical, "slope_deg": slope}
    stalled = (velocity == 0.0) & ~flat
    template = (
        "the stream runs below the critical velocity of {critical_velocity_m_s}, where friction brings it to a stall"
        " on a slope of {slope_deg}; " + (BED if bed else "make the slope steeper or reduce the friction")
    )
    yield Case(stalled, s, template, numbers, badness=critical)
    margin, limit = velocity / critical, scene.limit("min_velocity_margin")
    template = (
        "the stream runs at {velocity_m_s}, {margin} times the critical velocity of {critical_velocity_m_s} below which"
        " friction brings it to a stall on a slope of {slope_deg} (limit {limit}); "
        + (BED if bed else "make the slope steeper")
    )
    yield Case(
        (margin < limit) & ~flat & ~stalled,
        s,
        template,
        numbers | {"velocity_m_s": velocity, "margin": margin, "limit": limit},
        badness=-margin,
    )


@criterion(
    "below_cut_off",
    Severity.WARNING,
    summary="the last spoon ends too flat to clear itself",
    limit=f"slope < atan(μ_e) + {LIMITS['min_cut_off_margin_deg'].text}",
    source=LIMITS["min_cut_off_margin_deg"].source,
)
def below_cut_off(scene: Scene) -> Iterator[Case]:
    """Find a last spoon that ends flatter than the equivalent friction angle and a margin (rule of thumb).

    Args:
        scene: the segment with the stream along it.
    """
    surface = scene.contact.surface
    if not (scene.last_surface and scene.segment.side == FLOOR):
        return
    margin = scene.limit("min_cut_off_margin_deg")
    needed = np.degrees(np.arctan(scene.sampled.columns["equivalent_friction"][-1])) + margin
    slope = np.degrees(surface.slope + surface.turn)
    template = (
        "the spoon ends at {slope_deg}, flatter than the {needed_deg} at which it clears itself"
        f" (equivalent friction angle + {{margin_deg}}, {scene.source('min_cut_off_margin_deg')})"
    )
    mask = (scene.solved.status == Status.OK) & (surface.turn < 0.0) & (slope < needed)
    numbers = {"slope_deg": slope, "needed_deg": needed, "margin_deg": margin}
    yield Case(mask, scene.solved.exit.distance, template, numbers, badness=needed - slope, asks="steeper")
