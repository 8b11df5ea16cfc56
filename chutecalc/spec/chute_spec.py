"""The spec as pydantic models: bounds, meanings and units in one place, for checks, schema and docs."""

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from chutecalc.fields.quantities import (
    BeltSlope,
    BeltVelocity,
    FrictionAngle,
    InternalFrictionAngle,
    Name,
    Position,
    Slope,
)
from chutecalc.fields.quantity import Number, Quantity
from chutecalc.fields.rules import one_of
from chutecalc.fields.table import Table
from chutecalc.sections.registry import SHAPES, AnySection
from chutecalc.segments.registry import KINDS, AnySegment
from chutecalc.spec.inlet_belt import Belt
from chutecalc.spec.limits import Limits
from chutecalc.spec.operating import case_keys
from chutecalc.spec.rules import known_format, known_strength, locus_rows, names, one_inlet, placement, some_friction
from chutecalc.spec.sizes import COARSE, DENSE, FLOWS, LINES, PRESSES, RATIO, RUNS, SHEARED, TURNS, WEARS, WEIGHS

Density = Annotated[Number, Quantity("density", DENSE)]


class Flow(Table):
    """How much material flows."""

    rate_t_h: Annotated[Number, Quantity("mass rate", FLOWS)] = Field(description="mass rate of the stream")
    gravity_m_s2: Annotated[Number, Quantity("acceleration", WEIGHS)] = Field(
        9.80665, description="gravitational acceleration"
    )


USE = "name of the entry of the library that gives the keys which are not given here"
SOURCE = "where the numbers come from, such as a test report"


class Material(Table):
    """The bulk material."""

    use: str | None = Field(None, description=USE)
    name: str | None = Field(None, description="name of the material, shown in reports")
    density_kg_m3: Density = Field(description="bulk density in the stream")
    internal_friction_deg: InternalFrictionAngle = Field(None, description="effective angle of internal friction, δ")
    lump_m: Annotated[Number, Quantity("length", COARSE)] = Field(None, description="size of the largest lump")
    pressure_ratio: Annotated[Number, Quantity("number", RATIO)] = Field(
        None, description="K_v, pressure on a vertical wall over that on the centre section; without it δ sets K_v"
    )
    source: str | None = Field(None, description=SOURCE)
    rules: ClassVar = (some_friction,)


class Liner(Table):
    """A wall that the stream slides on: one of a friction angle, a yield locus and the material itself."""

    use: str | None = Field(None, description=USE)
    name: str | None = Field(None, description="name of the liner, for people")
    friction_deg: FrictionAngle = Field(None, description="wall friction angle")
    yield_locus_kpa: Annotated[Any, Quantity("pressure", PRESSES, zero=True, shape=(None, 2))] = Field(
        None,
        description="measured wall yield locus, rows of normal and shear stress; extrapolated with its end slopes",
    )
    own_material: Literal[True] | None = Field(
        None, description="true for material that slides on itself, as in a rock box"
    )
    slip_ratio: Annotated[Number, Quantity("number", RATIO)] = Field(
        1.0, description="slip velocity at the wall over mean velocity, for wear"
    )
    thickness_m: Annotated[Number, Quantity("length", LINES)] = Field(
        None, description="thickness that may wear away, for the life of the liner"
    )
    wear_mm3_per_j: Annotated[Number, Quantity("wear rate", WEARS)] = Field(
        None, description="volume lost per frictional work, measured with the material, for the life of the liner"
    )
    source: str | None = Field(None, description=SOURCE)
    rules: ClassVar = (one_of("friction_deg", "yield_locus_kpa", "own_material"), locus_rows)


class Inlet(Table):
    """How the stream enters: with a velocity and a slope, or from a belt."""

    velocity_m_s: Annotated[Number, Quantity("velocity", RUNS, zero=True)] = Field(
        None, description="velocity of the stream, along slope_deg"
    )
    slope_deg: Slope = Field(None, description="slope of the stream below horizontal; 90 falls straight down")
    belt: Belt | None = Field(None, description="belt that the stream comes from, instead of velocity and slope")
    at_m: Position = Field(
        [0.0, 0.0], description="x and z of the point where the stream enters, or of the pulley's centre"
    )
    rules: ClassVar = (one_inlet,)


