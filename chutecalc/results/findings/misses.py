"""What a stream in flight does not meet."""

from collections.abc import Iterator

import numpy as np

from chutecalc.core.fall import LONGEST_FALL
from chutecalc.design import Fall, Status
from chutecalc.physics.arrays import Array, Mask
from chutecalc.physics.surface import point
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.finding import Severity
from chutecalc.results.landings import before_start
from chutecalc.results.scene import Scene
from chutecalc.solver.segment_solution import Point


@criterion(
    "passed_by",
    Severity.FAILURE,
    Severity.NOTE,
    summary="the stream flies past a segment without touching it; a note where it may_be_passed",
)
def passed_by(scene: Scene) -> Iterator[Case]:
    """Find flights past the drawn end of a segment on the stream's side, and any past one that may be passed.

    Args:
        scene: the segment with the stream along it.
    """
    solved, gap = scene.solved, _gap(scene)
    numbers = {"velocity_m_s": solved.start.velocity, "slope_deg": np.degrees(solved.start.slope), "gap_m": gap}
    s = solved.start.distance
    template = (
        "the stream comes at {velocity_m_s} and a slope of {slope_deg} and flies past the segment, {gap_m} from its"
        " end, without touching it; move it into the stream or make it longer, or say may_be_passed = true"
    )
    if scene.segment.deflects:
        template += ". A plate is struck on its lower face, by a stream flatter than it; a floor is a straight"
    yield Case((solved.status == Status.MISSED) & (gap > 0.0), s, template, numbers)
    template = "the stream comes at {velocity_m_s} and a slope of {slope_deg} and flies past the segment, as it may"
    if scene.segment.closed:
        template = "the stream comes at {velocity_m_s} and a slope of {slope_deg} and flies through without touching it"
    yield Case(solved.status == Status.PASSED, s, template, numbers, Severity.NOTE)


@criterion(
    "missed",
    Severity.FAILURE,
    summary="a stream in flight does not meet the segment or the level that should catch it",
    in_falls=True,
)
def missed(scene: Scene) -> Iterator[Case]:
    """Find flights that fall short of the segment, and falls whose end is never reached.

    Args:
        scene: the segment with the stream along it.
    """
    solved = scene.solved
    lost = solved.status == Status.MISSED
    segment = scene.part.segment
    yield from _below_belt(scene)
    if isinstance(segment, Fall):
        yield from _never_ends(segment, solved.start, lost, scene.design.gravity)
        return
    gap = -_gap(scene)
    lost = lost & ~(gap < 0.0)
    before = before_start(solved)
    numbers = {"velocity_m_s": solved.start.velocity, "slope_deg": np.degrees(solved.start.slope)}
    begin = "the stream flies off at {velocity_m_s} and a slope of {slope_deg} and misses the segment: "
    s = solved.start.distance
    short = (
        f"{begin}it falls short and passes {{before_m}} before its start; let the segment begin further upstream, or"
        " keep the stream faster"
    )
    is_short = before > 0.0
    yield Case(lost & is_short, s, short, numbers | {"before_m": before})
    behind = f"{begin}it passes {{gap_m}} behind its end; move it towards the stream"
    yield Case(lost & ~is_short & np.isfinite(gap), s, behind, numbers | {"gap_m": gap})
    away = f"{begin}it never reaches it; check start_m and the slopes"
    yield Case(lost & ~is_short & np.isnan(gap), s, away, numbers)


def _below_belt(scene: Scene) -> Iterator[Case]:
    """Yield the case of streams that leave the chute below the line of the receiving belt."""
    belt, solved = scene.design.receiver, scene.solved
    if not scene.received or belt is None or belt.at is None:
        return
    passed, slope = solved.status == Status.PASSED, belt.slope_of_trace
    through = np.isin(solved.status, (Status.OK, Status.CONTACT_LOST)) | passed
    x, z, s = (
        np.where(passed, getattr(solved.start, name), getattr(solved.exit, name)) for name in ("x", "z", "distance")
    )
    below = (belt.at[1] - z) * np.cos(slope) + (belt.at[0] - x) * np.sin(slope)
    lost = through & np.isnan(scene.received["landing_x_m"]) & (scene.status == Status.MISSED)
    template = (
        "the stream leaves the chute {below_m} below the line of the receiving belt and never lands on it; end the"
        " chute above the belt, or correct receiver.at_m"
    )
    yield Case(lost & (below > 0.0), s, template, {"below_m": below})
    template = (
        "the stream meets the line of the receiving belt more than {limit_m} below the end of the chute, further than"
        " anything falls here; correct receiver.at_m, or the slope of the belt"
    )
    yield Case(lost & ~(below > 0.0), s, template, {"limit_m": np.array([LONGEST_FALL])})


def _gap(scene: Scene) -> Array:
    """Return how far from a segment's end a flight passes on the stream's side, m; NaN if it does not pass it.

    That is along the normal there; of a flight that never crosses it, below or above the end.
    """
    surface, gap = scene.contact.surface, scene.contact.arrival.gap
    end_x, end_z, _ = point(surface, np.ones(1))
    x, z, forward, downward, gravity = scene.solved.path
    time = np.where(forward > 0.0, (end_x - x) / forward, np.nan)
    beside = surface.side * (z - (downward + 0.5 * gravity * time) * time - end_z)
    return np.where(np.isnan(gap) & (time >= 0.0), beside, gap)


def _never_ends(fall: Fall, start: Point, lost: Mask, gravity: Array) -> Iterator[Case]:
    """Yield the cases of falls to a level or a distance that the stream never reaches."""
    begin = "the stream never reaches the end of the fall: it "
    if fall.run is None:
        yield Case(lost, start.distance, f"{begin}is already below that level; increase drop_m")
        return
    forward = start.velocity * np.cos(start.slope)
    time = fall.run / forward
    falls = (start.velocity * np.sin(start.slope) + 0.5 * gravity * time) * time
    down, steep = forward <= 0.0, falls > LONGEST_FALL
    yield Case(lost & down, start.distance, f"{begin}falls straight down; give drop_m instead of run_m", {})
    steep = steep & ~down
    template = (
        f"{begin}would fall {{falls_m}} on the way to {{run_m}}, and nothing here falls further than {{limit_m}}; give"
        " drop_m instead of run_m, or check the slope"
    )
    numbers = {"falls_m": falls, "run_m": fall.run, "limit_m": np.array([LONGEST_FALL])}
    yield Case(lost & steep, start.distance, template, numbers)
    yield Case(lost & ~steep & ~down, start.distance, f"{begin}is already past that distance; increase run_m")
