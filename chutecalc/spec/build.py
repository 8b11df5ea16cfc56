"""A checked spec as numbers: names resolved, units in SI, slopes along the chain, and the faults of geometry."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from chutecalc.design import Contact, Design, Fall, Segment
from chutecalc.physics.arrays import Array
from chutecalc.physics.motion import FLOOR, ROOF
from chutecalc.physics.pressure import vertical_pressure_ratio
from chutecalc.physics.section import Facets, Polygon, area_at_depth, facets
from chutecalc.spec import model
from chutecalc.spec.faults import PlacedFault
from chutecalc.spec.file import Place
from chutecalc.units import to_si

VERTICAL = np.array([np.pi / 2])


def build(spec: model.ChuteSpec, drawn_slopes: Mapping[int, Array] | None = None) -> Design:
    """The numeric description of a chute.

    Args:
        spec: the checked spec; its numbers may be arrays of length 1 or n.
        drawn_slopes: entry slopes, by number of the segment from 0, of curves tangent to a falling stream where another
            design has fixed them; else they follow the stream.

    Raises:
        GeometryError: all faults of geometry.
    """
    geometry = _Geometry(spec, drawn_slopes or {})
    design = geometry.design()
    if geometry.faults:
        raise GeometryError(geometry.faults)
    return design


class GeometryError(Exception):
    """A spec whose keys and values are right one by one, and do not go together."""

    def __init__(self, faults: list[PlacedFault]) -> None:
        self.faults = faults
        super().__init__(f"{len(faults)} faults of geometry")


def segment_names(spec: model.ChuteSpec) -> list[str]:
    """What each segment is called: its name, or its kind, with a number where that is taken."""
    names: list[str] = []
    taken = {segment.name for segment in spec.segments if segment.name}
    for segment in spec.segments:
        free = (f"{segment.kind}_{number}" for number in range(2, len(spec.segments) + 2))
        name = segment.name or next(item for item in (segment.kind, *free) if item not in taken)
        taken.add(name)
        names.append(name)
    return names


def _array(value: Any, dimension: str) -> Array:
    """A number of the spec in SI, of length 1 or n."""
    return np.atleast_1d(np.asarray(to_si(value, dimension), dtype=np.float64))


class _Geometry:
    """One pass along the spec; collects faults on its way."""

    def __init__(self, spec: model.ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        self.spec, self.drawn_slopes = spec, drawn_slopes
        self.faults: list[PlacedFault] = []

    def fault(self, place: Place, value: Any, problem: str, remedy: str) -> None:
        self.faults.append(PlacedFault(place, problem, remedy, value))

    def design(self) -> Design:
        """The design; of no use where there are faults."""
        material, flow, inlet = self.spec.material, self.spec.flow, self.spec.inlet
        friction = None if material.internal_friction_deg is None else _array(material.internal_friction_deg, "angle")
        if material.pressure_ratio is not None:
            ratio = _array(material.pressure_ratio, "number")
        else:
            assert friction is not None  # the material's own rule
            ratio = vertical_pressure_ratio(friction)
        return Design(
            mass_rate=_array(flow.rate_t_h, "mass rate"),
            density=_array(material.density_kg_m3, "density"),
            gravity=_array(flow.gravity_m_s2, "acceleration"),
            internal_friction=friction,
            vertical_ratio=ratio,
            inlet_velocity=_array(inlet.velocity_m_s, "velocity"),
            inlet_slope=_array(inlet.slope_deg, "angle"),
            segments=self.segments(ratio),
        )

    def segments(self, ratio: Array) -> tuple[Segment, ...]:
        """The segments, each with the slope at which it is drawn."""
        sections = {name: self.section(name, section) for name, section in self.spec.sections.items()}
        tables = {name: facets(section, ratio) for name, section in sections.items()}
        velocity = _array(self.spec.inlet.velocity_m_s, "velocity")
        if (velocity == 0.0).any() and self.spec.segments[0].kind != "fall":
            remedy = "give a velocity, or begin with a fall"
            self.fault(("inlet", "velocity_m_s"), self.spec.inlet.velocity_m_s, "leaves the stream at rest", remedy)
        resting = bool((velocity == 0.0).all())
        slope: Array | None = VERTICAL if resting else _array(self.spec.inlet.slope_deg, "angle")
        built: list[Segment] = []
        for number, (name, segment) in enumerate(zip(segment_names(self.spec), self.spec.segments, strict=True)):
            if isinstance(segment, model.Fall):
                built.append(Fall(name, segment.kind, _array(segment.drop_m, "length")))
                slope = slope if slope is not None and (slope == np.pi / 2).all() else None
                continue
            follows = self.drawn_slopes.get(number) if slope is None else slope
            contact = self.contact(("segments", number), name, segment, follows, sections, tables)
            built.append(contact)
            slope = contact.exit_slope
        return tuple(built)

    def contact(
        self,
        place: Place,
        name: str,
        segment: model.Straight | model.Arc,
        slope: Array | None,
        sections: dict[str, Polygon],
        tables: dict[str, Facets],
    ) -> Contact:
        """A guiding segment that follows a slope; None where that is the stream's."""
        section = segment.section or next(iter(sections))
        liner = self.spec.liners[segment.liner or next(iter(self.spec.liners))]
        radius: Array | None = None
        length: Array | None = None
        entry: Array | None
        if isinstance(segment, model.Straight):
            entry = exit_ = _array(segment.slope_deg, "angle")
            length = self.straight_length(place, segment, exit_)
        else:
            radius = _array(segment.radius_m, "length")
            exit_ = _array(segment.to_slope_deg, "angle")
            entry = slope if segment.from_slope_deg is None else _array(segment.from_slope_deg, "angle")
            self.check_turn(place, segment, entry, exit_)
        return Contact(
            name=name,
            kind=segment.kind,
            side=ROOF if isinstance(segment, model.Hood) else FLOOR,
            entry_slope=entry,
            exit_slope=exit_,
            radius=radius,
            length=length,
            section=sections[section],
            facets=tables[section],
            choke_area=area_at_depth(tables[section], sections[section].wall_height),
            wall_friction=np.tan(_array(liner.friction_deg, "angle")),
        )

    def straight_length(self, place: Place, segment: model.Straight, slope: Array) -> Array:
        """Length of a straight, from whichever of its three measures is given."""
        if segment.length_m is not None:
            return _array(segment.length_m, "length")
        if segment.drop_m is not None:
            if (slope == 0.0).any():
                self.fault(
                    (*place, "drop_m"), segment.drop_m, "gives a level segment no length", "give length_m or run_m"
                )
            return _array(segment.drop_m, "length") / np.where(slope > 0.0, np.sin(slope), 1.0)
        if (slope == np.pi / 2).any():
            self.fault(
                (*place, "run_m"), segment.run_m, "gives a vertical segment no length", "give length_m or drop_m"
            )
        return _array(segment.run_m, "length") / np.cos(slope)

    def check_turn(self, place: Place, segment: model.Arc, entry: Array | None, exit_: Array) -> None:
        """A hood has to steepen, a curve to turn; what begins tangent to a falling stream is known only when solved."""
        if entry is None:
            return
        key, start = (*place, "to_slope_deg"), f"{np.degrees(entry.flat[0]):.6g}°"
        if isinstance(segment, model.Hood) and (exit_ <= entry).any():
            problem = (
                f"has to be steeper than where the hood begins, {start}: only a roof that steepens guides a stream"
            )
            self.fault(key, segment.to_slope_deg, problem, "give a steeper slope, or make it a curve")
        elif (exit_ == entry).any():
            self.fault(
                key, segment.to_slope_deg, f"leaves the curve no length: it begins at {start}", "give another slope"
            )

    def section(self, name: str, section: model.Section) -> Polygon:
        """A cross-section as a polygon."""
        wall = np.array([np.inf]) if section.wall_height_m is None else _array(section.wall_height_m, "length")
        if isinstance(section, model.Rectangular):
            return Polygon(_array(section.width_m, "length"), (), (), wall)
        assert isinstance(section, model.Chamfered | model.Vee)
        base = _array(section.base_m, "length") if isinstance(section, model.Chamfered) else np.zeros(1)
        angle = _array(section.chamfer_deg, "angle")
        if ((base == 0.0) & (angle == np.pi / 2)).any():
            place: Place = ("sections", name, "chamfer_deg")
            self.fault(
                place, section.chamfer_deg, "leaves a section without a base no width", "give less than 90°, or a base"
            )
        top = np.array([np.inf]) if section.chamfer_m is None else _array(section.chamfer_m, "length")
        return Polygon(base, (top,), (angle,), wall)
