"""Quantities and names that several tables of a spec declare."""

from typing import Annotated, Any

from pydantic import Field

from chutecalc.fields.quantity import Number, Quantity

Length = Annotated[Number, Quantity("length", gt=0, le=1e5)]
Depth = Annotated[Number, Quantity("length", ge=0, le=1e5)]
"""A length that may be 0."""
Position = Annotated[Any, Quantity("length", ge=-1e5, le=1e5, shape=(2,))]
"""A point of the chute's side view, x and z."""
Slope = Annotated[Number, Quantity("angle", gt=-90, le=90)]
BeltVelocity = Annotated[Number, Quantity("velocity", gt=0, le=1e4)]
BeltSlope = Annotated[Number, Quantity("angle", gt=-90, lt=90)]
FrictionAngle = Annotated[Number, Quantity("angle", ge=0, lt=90)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z_][A-Za-z0-9_-]*$")]
