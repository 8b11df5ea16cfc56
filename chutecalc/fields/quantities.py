"""Quantities and names that several tables of a spec declare."""

from typing import Annotated, Any

from pydantic import Field

from chutecalc.core.fall import LONGEST_FALL
from chutecalc.fields.plausible import Plausible
from chutecalc.fields.quantity import Number, Quantity

LONG = Plausible(
    *(0.001, 0.01, 300.0, LONGEST_FALL),
    *("shorter than a finger is wide", "longer than any chute"),
    *("is no longer than a grain", "is longer than any chute or ore pass"),
)
WIDE = Plausible(
    *(0.001, 0.02, 10.0, 100.0),
    *("narrower than a finger", "wider than any chute"),
    *("lets hardly a grain pass", "is wider than a whole plant"),
)
THICK = Plausible(
    *(1e-5, 0.001, 2.0, 20.0),
    *("thinner than a coin", "thicker than any belt or load on it"),
    *("is thinner than paint", "is higher than a house"),
)
FAR = Plausible(
    *(0.0, 1e-6, 1000.0, 10_000.0),
    *("too little to measure", "further than any chute reaches"),
    too_large="lies outside of any plant",
)
CONVEYS = Plausible(
    *(0.001, 0.01, 15.0, 100.0),
    *("slower than any belt", "faster than any belt"),
    *("hardly moves", "would throw its load away"),
)
INCLINES = Plausible(
    *(0.0, 0.1, 60.0, 85.0),
    *("level to the eye", "steeper than any belt"),
    too_large="is so nearly upright that no belt holds a load there",
)
STEEP = Plausible(0.0, 1.0, 90.0, 90.0, "level to the eye", "steeper than vertical")
RISES = STEEP._replace(least=0.1, too_small="is as good as level")
ROUGH = Plausible(
    *(0.0, 3.0, 60.0, 85.0),
    *("as slippery as ice", "more than any wall or belt has"),
    too_large="holds whatever lies on it, so that nothing slides",
    coefficient=True,
)
STRONG = Plausible(
    *(0.0, 10.0, 75.0, 89.0),
    *("less than any bulk material has", "more than any bulk material has"),
    too_large="is solid, and does not flow",
    coefficient=True,
)

Length = Annotated[Number, Quantity("length", LONG)]
Width = Annotated[Number, Quantity("length", WIDE)]
"""A measure of a cross-section or of a pulley."""
Base = Annotated[Number, Quantity("length", WIDE, zero=True)]
"""A width that may be 0."""
Depth = Annotated[Number, Quantity("length", THICK, zero=True)]
"""A thickness that may be 0."""
Position = Annotated[Any, Quantity("length", FAR, ge=-FAR.most, shape=(2,))]
"""A point of the chute's side view, x and z."""
Slope = Annotated[Number, Quantity("angle", STEEP, gt=-90)]
BeltVelocity = Annotated[Number, Quantity("velocity", CONVEYS)]
BeltSlope = Annotated[Number, Quantity("angle", INCLINES, ge=-INCLINES.most)]
Rise = Annotated[Number, Quantity("angle", RISES)]
"""An angle of a wall of a cross-section from the plane of its centre."""
FrictionAngle = Annotated[Number, Quantity("angle", ROUGH, zero=True)]
"""An angle of friction on a wall or a belt."""
InternalFrictionAngle = Annotated[Number, Quantity("angle", STRONG, zero=True)]
LONGEST_NAME = 32
"""Characters of a name at most, so that tables of names and numbers fit into 80."""
Name = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_-]*$", max_length=LONGEST_NAME)]
