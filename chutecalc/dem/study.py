"""Beds against the friction law: means over seeds with their scatter, and the internal friction that fits best."""

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
INSENSITIVE = 1e-6
"""Where N_t/N changes less than that between δ = 0 and 90° no δ can be fitted."""
CLAIM = (
    "The check is one of shape: whether K(β) with one fitted δ follows the beds of one pour. The fitted δ depends on"
    " the pour and is not the measured angle of internal friction."
)


class Measured(NamedTuple):
    """A mean over seeds."""

    mean: float
    scatter: float
    """Standard deviation over the seeds; NaN for one seed."""


def measured(values: Sequence[float]) -> Measured:
    """Mean and standard deviation.

    >>> measured([1.0, 3.0])
    Measured(mean=2.0, scatter=1.4142135623730951)
    """
    return Measured(float(np.mean(values)), float(np.std(values, ddof=1)) if len(values) > 1 else math.nan)


class Point:
    """One group's beds: those that pass all checks count, the others are only shown.

    Args:
        group: the cases asked for.
        beds: of all seeds that were run.
        errors: of runs that did not end well.
        waiting: how many cases have not been run.
    """

    def __init__(self, group: Group, beds: Sequence[Bed], errors: Sequence[str] = (), waiting: int = 0) -> None:
        self.group, self.errors, self.waiting = group, tuple(errors), waiting
        self.all = tuple(beds)
        self.beds = tuple(bed for bed in beds if not bed.failed)
        self.failed = tuple(bed for bed in beds if bed.failed)

    def beds_of_seed(self, seed: int) -> list[Bed]:
        """The bed of a seed, where it passes all checks."""
        return [bed for bed in self.beds if bed.case.seed == seed]

    @property
    def case(self) -> Case:
        """That of the group."""
        return self.group.case

    @cached_property
    def trough(self) -> Trough:
        """That of the group."""
        return self.case.trough

    @property
    def area(self) -> Measured:
        """The beds' own, m²."""
        return measured([bed.area for bed in self.beds])

    @property
    def depth(self) -> Measured:
        """M."""
        return measured([bed.depth for bed in self.beds])

    @property
    def solid_fraction(self) -> Measured:
        """Of the interior."""
        return measured([bed.solid_fraction for bed in self.beds])

    @property
    def ratio(self) -> Measured:
        """N_t/N."""
        return measured([bed.ratio for bed in self.beds])

    @property
    def walls(self) -> dict[str, tuple[Measured, Measured]]:
        """Of each name of wall that all beds reach: load on one over the weight, and K."""
        names = [name for name in self.beds[0].by_name if all(name in bed.pressure_ratios for bed in self.beds)]
        return {
            name: (
                measured([bed.by_name[name] for bed in self.beds]),
                measured([bed.pressure_ratios[name] for bed in self.beds]),
            )
            for name in names
        }

    def law(self, vertical_ratio: float, law: str) -> Load:
        """What a law says of a bed of the same area."""
        return self.trough.load(self.area.mean, vertical_ratio, law)


class Fit(NamedTuple):
    """One angle of internal friction for several points."""

    internal_friction: float
    """δ, rad; NaN where the law does not depend on it."""
    scatter: float
    """Standard deviation of the δ fitted to each seed's beds, rad, with the mean where a seed's bed failed; NaN where
    there is one seed."""
    residual: float
    """Root of the mean square difference of N_t/N."""

    @property
    def vertical_ratio(self) -> float:
        """K_v of that δ; 1 where the law does not depend on it."""
        return float(vertical_pressure_ratio(0.0 if math.isnan(self.internal_friction) else self.internal_friction))


def residual(points: Sequence[Point], vertical_ratio: float, law: str) -> float:
    """Root of the mean square difference of N_t/N between beds and a law."""
    off = [point.ratio.mean - point.law(vertical_ratio, law).ratio for point in points]
    return float(np.sqrt(np.mean(np.square(off))))


def fit(points: Sequence[Point], law: str) -> Fit:
    """The δ with which a law comes nearest to the N_t/N of points, each at its own area.

    Args:
        points: of the same pour and particles, with a bed each at least.
        law: ``paper`` or ``equilibrium``.
    """
    means = {point: (point.trough, point.area.mean, point.ratio.mean) for point in points}
    best, off = _fitted(list(means.values()), law)
    alone = []
    for seed in {bed.case.seed for point in points for bed in point.beds}:
        own = {point: (point.trough, bed.area, bed.ratio) for point in points for bed in point.beds_of_seed(seed)}
        alone.append(_fitted(list((means | own).values()), law)[0])
    return Fit(best, measured(alone).scatter, off)


def _fitted(beds: Sequence[tuple[Trough, float, float]], law: str) -> tuple[float, float]:
    """δ and what is left, for troughs with the area and the N_t/N of their beds."""
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
    """Points of the same pour, particles and body force."""

    pour: str
    friction: float
    body_force: float
    raised_to: float
    points: tuple[Point, ...]
    """Those with at least one bed that counts."""
    fits: dict[str, Fit]
    """By law; empty where there is no point."""


class Study:
    """What a campaign has found so far.

    Args:
        campaign: with its folder.
        wall_friction: φ for μ_e, rad.
        vertical_ratio: K_v to compare with besides the fitted one; None for none.
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
        """All points, in series, with what fits them."""
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
        """Whether all cases have run and passed their checks."""
        return not any(point.failed or point.errors or point.waiting for point in self.points)
