"""The one catalogue of columns: what tables, CSV, JSON and plots call a quantity, and how people read it."""

import math
import re
from typing import Any, NamedTuple

from chutecalc.fields.units import TEXT, convert


class Column(NamedTuple):
    """A quantity along the stream."""

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

        >>> COLUMNS["depth_m"].shown(0.0254, "us"), COLUMNS["depth_m"].shown(float("nan"), "metric")
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

        >>> round(COLUMNS["velocity_m_s"].converted(1.5, "us"), 1)
        295.3
        """
        return convert(values, self.dimension, self.unit, self.us_unit) if units == "us" and self.us_unit else values

    def label(self, units: str) -> str:
        """As an axis is labelled: what it is, its symbol and its unit.

        >>> COLUMNS["velocity_m_s"].label("us"), COLUMNS["equivalent_friction"].label("metric")
        ('velocity v, fpm', 'equivalent friction μ_e')
        """
        named = self.heading if self.heading != self.symbol else re.split("[;,:]", self.meaning)[0]
        return ", ".join(part for part in (f"{named} {self.symbol}".strip(), self.unit_text(units)) if part)

    def unit_text(self, units: str) -> str:
        """The unit that goes with :meth:`shown`."""
        unit = self.us_unit if units == "us" and self.us_unit else self.unit
        return TEXT.get(unit, unit)


COLUMNS = {
    column.name: column
    for column in (
        Column("spec", "spec", "", "the spec's file"),
        Column("segment", "segment", "", "name of the segment; NAME:flight for a flight that leads to it"),
        Column("kind", "kind", "", "kind of the segment; flight"),
        Column("s_m", "s", "s", "distance from the inlet along the stream", "length", "m", 3, "ft", 2),
        Column(
            "x_m",
            "x",
            "x",
            "horizontal position along the chute; the inlet is at 0 unless at_m places it",
            "length",
            "m",
            3,
            "ft",
            2,
        ),
        Column("z_m", "z", "z", "height, likewise", "length", "m", 3, "ft", 2),
        Column("slope_deg", "slope", "a", "slope of the stream below horizontal", "angle", "deg", 2, "", 2),
        Column("velocity_m_s", "velocity", "v", "mean velocity of the stream", "velocity", "m_s", 3, "fpm", 1),
        Column("depth_m", "depth", "H", "flow depth normal to the centre section", "length", "m", 4, "in", 2),
        Column("chamfer_wetted_m", "chamfer", "C", "wetted length of one chamfer", "length", "m", 4, "in", 2),
        Column("area_m2", "area", "A", "flow area", "area", "m2", 5, "ft2", 4),
        Column("equivalent_friction", "μ_e", "μ_e", "equivalent friction", "number", "", 4),
        Column(
            "normal_acceleration_m_s2",
            "n",
            "n",
            "acceleration that presses the stream on its surface",
            "acceleration",
            "m_s2",
            2,
            "ft_s2",
            1,
        ),
        Column(
            "pressure_kpa",
            "pressure",
            "p",
            "on the centre section; in a vee, on the flanks at their foot; on a plate, of the impact",
            "pressure",
            "kpa",
            3,
            "psf",
            1,
        ),
        Column("wear_w_m2", "wear", "", "friction power per area there", "power", "w_m2", 1),
        Column("froude", "Fr", "Fr", "Froude number v/√(n A/b_s), b_s the free surface's width", "number", "", 2),
        Column("time_s", "time", "t", "since the inlet", "time", "s", 3),
        Column("chamfer_pressure_kpa", "p chamfer", "", "greatest on the chamfers", "pressure", "kpa", 3, "psf", 1),
        Column("chamfer_wear_w_m2", "wear chamfer", "", "friction power per area there", "power", "w_m2", 1),
        Column(
            "side_pressure_kpa", "p side", "", "greatest on the vertical side walls", "pressure", "kpa", 3, "psf", 1
        ),
        Column("side_wear_w_m2", "wear side", "", "friction power per area there", "power", "w_m2", 1),
        Column("wear_number", "N_WR", "N_WR", "n/g on an arc, Roberts' wear number", "number", "", 3),
    )
}
"""Station columns in the order of the CSV."""

FRICTION_COLUMNS = {
    column.name: column
    for column in (
        Column("chamfer_deg", "β", "β", "chamfer angle", "angle", "deg", 1),
        Column("internal_friction_deg", "δ", "δ", "effective angle of internal friction", "angle", "deg", 1),
        Column("base_m", "base", "B", "width of the centre section", "length", "m", 4, "in", 2),
        COLUMNS["chamfer_wetted_m"],
        COLUMNS["depth_m"],
        Column("pressure_ratio", "K", "K", "pressure on a chamfer over that on the centre section", "number", "", 4),
        COLUMNS["equivalent_friction"]._replace(digits=5),
        Column("status", "status", "", "ok, or impossible: a section that cannot be"),
    )
}
"""Columns of the friction study, in the order of the CSV."""

WAYS = {"exit": "at the end of the chute", "max": "largest on guiding surfaces", "min": "least on guiding surfaces"}
"""What a sweep's rows tell of a station column, by the first word of their names."""
RECEIVER_COLUMNS = {
    column.name: column
    for column in (
        Column("velocity_along_m_s", "along belt", "", "velocity along the belt", "velocity", "m_s", 3, "fpm", 1),
        Column("velocity_across_m_s", "onto belt", "", "velocity onto the belt", "velocity", "m_s", 3, "fpm", 1),
        Column("velocity_ratio", "belt ratio", "", "velocity along the belt over the belt's", "number", "", 4),
        Column("impact_pressure_kpa", "belt impact", "", "impact pressure on the belt", "pressure", "kpa", 3, "psf", 1),
        Column("wear_w_m2", "belt wear", "", "friction power per area of the belt", "power", "w_m2", 1),
        Column("acceleration_length_m", "belt slip", "", "length in which it accelerates", "length", "m", 3, "ft", 2),
        Column("acceleration_power_kw", "belt power", "", "power that accelerates it", "power", "kw", 3),
        Column("landed_velocity_m_s", "landed", "", "along it, impact's friction in", "velocity", "m_s", 3, "fpm", 1),
        Column("landed_acceleration_length_m", "landed slip", "", "accelerates from then", "length", "m", 3, "ft", 2),
        Column("matching_slope_deg", "matching slope", "", "exit slope with the belt's velocity", "angle", "deg", 2),
        Column(
            "matching_velocity_m_s", "matching", "", "exit velocity that would match", "velocity", "m_s", 3, "fpm", 1
        ),
    )
}
"""What a stream does to the belt that it goes to; in a sweep's rows behind ``receiver_``."""
_ALONG_ALONE = ("s_m", "x_m", "z_m", "time_s")


def row_columns() -> dict[str, Column]:
    """What a sweep's rows can tell of a design, by name.

    >>> row_columns()["max_depth_m"].label("metric")
    'max depth H, m'
    """
    found = {
        "status": Column("status", "status", "", "how the design ends; impossible: a section that cannot be"),
        "findings": Column("findings", "findings", "", "codes of the findings, see README"),
        "error_estimate": Column("error_estimate", "error", "", "of the exit velocity, relative", "number", "", 14),
    }
    for way, where in WAYS.items():
        for name, column in COLUMNS.items():
            if column.dimension and (way == "exit" or name not in _ALONG_ALONE):
                symbol = "" if column.heading == column.symbol else column.symbol
                found[f"{way}_{name}"] = column._replace(
                    name=f"{way}_{name}", heading=f"{way} {column.heading}", symbol=symbol, meaning=where
                )
    return found | {
        f"receiver_{name}": column._replace(name=f"receiver_{name}") for name, column in RECEIVER_COLUMNS.items()
    }


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
