"""How an uncertain number scatters, as a spec says it: plus/minus, a distribution, or the points of a shear test."""

import math
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from chutecalc.api.parameter import Parameter
from chutecalc.fields.units import same_quantity

PLUS_MINUS = "a number for plus/minus"
"""What the short form is called in messages."""
HALF_WIDTH = 1.959963984540054
"""Standard deviations of a normal distribution that hold 95 % of it on both sides of its mean."""
DISTRIBUTIONS = ("normal", "uniform", "triangular", "shear_test")
"""Names that a table may have in place of a number."""
FEWEST_POINTS = 2
"""Points of a shear test below which nothing is known of their scatter."""
STRESSES = 1e-6, 1e9
"""Least and greatest stress of a shear test, whatever its unit."""
LEAST_SLOPE = 2.0
"""Standard errors by which the slope of a shear test is above 0 at least."""
ROUNDING = 1e-9
"""Share by which a number may be off."""


class Scatter(NamedTuple):
    """How a number scatters, in the unit of its key.

    ``normal``: standard deviation about the value of the spec, such that the key takes the 95 % of the values in its
    middle. ``uniform``: least and greatest value. ``triangular``: least, most likely, greatest value. ``shear_test``:
    slope of a line through the origin, standard error of the slope, degrees of freedom, and what a case adds; the key
    is the angle of that slope and that.
    """

    kind: str
    """One of :data:`DISTRIBUTIONS`."""
    numbers: tuple[float, ...]
    """What describes it."""
    text: str
    """What the spec says, for people."""

    @classmethod
    def read(cls, value: Any, parameter: Parameter) -> "Scatter":
        """Return what a value of the table says.

        Args:
            value: as written.
            parameter: the number that scatters.

        Raises:
            ValueError: what is wrong, and what to do.
        """
        if not isinstance(value, dict):
            half = _number(value, "must be a number above 0, or a table with a distribution", "write plus/minus as 2")
            _check_reach(half, parameter)
            return cls("normal", (half / HALF_WIDTH,), f"± {half:g}")
        if len(value) != 1:
            raise ValueError(f"must have one distribution, not {len(value)}", f"use one of {', '.join(DISTRIBUTIONS)}")
        ((kind, given),) = value.items()
        return cls(kind, *_READ[kind](given, parameter))

    def moved(self, by: float, parameter: Parameter) -> "Scatter":
        """Return how the number scatters in a case that gives it another value: alike, about that value.

        Args:
            by: the value of the case less that of the spec, in the unit of the key.
            parameter: the number in the case.

        Raises:
            ValueError: what is wrong there, and what to do.
        """
        if by == 0.0 or self.kind == "normal":  # which is about the value in force
            return self
        if self.kind == "shear_test":
            *line, added = self.numbers
            return Scatter(self.kind, (*line, added + by), f"{self.text}, moved by {by:+g}")
        return Scatter(self.kind, *_READ[self.kind]([number + by for number in self.numbers], parameter))


_Read = tuple[tuple[float, ...], str]


def is_number(value: Any) -> bool:
    """Return whether a value of TOML is a finite number.

    Args:
        value: any value.

    >>> is_number(2), is_number(True), is_number(float("nan"))
    (True, False, False)
    """
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e308


def bounds_of(parameter: Parameter) -> tuple[float, float]:
    """Return the ends of the range of a number of a spec, infinite where there is none; 0 may be taken beside it.

    Args:
        parameter: the number; the values are in the unit of its path.
    """
    bounds = parameter.quantity.range_in(parameter.unit)
    return bounds.get("gt", bounds.get("ge", -math.inf)), bounds.get("lt", bounds.get("le", math.inf))


def _number(value: Any, problem: str, remedy: str) -> float:
    """Return a number above 0."""
    if not is_number(value) or value <= 0:
        raise ValueError(problem, remedy)
    return float(value)


def _normal(given: Any, parameter: Parameter) -> _Read:
    """Read a standard deviation."""
    deviation = _number(given, "normal must be a number above 0", "give the standard deviation")
    _check_reach(HALF_WIDTH * deviation, parameter)
    return (deviation,), f"σ {deviation:g}"


