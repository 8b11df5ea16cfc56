"""A checked spec as numbers: names resolved, units in SI, slopes along the chain, and the faults of geometry."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from chutecalc.design import Belt, Contact, Design, Fall, Receiver, Segment
from chutecalc.physics.arrays import Array, Mask, shared
from chutecalc.physics.belt import discharge
from chutecalc.physics.motion import FLOOR, ROOF
from chutecalc.physics.pressure import vertical_pressure_ratio
from chutecalc.physics.section import Circle, Facets, Polygon, Section, facets
from chutecalc.physics.wall import Wall, constant_wall, yield_locus
from chutecalc.spec import model
from chutecalc.spec.faults import PlacedFault
from chutecalc.spec.file import Place
from chutecalc.units import to_si

LONGEST = 1e5  # m, as of every length
VERTICAL = np.array([np.pi / 2])
EVERY = np.ones(1, dtype=bool)


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
        raise GeometryError(geometry.faults, geometry.faulty)
    return design


class GeometryError(Exception):
    """A spec whose keys and values are right one by one, and do not go together."""

    def __init__(self, faults: list[PlacedFault], designs: Mask) -> None:
        """All faults, and a mask of the designs that have them, of length 1 or n."""
        self.faults, self.designs = faults, designs
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


def _optional(length: Any) -> Array | None:
    """A length that may be absent."""
    return None if length is None else _array(length, "length")


def _array(value: Any, dimension: str) -> Array:
    """A number of the spec in SI, of length 1 or n."""
    return np.array(to_si(value, dimension), dtype=np.float64, ndmin=1)


class _Geometry:
    """One pass along the spec; collects faults on its way."""

    def __init__(self, spec: model.ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        self.spec, self.drawn_slopes = spec, drawn_slopes
        self.faults: list[PlacedFault] = []
        self.faulty: Mask = np.zeros(1, dtype=bool)

    def fault(self, designs: Mask, place: Place, value: Any, problem: str, remedy: str) -> None:
        """Notes a fault where there are designs that have it."""
        if designs.any():
            self.faults.append(PlacedFault(place, problem, remedy, value))
            self.faulty = self.faulty | designs

    def design(self) -> Design:
        """The design; of no use where there are faults."""
        material, flow = self.spec.material, self.spec.flow
        friction = None if material.internal_friction_deg is None else _array(material.internal_friction_deg, "angle")
        if material.pressure_ratio is not None:
            ratio = _array(material.pressure_ratio, "number")
        else:
            assert friction is not None  # the material's own rule
            ratio = vertical_pressure_ratio(friction)
        velocity, slope, place, belt = self.inlet()
        return Design(
            mass_rate=_array(flow.rate_t_h, "mass rate"),
            density=_array(material.density_kg_m3, "density"),
            gravity=_array(flow.gravity_m_s2, "acceleration"),
            internal_friction=friction,
            vertical_ratio=ratio,
            equilibrium=self.spec.model.friction_law == "equilibrium",
            inlet_place=place,
            inlet_velocity=velocity,
            inlet_slope=slope,
            belt=belt,
            receiver=self.receiver(),
            segments=self.segments(ratio, velocity, slope),
        )

    def inlet(self) -> tuple[Array, Array, tuple[Array, Array], Belt | None]:
        """Velocity, slope and place of the stream where it enters, and the belt it comes from."""
        inlet = self.spec.inlet
        x, z = (_array(item, "length") for item in inlet.at_m)
        if inlet.belt is None:
            return _array(inlet.velocity_m_s, "velocity"), _array(inlet.slope_deg, "angle"), (x, z), None
        velocity, incline = _array(inlet.belt.velocity_m_s, "velocity"), _array(inlet.belt.incline_deg, "angle")
        lower = _array(inlet.belt.pulley_radius_m, "length") + _array(inlet.belt.belt_thickness_m, "length")
        middle = lower + 0.5 * _array(inlet.belt.material_depth_m, "length")
        leaves = discharge(velocity, incline, middle, _array(self.spec.flow.gravity_m_s2, "acceleration"))
        belt = Belt((x, z), velocity, incline, lower, middle)
        return velocity, leaves.slope, (x + leaves.x, z + leaves.z), belt

    def receiver(self) -> Receiver | None:
        """The belt below, if there is one."""
        belt = self.spec.receiver
        if belt is None:
            return None
        friction = np.tan(_array(belt.friction_deg, "angle"))
        return Receiver(_array(belt.velocity_m_s, "velocity"), _array(belt.slope_deg, "angle"), friction)

    def segments(self, ratio: Array, velocity: Array, inlet_slope: Array) -> tuple[Segment, ...]:
        """The segments, each with the slope at which it is drawn."""
        sections = {name: self.section(name, section) for name, section in self.spec.sections.items()}
        tables = {name: facets(section, ratio) for name, section in sections.items()}
        walls = {name: self.wall(liner) for name, liner in self.spec.liners.items()}
        if self.spec.segments[0].kind != "fall":
            place, remedy = ("inlet", "velocity_m_s"), "give a velocity, or begin with a fall"
            self.fault(velocity == 0.0, place, self.spec.inlet.velocity_m_s, "leaves the stream at rest", remedy)
        slope: Array | None = shared(np.where(velocity == 0.0, VERTICAL, inlet_slope))  # a stream at rest falls
        built: list[Segment] = []
        for number, (name, segment) in enumerate(zip(segment_names(self.spec), self.spec.segments, strict=True)):
            if isinstance(segment, model.Fall):
                vertical = slope is not None and bool((slope == np.pi / 2).all())
                if vertical and segment.run_m is not None:
                    problem = "is never reached: the stream falls straight down"
                    self.fault(EVERY, ("segments", number, "run_m"), segment.run_m, problem, "give drop_m")
                drop, run = _optional(segment.drop_m), _optional(segment.run_m)
                built.append(Fall(name, segment.kind, drop, run))
                slope = VERTICAL if vertical else None
                continue
            follows = self.drawn_slopes.get(number, slope)
            contact = self.contact(("segments", number), name, segment, follows, sections, tables, walls)
            built.append(contact)
            slope = None if segment.kind == "plate" else contact.exit_slope
        return tuple(built)

    def contact(
        self,
        place: Place,
        name: str,
        segment: model.Flat | model.Arc,
        slope: Array | None,
        sections: dict[str, Section],
        tables: dict[str, Facets],
        walls: dict[str, Wall],
    ) -> Contact:
        """A guiding segment that follows a slope; None where that is the stream's."""
        section, end_section = self.named_sections(place, segment, sections)
        liner = segment.liner or next(iter(self.spec.liners))
        radius: Array | None = None
        length: Array | None = None
        entry: Array | None
        if isinstance(segment, model.Flat):
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
            side=ROOF if segment.kind in ("hood", "plate") else FLOOR,
            entry_slope=entry,
            exit_slope=exit_,
            radius=radius,
            length=length,
            start=None
            if segment.start_m is None
            else (_array(segment.start_m[0], "length"), _array(segment.start_m[1], "length")),
            section=sections[section],
            end_section=None if end_section is None else sections[end_section],
            facets=tables[section],
            wall=walls[liner],
            slip_ratio=_array(self.spec.liners[liner].slip_ratio, "number"),
        )

    def named_sections(
        self, place: Place, segment: model.Guided, sections: dict[str, Section]
    ) -> tuple[str, str | None]:
        """Names of the sections at the start and, along a taper, at the end."""
        if not isinstance(segment.section, list):
            return segment.section or next(iter(sections)), None
        first, last = segment.section
        one, other = self.spec.sections[first], self.spec.sections[last]
        alike = type(one) is type(other) and one.model_fields_set == other.model_fields_set
        if isinstance(one, model.Faceted) and isinstance(other, model.Faceted):
            alike = alike and len(one.facets) == len(other.facets)
        if not alike:
            problem = f"tapers from {first} to {last}, which differ in more than numbers"
            self.fault(EVERY, (*place, "section"), None, problem, "give both the same shape and the same keys")
            return first, None
        return first, last if last != first else None

    def wall(self, liner: model.Liner) -> Wall:
        """The friction law of a liner."""
        if liner.friction_deg is not None:
            return constant_wall(np.tan(_array(liner.friction_deg, "angle")))
        strength = np.sin(_array(self.spec.material.internal_friction_deg, "angle"))
        if liner.yield_locus_kpa is None:
            return constant_wall(strength)
        columns = zip(*liner.yield_locus_kpa, strict=True)
        normal, shear = (
            np.stack(np.broadcast_arrays(*(_array(item, "pressure") for item in column))) for column in columns
        )
        return yield_locus(normal, shear, strength)

    def straight_length(self, place: Place, segment: model.Flat, slope: Array) -> Array:
        """Length of a flat segment, from whichever of its three measures is given."""
        length = self._flat_length(place, segment, slope)
        key = "drop_m" if segment.drop_m is not None else "run_m"
        problem = f"makes the segment {float(length.max()):.3g} m long: more than {LONGEST:g} m"
        self.fault(length > LONGEST, (*place, key), getattr(segment, key), problem, "change it, or the slope")
        return np.minimum(length, LONGEST)

    def _flat_length(self, place: Place, segment: model.Flat, slope: Array) -> Array:
        """The same, however long."""
        if segment.length_m is not None:
            return _array(segment.length_m, "length")
        if segment.drop_m is not None:
            problem = "gives a level segment no length"
            self.fault(slope == 0.0, (*place, "drop_m"), segment.drop_m, problem, "give length_m or run_m")
            return _array(segment.drop_m, "length") / np.where(slope != 0.0, np.abs(np.sin(slope)), 1.0)
        problem = "gives a vertical segment no length"
        self.fault(slope == np.pi / 2, (*place, "run_m"), segment.run_m, problem, "give length_m or drop_m")
        return _array(segment.run_m, "length") / np.where(slope != np.pi / 2, np.cos(slope), 1.0)

    def check_turn(self, place: Place, segment: model.Arc, entry: Array | None, exit_: Array) -> None:
        """A hood has to steepen, a curve to turn; what begins tangent to a falling stream is known only when solved."""
        if entry is None:
            return
        key, start = (*place, "to_slope_deg"), f"{np.degrees(entry.flat[0]):.6g}°"
        if segment.kind == "hood":
            problem = (
                f"has to be steeper than where the hood begins, {start}: only a roof that steepens guides a stream"
            )
            self.fault(exit_ <= entry, key, segment.to_slope_deg, problem, "give a steeper slope, or make it a curve")
        else:
            problem = f"leaves the curve no length: it begins at {start}"
            self.fault(exit_ == entry, key, segment.to_slope_deg, problem, "give another slope")

    def section(self, name: str, section: model.Section) -> Section:
        """A cross-section in numbers."""
        wall = np.array([np.inf]) if section.wall_height_m is None else _array(section.wall_height_m, "length")
        if isinstance(section, model.Circular):
            return Circle(_array(section.radius_m, "length"), wall)
        if isinstance(section, model.Rectangular):
            return Polygon(_array(section.width_m, "length"), (), (), wall)
        if isinstance(section, model.Faceted):
            return self.faceted(("sections", name, "facets"), section, wall)
        assert isinstance(section, model.Chamfered | model.Vee)
        base = _array(section.base_m, "length") if isinstance(section, model.Chamfered) else np.zeros(1)
        angle = _array(section.chamfer_deg, "angle")
        place, problem = ("sections", name, "chamfer_deg"), "leaves a section without a base no width"
        narrow = (base == 0.0) & (angle == np.pi / 2)
        self.fault(narrow, place, section.chamfer_deg, problem, "give less than 90°, or a base")
        top = np.array([np.inf]) if section.chamfer_m is None else _array(section.chamfer_m, "length")
        return Polygon(base, (top,), (angle,), wall)

    def faceted(self, place: Place, section: model.Faceted, wall: Array) -> Polygon:
        """Facets from the centre outwards; those that are level in all designs are the centre section."""
        lengths = [_array(facet.length_m, "length") for facet in section.facets]
        slopes = [_array(facet.slope_deg, "angle") for facet in section.facets]
        for number, (lower, upper) in enumerate(pairwise(slopes), 2):
            value, remedy = section.facets[number - 1].slope_deg, "order them from the centre outwards"
            problem = "is flatter than the facet before it"
            self.fault(upper < lower, (*place, number - 1, "slope_deg"), value, problem, remedy)
        self.fault(slopes[-1] == 0.0, place, None, "are all level, and hold no stream", "add one that rises")
        value, problem = section.facets[0].slope_deg, "leaves the section no width"
        remedy = "begin with a facet that is less steep"
        self.fault(slopes[0] == np.pi / 2, (*place, 0, "slope_deg"), value, problem, remedy)
        base = np.zeros(1)
        while len(slopes) > 1 and (slopes[0] == 0.0).all():
            base = base + 2.0 * lengths.pop(0)
            slopes.pop(0)
        return Polygon(base, tuple(lengths), tuple(slopes), wall)
