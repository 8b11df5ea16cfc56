"""What the receiving belt makes of the stream."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS

PLAN = (
    "at a plan angle of {plan_angle_deg} only cos ψ = {share} of its horizontal velocity goes along the belt, however"
    " fast it is; a chute that turns the stream in plan is drawn in the plane of the receiving belt from there on, with"
    " plan_angle_deg = 0"
)
"""What to do where the heading of the stream, and not its velocity, is the reason."""


@criterion(
    "not_accelerated",
    Severity.WARNING,
    summary="the receiving belt never brings the stream to its own velocity",
    in_falls=True,
)
def not_accelerated(scene: Scene) -> Iterator[Case]:
    """Find receiving belts that cannot bring the stream to their velocity.

    Args:
        scene: the segment with the stream along it.
    """
    belt, received = scene.design.receiver, scene.received
    if belt is None or not received:
        return
    template = (
        "the belt never brings the stream from {velocity_along_m_s} to its own {belt_velocity_m_s}: its friction is too"
        " small for its slope of {belt_slope_deg}; use a flatter belt"
    )
    yield Case(
        np.isposinf(received["acceleration_length_m"]),
        scene.exit_distance,
        template,
        {
            "velocity_along_m_s": received["velocity_along_m_s"],
            "belt_velocity_m_s": belt.velocity,
            "belt_slope_deg": np.degrees(belt.slope),
        },
    )


@criterion(
    "hard_landing",
    Severity.WARNING,
    summary="the stream lands hard on the receiving belt",
    limit=f"velocity into the belt > {LIMITS['max_velocity_into_m_s'].text}",
    source=LIMITS["max_velocity_into_m_s"].source,
    in_falls=True,
)
def hard_landing(scene: Scene) -> Iterator[Case]:
    """Find streams that land hard on the receiving belt: by their velocity into it, or a pressure above its limit.

    Args:
        scene: the segment with the stream along it.
    """
    received, belt = scene.received, scene.design.receiver
    if not received or belt is None:
        return
    into, pressure = received["velocity_into_m_s"], received["impact_pressure_kpa"]
    fastest, greatest = scene.limit("max_velocity_into_m_s"), scene.limit("max_belt_impact_kpa")
    advice = (
        "it comes at a slope of {slope_deg} onto a belt of {belt_slope_deg}: expect wear and damage; end the chute"
        " closer to the slope of the belt, and nearer above it"
    )
    slopes = {"slope_deg": received["landing_slope_deg"], "belt_slope_deg": np.degrees(belt.slope)}
    source = scene.source("max_velocity_into_m_s")
    template = f"the stream lands with {{velocity_m_s}} into the belt (limit {{limit_m_s}}, {source}): {advice}"
    s, numbers = scene.exit_distance, {"velocity_m_s": into, "limit_m_s": fastest} | slopes
    asks = "flatter"
    yield Case(into > fastest, s, template, numbers, badness=into, asks=asks)
    template = f"the stream lands on the belt with {{pressure_kpa}} (limit {{limit_kpa}}): {advice}"
    numbers = {"pressure_kpa": pressure, "limit_kpa": greatest} | slopes
    yield Case(pressure > greatest, s, template, numbers, badness=pressure, asks=asks)


@criterion(
    "off_speed",
    Severity.WARNING,
    summary="the stream is slower or faster than the receiving belt",
    limit=f"velocity ratio < {LIMITS['min_velocity_ratio'].text} or > {LIMITS['max_velocity_ratio'].text}",
    source=LIMITS["min_velocity_ratio"].source,
    in_falls=True,
)
def off_speed(scene: Scene) -> Iterator[Case]:
    """Find streams whose velocity along the receiving belt is far from the belt's (rule of thumb).

    Args:
        scene: the segment with the stream along it.
    """
    belt, received = scene.design.receiver, scene.received
    if belt is None or not received:
        return
    ratio, low, high = received["velocity_ratio"], scene.limit("min_velocity_ratio"), scene.limit("max_velocity_ratio")
    source = scene.source("min_velocity_ratio", "max_velocity_ratio")
    share = np.round(np.cos(belt.plan_angle), 12)  # 0 at 90°
    turned = (ratio < low) & (share < low)  # horizontal at the belt's speed, it would still be too slow along the belt
    numbers = {
        "velocity_m_s": received["velocity_along_m_s"],
        "ratio": ratio,
        "belt_velocity_m_s": belt.velocity,
        "low": low,
        "high": high,
        "plan_angle_deg": np.degrees(belt.plan_angle),
        "share": share,
    }
    for mask, asks, advice in (
        (turned, "", PLAN),
        ((ratio < low) & ~turned, "faster", "make the stream faster, or end the chute closer to the slope of the belt"),
        (ratio > high, "slower", "make the stream slower, or the belt faster"),
    ):
        template = (
            "along the belt the stream has {velocity_m_s}, {ratio} times the {belt_velocity_m_s} of the belt (limits"
            f" {{low}} to {{high}}, {source}), which wears it; {advice}"
        )
        yield Case(mask, scene.exit_distance, template, numbers, badness=np.abs(ratio - 1.0), asks=asks)


@criterion(
    "far_landing",
    Severity.WARNING,
    summary="the stream lands far from where the receiving belt is to be loaded",
    limit=f"distance > {LIMITS['max_landing_offset_m'].text}",
    source=LIMITS["max_landing_offset_m"].source,
    in_falls=True,
)
def far_landing(scene: Scene) -> Iterator[Case]:
    """Find streams that land further from the place of the receiving belt than a limit that a spec may set.

    Args:
        scene: the segment with the stream along it.
    """
    belt, received = scene.design.receiver, scene.received
    if belt is None or belt.at is None or not received:
        return
    ahead = received["landing_x_m"] - belt.at[0]
    distance, limit = np.hypot(ahead, received["landing_z_m"] - belt.at[1]), scene.limit("max_landing_offset_m")
    for mask, where in ((ahead < 0.0, "before"), (ahead >= 0.0, "beyond")):
        template = (
            f"the stream lands {{distance_m}} {where} at_m of the receiving belt (limit {{limit_m}}); move the end of"
            " the chute or the belt, or correct receiver.at_m"
        )
        numbers = {"distance_m": distance, "limit_m": limit}
        yield Case(mask & (distance > limit), scene.exit_distance, template, numbers, badness=distance)
