"""Whether the steel stands clear of the receiving belt."""

from collections.abc import Iterator

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.surface import least_height, point
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.solver.segment_solution import FIELD
from chutecalc.solver.steel import drawn_surface
from chutecalc.spec.limits import LIMITS

ROUNDING = 1e-9
"""Length below which two places are one, m."""


@criterion(
    "steel_on_belt",
    Severity.WARNING,
    summary="the steel stands on or below the receiving belt, or nearer above it than a limit",
    limit=f"distance ≤ {LIMITS['min_belt_clearance_m'].text}",
    source=LIMITS["min_belt_clearance_m"].source,
)
def steel_on_belt(scene: Scene) -> Iterator[Case]:
    """Find segments whose drawn surface comes down to the line of the receiving belt.

    Args:
        scene: the segment with the stream along it.
    """
    belt = scene.design.receiver
    if belt is None or belt.at is None:
        return
    surface, limit = drawn_surface(scene.contact), scene.limit("min_belt_clearance_m")
    height, share = least_height(surface, *belt.at, belt.slope_of_trace)
    first = scene.solved.table[FIELD["strikes"]] == 0.0  # not once more where the stream strikes it again
    x, z, _ = point(surface, share)
    numbers = {"gap_m": np.abs(height), "x_m": x, "z_m": z, "limit_m": limit}
    where = "the receiving belt, at x {x_m}, z {z_m}"
    advice = "raise it or end it further up, or correct receiver.at_m"
    source = scene.source("min_belt_clearance_m")
    near = f"the steel stands only {{gap_m}} above {where} (limit {{limit_m}}, {source}); {advice}"
    below = height < -ROUNDING
    on = ~below & (height <= ROUNDING)
    for mask, template in (
        (below, f"the steel reaches {{gap_m}} below the surface of {where}; {advice}"),
        (on, f"the steel touches {where}; {advice}"),
        (~below & ~on & (height < limit - ROUNDING), near),
    ):
        yield Case(mask & first, _distance(scene, share), template, numbers, badness=-height)


def _distance(scene: Scene, share: Array) -> Array:
    """Return how far from the inlet the stream is at a share of the segment's length, m; NaN where it does not come."""
    begin, end = scene.part.span()
    travelled = np.where(end > begin, (share - begin) / np.where(end > begin, end - begin, 1.0), 0.0)
    return scene.distance(np.clip(travelled, 0.0, 1.0))
