"""Whether the friction of liners is known and possible."""

from collections.abc import Iterator

import numpy as np

from chutecalc.physics.pressure import greatest_wall_friction
from chutecalc.physics.wall import wall_friction
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene

ROUNDING = 1e-12


@criterion(
    "inadmissible_friction",
    Severity.WARNING,
    summary="the wall friction exceeds what the material itself can show",
    limit="φ > atan(sin δ)",
    source="Paper, section 6",
    needs=[("wall_friction", LARGEST)],
)
def inadmissible_friction(scene: Scene) -> Iterator[Case]:
    """Find wall friction above atan(sin δ) (Paper, section 6), or a yield locus that this bounds.

    Args:
        scene: the segment with the stream along it.
    """
    internal = scene.design.internal_friction
    if internal is None:
        return
    bound, worst, impact = np.sin(internal), scene.extreme("wall_friction", LARGEST), scene.contact.arrival.impact
    numbers = {
        "greatest_deg": np.degrees(greatest_wall_friction(internal)),
        "internal_friction_deg": np.degrees(internal),
    }
    wall = scene.segment.wall
    if wall.changes:
        template = (
            "somewhere on this segment the yield locus gives more friction than the material can have on any wall,"
            " {greatest_deg} = atan(sin {internal_friction_deg}); that limit is used there: check locus and angle"
        )
        least = bound * (1.0 - ROUNDING)
        on_floor = worst.value >= least
        mask = on_floor | ((impact.pressure > 0.0) & (wall_friction(wall, impact.stress) >= least))
        s = np.where(on_floor, scene.distance(worst.share), scene.solved.entry.distance)
        yield Case(mask, s, template, numbers)
        return
    template = (
        "the wall friction of {friction_deg} exceeds what the material can have on any wall, {greatest_deg} ="
        " atan(sin {internal_friction_deg}); it is used as given: check both angles"
    )
    numbers["friction_deg"] = np.degrees(np.arctan(wall.slopes[0]))
    mask = np.isfinite(worst.value) & (wall.slopes[0] > bound * (1.0 + ROUNDING))
    s = scene.solved.entry.distance
    yield Case(mask, s, template, numbers, badness=wall.slopes[0] / bound)


@criterion(
    "outside_locus",
    Severity.WARNING,
    summary="the floor carries stresses outside the measured yield locus",
    needs=[("wall_stress_kpa", LEAST), ("wall_stress_kpa", LARGEST)],
)
def outside_locus(scene: Scene) -> Iterator[Case]:
    """Find floors that carry less or more stress than their yield locus was measured at.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.segment.measured is None:
        return
    impact = scene.contact.arrival.impact
    low, high = (rows / 1000.0 for rows in scene.segment.measured)
    struck = np.where(impact.pressure > 0.0, impact.stress / 1000.0, np.nan)
    least = np.fmin(scene.extreme("wall_stress_kpa", LEAST).value, struck)
    most = np.fmax(scene.extreme("wall_stress_kpa", LARGEST).value, struck)
    below, above = least < low * (1.0 - ROUNDING), most > high * (1.0 + ROUNDING)
    template = (
        "the floor carries {least_kpa} to {most_kpa}, but the yield locus was measured from {first_kpa} to {last_kpa};"
        " beyond that range friction is extrapolated: measure it there too"
    )
    s = np.where(below, scene.distance(scene.extreme("wall_stress_kpa", LEAST).share), scene.solved.entry.distance)
    numbers = {"least_kpa": least, "most_kpa": most, "first_kpa": low, "last_kpa": high}
    yield Case(below | above, s, template, numbers, badness=np.fmax(low / least, most / high))