class Receiver(Table):
    """The belt that the stream goes to."""

    velocity_m_s: BeltVelocity = Field(description="velocity of the belt")
    slope_deg: BeltSlope = Field(0.0, description="slope of the belt, positive downhill")
    friction_deg: FrictionAngle = Field(description="friction angle of the material on the belt")
    at_m: Position = Field(
        None, description="x and z of a point of its surface; where the last segment ends if not given"
    )
    plan_angle_deg: Annotated[Number, Quantity("angle", TURNS, ge=-180)] = Field(
        0.0, description="angle between the headings of stream and belt, seen from above"
    )


class Model(Table):
    """Variants of the model."""

    friction_law: Literal["paper", "equilibrium"] = Field(
        "paper",
        description="paper: the centre section bears the load that hydrostatic wall pressures do not; equilibrium: all"
        " wall pressures are scaled until they bear it",
    )
    steel: Literal["fixed", "follows_stream"] = Field(
        "fixed",
        description="fixed: the chute is drawn at the spec as written and stands still while operating keys vary;"
        " follows_stream: what is placed by the stream moves with it",
    )
    momentum_factor: Annotated[Number, Quantity("number", SHEARED)] = Field(
        1.0,
        description="α_m, momentum of the stream over that of its mean velocity: 1 for a uniform profile, 1.25 for one"
        " sheared over its whole depth on a rough bed (Bagnold), 1.33 for a linear one",
    )
    longitudinal_pressure_ratio: Annotated[Number, Quantity("number", RATIO._replace(least=1e-6), zero=True)] = Field(
        0.0,
        description="K_l, pressure along the stream over that normal to the centre section, between K_v and 1; 0"
        " neglects it, as the paper does",
    )


class Project(Table):
    """What the title block of a report says; any text, also of several lines."""

    client: str | None = Field(None, description="who the chute is for")
    project: str | None = Field(None, description="name of the project")
    number: str | None = Field(None, description="number of the document")
    revision: str | None = Field(None, description="revision of the document")
    prepared: str | None = Field(None, description="who prepared it")
    checked: str | None = Field(None, description="who checked it")
    date: str | None = Field(None, description="date of the document, as it is to be printed")
    notes: str | None = Field(None, description="what else is to stand in the title block")


class ChuteSpec(Table):
    """A chute."""

    format: Literal[1] = Field(1, description="version of the file format")
    title: str | None = Field(None, description="title of reports and plots")
    project: Project = Field(Project(), description="title block of reports, optional")
    flow: Flow
    material: Material
    liners: dict[Name, Liner] = Field(min_length=1, description="liners by name")
    sections: dict[Name, AnySection] = Field(min_length=1, description="cross-sections by name")
    inlet: Inlet
    model: Model = Field(Model(), description="variant of the model, optional")
    receiver: Receiver | None = Field(None, description="belt that the stream goes to, optional")
    limits: Limits = Field(Limits(), description="limits of findings, optional")
    segments: list[AnySegment] = Field(min_length=1, description="segments in the order in which the stream meets them")
    cases: dict[Name, dict[str, Any]] = Field(
        {}, description="operating states that the same steel has to serve, by name: key paths with their values"
    )
    uncertainty: dict[str, Any] = Field(
        {}, description="how uncertain numbers are: key paths with plus/minus or a distribution, and their correlation"
    )
    rules: ClassVar = (known_format, names, placement, known_strength, case_keys)
    hints: ClassVar = dict.fromkeys(("spoon", "crest"), "use curve: a spoon or crest is a curve")
    choices: ClassVar = {"kind": tuple(KINDS), "shape": tuple(SHAPES)}
