"""The friction study of the paper, section 6: equivalent friction over the chamfer angle."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Status
from chutecalc.errors import UsageError
from chutecalc.fields.quantities import ROUGH, STRONG, WIDE
from chutecalc.fields.ranges import read_values
from chutecalc.physics.arrays import Array
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.pressure import greatest_wall_friction, pressure_ratio, vertical_pressure_ratio
from chutecalc.physics.section import Polygon
from chutecalc.physics.wetting import wetting

ANGLE_RANGES = {"beta": "0:90:5", "delta": "30:55:5"}
"""Ranges of the chamfer angle β and the angle of internal friction δ in the paper's figures, deg."""
CHAMFERS, INTERNAL_FRICTIONS = (tuple(read_values(name, text).tolist()) for name, text in ANGLE_RANGES.items())
"""The angles β and δ of these ranges, deg."""
WALL_FRICTION, BASE, AREA = 25.0, 0.5, 0.05
"""Wall friction angle of the paper, deg; width, m, and flow area, m². Its text and figures agree with A/B² = 0.2."""
MOST_ANGLES = {"beta": 90.0, "delta": STRONG.most, "phi": ROUGH.most}
"""Largest angles, deg: of a wall upright, and as a spec takes them; widths and areas too are those of a spec."""
MOST_ROWS = 1_000_000
"""Rows of a study, which are all in memory."""
FINE = 10_001
"""Number of angles among which the best one is sought: at most 0.009° apart."""
ROUNDING = 1e-14
"""Share of B² below which a base is rounding: the section is a vee."""
Columns = dict[str, Any]
"""Arrays of one length by column name."""


def _constant_base(base: float, area: float, cotangent: Array) -> Array:
    return np.full(cotangent.shape, base**2)


def _constant_width(base: float, area: float, cotangent: Array) -> Array:
    return base**2 - 4.0 * area * cotangent  # free surface² = B² + 4 A cot β


def _constant_depth(base: float, area: float, cotangent: Array) -> Array:
    left = base - area / base * cotangent  # H = A/W stays, the mean width W too
    return left * np.abs(left)


BASE_SQUARED: dict[str, Callable[[float, float, Array], Array]] = {
    "base": _constant_base,
    "width": _constant_width,
    "depth": _constant_depth,
}
"""The dimension that is constant besides the flow area, with the square of the centre section's width that follows, m².

Negative where there is no such section. Paper, sections 6.1 (Figure 5), 6.2 (Figure 7) and 6.3 (Figure 9).
"""


class Best(NamedTuple):
    """The chamfer angles at which the equivalent friction of a material is least."""

    internal_friction_deg: float
    """Angle of internal friction δ of the material, deg."""
    inside_deg: float
    """Chamfer angle of the lowest local minimum inside the range, deg; NaN where there is none."""
    inside_friction: float
    """Equivalent friction μ_e there, a coefficient."""
    end_deg: float
    """Chamfer angle at the end of the range that has the lower μ_e, deg."""
    end_friction: float
    """Equivalent friction μ_e there, a coefficient."""


