"""Whether the stream is one that the model and the drawn section describe."""

from collections.abc import Iterator

import numpy as np

from chutecalc.physics.arrays import Array, Numbers
from chutecalc.results.criterion import Case, Scene, criterion
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Severity
from chutecalc.solver.segment_solution import TANGENT

THICKEST = 1.0
THICKEST_ON_ARC = 0.1
SLOWEST_FROUDE = 2.0
MOST_MISSING = 0.10


@criterion(
    "thick_stream",
    Severity.WARNING,
    summary="the stream is too deep for its width or for the radius of its surface",
    limit=f"H > {THICKEST:g} b, H > {THICKEST_ON_ARC:g} R",
    needs=[("thickness", LARGEST), ("depth_m", LARGEST)],
)
def thick_stream(scene: Scene) -> Iterator[Case]:
    """Find depths above the stream's greatest width b, or above a tenth of the radius.

    Args:
        scene: the segment with the stream along it.
    """
    thick, deep = scene.extreme("thickness", LARGEST), scene.extreme("depth_m", LARGEST)
    template = (
        "the depth reaches {thickness} times the stream's width (limit 1), too thick for a model with one mean"
        " velocity; use a wider section"
    )
    s, numbers = scene.distance(thick.share), {"thickness": thick.value}
    yield from _too_thick(thick.value, THICKEST, s, template, numbers, "the stream's width")
    share = deep.value * np.abs(scene.contact.surface.curvature)
    template = (
        "the depth of {depth_m:in} reaches {share} of the radius (limit 0.1), too thick for a model with one mean"
        " velocity; use a larger radius"
    )
    s, numbers = scene.distance(deep.share), {"depth_m": deep.value, "share": share}
    yield from _too_thick(share, THICKEST_ON_ARC, s, template, numbers, "a tenth of the radius")


def _too_thick(ratio: Array, limit: float, s: Array, template: str, numbers: Numbers, what: str) -> Iterator[Case]:
    """Yield the cases of a depth above a limit: a largest depth, and a stall, towards which it grows without bound."""
    thick, bounded = ratio > limit, np.isfinite(ratio)
    yield Case(thick & bounded, s, template, numbers)
    template = (
        f"the depth grows without bound where the stream stalls, past {what}: too thick for a model with one mean"
        " velocity; prevent the stall"
    )
    yield Case(thick & ~bounded, s, template)


@criterion(
    "slow_stream",
    Severity.WARNING,
    summary="the stream is so slow that the neglected pressure gradient counts",
    limit=f"Fr < {SLOWEST_FROUDE:g}",
    needs=[("froude", LEAST)],
)
def slow_stream(scene: Scene) -> Iterator[Case]:
    """Find Froude numbers below 2, where the neglected pressure gradient changes dv/ds by about K/Fr².

    Args:
        scene: the segment with the stream along it.
    """
    froude = scene.extreme("froude", LEAST)
    template = (
        "the Froude number falls to {froude} (limit 2): the pressure gradient along the stream, which the model"
        " neglects, changes dv/ds by about 1/Fr² there; a steeper slope makes the stream faster"
    )
    mask = froude.value < SLOWEST_FROUDE
    yield Case(mask, scene.distance(froude.share), template, {"froude": froude.value})


@criterion(
    "missing_load",
    Severity.WARNING,
    summary="the paper's law lays much of the weight on the centre section by way of correction",
    limit=f"m > {MOST_MISSING:g}",
    needs=[("missing_load", LARGEST)],
)
def missing_load(scene: Scene) -> Iterator[Case]:
    """Find loads above a tenth of the weight that the paper's law lays on the centre section as a correction.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.design.equilibrium:
        return
    missing = scene.extreme("missing_load", LARGEST)
    friction, even = scene.at(missing.share, "equivalent_friction", "equilibrium_friction")
    template = (
        "hydrostatic wall pressures do not carry {missing_percent} % of the weight (limit 10 %): the paper's law lays"
        " it on the centre section, which gives μ_e = {equivalent_friction}; spread over all walls it would be"
        ' {equilibrium_friction} (friction_law = "equilibrium")'
    )
    yield Case(
        missing.value > MOST_MISSING,
        scene.distance(missing.share),
        template,
        {
            "missing_load": missing.value,
            "missing_percent": 100.0 * missing.value,
            "equivalent_friction": friction,
            "equilibrium_friction": even,
        },
    )


@criterion(
    "above_chamfer",
    Severity.NOTE,
    summary="the depth passes the drawn top of the section",
    needs=[("above_top_m", LARGEST)],
)
def above_chamfer(scene: Scene) -> Iterator[Case]:
    """Find depths above the drawn top of the section.

    Args:
        scene: the segment with the stream along it.
    """
    worst = scene.extreme("above_top_m", LARGEST)
    (top,) = scene.at(worst.share, "top_m")
    template = (
        "the depth of {depth_m:in} exceeds the drawn top of the section at {top_m:in}; above it the walls are taken as"
        " vertical"
    )
    numbers = {"depth_m": worst.value + top, "top_m": top}
    yield Case(worst.value > 0.0, scene.distance(worst.share), template, numbers)


@criterion(
    "geometry_follows_flow", Severity.NOTE, summary="a curve is drawn tangent to a stream that does not fall vertically"
)
def geometry_follows_flow(scene: Scene) -> Iterator[Case]:
    """Find curves tangent to a stream that does not fall vertically: their drawn slope changes with the flow.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.segment.entry_slope is not None:
        return
    slope = np.degrees(scene.contact.surface.slope)
    template = (
        "the curve is drawn tangent to the stream, from {slope_deg}, so its shape changes with the flow; set"
        " from_slope_deg to fix it"
    )
    s = scene.solved.start.distance
    mask = slope < 90.0 - np.degrees(TANGENT)
    yield Case(mask, s, template, {"slope_deg": slope})
