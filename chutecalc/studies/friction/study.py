"""The friction study of the paper, section 6: what chamfers at an angle do to the equivalent friction."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from chutecalc.errors import UsageError
from chutecalc.physics.arrays import Array
from chutecalc.physics.friction import equivalent_friction
from chutecalc.physics.pressure import greatest_wall_friction, pressure_ratio, vertical_pressure_ratio
from chutecalc.physics.section import Polygon
from chutecalc.physics.wetting import wetting

CHAMFERS = tuple(float(angle) for angle in range(0, 91, 5))
INTERNAL_FRICTIONS = tuple(float(angle) for angle in range(30, 56, 5))
ANGLE_RANGES = {"beta": "0:90:5", "delta": "30:55:5"}
"""The same as a command line has them."""
WALL_FRICTION, BASE, AREA = 25.0, 0.5, 0.05
"""Angle, deg, as in the paper; width, m, and flow area, m²: A/B² = 0.2 is what its text and figures agree with."""
FINE = 10_001
"""Angles among which a best one is looked for: 0.009° apart at most."""
ROUNDING = 1e-14
Columns = dict[str, Any]


def _centre_width_kept(base: float, area: float, cotangent: Array) -> Array:
    return np.full(cotangent.shape, base**2)


def _width_kept(base: float, area: float, cotangent: Array) -> Array:
    return base**2 - 4.0 * area * cotangent  # free surface² = B² + 4 A cot β


def _depth_kept(base: float, area: float, cotangent: Array) -> Array:
    left = base - area / base * cotangent  # H = A/W stays, the mean width W too
    return left * np.abs(left)


KEPT: dict[str, Callable[[float, float, Array], Array]] = {
    "base": _centre_width_kept,
    "width": _width_kept,
    "depth": _depth_kept,
}
"""What stays beside the flow area, and the square of the centre section's width then, negative where there is none.

Paper, section 6.1 (Figure 5), 6.2 (Figure 7), 6.3 (Figure 9).
"""


class Best(NamedTuple):
    """Where the equivalent friction of a material is least among the angles of a study that have a section."""

    internal_friction_deg: float
    inside_deg: float
    """The least with larger values on both of its sides; NaN where there is none."""
    inside_friction: float
    end_deg: float
    """The end of the range that has the lower value."""
    end_friction: float


class FrictionStudy:
    """Equivalent friction over chamfer angle and internal friction, at one flow area.

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
        """Checks what is asked and works it out.

        Args:
            chamfer_deg: β, 0 (a flat plane) to 90 (square corners).
            internal_friction_deg: δ, 0 to less than 90.
            keep: what stays while β varies: ``base`` (centre section), ``width`` (of the free surface) or ``depth``.
            wall_friction_deg: φ, 0 to less than 90.
            base_m: B, the width between square corners.
            area_m2: A.

        Raises:
            UsageError: which value is out of its range.
        """
        self.chamfer_deg = np.atleast_1d(np.asarray(chamfer_deg, dtype=np.float64))
        self.internal_friction_deg = np.atleast_1d(np.asarray(internal_friction_deg, dtype=np.float64))
        self.keep, self.wall_friction_deg, self.base_m, self.area_m2 = keep, wall_friction_deg, base_m, area_m2
        faults = list(self._faults())
        if faults:
            raise UsageError("\n".join(faults))
        beta, delta = np.meshgrid(self.chamfer_deg, self.internal_friction_deg)
        self.columns: Columns = self._columns(beta.ravel(), delta.ravel())
        """Arrays by column name, a row for each angle of the first material, then of the second, and so on.

        A section that cannot be has the status ``impossible`` and NaN; so has the chamfer's length at β = 0.
        """

    def line(self, internal_friction_deg: float) -> Columns:
        """The rows of one material that have a section."""
        rows = self.columns["internal_friction_deg"] == internal_friction_deg
        rows &= self.columns["status"] == "ok"
        return {name: values[rows] for name, values in self.columns.items()}

    def best(self) -> list[Best]:
        """The best angle of each material, among 10,001 from the least to the greatest asked for."""
        angles = np.linspace(self.chamfer_deg.min(), self.chamfer_deg.max(), FINE)
        return [self._best(angles, float(delta)) for delta in self.internal_friction_deg]

    def inadmissible(self) -> list[float]:
        """The internal frictions, deg, whose material is too weak for the wall friction: φ > atan(sin δ)."""
        steepest = np.degrees(greatest_wall_friction(np.radians(self.internal_friction_deg)))
        return [float(delta) for delta in self.internal_friction_deg[self.wall_friction_deg > steepest]]

    def _faults(self) -> Iterator[str]:
        """All that is out of its range."""
        if self.keep not in KEPT:
            yield f"keep has to be {', '.join(KEPT)}, not {self.keep}"
        angles = {
            "beta": self.chamfer_deg,
            "delta": self.internal_friction_deg,
            "phi": np.array([self.wall_friction_deg]),
        }
        for name, values in angles.items():
            fits = (values >= 0.0) & ((values <= 90.0) if name == "beta" else (values < 90.0))
            if not fits.all() or not values.size:
                given = f"{values[~fits][0]:g}" if values.size else "nothing"
                yield f"{name} has to be from 0 to {'90' if name == 'beta' else 'less than 90'} degrees, not {given}"
        for name, value, unit in (("base", self.base_m, "m"), ("area", self.area_m2, "m²")):
            if not 0.0 < value <= 1e5:
                yield f"{name} has to be greater than 0 and at most 100000 {unit}, not {value:g}"

    def _columns(self, chamfer_deg: Array, internal_friction_deg: Array) -> Columns:
        """The table: one section after the other through the friction law that chutes are solved with."""
        beta, ratio = np.radians(chamfer_deg), vertical_pressure_ratio(np.radians(internal_friction_deg))
        with np.errstate(all="ignore"):  # β = 0 has neither cotangent nor chamfer
            square = KEPT[self.keep](self.base_m, self.area_m2, np.cos(beta) / np.sin(beta))
            square = np.where(np.abs(square) < ROUNDING * self.base_m**2, 0.0, square)  # a vee
            base = np.sqrt(square)
            section = Polygon(base, (np.full(1, np.inf),), (beta,), np.full(1, np.inf))
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
            "status": np.where(possible, "ok", "impossible"),
        }

    def _best(self, angles: Array, delta: float) -> Best:
        """The best angle of one material."""
        columns = self._columns(angles, np.full(1, delta))
        friction = columns["equivalent_friction"]
        angles, friction = angles[np.isfinite(friction)], friction[np.isfinite(friction)]
        if not friction.size:
            return Best(delta, np.nan, np.nan, np.nan, np.nan)
        middle = friction[1:-1]
        dips = 1 + np.flatnonzero((middle < friction[:-2]) & (middle <= friction[2:]))
        inside = dips[friction[dips].argmin()] if dips.size else None
        end = 0 if friction[0] < friction[-1] else -1
        return Best(
            delta,
            np.nan if inside is None else float(angles[inside]),
            np.nan if inside is None else float(friction[inside]),
            float(angles[end]),
            float(friction[end]),
        )