class FrictionStudy:
    """Equivalent friction over chamfer angle and internal friction at one flow area, by the paper's law (Paper Eq 11).

    >>> study = FrictionStudy([45.0, 90.0], [30.0, 55.0], keep="base")
    >>> study.columns["equivalent_friction"].round(5).tolist()
    [0.48509, 0.49739, 0.4818, 0.47558]
    """

    def __init__(
        self,
        chamfer_deg: Sequence[float] = CHAMFERS,
        internal_friction_deg: Sequence[float] = INTERNAL_FRICTIONS,
        keep: str = "base",
        wall_friction_deg: float = WALL_FRICTION,
        base_m: float = BASE,
        area_m2: float = AREA,
    ) -> None:
        """Check the arguments and compute the columns.

        Args:
            chamfer_deg: Chamfer angles β, deg, from 0 (a flat plane) to 90 (square corners).
            internal_friction_deg: Angles of internal friction δ, deg, from 0 to 89.
            keep: Dimension that is constant while β varies: ``base`` (width of the centre section), ``width`` (of the
                free surface) or ``depth``.
            wall_friction_deg: Wall friction angle φ, deg, from 0 to 85.
            base_m: Width B between square corners, m, from 0.001 to 100.
            area_m2: Flow area A, m², from 1e-6 to 10,000.

        Raises:
            UsageError: All values that are out of range.
        """
        self.chamfer_deg = np.atleast_1d(np.asarray(chamfer_deg, dtype=np.float64))
        self.internal_friction_deg = np.atleast_1d(np.asarray(internal_friction_deg, dtype=np.float64))
        self.keep, self.wall_friction_deg, self.base_m, self.area_m2 = keep, wall_friction_deg + 0.0, base_m, area_m2
        faults = list(self._faults())
        if faults:
            raise UsageError(*faults)
        beta, delta = np.meshgrid(self.chamfer_deg, self.internal_friction_deg)
        self.columns: Columns = self._columns(beta.ravel(), delta.ravel())
        """Arrays by column name, with a row for each chamfer angle of the first material, then of the next, and so on.

        An impossible section has the status ``impossible`` and NaN. The chamfer's length is NaN at β = 0 too.
        """

    def line(self, internal_friction_deg: float) -> Columns:
        """Return the rows of one material, without impossible sections.

        Args:
            internal_friction_deg: Angle of internal friction δ of the material, deg.

        >>> FrictionStudy([30.0, 60.0], [40.0], keep="width").line(40.0)["chamfer_deg"].tolist()
        [60.0]
        """
        rows = self.columns["internal_friction_deg"] == internal_friction_deg
        rows &= self.columns["status"] == Status.OK_LABEL
        return {name: values[rows] for name, values in self.columns.items()}

    def best(self) -> list[Best]:
        """Find the best chamfer angle of each material among 10,001 from the smallest to the largest of the study.

        >>> (best,) = FrictionStudy(internal_friction_deg=[40.0]).best()
        >>> round(best.inside_deg, 2), best.end_deg
        (75.9, 0.0)
        """
        angles = np.linspace(self.chamfer_deg.min(), self.chamfer_deg.max(), FINE)
        return [self._best(angles, float(delta)) for delta in self.internal_friction_deg]

    def inadmissible(self) -> list[float]:
        """Return the angles of internal friction, deg, at which the wall friction angle is not attainable.

        These are materials with φ > atan(sin δ), which slide on themselves instead (Paper, section 6).

        >>> FrictionStudy(internal_friction_deg=[25.0, 30.0]).inadmissible()
        [25.0]
        """
        steepest = np.degrees(greatest_wall_friction(np.radians(self.internal_friction_deg)))
        return [float(delta) for delta in self.internal_friction_deg[self.wall_friction_deg > steepest]]

    def _faults(self) -> Iterator[str]:
        """Yield a message for each value that is out of range."""
        if self.keep not in BASE_SQUARED:
            yield f"keep must be one of {', '.join(BASE_SQUARED)}, not {self.keep}"
        angles = {
            "beta": self.chamfer_deg,
            "delta": self.internal_friction_deg,
            "phi": np.array([self.wall_friction_deg]),
        }
        for name, values in angles.items():
            fits = (values >= 0.0) & (values <= MOST_ANGLES[name])
            if not fits.all() or not values.size:
                given = f"{values[~fits][0]:g}" if values.size else "nothing"
                yield f"{name} must be from 0 to {MOST_ANGLES[name]:g} degrees, not {given}"
        rows = self.chamfer_deg.size * self.internal_friction_deg.size
        if rows > MOST_ROWS:
            yield f"beta and delta make {rows:,} rows, and at most {MOST_ROWS:,} are allowed: take fewer values"
        for name, value, power, unit in (("base", self.base_m, 1, "m"), ("area", self.area_m2, 2, "m²")):
            least, most = WIDE.least**power, WIDE.most**power
            if not least <= value <= most:
                yield f"{name} must be at least {least:g} and at most {most:g} {unit}, not {value:g}"

    def _columns(self, chamfer_deg: Array, internal_friction_deg: Array) -> Columns:
        """Compute the table with the friction law that chutes are solved with."""
        beta, ratio = np.radians(chamfer_deg), vertical_pressure_ratio(np.radians(internal_friction_deg))
        with np.errstate(all="ignore"):  # β = 0 has neither cotangent nor chamfer
            square = BASE_SQUARED[self.keep](self.base_m, self.area_m2, np.cos(beta) / np.sin(beta))
            square = np.where(np.abs(square) < ROUNDING * self.base_m**2, 0.0, square)  # a vee
            base = np.sqrt(square)
            endless = np.full(1, np.inf)
            section = Polygon(base, lengths=(endless,), inclinations=(beta,), wall_height=endless)
            wet = wetting(section, ratio, np.full(1, self.area_m2))
        flat = (beta == 0.0) & (base > 0.0)  # no depth, and nothing stands against a wall
        possible = flat | np.isfinite(wet.depth)
        friction = equivalent_friction(np.tan(np.radians(self.wall_friction_deg)), np.where(flat, 0.0, wet.excess))
        numbers = {
            "base_m": base,
            "chamfer_wetted_m": wet.chamfer,
            "depth_m": np.where(flat, 0.0, wet.depth),
            "pressure_ratio": pressure_ratio(beta, ratio),
            "equivalent_friction": friction,
        }
        return {
            "chamfer_deg": chamfer_deg,
            "internal_friction_deg": internal_friction_deg,
            **{name: np.where(possible, values, np.nan) for name, values in numbers.items()},
            "status": np.where(possible, Status.OK_LABEL, Status.IMPOSSIBLE_LABEL),
        }

    def _best(self, angles: Array, delta: float) -> Best:
        """Find the best angle of one material."""
        columns = self._columns(angles, np.full(1, delta))
        friction = columns["equivalent_friction"]
        angles, friction = angles[np.isfinite(friction)], friction[np.isfinite(friction)]
        if not friction.size:
            return Best(delta, inside_deg=np.nan, inside_friction=np.nan, end_deg=np.nan, end_friction=np.nan)
        middle = friction[1:-1]
        dips = 1 + np.flatnonzero((middle < friction[:-2]) & (middle <= friction[2:]))
        inside = dips[friction[dips].argmin()] if dips.size else None
        end = 0 if friction[0] < friction[-1] else -1
        return Best(
            delta,
            inside_deg=np.nan if inside is None else float(angles[inside]),
            inside_friction=np.nan if inside is None else float(friction[inside]),
            end_deg=float(angles[end]),
            end_friction=float(friction[end]),
        )
