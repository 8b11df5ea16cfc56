"""The belt that the stream comes from: its keys, their rules, and its numbers."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import Field

from chutecalc import design
from chutecalc.fields.faults import GeometryFaults, Location
from chutecalc.fields.plausible import Plausible
from chutecalc.fields.quantities import INCLINES, BeltSlope, BeltVelocity, Depth, FrictionAngle, Width
from chutecalc.fields.quantity import Number, Quantity, in_si
from chutecalc.fields.table import Table, Violation
from chutecalc.physics.arrays import Array
from chutecalc.physics.troughed_belt import BeltLoad, belt_load, usable_width

_BELTS = Plausible(
    *(0.1, 0.2, 4.0, 20.0),
    *("narrower than any belt", "wider than any belt"),
    *("is a toy", "is wider than any pulley"),
)
LOCATION: Location = ("inlet", "belt")
LoadAngle = Annotated[Number, Quantity("angle", INCLINES, zero=True)]


def loaded_belt(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield faults of a belt's load: keys that go with its width, and a depth beside it.

    Args:
        table: of the belt, with documented keys.
    """
    wide = "width_m" in table
    for key in ("roll_m", "trough_deg", "surcharge_deg"):
        if key in table and not wide:
            yield Violation((key,), "is only for a belt with width_m", "add width_m, or remove this key")
    for key, remedy in (
        ("trough_deg", "add it; 0 is a flat belt"),
        ("surcharge_deg", "add the surcharge angle of the material on the belt"),
    ):
        if wide and key not in table:
            yield Violation((key,), "is missing, and needed with width_m", remedy, is_missing=True)
    if wide and "material_depth_m" in table:
        problem = "follows from width_m and the rate"
        yield Violation(("material_depth_m",), problem, "remove it, or remove width_m and what goes with it")


class Belt(Table):
    """The belt that the stream comes from."""

    velocity_m_s: BeltVelocity = Field(description="velocity of the belt")
    incline_deg: BeltSlope = Field(0.0, description="incline of the belt, positive uphill")
    pulley_radius_m: Width = Field(description="radius of the head pulley")
    belt_thickness_m: Depth = Field(0.0, description="thickness of the belt")
    material_depth_m: Depth = Field(
        None, description="depth of the stream on the belt, 0 if not given; the path is that of its middle"
    )
    width_m: Annotated[Number, Quantity("length", _BELTS)] = Field(
        None, description="width of the belt; the depth of the stream then follows from the rate"
    )
    roll_m: Width = Field(
        None, description="length of the middle one of three rolls; a third of the width and 10 mm if not given"
    )
    trough_deg: LoadAngle = Field(None, description="trough angle of the side rolls; 0 is a flat belt")
    surcharge_deg: LoadAngle = Field(None, description="surcharge angle of the material on the running belt")
    friction_deg: FrictionAngle = Field(
        None, description="friction angle of the material on the belt; a stream carried round the pulley slides on it"
    )
    rules: ClassVar = (loaded_belt,)

    def build(self, centre: tuple[Array, Array], volume_rate: Array, faults: GeometryFaults) -> design.Belt:
        """Return the belt in numbers.

        Args:
            centre: x and z of the centre of its head pulley, m.
            volume_rate: of the stream, m³/s.
            faults: collects faults of its geometry.
        """
        load = self._load(volume_rate, faults)
        given = in_si(0.0 if self.material_depth_m is None else self.material_depth_m, "length")
        depth = given if load is None else load.depth
        lower = in_si(self.pulley_radius_m, "length") + in_si(self.belt_thickness_m, "length")
        return design.Belt(
            centre=centre,
            velocity=in_si(self.velocity_m_s, "velocity"),
            incline=in_si(self.incline_deg, "angle"),
            lower_radius=lower,
            middle_radius=lower + 0.5 * depth,
            friction=None if self.friction_deg is None else in_si(self.friction_deg, "angle"),
            load=load,
        )

    def _load(self, volume_rate: Array, faults: GeometryFaults) -> BeltLoad | None:
        """Return the load on a belt whose width is given, or None."""
        if self.width_m is None:
            return None
        width, velocity = in_si(self.width_m, "length"), in_si(self.velocity_m_s, "velocity")
        trough, surcharge = in_si(self.trough_deg, "angle"), in_si(self.surcharge_deg, "angle")
        roll = width / 3.0 + 0.01 if self.roll_m is None else in_si(self.roll_m, "length")
        problem, remedy = "is not shorter than the belt is wide", "give a shorter roll, or a wider belt"
        faults.note(roll >= width, (*LOCATION, "roll_m"), self.roll_m, problem, remedy)
        on_roll = roll >= usable_width(width)  # no load gets to the side rolls
        level = (surcharge == 0.0) & ((trough == 0.0) | on_roll)
        problem, remedy = "leaves no load on a flat belt", "give a surcharge angle above 0, or a trough"
        faults.note(level, (*LOCATION, "surcharge_deg"), self.surcharge_deg, problem, remedy)
        with np.errstate(divide="ignore", invalid="ignore"):  # of those without a load
            return belt_load(volume_rate, velocity, width, roll, trough, surcharge)
