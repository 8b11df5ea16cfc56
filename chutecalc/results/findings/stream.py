"""Whether the stream is one that the model and the drawn section describe."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.criterion import Case, criterion
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Severity
from chutecalc.results.scene import Scene
from chutecalc.solver.segment_solution import FIELD, TANGENT
from chutecalc.spec.limits import LIMITS


@criterion(
    "thick_stream",
    Severity.WARNING,
    summary="the stream is too deep for its width or for the radius of its surface",
    limit=f"H > {LIMITS['max_depth_over_width'].text} b, H > {LIMITS['max_depth_over_radius'].text} R",
    needs=[("thickness", LARGEST), ("depth_m", LARGEST)],
    foretells_failure=True,
)
def thick_stream(scene: Scene) -> Iterator[Case]:
    """Find depths above the stream's greatest width b, or above a tenth of the radius, unless other limits are given.

    Args:
        scene: the segment with the stream along it.
    """
    thick, deep = scene.extreme("thickness", LARGEST), scene.extreme("depth_m", LARGEST)
    limit = scene.limit("max_depth_over_width")
    template = (
        "the depth reaches {thickness} times the stream's width (limit {limit}), too thick for a model with one mean"
        " velocity; use a wider section"
    )
    numbers = {"thickness": thick.value, "limit": limit}
    yield Case(thick.value > limit, scene.distance(thick.share), template, numbers, badness=thick.value)
    share, limit = deep.value * np.abs(scene.contact.surface.curvature), scene.limit("max_depth_over_radius")
    template = (
        "the depth of {depth_m:in} reaches {share} of the radius (limit {limit}), too thick for a model with one mean"
        " velocity; use a larger radius"
    )
    numbers = {"depth_m": deep.value, "share": share, "limit": limit}
    yield Case(share > limit, scene.distance(deep.share), template, numbers, badness=share)


@criterion(
    "slow_stream",
    Severity.WARNING,
    summary="the stream is so slow that the neglected pressure gradient counts",
    limit=f"Fr < {LIMITS['min_froude'].text}",
    needs=[("froude", LEAST)],
    foretells_failure=True,
)
def slow_stream(scene: Scene) -> Iterator[Case]:
    """Find low Froude numbers, where a neglected pressure gradient changes dv/ds by about K/Fr².

    Args:
        scene: the segment with the stream along it.
    """
    froude, limit = scene.extreme("froude", LEAST), scene.limit("min_froude")
    template = (
        "the Froude number falls to {froude} (limit {limit}): the pressure gradient along the stream, which the model"
        " neglects, changes dv/ds by about 1/Fr² there; a steeper slope makes the stream faster"
    )
    mask = (froude.value < limit) & (scene.design.longitudinal_ratio == 0.0)
    numbers = {"froude": froude.value, "limit": limit}
    yield Case(mask, scene.distance(froude.share), template, numbers, badness=-froude.value, asks="faster")


@criterion(
    "missing_load",
    Severity.WARNING,
    summary="the paper's law lays much of the weight on the centre section by way of correction",
    limit=f"m > {LIMITS['max_missing_load'].text}",
    source=LIMITS["max_missing_load"].source,
    needs=[("missing_load", LARGEST)],
)
def missing_load(scene: Scene) -> Iterator[Case]:
    """Find loads that are too large for the paper's law, which lays them on the centre section as a correction.

    Args:
        scene: the segment with the stream along it.
    """
    if scene.design.equilibrium:
        return
    missing, limit = scene.extreme("missing_load", LARGEST), scene.limit("max_missing_load")
    friction, even = scene.at(missing.share, "equivalent_friction", "equilibrium_friction")
    template = (
        "the wall pressures of the paper's friction law leave {missing_percent} % of the weight of the stream uncarried"
        " (limit {limit_percent} %); this missing load is laid on the floor, which gives μ_e = {equivalent_friction};"
        ' spread over all walls (friction_law = "equilibrium") it would be {equilibrium_friction}: solve with that law'
        " too, and design for the higher friction"
    )
    runs = scene.part.length() > 0.0  # not where the stream leaves at once
    yield Case(
        (missing.value > limit) & (runs | scene.segment.deflects),
        scene.distance(missing.share),
        template,
        {
            "missing_load": missing.value,
            "missing_percent": 100.0 * missing.value,
            "limit_percent": 100.0 * limit,
            "equivalent_friction": friction,
            "equilibrium_friction": even,
        },
        badness=missing.value,
    )


@criterion(
    "above_chamfer",
    Severity.NOTE,
    summary="the depth passes the drawn top of the section",
    needs=[("above_top_m", LARGEST)],
    foretells_failure=True,
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
        "the curve is drawn tangent to the stream of the spec, from {slope_deg}: another flow draws another curve; set"
        " from_slope_deg, or let `chutecalc freeze` write it down"
    )
    s, first = scene.solved.start.distance, scene.solved.table[FIELD["strikes"]] == 0.0
    mask = first & (slope < 90.0 - np.degrees(TANGENT))
    yield Case(mask, s, template, {"slope_deg": slope})