def _check_reach(half: float, parameter: Parameter) -> None:
    """Check that the key takes the value of the spec plus and minus what 95 % of all values lie within.

    Args:
        half: width of that to either side.
        parameter: the number.

    Raises:
        ValueError: it does not: then the distribution is another one than this, and so is its mean.
    """
    (low, high), value = bounds_of(parameter), parameter.value_in_unit
    room = min(value - low, high - value)
    if half > room * (1.0 + ROUNDING):
        most = f"at most {_down(room)} for plus/minus, or " if room > 0.0 else ""
        problem = f"spreads 95 % of the values from {value - half:.6g} to {value + half:.6g}, and they must be"
        raise ValueError(f"{problem} {_allowed(parameter)}", f"use {most}uniform or triangular")


def _down(number: float) -> str:
    """Return a number with four digits, rounded down."""
    step = 10.0 ** (math.floor(math.log10(number)) - 3)
    return f"{math.floor(number / step * (1.0 + ROUNDING)) * step:.4g}"


def _allowed(parameter: Parameter) -> str:
    """Return what a key takes, in words."""
    return parameter.quantity.bounds_text(parameter.unit)


def _ordered(given: Any, names: str, parameter: Parameter) -> tuple[float, ...]:
    """Read values in rising order that the key takes, or comes as close to as one likes."""
    count = len(names.split(", "))
    if not isinstance(given, list) or len(given) != count or not all(map(is_number, given)):
        raise ValueError(f"must be {count} numbers", f"write [{names}]")
    if given[0] >= given[-1] or any(one > other for one, other in pairwise(given)):
        raise ValueError("has numbers that do not rise", f"write [{names}]")
    low, high = bounds_of(parameter)
    if given[0] < low or given[-1] > high:
        ends = f"reaches from {given[0]:g} to {given[-1]:g}"
        raise ValueError(f"{ends}, and values must be {_allowed(parameter)}", "keep its ends within that")
    return tuple(map(float, given))


def _uniform(given: Any, parameter: Parameter) -> _Read:
    """Read the ends of a range."""
    low, high = _ordered(given, "least, greatest", parameter)
    return (low, high), f"{low:g} to {high:g}"


def _triangular(given: Any, parameter: Parameter) -> _Read:
    """Read the ends of a range and the most likely value."""
    low, mode, high = _ordered(given, "least, most likely, greatest", parameter)
    return (low, mode, high), f"{low:g} to {high:g}, most likely {mode:g}"


def _shear_test(given: Any, parameter: Parameter) -> _Read:
    """Read points of a shear test: fit shear = slope * normal by least squares, through the origin.

    The slope is Σ σ τ / Σ σ², and its standard error s / √Σ σ² with s² = Σ (τ - slope σ)² / (N - 1): one number is
    fitted, which leaves N - 1 degrees of freedom.
    """
    if parameter.key not in same_quantity("friction_deg"):
        raise ValueError("is not a friction angle, which is all that a shear test tells", "use another distribution")
    rows, (low, high) = given if isinstance(given, list) else [], STRESSES
    if len(rows) < FEWEST_POINTS or not all(
        isinstance(row, list) and len(row) == 2 and all(is_number(item) and low <= item <= high for item in row)
        for row in rows
    ):
        problem = f"shear_test must be {FEWEST_POINTS} or more rows of a normal and a shear stress, {low:g} to {high:g}"
        raise ValueError(problem, "write [[4, 1.9], [8, 3.7], ...] in kPa")
    normal, shear = np.array(rows, dtype=float).T
    slope = float(normal @ shear / (normal @ normal))
    freedom = len(rows) - 1
    error = math.sqrt(float(np.sum((shear - slope * normal) ** 2)) / freedom / float(normal @ normal))
    if error <= 1e-12 * slope:
        raise ValueError("has points on one line through the origin, which tell no scatter", "give a number instead")
    if slope < LEAST_SLOPE * error:
        problem = f"has points that scatter too much: shear over normal stress is {slope:.3g} ± {error:.1g}"
        raise ValueError(f"{problem}, hardly more than 0", "check them, [normal, shear] each, or measure more")
    return (slope, error, float(freedom), 0.0), f"shear test of {len(rows)} points"


_READ = dict(zip(DISTRIBUTIONS, (_normal, _uniform, _triangular, _shear_test), strict=True))
