"""The beds of one group of cases: means and scatter over their seeds."""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from chutecalc.dem.bed import Bed
from chutecalc.dem.campaign import Group
from chutecalc.dem.case import Case
from chutecalc.dem.trough import Load, Trough


class Measured(NamedTuple):
    """A mean over seeds."""

    mean: float
    """Mean, in the unit of the quantity."""
    scatter: float
    """Standard deviation over the seeds, in the same unit; NaN for one seed."""

    def scaled(self, factor: float) -> "Measured":
        """Multiply by a constant.

        Args:
            factor: A number of at least 0, in any unit.

        >>> Measured(mean=2.0, scatter=1.0).scaled(0.5)
        Measured(mean=1.0, scatter=0.5)
        """
        return Measured(factor * self.mean, factor * self.scatter)


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
