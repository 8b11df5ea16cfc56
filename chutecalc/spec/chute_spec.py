"""The spec as pydantic models: bounds, meaning and units in one place, for checks, schema and docs."""

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from chutecalc.fields.quantities import Depth, FrictionAngle, Length, Name, Position, Slope
from chutecalc.fields.quantity import Number, Quantity
from chutecalc.fields.rules import one_of
from chutecalc.fields.table import Table
from chutecalc.sections.registry import SHAPES, AnySection
from chutecalc.segments.registry import KINDS, AnySegment
from chutecalc.spec.rules import known_format, known_strength, locus_rows, names, one_inlet, placement, some_friction


class Flow(Table):
    """How much flows."""

    rate_t_h: Annotated[Number, Quantity("mass rate", gt=0, le=1e9)] = Field(description="mass rate of the stream")
    gravity_m_s2: Annotated[Number, Quantity("acceleration", gt=0, le=1e4)] = Field(9.80665, description="gravity")


class Material(Table):
    """What flows."""

    name: str | None = Field(None, description="for people")
    density_kg_m3: Annotated[Number, Quantity("density", gt=0, le=1e5)] = Field(
        description="bulk density in the stream"
    )
    internal_friction_deg: FrictionAngle = Field(None, description="effective angle of internal friction, δ")
    pressure_ratio: Annotated[Number, Quantity("number", gt=0, le=1)] = Field(
        None, description="K_v, pressure on a vertical wall over that on the centre section, instead of what δ gives"
    )
    rules: ClassVar = (some_friction,)


class Liner(Table):
    """What the stream slides on."""

    friction_deg: FrictionAngle = Field(None, description="wall friction angle")
    yield_locus_kpa: Annotated[Any, Quantity("pressure", ge=0, le=1e6, shape=(None, 2))] = Field(
        None, description="measured instead: rows of normal and shear stress; beyond them the end slopes go on"
    )
    own_material: Literal[True] | None = Field(
        None, description="instead: the material slides on itself, as in a rock box"
    )
    slip_ratio: Annotated[Number, Quantity("number", gt=0, le=1)] = Field(
        1.0, description="slip velocity at the wall over mean velocity, for wear"
    )
    rules: ClassVar = (one_of("friction_deg", "yield_locus_kpa", "own_material"), locus_rows)


class Belt(Table):
    """The belt that the stream comes from."""

    velocity_m_s: Annotated[Number, Quantity("velocity", gt=0, le=1e4)] = Field(description="of the belt")
    incline_deg: Annotated[Number, Quantity("angle", gt=-90, lt=90)] = Field(0.0, description="positive uphill")
    pulley_radius_m: Length = Field(description="of the head pulley")
    belt_thickness_m: Depth = Field(0.0, description="of the belt")
    material_depth_m: Depth = Field(0.0, description="of the stream on it; its middle is followed")


class Inlet(Table):
    """How the stream enters."""

    velocity_m_s: Annotated[Number, Quantity("velocity", ge=0, le=1e4)] = Field(
        None, description="of the stream, along slope_deg"
    )
    slope_deg: Slope = Field(None, description="of the stream below horizontal; 90 falls straight down")
    belt: Belt | None = Field(None, description="instead: the belt that it comes from")
    at_m: Position = Field([0.0, 0.0], description="x and z of where it enters, or of the pulley's centre")
    rules: ClassVar = (one_inlet,)


class Receiver(Table):
    """The belt that the stream goes to."""

    velocity_m_s: Annotated[Number, Quantity("velocity", gt=0, le=1e4)] = Field(description="of the belt")
    slope_deg: Annotated[Number, Quantity("angle", gt=-90, lt=90)] = Field(0.0, description="of the belt, downhill")
    friction_deg: FrictionAngle = Field(description="of the material on the belt")


class Model(Table):
    """Which model is used."""

    friction_law: Literal["paper", "equilibrium"] = Field(
        "paper",
        description="load that hydrostatic wall pressures do not carry is laid on the centre section (paper), or all"
        " wall pressures are scaled until they carry it (equilibrium)",
    )


class ChuteSpec(Table):
    """A chute."""

    format: Literal[1] = Field(1, description="of this file")
    title: str | None = Field(None, description="for people")
    flow: Flow
    material: Material
    liners: dict[Name, Liner] = Field(min_length=1, description="by name")
    sections: dict[Name, AnySection] = Field(min_length=1, description="by name")
    inlet: Inlet
    model: Model = Field(Model(), description="optional")
    receiver: Receiver | None = Field(None, description="optional")
    segments: list[AnySegment] = Field(min_length=1, description="in the order in which the stream meets them")
    rules: ClassVar = (known_format, names, placement, known_strength)
    choices: ClassVar = {"kind": tuple(KINDS), "shape": tuple(SHAPES)}
