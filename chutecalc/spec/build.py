"""Turns a checked spec into numbers: SI units, names resolved, drawn slopes from segment to segment."""

import numpy as np

from chutecalc.design import VERTICAL, Belt, Design, Receiver, Segment
from chutecalc.fields.faults import GeometryFaults
from chutecalc.fields.quantity import in_si, optional
from chutecalc.physics.arrays import Array, shared
from chutecalc.physics.head_pulley import discharge
from chutecalc.physics.pressure import vertical_pressure_ratio
from chutecalc.physics.wall import Wall, constant_wall, yield_locus
from chutecalc.segments.base import Context, Lining
from chutecalc.spec import chute_spec as model
from chutecalc.spec.entry import check_entry, check_reach
from chutecalc.spec.segment_names import segment_names


def build(spec: model.ChuteSpec, drawing: Design | None = None) -> Design:
    """Return the numeric description of a chute.

    Args:
        spec: the checked spec; its numbers may be arrays of length 1 or n.
        drawing: the chute at its design point, where another stream enters than for which its segments are drawn.

    Raises:
        GeometryError: All faults of geometry.
    """
    geometry = _Geometry(spec, drawing)
    design = geometry.design()
    geometry.faults.raise_any()
    return design


class _Geometry:
    """One pass through the spec, which collects faults of geometry."""

    def __init__(self, spec: model.ChuteSpec, drawing: Design | None) -> None:
        self.spec, self.drawing, self.faults = spec, drawing, GeometryFaults()

    def design(self) -> Design:
        """Return the design; it is of no use if there are faults."""
        material, flow = self.spec.material, self.spec.flow
        friction = optional(material.internal_friction_deg, "angle")
        if material.pressure_ratio is not None:
            ratio = in_si(material.pressure_ratio, "number")
        else:
            assert friction is not None  # the material's own rule
            ratio = vertical_pressure_ratio(friction)
        velocity, slope, position, belt = self.inlet()
        drawn = (velocity, slope) if self.drawing is None else (self.drawing.inlet_velocity, self.drawing.inlet_slope)
        segments = self.segments(*drawn)
        check_reach(self.spec, self.faults)
        check_entry(self.spec, velocity, segments[0], self.faults)
        return Design(
            mass_rate=in_si(flow.rate_t_h, "mass rate"),
            density=in_si(material.density_kg_m3, "density"),
            lump=optional(material.lump_m, "length"),
            gravity=in_si(flow.gravity_m_s2, "acceleration"),
            internal_friction=friction,
            vertical_ratio=ratio,
            momentum_factor=in_si(self.spec.model.momentum_factor, "number"),
            longitudinal_ratio=in_si(self.spec.model.longitudinal_pressure_ratio, "number"),
            equilibrium=self.spec.model.friction_law == "equilibrium",
            inlet_position=position,
            inlet_velocity=velocity,
            inlet_slope=slope,
            belt=belt,
            receiver=self.receiver(),
            limits=self.spec.limits.in_order(),
            segments=segments,
        )

    def inlet(self) -> tuple[Array, Array, tuple[Array, Array], Belt | None]:
        """Return velocity, slope and position of the stream where it enters, and the belt that it comes from."""
        inlet = self.spec.inlet
        x, z = (in_si(item, "length") for item in inlet.at_m)
        if inlet.belt is None:
            return in_si(inlet.velocity_m_s, "velocity"), in_si(inlet.slope_deg, "angle"), (x, z), None
        flow = self.spec.flow
        volume_rate = in_si(flow.rate_t_h, "mass rate") / in_si(self.spec.material.density_kg_m3, "density")
        belt = inlet.belt.build((x, z), volume_rate, self.faults)
        leaves = discharge(
            velocity=belt.velocity,
            incline=belt.incline,
            belt_radius=belt.lower_radius,
            radius=belt.middle_radius,
            gravity=in_si(flow.gravity_m_s2, "acceleration"),
            friction=belt.friction,
        )
        return leaves.velocity, leaves.slope, (x + leaves.x, z + leaves.z), belt

    def receiver(self) -> Receiver | None:
        """Return the receiving belt, or None."""
        belt = self.spec.receiver
        if belt is None:
            return None
        return Receiver(
            velocity=in_si(belt.velocity_m_s, "velocity"),
            slope=in_si(belt.slope_deg, "angle"),
            friction=np.tan(in_si(belt.friction_deg, "angle")),
            plan_angle=in_si(belt.plan_angle_deg, "angle"),
            at=None if belt.at_m is None else (in_si(belt.at_m[0], "length"), in_si(belt.at_m[1], "length")),
        )

    def segments(self, velocity: Array, inlet_slope: Array) -> tuple[Segment, ...]:
        """Return the segments, each with the slopes at which it is drawn.

        Args:
            velocity: of the stream where it enters at the design point, m/s.
            inlet_slope: of the stream there, rad below horizontal.
        """
        tables = self.spec.segments
        sections = {
            name: section.build(("sections", name), self.faults) for name, section in self.spec.sections.items()
        }
        linings = {name: self.lining(liner) for name, liner in self.spec.liners.items()}
        slope: Array | None = shared(np.where(velocity == 0.0, VERTICAL, inlet_slope))  # a stream at rest falls
        falling = bool(np.all(slope == np.pi / 2))  # straight down, and past nothing yet that it may not follow
        names = segment_names([(table.name, table.kind) for table in tables])
        built: list[Segment] = []
        for number, (name, table) in enumerate(zip(names, tables, strict=True)):
            flies = number > 0 and not tables[number - 1].guides and not falling
            context = Context(
                location=("segments", number),
                name=name,
                slope=slope,
                tangent=None if flies else slope,
                sections=self.spec.sections,
                drawn_sections=sections,
                linings=linings,
                faults=self.faults,
            )
            built.append(table.build(context))
            slope, falling = built[-1].drawn_end(slope), falling and not table.guides
        return tuple(built)

    def lining(self, liner: model.Liner) -> Lining:
        """Return a liner in numbers.

        Args:
            liner: its table of the spec.
        """
        wall, measured = self.wall(liner)
        return Lining(
            wall=wall,
            measured=measured,
            own_material=bool(liner.own_material),
            slip_ratio=in_si(liner.slip_ratio, "number"),
            thickness=optional(liner.thickness_m, "length"),
            wear_rate=optional(liner.wear_mm3_per_j, "wear rate"),
        )

    def wall(self, liner: model.Liner) -> tuple[Wall, tuple[Array, Array] | None]:
        """Return the friction law of a liner, and the least and greatest normal stress at which it was measured, Pa.

        Args:
            liner: its table of the spec.
        """
        if liner.friction_deg is not None:
            return constant_wall(np.tan(in_si(liner.friction_deg, "angle"))), None
        strength, rows = np.sin(in_si(self.spec.material.internal_friction_deg, "angle")), liner.yield_locus_kpa
        if rows is None:
            return constant_wall(strength), None
        normal, shear = (
            np.stack(np.broadcast_arrays(*(in_si(item, "pressure") for item in column)))
            for column in zip(*rows, strict=True)
        )
        measured = in_si(rows[0][0], "pressure"), in_si(rows[-1][0], "pressure")
        return yield_locus(normal, shear, strength), measured
