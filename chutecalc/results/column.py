"""A column of a table: its name, its unit, and how people read its numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from chutecalc.fields.units import TEXT, convert, unit_of

if TYPE_CHECKING:
    from chutecalc.physics.arrays import Array


class Units(StrEnum):
    """Units of what people read. Data files are always in SI units and degrees."""

    METRIC = "metric"
    US = "us"


@dataclass(frozen=True, eq=False)
class Column:
    """A quantity, and how people read it."""

    name: str
    """Name in CSV and JSON and from Python, with its unit."""
    heading: str
    """Heading in tables."""
    symbol: str
    """Symbol of docs/nomenclature.md; empty where there is none."""
    meaning: str
    dimension: str = ""
    """Dimension; empty for text, ``number`` for what has no unit."""
    unit: str = ""
    """Unit as specs spell it, such as ``m_s``; empty for text and for numbers without a unit."""
    digits: int = 3
    """Decimals in tables."""
    us_unit: str = ""
    """Unit for people in the United States; empty where that is the same."""
    us_digits: int = 1
    source: str = ""
    """Publication that defines it, with the equation; empty where it follows from the model."""
    equation: str = ""
    """How it follows, in the symbols of docs/nomenclature.md; empty where the meaning says it."""
    page: str = ""
    """Heading of docs/physics.md that derives it, as its links name it."""

    def shown(self, value: float, units: str) -> str:
        """Format a number for tables.

        Args:
            value: in the column's own unit.
            units: ``metric`` or ``us``.

        Returns:
            The number without its unit; empty for NaN, ∞ where it grows without bound.

        >>> column = Column("depth_m", "depth", "H", "flow depth", "length", "m", 4, "in", 2)
        >>> column.shown(0.0254, "us"), column.shown(float("nan"), "metric")
        ('1.00', '')
        """
        if value != value:
            return ""
        if math.isinf(value):
            return "∞" if value > 0 else "-∞"
        if units == Units.US and self.us_unit:
            return f"{convert(value, self.dimension, self.unit, self.us_unit):z.{self.us_digits}f}"
        return f"{value:z.{self.digits}f}"

    def converted(self, values: Any, units: str) -> Any:
        """Convert numbers to the unit of :meth:`unit_text`.

        Args:
            values: numbers or arrays in the column's own unit.
            units: ``metric`` or ``us``.

        >>> column = Column("velocity_m_s", "velocity", "v", "mean velocity", "velocity", "m_s", 3, "fpm", 1)
        >>> round(column.converted(1.5, "us"), 1)
        295.3
        """
        if units == Units.US and self.us_unit:
            return convert(values, self.dimension, self.unit, self.us_unit)
        return values

    def label(self, units: str) -> str:
        """Return the label of an axis: name, symbol and unit.

        Args:
            units: ``metric`` or ``us``.

        >>> Column("velocity_m_s", "velocity", "v", "mean velocity", "velocity", "m_s", 3, "fpm", 1).label("us")
        'velocity v, fpm'
        >>> Column("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4).label("metric")
        'equivalent friction μ_e'
        """
        return ", ".join(part for part in (f"{self.words} {self.symbol}".strip(), self.unit_text(units)) if part)

    @property
    def words(self) -> str:
        """Name in words: the heading, or the first part of the meaning where the heading is a symbol."""
        return self.heading if self.heading != self.symbol else re.split("[;,:]", self.meaning)[0]

    def unit_text(self, units: str) -> str:
        """Return the unit of :meth:`shown` as people write it.

        Args:
            units: ``metric`` or ``us``.
        """
        unit = self.us_unit if units == Units.US and self.us_unit else self.unit
        return TEXT.get(unit, unit)


@dataclass(frozen=True, eq=False, kw_only=True)
class FormulaColumn(Column):
    """A column with the formula of its values."""

    formula: Callable[..., Array]


_US_UNITS = {
    "m": ("length", "ft"),
    "m2": ("area", "ft2"),
    "m3": ("volume", "ft3"),
    "m_s": ("velocity", "fpm"),
    "kpa": ("pressure", "psf"),
    "n": ("force", "lbf"),
}
"""Units that messages convert to US units, by their dimension."""


def quantity_text(name: str, value: float, units: str, us_unit: str = "") -> str:
    """Format a number of a message with its unit.

    Args:
        name: of the number; it ends in the unit, as ``depth_m``.
        value: in that unit.
        units: ``metric`` or ``us``.
        us_unit: unit in the United States; the usual one for its dimension if empty.

    >>> quantity_text("critical_velocity_m_s", 1.5, "metric"), quantity_text("depth_m", 0.3048, "us", "in")
    ('1.5 m/s', '12 in')
    """
    unit = unit_of(name)
    if units == Units.US and unit in _US_UNITS:
        dimension, usual = _US_UNITS[unit]
        value, unit = convert(value, dimension, unit, us_unit or usual), us_unit or usual
    shown = TEXT.get(unit, unit)
    return f"{value:z.4g}".replace("inf", "∞") + ("°" if unit == "deg" else f" {shown}" if shown else "")
