"""A column of a table: its name, its unit, and how people read its numbers."""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from chutecalc.fields.units import TEXT, convert
from chutecalc.physics.arrays import Array

Numbers = dict[str, Array]
"""Arrays by column name."""


@dataclass(frozen=True)
class Column:
    """A quantity, and how people read it."""

    name: str
    """In CSV and JSON and from Python, with its unit."""
    heading: str
    symbol: str
    meaning: str
    dimension: str = ""
    """Empty for text; ``number`` for what has no unit."""
    unit: str = ""
    digits: int = 3
    """Decimals that people are shown."""
    us_unit: str = ""
    us_digits: int = 1

    def shown(self, value: float, units: str) -> str:
        """A number as people are shown it; nothing where it does not exist.

        >>> column = Column("depth_m", "depth", "H", "flow depth", "length", "m", 4, "in", 2)
        >>> column.shown(0.0254, "us"), column.shown(float("nan"), "metric")
        ('1.00', '')
        """
        if value != value:
            return ""
        if math.isinf(value):
            return "∞" if value > 0 else "-∞"
        if units == "us" and self.us_unit:
            return f"{convert(value, self.dimension, self.unit, self.us_unit):.{self.us_digits}f}"
        return f"{value:.{self.digits}f}"

    def converted(self, values: Any, units: str) -> Any:
        """Numbers in the unit of :meth:`unit_text`.

        >>> column = Column("velocity_m_s", "velocity", "v", "mean velocity", "velocity", "m_s", 3, "fpm", 1)
        >>> round(column.converted(1.5, "us"), 1)
        295.3
        """
        return convert(values, self.dimension, self.unit, self.us_unit) if units == "us" and self.us_unit else values

    def label(self, units: str) -> str:
        """As an axis is labelled: what it is, its symbol and its unit.

        >>> Column("velocity_m_s", "velocity", "v", "mean velocity", "velocity", "m_s", 3, "fpm", 1).label("us")
        'velocity v, fpm'
        >>> Column("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4).label("metric")
        'equivalent friction μ_e'
        """
        named = self.heading if self.heading != self.symbol else re.split("[;,:]", self.meaning)[0]
        return ", ".join(part for part in (f"{named} {self.symbol}".strip(), self.unit_text(units)) if part)

    def unit_text(self, units: str) -> str:
        """The unit that goes with :meth:`shown`."""
        unit = self.us_unit if units == "us" and self.us_unit else self.unit
        return TEXT.get(unit, unit)


@dataclass(frozen=True, kw_only=True)
class FormulaColumn(Column):
    """A column with the formula of its values."""

    formula: Callable[..., Array]


_PEOPLE = {"m": ("length", "ft"), "m_s": ("velocity", "fpm"), "kpa": ("pressure", "psf")}
"""Units that messages change for people in the United States."""
_INCHES = ("depth_m", "chamfer_m", "wall_height_m")


def quantity_text(name: str, value: float, units: str) -> str:
    """A number of a message with its unit, told from the end of its name.

    >>> quantity_text("critical_velocity_m_s", 1.5, "metric"), quantity_text("depth_m", 0.3048, "us")
    ('1.5 m/s', '12 in')
    """
    known = sorted((unit for unit in (*TEXT, "m", "s") if name.endswith(f"_{unit}")), key=len)
    unit = known[-1] if known else ""
    if units == "us" and unit in _PEOPLE:
        dimension, other = ("length", "in") if name in _INCHES else _PEOPLE[unit]
        value, unit = convert(value, dimension, unit, other), other
    shown = TEXT.get(unit, unit)
    return f"{value:.4g}".replace("inf", "∞") + ("°" if unit == "deg" else f" {shown}" if shown else "")
