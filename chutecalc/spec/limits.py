"""The limits of findings: one key each, with its unit, its default, what it limits, and where it comes from."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, NamedTuple

import numpy as np
from pydantic import Field

from chutecalc.fields.plausible import Plausible
from chutecalc.fields.quantity import Number, Quantity, in_si
from chutecalc.fields.rules import is_numeric
from chutecalc.fields.table import Table, Violation
from chutecalc.fields.units import TEXT, first_unit, from_si
from chutecalc.physics.arrays import Array

NONE = np.array([np.inf])
"""A limit that nothing exceeds, shape (1,)."""
PRACTICE, MODEL = "rule of thumb", "chutecalc"
"""Sources: the practice of the field, and what this model neglects."""

_ANY, _NONE = "limits nothing", "is as good as none"
_RATIO = Plausible(1e-6, 0.01, 20.0, 100.0, "next to nothing", "as large as a percentage", _NONE, _ANY)
_STEEP = Plausible(0.0, 1.0, 90.0, 90.0, "no angle to speak of", "steeper than vertical", too_large=_ANY)
_FAST = Plausible(1e-6, 0.1, 15.0, 1e4, "hardly a motion", "faster than a belt", _NONE, _ANY)
_HARD = Plausible(1e-6, 0.05, 500.0, 1e6, "hardly a load", "more than a belt bears", _NONE, _ANY)
_OFF = Plausible(1e-6, 0.01, 20.0, 1e4, "next to nothing", "wider than a belt", _NONE, _ANY)
_ABOVE = Plausible(
    0.0, 0.005, 10.0, 100.0, "next to nothing", "higher than a chute", too_large="is more than any chute keeps"
)
Share = Annotated[Number, Quantity("number", _RATIO)]
Angle = Annotated[Number, Quantity("angle", _STEEP, zero=True)]
Speed = Annotated[Number, Quantity("velocity", _FAST)]
Pressure = Annotated[Number, Quantity("pressure", _HARD)]
Offset = Annotated[Number, Quantity("length", _OFF)]
Gap = Annotated[Number, Quantity("length", _ABOVE, zero=True)]


def _limit(default: float | None, meaning: str, source: str, finding: str) -> Any:
    """Declare a limit: its default in the unit of the key, None for none."""
    return Field(default, description=meaning, json_schema_extra={"x-source": source, "x-finding": finding})


def ratio_range(table: dict[str, Any]) -> Iterator[Violation]:
    """Yield a violation where the least velocity ratio is not below the largest.

    Args:
        table: of the limits, with documented keys.
    """
    low, high = (table.get(key, LIMITS[key].default or 0.0) for key in ("min_velocity_ratio", "max_velocity_ratio"))
    if is_numeric(low) and is_numeric(high) and np.any(np.greater_equal(low, high)):
        key = "min_velocity_ratio" if "min_velocity_ratio" in table else "max_velocity_ratio"
        yield Violation((key,), "leaves no velocity ratio between the two limits", "give a range, such as 0.9 to 1.1")


class Limits(Table):
    """Where findings begin; each key is optional."""

    max_impact_angle_deg: Angle = _limit(
        20.0, "angle between stream and surface at an impact", PRACTICE, "steep_impact"
    )
    min_velocity_margin: Share = _limit(
        1.25, "velocity on a straight over the critical velocity", MODEL, "decelerating"
    )
    min_cut_off_margin_deg: Angle = _limit(
        5.0, "slope at the end of the last spoon above the equivalent friction angle", PRACTICE, "below_cut_off"
    )
    max_depth_over_width: Share = _limit(1.0, "depth over the width of the stream", "Roberts (2003)", "thick_stream")
    max_depth_over_radius: Share = _limit(0.1, "depth over the radius of the surface", MODEL, "thick_stream")
    min_froude: Share = _limit(2.0, "Froude number", MODEL, "slow_stream")
    max_missing_load: Share = _limit(
        0.10, "share of the weight that hydrostatic wall pressures do not carry", "Paper, section 5", "missing_load"
    )
    max_fill: Share = _limit(0.6, "depth over the height of the walls of an open section", PRACTICE, "overfull")
    max_closed_fill: Share = _limit(0.4, "flow area over the area of a closed section", PRACTICE, "overfull")
    min_width_over_lump: Share = _limit(3.0, "width of the section over the largest lump", PRACTICE, "narrow_for_lumps")
    min_depth_over_lump: Share = _limit(1.0, "depth over the largest lump", MODEL, "fine_stream")
    max_standing_share: Share = _limit(
        0.5, "share of a segment that does not clear after a stop; below it a note", MODEL, "will_not_clear"
    )
    max_belt_fill: Share = _limit(1.0, "load of the feeding belt over its full load", "ISO 5048", "belt_overfull")
    min_velocity_ratio: Share = _limit(0.9, "velocity along the receiving belt over the belt's", PRACTICE, "off_speed")
    max_velocity_ratio: Share = _limit(1.1, "velocity along the receiving belt over the belt's", PRACTICE, "off_speed")
    max_velocity_into_m_s: Speed = _limit(2.5, "velocity into the receiving belt", PRACTICE, "hard_landing")
    max_belt_impact_kpa: Pressure = _limit(
        None, "impact pressure on the receiving belt; none by default", "the belt's rating", "hard_landing"
    )
    max_landing_offset_m: Offset = _limit(
        None,
        "distance between where the stream lands and at_m of the receiving belt; none by default",
        "the loading point",
        "far_landing",
    )
    min_belt_clearance_m: Gap = _limit(
        0.0, "distance of the steel above the receiving belt, normal to it", "the belt's surface", "steel_on_belt"
    )

    rules: ClassVar = (ratio_range,)

    def in_order(self) -> tuple[Array, ...]:
        """Return the limits in the order of :data:`LIMITS`, in SI units and rad; infinite where there is none."""
        given = ((getattr(self, key), limit.dimension) for key, limit in LIMITS.items())
        return tuple(NONE if value is None else in_si(value, dimension) for value, dimension in given)


class Limit(NamedTuple):
    """What is declared of a limit."""

    number: int
    """Its place among the limits of a design."""
    key: str
    dimension: str
    default: float | None
    """In the unit of the key; None where nothing is limited by default."""
    meaning: str
    source: str
    finding: str
    """Code of the finding that it begins."""

    @property
    def text(self) -> str:
        """The default with its unit, as people write it."""
        return self.shown(self.default)

    def shown(self, value: float | None) -> str:
        """Return a limit with its unit, as people write it.

        Args:
            value: in the unit of the key; None for no limit.

        >>> LIMITS["max_velocity_into_m_s"].shown(3.0)
        '3 m/s'
        """
        if value is None:
            return "none"
        unit = first_unit(self.dimension)
        return f"{value:g}" + ("°" if unit == "deg" else f" {TEXT.get(unit, unit)}".rstrip())

    def of(self, limits: tuple[Array, ...]) -> Array:
        """Return the limit in force, in the unit of its key.

        Args:
            limits: of a design, in SI units, in the order of :data:`LIMITS`, each of shape (1,) or (designs,).

        >>> LIMITS["max_velocity_into_m_s"].of(Limits().in_order()).tolist()
        [2.5]
        """
        value: Array = from_si(limits[self.number], self.dimension)
        return value


def _declared() -> Iterator[Limit]:
    """Yield what the fields of the table say."""
    for number, (key, field) in enumerate(Limits.model_fields.items()):
        more: Any = field.json_schema_extra
        yield Limit(
            number,
            key,
            Limits.quantities()[key].dimension,
            field.default,
            field.description or "",
            more["x-source"],
            more["x-finding"],
        )


LIMITS = {limit.key: limit for limit in _declared()}
"""All limits by their keys."""
