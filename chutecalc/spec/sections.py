"""Cross-sections of a checked spec as numbers."""

from itertools import pairwise

import numpy as np

from chutecalc.fields.faults import EVERY, GeometryFaults, Location
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array
from chutecalc.physics.section import Circle, Polygon, Section
from chutecalc.spec import chute_spec as model

UNBOUNDED = np.array([np.inf])
"""Of what has no top."""


def build_section(name: str, section: model.Section, faults: GeometryFaults) -> Section:
    """A cross-section in numbers.

    Args:
        name: of the section, for the locations of faults.
        section: as the spec says it.
        faults: what is wrong with it is noted there.
    """
    wall = UNBOUNDED if section.wall_height_m is None else in_si(section.wall_height_m, "length")
    if isinstance(section, model.Circular):
        return Circle(in_si(section.radius_m, "length"), wall)
    if isinstance(section, model.Rectangular):
        return Polygon(in_si(section.width_m, "length"), (), (), wall)
    if isinstance(section, model.Faceted):
        return _faceted(("sections", name, "facets"), section, wall, faults)
    assert isinstance(section, model.Chamfered | model.Vee)
    base = in_si(section.base_m, "length") if isinstance(section, model.Chamfered) else np.zeros(1)
    angle = in_si(section.chamfer_deg, "angle")
    location, problem = ("sections", name, "chamfer_deg"), "leaves a section without a base no width"
    narrow = (base == 0.0) & (angle == np.pi / 2)
    faults.note(narrow, location, section.chamfer_deg, problem, "give less than 90°, or a base")
    top = UNBOUNDED if section.chamfer_m is None else in_si(section.chamfer_m, "length")
    return Polygon(base, (top,), (angle,), wall)


def _faceted(location: Location, section: model.Faceted, wall: Array, faults: GeometryFaults) -> Polygon:
    """Facets from the centre outwards; those that are level are the centre section."""
    lengths = [in_si(facet.length_m, "length") for facet in section.facets]
    slopes = [in_si(facet.slope_deg, "angle") for facet in section.facets]
    for number, (lower, upper) in enumerate(pairwise(slopes), 2):
        value, remedy = section.facets[number - 1].slope_deg, "order them from the centre outwards"
        problem = "is flatter than the facet before it"
        faults.note(upper < lower, (*location, number - 1, "slope_deg"), value, problem, remedy)
    faults.note(slopes[-1] == 0.0, location, None, "are all level, and hold no stream", "add one that rises")
    value, problem = section.facets[0].slope_deg, "leaves the section no width"
    remedy = "begin with a facet that is less steep"
    faults.note(slopes[0] == np.pi / 2, (*location, 0, "slope_deg"), value, problem, remedy)
    return Polygon(np.zeros(1), tuple(lengths), tuple(slopes), wall)


def section_names(
    location: Location, segment: model.Guided, sections: dict[str, model.AnySection], faults: GeometryFaults
) -> tuple[str, str | None]:
    """Names of a segment's sections at its start and, along a taper, at its end.

    Args:
        location: of the segment in the spec.
        segment: a guiding one.
        sections: of the spec.
        faults: a taper between sections that are not alike is noted there.
    """
    if not isinstance(segment.section, list):
        return segment.section or next(iter(sections)), None
    first, last = segment.section
    one, other = sections[first], sections[last]
    alike = type(one) is type(other) and one.model_fields_set == other.model_fields_set
    if isinstance(one, model.Faceted) and isinstance(other, model.Faceted):
        alike = alike and len(one.facets) == len(other.facets)
    if not alike:
        problem = f"tapers from {first} to {last}, which differ in more than numbers"
        faults.note(EVERY, (*location, "section"), None, problem, "give both the same shape and the same keys")
        return first, None
    return first, last if last != first else None
