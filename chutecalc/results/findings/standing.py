"""What stays on a segment after a stop, and does not start by itself."""

from collections.abc import Iterator

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Mask
from chutecalc.physics.motion import FLOOR
from chutecalc.physics.wall import holding_depth
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.extremes import LEAST
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.results.stretches import negative_stretches
from chutecalc.spec.limits import LIMITS


@criterion(
    "will_not_clear",
    Severity.NOTE,
    Severity.WARNING,
    summary="what stands on a segment after a stop does not start by itself; a warning on most of its length",
    limit=f"a < atan(μ_e), a warning on a share > {LIMITS['max_standing_share'].text}",
    needs=[("clearing_margin_deg", LEAST)],
)
def will_not_clear(scene: Scene) -> Iterator[Case]:
    """Find floors that are flatter than the equivalent friction angle of a bed at rest, and beds held by adhesion.

    At a stop the bed is as deep as the stream was, and presses with its weight alone, n = g cos a. A bed of its own
    material, as in a rock box, is meant to stay.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.segment.own_material:
        return
    runs = (scene.solved.status == Status.OK) & (scene.contact.surface.side == FLOOR)  # a bed falls off a roof
    yield from _too_flat(scene, runs)
    yield from _held(scene, runs)


def _too_flat(scene: Scene, runs: Mask) -> Iterator[Case]:
    """Yield the cases of stretches that are too flat to clear, of designs whose stream runs along the floor."""
    part, worst = scene.part, scene.extreme("clearing_margin_deg", LEAST)
    if not (runs & (worst.value < 0.0)).any():
        return
    stretches = negative_stretches(part, "clearing_margin_deg")
    share = stretches.total(*stretches)
    volume = part.design.volume_rate * stretches.total(*(part.at(shares, ["time_s"])["time_s"] for shares in stretches))
    first = np.where(stretches.end > stretches.begin, stretches.begin, 1.0).min(axis=0)
    (slope,) = scene.at(worst.share, "slope_deg")
    numbers = {
        "standing_m": share * part.length(),
        "standing_percent": 100.0 * share,
        "volume_m3": volume,
        "slope_deg": slope,
        "needed_deg": slope - worst.value,
    }
    template = (
        "after a stop, {standing_m} of the segment ({standing_percent} %) and the {volume_m3} on it do not start by"
        " themselves: the slope falls to {slope_deg}, and {needed_deg} is needed there; "
    )
    stands, most = runs & (share > 0.0), share > scene.limit("max_standing_share")
    s = scene.distance(first)
    steeper = f"{template}make it steeper or smoother"
    yield Case(stands & most, s, steeper, numbers, Severity.WARNING, badness=share, asks="steeper")
    yield Case(stands & ~most, s, f"{template}provide for cleaning it", numbers, badness=share)


def _held(scene: Scene, runs: Mask) -> Iterator[Case]:
    """Yield the case of a bed that adhesion holds where the segment is steepest, of the same designs."""
    wall, surface, design = scene.segment.wall, scene.contact.surface, scene.design
    if not wall.intercepts.any():
        return
    begin, end = (np.broadcast_to(share, scene.designs) for share in scene.part.span())
    first, last = (surface.slope + surface.turn * share for share in (begin, end))
    steepest = np.fmax(first, last)
    held = holding_depth(wall, steepest, design.density * design.gravity)
    template = (
        "after a stop, adhesion holds a bed of up to {depth_m:in} where the segment is steepest, {slope_deg}: expect"
        " build-up; provide for cleaning it"
    )
    mask = runs & (held > 0.0) & np.isfinite(held)
    s = scene.distance(np.where(last > first, 1.0, 0.0))
    yield Case(mask, s, template, {"depth_m": held, "slope_deg": np.degrees(steepest)}, badness=held)
