"""What the belt that the stream comes from makes of it."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS

_ON_PULLEY = (
    *("discharge_froude", "slope_deg", "velocity_m_s", "slide_start_deg", "held_slope_deg", "held_velocity_m_s"),
    *("frictionless_slope_deg", "frictionless_velocity_m_s"),
)


@criterion(
    "slides_on_pulley",
    Severity.WARNING,
    Severity.NOTE,
    summary="the belt is too slow to throw the stream, which slides on the pulley, or may do so",
    limit="Fr < cos ε",
    in_falls=True,
)
def slides_on_pulley(scene: Scene) -> Iterator[Case]:
    """Find streams that go round the pulley: they slide, or without a friction angle may do so.

    Args:
        scene: the segment with the stream along it.
    """
    inlet = scene.inlet
    if "held_slope_deg" not in inlet:
        return
    carried = np.isfinite(inlet["held_slope_deg"])
    numbers = {name: inlet[name] for name in _ON_PULLEY if name in inlet}
    begin = "the belt is too slow to throw the stream (V²/(g r) is {discharge_froude}): "
    held = "at {held_slope_deg} and {held_velocity_m_s}"
    if "slide_start_deg" in inlet:
        slides = (
            "it slides on the pulley from {slide_start_deg} on and leaves at {slope_deg} and {velocity_m_s}, and not"
            f" {held} as one that is held; a faster belt or a smaller pulley throws it"
        )
        yield Case(carried, np.zeros(1), begin + slides, numbers, badness=-inlet["discharge_froude"])
        return
    bounds = (
        f"it leaves {held} if the belt holds it to the end, as is solved here, and at {{frictionless_slope_deg}} and"
        " {frictionless_velocity_m_s} if it slides without friction; give friction_deg of the belt"
    )
    yield Case(carried, np.zeros(1), begin + bounds, numbers, Severity.NOTE)


@criterion(
    "belt_overfull",
    Severity.WARNING,
    summary="the belt brings more than it can carry",
    limit=f"A_b > {LIMITS['max_belt_fill'].text} S",
    source=LIMITS["max_belt_fill"].source,
    in_falls=True,
)
def belt_overfull(scene: Scene) -> Iterator[Case]:
    """Find loads larger than the area that the belt can carry.

    Args:
        scene: the segment with the stream along it.
    """
    if "belt_fill" not in scene.inlet:
        return
    numbers = {name: scene.inlet[name] for name in ("belt_fill", "load_width_m", "load_area_m2")}
    numbers["limit"] = scene.limit("max_belt_fill")
    template = (
        "the load of {load_area_m2} fills the belt that brings it to {belt_fill} (limit {limit}) and spills; it would"
        " cover {load_width_m:in} of belt: use a wider or faster belt"
    )
    fill = numbers["belt_fill"]
    yield Case(fill > numbers["limit"], np.zeros(1), template, numbers, badness=fill)
