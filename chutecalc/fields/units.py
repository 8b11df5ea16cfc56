"""The one table of units: the endings of keys, and how their values convert.

Each dimension lists its units; the first is the one that the spec format documents and that models hold. A factor is a
pair of numbers, so that 3000 mm are exactly 3 m.
"""

import math
from typing import Any

UNITS: dict[str, dict[str, tuple[float, float]]] = {
    "length": {"m": (1, 1), "mm": (1, 1000), "in": (127, 5000), "ft": (381, 1250)},
    "angle": {"deg": (1, 1), "rad": (180, math.pi)},
    "mass rate": {"t_h": (1, 1), "kg_s": (18, 5), "stph": (45359237, 50000000)},
    "density": {"kg_m3": (1, 1), "t_m3": (1000, 1), "lb_ft3": (0.45359237, 0.028316846592)},
    "velocity": {"m_s": (1, 1), "fpm": (127, 25000), "ft_s": (381, 1250)},
    "acceleration": {"m_s2": (1, 1), "ft_s2": (381, 1250)},
    "pressure": {"kpa": (1, 1), "pa": (1, 1000), "psf": (0.45359237 * 9.80665, 0.09290304 * 1000)},
    "area": {"m2": (1, 1), "ft2": (0.09290304, 1)},
    "force": {"n": (1, 1), "lbf": (0.45359237 * 9.80665, 1)},
    "volume": {"m3": (1, 1), "ft3": (0.028316846592, 1)},
    "wear rate": {"mm3_per_j": (1, 1), "m3_per_j": (1000000000, 1)},
    "number": {"": (1, 1)},
}
"""Dimension to unit suffix to (numerator, denominator) of one such unit in the first unit."""

TEXT = {
    "deg": "°",
    "t_h": "t/h",
    "kg_s": "kg/s",
    "kg_m3": "kg/m³",
    "t_m3": "t/m³",
    "lb_ft3": "lb/ft³",
    "m_s": "m/s",
    "ft_s": "ft/s",
    "m_s2": "m/s²",
    "ft_s2": "ft/s²",
    "kpa": "kPa",
    "pa": "Pa",
    "mm3_per_j": "mm³/J",
    "m3_per_j": "m³/J",
    "m2": "m²",
    "ft2": "ft²",
    "w_m2": "W/m²",
    "kw": "kW",
    "n": "N",
    "h": "h",
    "m3": "m³",
    "ft3": "ft³",
}
"""Unit suffix as people write it; suffixes that are not listed are written as they stand."""

LARGEST_INTEGER = 10**300  # Python's integers know no bounds, floats do

_SI = {"mass rate": (5, 18), "pressure": (1000, 1), "angle": (math.pi, 180), "wear rate": (1, 1000000000)}
"""One of a dimension's first unit in SI, where that is another."""


def convert(value: Any, dimension: str, source: str, target: str) -> Any:
    """Convert a number or array from one unit of a dimension to another.

    Args:
        value: in the unit ``source``.
        dimension: one of :data:`UNITS`.
        source, target: suffixes of its units.

    Returns:
        The value in the unit ``target``; the same object where that is ``source``.

    >>> convert(3000.0, "length", "mm", "m"), convert(1.0, "velocity", "fpm", "m_s")
    (3.0, 0.00508)
    """
    if source == target:
        return value
    (up, down), (target_up, target_down) = UNITS[dimension][source], UNITS[dimension][target]
    if isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        value = math.inf if value > 0 else -math.inf
    return value * (up * target_down) / (down * target_up)


def to_si(value: Any, dimension: str) -> Any:
    """Convert a number or array from a dimension's first unit to SI (angles to rad).

    Args:
        value: in the dimension's first unit.
        dimension: one of :data:`UNITS`.

    >>> to_si(3.6, "mass rate"), to_si(180.0, "angle") == math.pi
    (1.0, True)
    """
    up, down = _SI.get(dimension, (1, 1))
    return value * up / down


def from_si(value: Any, dimension: str) -> Any:
    """Convert a number or array from SI (angles in rad) to a dimension's first unit.

    Args:
        value: in SI units.
        dimension: one of :data:`UNITS`.

    >>> from_si(1.0, "mass rate"), from_si(math.pi, "angle") == 180.0
    (3.6, True)
    """
    up, down = _SI.get(dimension, (1, 1))
    return value * down / up


def first_unit(dimension: str) -> str:
    """Return the suffix of the unit in which tables of a spec hold a dimension.

    Args:
        dimension: one of :data:`UNITS`.

    >>> first_unit("pressure")
    'kpa'
    """
    return next(iter(UNITS[dimension]))


def unit_keys(key: str, dimension: str) -> dict[str, str]:
    """Return the keys that name a field in each unit of its dimension, the documented one first.

    Args:
        key: the documented one, which ends in the dimension's first unit.
        dimension: one of :data:`UNITS`.

    Returns:
        Key to suffix of its unit.

    >>> unit_keys("radius_m", "length")
    {'radius_m': 'm', 'radius_mm': 'mm', 'radius_in': 'in', 'radius_ft': 'ft'}
    """
    stem = key.removesuffix(first_unit(dimension))
    return {stem + unit: unit for unit in UNITS[dimension]}


def same_quantity(key: str) -> list[str]:
    """Return a key in all units of its dimension, which is read from its ending.

    Args:
        key: in any unit; one that ends in no unit stands alone.

    >>> same_quantity("slope_rad"), same_quantity("name")
    (['slope_deg', 'slope_rad'], ['name'])
    """
    endings = [
        (unit, dimension) for dimension, units in UNITS.items() for unit in units if unit and key.endswith(f"_{unit}")
    ]
    if not endings:
        return [key]
    unit, dimension = max(endings, key=lambda ending: len(ending[0]))
    stem = key.removesuffix(unit)
    return [stem + other for other in UNITS[dimension]]


def unit_of(name: str) -> str:
    """Return the unit that a name ends in; empty where it ends in none.

    Args:
        name: of a column or a number.

    >>> unit_of("exit_velocity_m_s"), unit_of("fill")
    ('m_s', '')
    """
    return max((unit for unit in (*TEXT, "m", "s") if name.endswith(f"_{unit}")), key=len, default="")


def with_unit(number: float, unit: str) -> str:
    """Return a number as people write it, with its unit.

    Args:
        number: in that unit.
        unit: its suffix.

    >>> with_unit(90.0, "deg"), with_unit(1e5, "m")
    ('90°', '100,000 m')
    """
    return _plain(number) + ("°" if unit == "deg" else f" {TEXT.get(unit, unit)}".rstrip())


def _plain(number: float) -> str:
    """Return six digits of a number, a large one with separators between thousands."""
    short = f"{number:.6g}"
    return f"{float(short):,.0f}" if abs(number) >= 1e4 else short
