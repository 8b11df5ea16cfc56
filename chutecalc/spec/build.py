"""A checked spec as numbers: names resolved, units in SI, slopes along the chain, and the faults of geometry."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from chutecalc.design import Belt, Contact, Design, Fall, Receiver, Segment
from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.quantity import in_si
from chutecalc.physics.arrays import Array, shared
from chutecalc.physics.belt import discharge
from chutecalc.physics.motion import FLOOR, ROOF
from chutecalc.physics.pressure import vertical_pressure_ratio
from chutecalc.physics.section import Section
from chutecalc.physics.wall import Wall, constant_wall, yield_locus
from chutecalc.spec import chute_spec as model
from chutecalc.spec.sections import build_section, section_names

LONGEST = 1e5  # m, as of every length
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
    geometry.faults.check()
    return design


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
    return None if length is None else in_si(length, "length")


class _Geometry:
    """One pass along the spec; collects faults on its way."""

    def __init__(self, spec: model.ChuteSpec, drawn_slopes: Mapping[int, Array]) -> None:
        self.spec, self.drawn_slopes = spec, drawn_slopes
        self.faults = GeometryFaults()

    def design(self) -> Design:
        """The design; of no use where there are faults."""
        material, flow = self.spec.material, self.spec.flow
        friction = None if material.internal_friction_deg is None else in_si(material.internal_friction_deg, "angle")
        if material.pressure_ratio is not None:
            ratio = in_si(material.pressure_ratio, "number")
        else:
            assert friction is not None  # the material's own rule
            ratio = vertical_pressure_ratio(friction)
        velocity, slope, position, belt = self.inlet()
        return Design(
            mass_rate=in_si(flow.rate_t_h, "mass rate"),
            density=in_si(material.density_kg_m3, "density"),
            gravity=in_si(flow.gravity_m_s2, "acceleration"),
            internal_friction=friction,
            vertical_ratio=ratio,
            equilibrium=self.spec.model.friction_law == "equilibrium",
            inlet_position=position,
            inlet_velocity=velocity,
            inlet_slope=slope,
            belt=belt,
            receiver=self.receiver(),
            segments=self.segments(velocity, slope),
        )

    def inlet(self) -> tuple[Array, Array, tuple[Array, Array], Belt | None]:
        """Velocity, slope and position of the stream where it enters, and the belt it comes from."""
        inlet = self.spec.inlet
        x, z = (in_si(item, "length") for item in inlet.at_m)
        if inlet.belt is None:
            return in_si(inlet.velocity_m_s, "velocity"), in_si(inlet.slope_deg, "angle"), (x, z), None
        velocity, incline = in_si(inlet.belt.velocity_m_s, "velocity"), in_si(inlet.belt.incline_deg, "angle")
        lower = in_si(inlet.belt.pulley_radius_m, "length") + in_si(inlet.belt.belt_thickness_m, "length")
        middle = lower + 0.5 * in_si(inlet.belt.material_depth_m, "length")
        leaves = discharge(velocity, incline, lower, middle, in_si(self.spec.flow.gravity_m_s2, "acceleration"))
        belt = Belt((x, z), velocity, incline, lower, middle)
        return leaves.velocity, leaves.slope, (x + leaves.x, z + leaves.z), belt

    def receiver(self) -> Receiver | None:
        """The belt below, if there is one."""
        belt = self.spec.receiver
        if belt is None:
            return None
        friction = np.tan(in_si(belt.friction_deg, "angle"))
        return Receiver(in_si(belt.velocity_m_s, "velocity"), in_si(belt.slope_deg, "angle"), friction)

    def segments(self, velocity: Array, inlet_slope: Array) -> tuple[Segment, ...]:
        """The segments, each with the slope at which it is drawn."""
        sections = {name: build_section(name, section, self.faults) for name, section in self.spec.sections.items()}
        walls = {name: self.wall(liner) for name, liner in self.spec.liners.items()}
        if self.spec.segments[0].kind != "fall":
            location, remedy = ("inlet", "velocity_m_s"), "give a velocity, or begin with a fall"
            self.faults.note(
                velocity == 0.0, location, self.spec.inlet.velocity_m_s, "leaves the stream at rest", remedy
            )
        slope: Array | None = shared(np.where(velocity == 0.0, VERTICAL, inlet_slope))  # a stream at rest falls
        falling = bool(np.all(slope == np.pi / 2))  # straight down, and past nothing yet that it may not follow
        built: list[Segment] = []
        for number, (name, segment) in enumerate(zip(segment_names(self.spec), self.spec.segments, strict=True)):
            if isinstance(segment, model.Fall):
                straight_down = np.zeros(1, dtype=bool) if slope is None else slope == np.pi / 2
                if segment.run_m is not None:
                    problem, key = "is never reached: the stream falls straight down", ("segments", number, "run_m")
                    self.faults.note(straight_down, key, segment.run_m, problem, "give drop_m")
                drop, run = _optional(segment.drop_m), _optional(segment.run_m)
                built.append(Fall(name, segment.kind, drop, run))
                slope = VERTICAL if straight_down.all() else None
                continue
            after_fall = number > 0 and isinstance(self.spec.segments[number - 1], model.Fall)
            follows = self.drawn_slopes.get(number, None if after_fall and not falling else slope)
            contact = self.contact(("segments", number), name, segment, follows, sections, walls)
            built.append(contact)
            slope, falling = contact.exit_slope, False
        return tuple(built)

    def contact(
        self,
        location: Location,
        name: str,
        segment: model.Flat | model.Arc,
        slope: Array | None,
        sections: dict[str, Section],
        walls: dict[str, Wall],
    ) -> Contact:
        """A guiding segment that follows a slope; None where that is the stream's."""
        section, end_section = section_names(location, segment, self.spec.sections, self.faults)
        liner = segment.liner or next(iter(self.spec.liners))
        radius: Array | None = None
        length: Array | None = None
        entry: Array | None
        if isinstance(segment, model.Flat):
            entry = exit_ = in_si(segment.slope_deg, "angle")
            length = self.straight_length(location, segment, exit_)
        else:
            radius = in_si(segment.radius_m, "length")
            exit_ = in_si(segment.to_slope_deg, "angle")
            entry = slope if segment.from_slope_deg is None else in_si(segment.from_slope_deg, "angle")
            self.check_turn(location, segment, entry, exit_)
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
            else (in_si(segment.start_m[0], "length"), in_si(segment.start_m[1], "length")),
            section=sections[section],
            end_section=None if end_section is None else sections[end_section],
            wall=walls[liner],
            measured=self.measured(self.spec.liners[liner]),
            slip_ratio=in_si(self.spec.liners[liner].slip_ratio, "number"),
        )

    def measured(self, liner: model.Liner) -> tuple[Array, Array] | None:
        """The range of normal stress that a locus was measured in."""
        rows = liner.yield_locus_kpa
        return None if rows is None else (in_si(rows[0][0], "pressure"), in_si(rows[-1][0], "pressure"))

    def wall(self, liner: model.Liner) -> Wall:
        """The friction law of a liner."""
        if liner.friction_deg is not None:
            return constant_wall(np.tan(in_si(liner.friction_deg, "angle")))
        strength = np.sin(in_si(self.spec.material.internal_friction_deg, "angle"))
        if liner.yield_locus_kpa is None:
            return constant_wall(strength)
        columns = zip(*liner.yield_locus_kpa, strict=True)
        normal, shear = (
            np.stack(np.broadcast_arrays(*(in_si(item, "pressure") for item in column))) for column in columns
        )
        return yield_locus(normal, shear, strength)

    def straight_length(self, location: Location, segment: model.Flat, slope: Array) -> Array:
        """Length of a flat segment, from whichever of its three measures is given."""
        length = self._flat_length(location, segment, slope)
        key = "drop_m" if segment.drop_m is not None else "run_m"
        problem = f"makes the segment {float(length.max()):.3g} m long: more than {LONGEST:g} m"
        self.faults.note(length > LONGEST, (*location, key), getattr(segment, key), problem, "change it, or the slope")
        return np.minimum(length, LONGEST)

    def _flat_length(self, location: Location, segment: model.Flat, slope: Array) -> Array:
        """The same, however long."""
        if segment.length_m is not None:
            return in_si(segment.length_m, "length")
        if segment.drop_m is not None:
            problem = "gives a level segment no length"
            self.faults.note(slope == 0.0, (*location, "drop_m"), segment.drop_m, problem, "give length_m or run_m")
            return in_si(segment.drop_m, "length") / np.where(slope != 0.0, np.abs(np.sin(slope)), 1.0)
        problem = "gives a vertical segment no length"
        self.faults.note(slope == np.pi / 2, (*location, "run_m"), segment.run_m, problem, "give length_m or drop_m")
        return in_si(segment.run_m, "length") / np.where(slope != np.pi / 2, np.cos(slope), 1.0)

    def check_turn(self, location: Location, segment: model.Arc, entry: Array | None, exit_: Array) -> None:
        """A hood has to steepen, a curve to turn; what begins tangent to a falling stream is known only when solved."""
        if entry is None:
            return
        hood = segment.kind == "hood"
        wrong = exit_ <= entry if hood else exit_ == entry
        if wrong.any():
            start = f"{np.degrees(entry.flat[0]):.6g}°"
            problem = f"leaves the curve no length: it begins at {start}"
            remedy = "give another slope"
            if hood:
                problem = (
                    f"has to be steeper than where the hood begins, {start}: only a roof that steepens guides a stream"
                )
                remedy = "give a steeper slope, or make it a curve"
            self.faults.note(wrong, (*location, "to_slope_deg"), segment.to_slope_deg, problem, remedy)
