"""Quantities and names that several tables of a spec declare."""

from typing import Annotated, Any

from pydantic import Field

from chutecalc.fields.plausible import Plausible
from chutecalc.fields.quantity import Number, Quantity

LONG = Plausible(0.01, 300.0, "shorter than a finger is wide", "longer than any chute")
WIDE = Plausible(0.02, 10.0, "narrower than a finger", "wider than any chute")
THICK = Plausible(0.001, 2.0, "thinner than a coin", "thicker than any belt or load on it")
FAR = Plausible(1e-6, 1000.0, "too little to measure", "further than any chute reaches")
CONVEYS = Plausible(0.01, 15.0, "slower than any belt", "faster than any belt")
INCLINES = Plausible(0.1, 60.0, "level to the eye", "steeper than any belt")
STEEP = Plausible(1.0, 90.0, "level to the eye", "steeper than vertical")
ROUGH = Plausible(3.0, 60.0, "as slippery as ice", "more than any wall or belt has", coefficient=True)
STRONG = Plausible(10.0, 75.0, "less than any bulk material has", "more than any bulk material has", coefficient=True)

Length = Annotated[Number, Quantity("length", gt=0, le=1e5, plausible=LONG)]
Width = Annotated[Number, Quantity("length", gt=0, le=1e5, plausible=WIDE)]
"""A measure of a cross-section or of a pulley."""
Base = Annotated[Number, Quantity("length", ge=0, le=1e5, plausible=WIDE)]
"""A width that may be 0."""
Depth = Annotated[Number, Quantity("length", ge=0, le=1e5, plausible=THICK)]
"""A thickness that may be 0."""
Position = Annotated[Any, Quantity("length", ge=-1e5, le=1e5, shape=(2,), plausible=FAR)]
"""A point of the chute's side view, x and z."""
Slope = Annotated[Number, Quantity("angle", gt=-90, le=90, plausible=STEEP)]
BeltVelocity = Annotated[Number, Quantity("velocity", gt=0, le=1e4, plausible=CONVEYS)]
BeltSlope = Annotated[Number, Quantity("angle", gt=-90, lt=90, plausible=INCLINES)]
FrictionAngle = Annotated[Number, Quantity("angle", ge=0, lt=90, plausible=ROUGH)]
"""An angle of friction on a wall or a belt."""
InternalFrictionAngle = Annotated[Number, Quantity("angle", ge=0, lt=90, plausible=STRONG)]
LONGEST_NAME = 32
"""Characters of a name at most, so that tables of names and numbers fit into 80."""
Name = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_-]*$", max_length=LONGEST_NAME)]
