"""The spec as pydantic models: bounds, meaning and units in one place, for checks, schema and docs."""

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from chutecalc.fields.quantity import Number, Quantity
from chutecalc.fields.table import Table
from chutecalc.spec.rules import (
    GUIDED,
    downhill,
    known_format,
    known_strength,
    locus_rows,
    names,
    one_inlet,
    one_of,
    placement,
    some_friction,
)

Length = Annotated[Number, Quantity("length", gt=0, le=1e5)]
Depth = Annotated[Number, Quantity("length", ge=0, le=1e5)]
Slope = Annotated[Number, Quantity("angle", gt=-90, le=90)]
FrictionAngle = Annotated[Number, Quantity("angle", ge=0, lt=90)]
ChamferAngle = Annotated[Number, Quantity("angle", gt=0, le=90)]
NAMED = "how paths, tables and findings call it; its kind without it"
Name = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_-]*$")]


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


class Section(Table):
    """A cross-section."""

    wall_height_m: Length = Field(None, description="of the walls above the floor; deeper than that chokes")


class Rectangular(Section):
    """A rectangle."""

    shape: Literal["rectangular"]
    width_m: Length = Field(description="between the walls")


class Chamfered(Section):
    """A centre section between two chamfers."""

    shape: Literal["chamfered"]
    base_m: Depth = Field(description="width of the centre section")
    chamfer_deg: ChamferAngle = Field(description="angle of the chamfers from the plane of the centre section")
    chamfer_m: Length = Field(None, description="length of a chamfer; vertical walls above it; no top without it")


class Vee(Section):
    """Two flanks that meet."""

    shape: Literal["vee"]
    chamfer_deg: ChamferAngle = Field(description="angle of the flanks from the horizontal plane of the section")
    chamfer_m: Length = Field(None, description="length of a flank; vertical walls above it; no top without it")


class Circular(Section):
    """The lower half of a circle, vertical walls above it."""

    shape: Literal["circular"]
    radius_m: Length = Field(description="of the circle")


class Facet(Table):
    """A flat wall."""

    length_m: Length = Field(description="along the section")
    slope_deg: Annotated[Number, Quantity("angle", ge=0, le=90)] = Field(description="from the plane of the section")


class Faceted(Section):
    """Flat walls one above the other."""

    shape: Literal["facets"]
    facets: list[Facet] = Field(
        min_length=1, description="of one side, from the centre outwards, none flatter than the one before"
    )


AnySection = Annotated[Rectangular | Chamfered | Vee | Circular | Faceted, Field(discriminator="shape")]


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
    at_m: Annotated[Any, Quantity("length", ge=-1e5, le=1e5, shape=(2,))] = Field(
        [0.0, 0.0], description="x and z of where it enters, or of the pulley's centre"
    )
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


class Guided(Table):
    """A segment that guides the stream."""

    name: Name | None = Field(None, description=NAMED)
    section: str | Annotated[list[str], Field(min_length=2, max_length=2)] | None = Field(
        None, description="its cross-section, or that at its start and at its end; not needed where there is one only"
    )
    liner: str | None = Field(None, description="its liner; not needed where there is one only")
    start_m: Annotated[Any, Quantity("length", ge=-1e5, le=1e5, shape=(2,))] = Field(
        None, description="x and z of where it is drawn from, after a fall that goes onto_next"
    )


class Flat(Guided):
    """A straight, which is an inclined floor, or a plate, which is a flat roof that is struck and left."""

    kind: Literal["straight", "plate"]
    slope_deg: Slope = Field(description="below horizontal; of a straight from 0 on")
    length_m: Length = Field(None, description="along it")
    drop_m: Length = Field(None, description="its height, instead of its length")
    run_m: Length = Field(None, description="its horizontal length, instead of its length")
    rules: ClassVar = (one_of("length_m", "drop_m", "run_m"), downhill)


class Arc(Guided):
    """A curve, which is a floor (a spoon where it flattens, a crest where it steepens), or a hood, which is a roof."""

    kind: Literal["curve", "hood"]
    radius_m: Length = Field(description="of the guiding surface")
    to_slope_deg: Slope = Field(description="slope at its end, below horizontal; a hood has to steepen")
    from_slope_deg: Slope = Field(None, description="slope at its start; tangent to the flow without it")


class Fall(Table):
    """Free flight."""

    kind: Literal["fall"]
    name: Name | None = Field(None, description=NAMED)
    drop_m: Length = Field(None, description="from the drawn end of the segment before it, or the inlet, to its own")
    run_m: Length = Field(None, description="its horizontal length, instead of its height")
    onto_next: Literal[True] | None = Field(
        None, description="instead: to where it meets the next segment, which has start_m"
    )
    rules: ClassVar = (one_of("drop_m", "run_m", "onto_next"),)


AnySegment = Annotated[Flat | Arc | Fall, Field(discriminator="kind")]


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
    choices: ClassVar = {
        "kind": (*GUIDED, "fall"),
        "shape": ("rectangular", "chamfered", "vee", "circular", "facets"),
    }
