"""Whether the section has room for the stream and its lumps."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array
from chutecalc.physics.wetting import area_at_depth, wetting
from chutecalc.results.criterion import Case, criterion
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.spec.limits import LIMITS


@criterion(
    "overfull",
    Severity.WARNING,
    summary="the stream fills more of the section than leaves room for surges",
    limit=f"fill > {LIMITS['max_fill'].text}, in closed sections > {LIMITS['max_closed_fill'].text}",
    source=LIMITS["max_fill"].source,
    needs=[("fill", LARGEST)],
    foretells_failure=True,
)
def overfull(scene: Scene) -> Iterator[Case]:
    """Find streams that fill too much of their section (rule of thumb).

    Args:
        scene: the segment with the stream along it.
    """
    fullest, closed = scene.extreme("fill", LARGEST), scene.segment.section.closed
    key = "max_closed_fill" if closed else "max_fill"
    limit, source = scene.limit(key), scene.source(key)
    what = "of the closed section" if closed else "of the height of the walls"
    template = (
        f"the stream fills {{fill}} {what} (limit {{limit}}, {source}), which leaves little room for surges; use a"
        " wider section" + ("" if closed else " or higher walls")
    )
    mask = (fullest.value > limit) & np.isfinite(fullest.value)
    numbers = {"fill": fullest.value, "limit": limit}
    yield Case(mask, scene.distance(fullest.share), template, numbers, badness=fullest.value)


@criterion(
    "fine_stream",
    Severity.WARNING,
    summary="the stream is shallower than its largest lump: it is not a continuum",
    limit=f"H < {LIMITS['min_depth_over_lump'].text} lump",
    needs=[("depth_m", LEAST)],
)
def fine_stream(scene: Scene) -> Iterator[Case]:
    """Find streams that are shallower than their largest lump.

    Args:
        scene: the segment with the stream along it.
    """
    lump, limit = scene.design.lump, scene.limit("min_depth_over_lump")
    if lump is None or scene.segment.deflects:
        return
    least = scene.extreme("depth_m", LEAST)
    template = (
        "the stream is only {depth_m:in} deep, with lumps of {lump_m:in} (limit {limit} times a lump): they roll"
        " one by one rather than flow, so velocities are rough; check them with a discrete-element simulation"
    )
    numbers = {"depth_m": least.value, "lump_m": lump, "limit": limit}
    badness = -least.value / lump
    yield Case(least.value < limit * lump, scene.distance(least.share), template, numbers, badness=badness)


@criterion(
    "narrow_for_lumps",
    Severity.WARNING,
    summary="the section is so narrow that lumps may wedge in it",
    limit=f"width < {LIMITS['min_width_over_lump'].text} lumps",
    source=LIMITS["min_width_over_lump"].source,
    needs=[("depth_m", LEAST)],
)
def narrow_for_lumps(scene: Scene) -> Iterator[Case]:
    """Find sections narrower than three lumps (rule of thumb), at the height of a lump or of a deeper stream.

    Args:
        scene: the segment with the stream along it.
    """
    lump, limit = scene.design.lump, scene.limit("min_width_over_lump")
    if lump is None or scene.segment.deflects:
        return
    height, segment = np.fmax(scene.extreme("depth_m", LEAST).value, lump), scene.segment
    widths = [_width(scene, section, height) for section in (segment.section, segment.end_section or segment.section)]
    width = np.minimum(*widths)
    template = (
        "the section is {width_m:in} wide, with lumps of {lump_m:in} (limit {limit} times a lump,"
        f" {scene.source('min_width_over_lump')}):"
        " they may wedge; use a wider section"
    )
    s = np.where(widths[0] <= widths[1], scene.solved.entry.distance, scene.solved.exit.distance)
    there = np.isfinite(scene.solved.entry.distance)
    numbers = {"width_m": width, "lump_m": lump, "limit": limit}
    yield Case(there & (width < limit * lump), s, template, numbers, badness=-width / lump)


def _width(scene: Scene, section: Any, height: Array) -> Array:
    """Return the width of a section at a height above its floor, m."""
    finite = np.where(np.isfinite(height), height, 1.0)
    return wetting(section, scene.design.vertical_ratio, area_at_depth(section, finite)).width
