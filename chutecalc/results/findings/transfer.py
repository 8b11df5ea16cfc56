"""What the receiving belt makes of the stream."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.criterion import Case, Scene, criterion
from chutecalc.results.finding import Severity


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
