"""Beds and the friction law: means and scatter over seeds, and the angle of internal friction that fits best."""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.dem.bed import Bed
from chutecalc.dem.campaign import Campaign, Group
from chutecalc.dem.case import Case
from chutecalc.dem.trough import Load, Trough
from chutecalc.physics.arrays import Array
from chutecalc.physics.pressure import vertical_pressure_ratio

LAWS = ("paper", "equilibrium")
"""The friction laws."""
INSENSITIVE = 1e-6
"""Where N_t/N changes by less than this between δ = 0 and 90°, no δ can be fitted."""
CLAIM = (
    "This check is about shape: does K(β) with one fitted δ follow the beds of one pour? The fitted δ depends on the"
    " pour and is not the measured angle of internal friction."
)
"""What the check shows, and what it does not."""


class Measured(NamedTuple):
    """A mean over seeds."""

    mean: float
    """Mean, in the unit of the quantity."""
    scatter: float
    """Standard deviation over the seeds, in the same unit; NaN for one seed."""


def measured(values: Sequence[float]) -> Measured:
    """Compute mean and standard deviation.

    Args:
        values: One number for each seed, any unit.

    >>> measured([1.0, 3.0])
    Measured(mean=2.0, scatter=1.4142135623730951)
    """
    return Measured(float(np.mean(values)), float(np.std(values, ddof=1)) if len(values) > 1 else math.nan)


class Point:
    """The beds of one group. Beds that pass all checks are averaged; the others are only listed.

    Args:
        group: The group.
        beds: The beds of all seeds that have been run.
        errors: Messages of runs that failed.
        waiting: Number of cases that have not been run.

    >>> case = Case(base=0.5, lengths=(), inclinations=(), area=0.05, friction=0.75, pour="rain", seed=1)
    >>> point = Point(Group(case, seeds=3), beds=[], waiting=3)
    >>> point.trough.base, point.beds_of_seed(1)
    (0.5, [])
    """

    def __init__(self, group: Group, beds: Sequence[Bed], errors: Sequence[str] = (), waiting: int = 0) -> None:
        self.group, self.errors, self.waiting = group, tuple(errors), waiting
        self.all = tuple(beds)
        self.beds = tuple(bed for bed in beds if not bed.failed)
        self.failed = tuple(bed for bed in beds if bed.failed)

    def beds_of_seed(self, seed: int) -> list[Bed]:
        """Return the bed of a seed, if it passes all checks.

        Args:
            seed: The seed.
        """
        return [bed for bed in self.beds if bed.case.seed == seed]

    @property
    def case(self) -> Case:
        """The group's case with the first seed."""
        return self.group.case

    @cached_property
    def trough(self) -> Trough:
        """The group's trough."""
        return self.case.trough

    @property
    def area(self) -> Measured:
        """Measured area of the beds, m²."""
        return measured([bed.area for bed in self.beds])

    @property
    def depth(self) -> Measured:
        """Depth of level beds of that area, m."""
        return measured([bed.depth for bed in self.beds])

    @property
    def solid_fraction(self) -> Measured:
        """Solid fraction of the beds' interior, a ratio of volumes."""
        return measured([bed.solid_fraction for bed in self.beds])

    @property
    def ratio(self) -> Measured:
        """N_t/N, the sum of all normal loads over the weight."""
        return measured([bed.ratio for bed in self.beds])

    @property
    def walls(self) -> dict[str, tuple[Measured, Measured]]:
        """Load on one wall over the weight, and its pressure ratio K, by the name of each wall that all beds reach."""
        names = [name for name in self.beds[0].by_name if all(name in bed.pressure_ratios for bed in self.beds)]
        return {
            name: (
                measured([bed.by_name[name] for bed in self.beds]),
                measured([bed.pressure_ratios[name] for bed in self.beds]),
            )
            for name in names
        }

    def law(self, vertical_ratio: float, law: str) -> Load:
        """Compute the loads of a friction law for a bed of the same area.

        Args:
            vertical_ratio: Pressure ratio K_v of a vertical wall, in (0, 1].
            law: ``paper`` or ``equilibrium``.
        """
        return self.trough.load(self.area.mean, vertical_ratio, law)


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


class Series(NamedTuple):
    """Points with one pour, one kind of particles and one body force."""

    pour: str
    """Name of the pour."""
    friction: float
    """Coefficient of friction between particles."""
    body_force: float
    """Body force of the pour, in g."""
    raised_to: float
    """Body force to which the resting beds are raised, in g; 0 where they are not."""
    points: tuple[Point, ...]
    """The points with at least one bed that passes all checks."""
    fits: dict[str, Fit]
    """Fits by law; empty where there is no point."""


class Study:
    """The results of a campaign so far.

    Args:
        campaign: The campaign with its folder.
        wall_friction: Wall friction angle φ for μ_e, rad.
        vertical_ratio: Pressure ratio K_v to compare with besides the fitted one; None for none.

    >>> from chutecalc.dem.store import Store
    >>> case = Case(base=0.5, lengths=(), inclinations=(), area=0.05, friction=0.75, pour="rain", seed=1)
    >>> study = Study(Campaign([Group(case, seeds=3)], Store("no-such-folder")), wall_friction=math.radians(25.0))
    >>> study.sound, study.points[0].waiting
    (False, 1)
    """

    def __init__(self, campaign: Campaign, wall_friction: float, vertical_ratio: float | None = None) -> None:
        self.wall_friction, self.vertical_ratio = wall_friction, vertical_ratio
        self.store = campaign.store
        outcomes = [(group, campaign.outcome(group)) for group in campaign.groups]
        self.points = tuple(
            Point(group, outcome.beds, outcome.errors, len(outcome.needed)) for group, outcome in outcomes
        )

    @cached_property
    def series(self) -> tuple[Series, ...]:
        """All points as series, with their fits."""
        series: dict[tuple[str, float, float, float], list[Point]] = {}
        for point in self.points:
            case = point.case
            key = (case.pour, case.friction, case.body_force, case.raised_to)
            series.setdefault(key, []).append(point)
        fitted = []
        for key, points in series.items():
            usable = tuple(point for point in points if point.beds)
            fitted.append(Series(*key, usable, {law: fit(usable, law) for law in LAWS} if usable else {}))
        return tuple(fitted)

    @property
    def sound(self) -> bool:
        """Whether all cases have been run and pass their checks."""
        return not any(point.failed or point.errors or point.waiting for point in self.points)
