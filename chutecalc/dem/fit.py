"""The angle of internal friction with which a friction law comes closest to beds."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.dem.point import Point, measured
from chutecalc.dem.trough import Trough
from chutecalc.physics.arrays import Array
from chutecalc.physics.pressure import vertical_pressure_ratio

INSENSITIVE = 1e-6
"""Where N_t/N changes by less than this between δ = 0 and 90°, no δ can be fitted."""


class Fit(NamedTuple):
    """One angle of internal friction fitted to several points."""

    internal_friction: float
    """Fitted δ, rad; NaN where the law does not depend on it."""
    scatter: float
    """Standard deviation of the δ fitted to the beds of each seed, rad. The point's mean replaces a seed's bed
    that fails. NaN for one seed."""
    residual: float
    """Root mean square difference of N_t/N between beds and law, a ratio."""

    @property
    def vertical_ratio(self) -> float:
        """Pressure ratio K_v of that δ; 1 where the law does not depend on it."""
        return float(vertical_pressure_ratio(0.0 if math.isnan(self.internal_friction) else self.internal_friction))


def residual(points: Sequence[Point], vertical_ratio: float, law: str) -> float:
    """Compute the root mean square difference of N_t/N between beds and a law.

    Args:
        points: The beds, at least one in each point.
        vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].
        law: ``paper`` or ``equilibrium``.

    >>> from types import SimpleNamespace
    >>> from chutecalc.dem.campaign import Group
    >>> from chutecalc.dem.case import Case
    >>> case = Case(base=0.5, lengths=(), inclinations=(), area=0.05, friction=0.75, pour="rain", seed=1)
    >>> bed = SimpleNamespace(case=case, area=0.05, ratio=1.1, failed=())
    >>> round(residual([Point(Group(case, seeds=1), [bed])], vertical_ratio=0.4, law="paper"), 6)  # 1 + K_v H/B = 1.08
    0.02
    """
    off = [point.ratio.mean - point.law(vertical_ratio, law).ratio for point in points]
    return float(np.sqrt(np.mean(np.square(off))))


def fit(points: Sequence[Point], law: str) -> Fit:
    """Fit the angle of internal friction δ with which a law comes closest to the N_t/N of beds.

    Each bed is compared at its measured area.

    Args:
        points: Beds of one pour and one kind of particles, at least one in each point.
        law: ``paper`` or ``equilibrium``.

    Returns:
        The best δ; NaN where N_t/N does not depend on it.

    >>> from types import SimpleNamespace
    >>> from chutecalc.dem.campaign import Group
    >>> from chutecalc.dem.case import Case
    >>> case = Case(base=0.5, lengths=(), inclinations=(), area=0.05, friction=0.75, pour="rain", seed=1)
    >>> bed = SimpleNamespace(case=case, area=0.05, ratio=1.0 + 0.2 / 3.0, failed=())  # 1 + K_v H/B with K_v = 1/3
    >>> best = fit([Point(Group(case, seeds=1), [bed])], law="paper")
    >>> round(math.degrees(best.internal_friction), 3), round(best.residual, 6)
    (30.0, 0.0)
    """
    means = {point: (point.trough, point.area.mean, point.ratio.mean) for point in points}
    best, off = _fitted(list(means.values()), law)
    alone = []
    for seed in {bed.case.seed for point in points for bed in point.beds}:
        own = {point: (point.trough, bed.area, bed.ratio) for point in points for bed in point.beds_of_seed(seed)}
        alone.append(_fitted(list((means | own).values()), law)[0])
    return Fit(best, measured(alone).scatter, off)


def _fitted(beds: Sequence[tuple[Trough, float, float]], law: str) -> tuple[float, float]:
    """Fit δ to troughs with the area and the N_t/N of their beds; return it with the residual."""
    from scipy.optimize import minimize_scalar

    measured_ratios = np.array([ratio for _, _, ratio in beds])

    def off(internal_friction: float) -> Array:
        vertical_ratio = float(vertical_pressure_ratio(internal_friction))
        by_law: Array = np.array([trough.load(area, vertical_ratio, law).ratio for trough, area, _ in beds])
        by_law -= measured_ratios
        return by_law

    if np.abs(off(0.0) - off(math.pi / 2 - 1e-6)).max() < INSENSITIVE:
        return math.nan, float(np.sqrt(np.mean(off(0.5) ** 2)))
    found = minimize_scalar(
        lambda delta: float(np.mean(off(delta) ** 2)), bounds=(0.0, math.pi / 2 - 1e-6), options={"xatol": 1e-7}
    )
    return float(found.x), float(np.sqrt(found.fun))
