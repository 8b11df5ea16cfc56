"""The spec as pydantic models: bounds, meaning and units in one place, for checks, schema and docs."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from chutecalc.spec.quantity import Number, Quantity, Rule, Table

Length = Annotated[Number, Quantity("length", gt=0)]
Depth = Annotated[Number, Quantity("length", ge=0)]
FloorSlope = Annotated[Number, Quantity("angle", ge=0, le=90)]
Slope = Annotated[Number, Quantity("angle", gt=-90, le=90)]
FrictionAngle = Annotated[Number, Quantity("angle", ge=0, lt=90)]
ChamferAngle = Annotated[Number, Quantity("angle", gt=0, le=90)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_-]*$")]


def one_of(*keys: str) -> Any:
    """The rule that exactly one of some keys is given."""

    def rule(table: dict[str, Any]) -> Iterator[Rule]:
        given = [key for key in keys if key in table]
        if len(given) != 1:
            names = ", ".join(keys)
            problem = f"is one too many: give only one of {names}" if given else f"is missing: give one of {names}"
            yield Rule((given[-1] if given else keys[0],), problem, "remove the others" if given else f"add {keys[0]}")

    return rule


def _some_friction(table: dict[str, Any]) -> Iterator[Rule]:
    if "internal_friction_deg" not in table and "pressure_ratio" not in table:
        problem = "internal_friction_deg or pressure_ratio is needed"
        yield Rule(
            ("internal_friction_deg",), problem, "add internal_friction_deg, the effective angle of internal friction"
        )


class Flow(Table):
    """How much flows."""

    rate_t_h: Annotated[Number, Quantity("mass rate", gt=0)] = Field(description="mass rate of the stream")
    gravity_m_s2: Annotated[Number, Quantity("acceleration", gt=0)] = Field(9.80665, description="gravity")


class Material(Table):
    """What flows."""

    name: str | None = Field(None, description="for people")
    density_kg_m3: Annotated[Number, Quantity("density", gt=0)] = Field(description="bulk density in the stream")
    internal_friction_deg: FrictionAngle = Field(None, description="effective angle of internal friction, δ")
    pressure_ratio: Annotated[Number, Quantity("number", gt=0, le=1)] = Field(
        None, description="K_v, pressure on a vertical wall over that on the centre section, instead of what δ gives"
    )
    rules: ClassVar = (_some_friction,)


class Liner(Table):
    """What the stream slides on."""

    friction_deg: FrictionAngle = Field(description="wall friction angle")


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


AnySection = Annotated[Rectangular | Chamfered | Vee, Field(discriminator="shape")]


class Inlet(Table):
    """How the stream enters."""

    velocity_m_s: Annotated[Number, Quantity("velocity", ge=0)] = Field(description="of the stream, along slope_deg")
    slope_deg: Slope = Field(description="of the stream below horizontal; 90 falls straight down")


class Segment(Table):
    """What all segments have."""

    kind: str
    name: Name | None = Field(None, description="how paths, tables and findings call it; its kind without it")


class Guided(Segment):
    """A segment that guides the stream."""

    section: str | None = Field(None, description="its cross-section; not needed where there is one only")
    liner: str | None = Field(None, description="its liner; not needed where there is one only")


class Straight(Guided):
    """An inclined chute."""

    kind: Literal["straight"]
    slope_deg: FloorSlope = Field(description="below horizontal")
    length_m: Length = Field(None, description="along the floor")
    drop_m: Length = Field(None, description="its height, instead of its length")
    run_m: Length = Field(None, description="its horizontal length, instead of its length")
    rules: ClassVar = (one_of("length_m", "drop_m", "run_m"),)


class Arc(Guided):
    """A circular arc."""

    radius_m: Length = Field(description="of the guiding surface")
    to_slope_deg: Slope = Field(description="slope at its end, below horizontal")
    from_slope_deg: Slope = Field(None, description="slope at its start; tangent to the flow without it")


class Curve(Arc):
    """A curved floor: a spoon where it flattens, a crest where it steepens."""

    kind: Literal["curve"]


class Hood(Arc):
    """A curved roof that the stream is pressed under; it has to steepen."""

    kind: Literal["hood"]


class Fall(Segment):
    """Free flight."""

    kind: Literal["fall"]
    drop_m: Length = Field(description="from the end of the segment before it, or from the inlet, down to its own end")


GUIDED = ("straight", "curve", "hood")

AnySegment = Annotated[Straight | Curve | Hood | Fall, Field(discriminator="kind")]


def _names(table: dict[str, Any]) -> Iterator[Rule]:
    """Sections and liners are named where there are several, and defined where they are named; segments are unique."""
    segments = table.get("segments")
    seen: dict[str, int] = {}
    for number, segment in enumerate(segments if isinstance(segments, list) else []):
        if not isinstance(segment, dict):
            continue
        place = ("segments", number)
        name = segment.get("name")
        if isinstance(name, str):
            if name in seen:
                yield Rule((*place, "name"), f"is the name of segment {seen[name]} too", "choose another name")
            seen.setdefault(name, number + 1)
        if segment.get("kind") in GUIDED:
            yield from _reference(table, segment, place, "section", "sections")
            yield from _reference(table, segment, place, "liner", "liners")


def _reference(
    table: dict[str, Any], segment: dict[str, Any], place: tuple[str | int, ...], key: str, kinds: str
) -> Iterator[Rule]:
    """One reference of a segment to the sections or liners."""
    defined, named = table.get(kinds), segment.get(key)
    if not isinstance(defined, dict) or not defined:
        return
    names = ", ".join(defined)
    if named is None and len(defined) > 1:
        yield Rule((*place, key), "is missing, and there are several", f"name one of {names}")
    elif isinstance(named, str) and named not in defined:
        yield Rule((*place, key), f"is not defined in [{kinds}]", f"name one of {names}, or add [{kinds}.{named}]")


class ChuteSpec(Table):
    """A chute."""

    format: Literal[1] = Field(1, description="of this file")
    title: str | None = Field(None, description="for people")
    flow: Flow
    material: Material
    liners: dict[Name, Liner] = Field(min_length=1, description="by name")
    sections: dict[Name, AnySection] = Field(min_length=1, description="by name")
    inlet: Inlet
    segments: list[AnySegment] = Field(min_length=1, description="in the order in which the stream meets them")
    rules: ClassVar = (_names,)
    choices: ClassVar = {"kind": (*GUIDED, "fall"), "shape": ("rectangular", "chamfered", "vee")}
