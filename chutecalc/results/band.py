"""The band of a model's own assumptions: what the momentum factor and pressure along the stream may change.

One mean velocity and no pressure along the stream are assumptions. The variants of :func:`variants_of` cover what they
leave open. It is a band of assumptions, not a confidence interval.
"""

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import product
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Mask
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute

MOMENTUM_FACTORS = (1.0, 1.25, 1.33)
"""α_m of a uniform profile, of Bagnold's for a stream sheared over its whole depth on a rough bed, and of a linear one:
∫ u² dζ/(H v²) for u ~ 1, 1 - (ζ/H)^(3/2) and 1 - ζ/H."""
COLUMNS = ("velocity_m_s", "depth_m")
"""Columns that have a band."""
NOTE = "a band of assumptions, not a confidence interval"


class Variant(NamedTuple):
    """One set of assumptions."""

    momentum_factor: float
    longitudinal_ratio: float

    def __str__(self) -> str:
        return f"α_m = {self.momentum_factor:.4g}, K_l = {self.longitudinal_ratio:.4g}"


class Range(NamedTuple):
    """Least and largest value of a number among the variants."""

    least: float
    largest: float


class Stop(NamedTuple):
    """Where variants end that end otherwise than the chute as written: the band holds without them from there on."""

    status: str
    segment: str
    """Name of the segment."""
    s_m: Range
    """Distance from the inlet along the stream, m."""
    variants: tuple[Variant, ...]


Ranges = dict[str, Range]


def variants_of(given: Variant, vertical_ratio: float) -> list[Variant]:
    """Return the variants that make a band: the one of the spec, then all combinations.

    K_l is 0, neglected; K_v, that of a stream whose walls and length press alike; and 1, that of a liquid.

    Args:
        given: the numbers of the spec.
        vertical_ratio: pressure ratio K_v.

    >>> [str(variant) for variant in variants_of(Variant(1.0, 0.0), 0.1)][:3]
    ['α_m = 1, K_l = 0', 'α_m = 1, K_l = 0.1', 'α_m = 1, K_l = 1']
    """
    grid = (Variant(*pair) for pair in product(MOMENTUM_FACTORS, (0.0, vertical_ratio, 1.0)))
    return list(dict.fromkeys([given, *grid]))


class Band:
    """Velocity and depth of one chute under the variants of its assumptions.

    >>> import chutecalc
    >>> band = chutecalc.solve_band(chutecalc.parse(chutecalc.STARTER))
    >>> band
    <Band of 9 variants: exit velocity 5.734 to 6.222 m/s>
    >>> [round(number, 3) for number in band.segments["spoon"]["maximum"]["velocity_m_s"]]
    [6.309, 6.607]
    """

    def __init__(self, solution: SolvedChute, variants: Sequence[Variant]) -> None:
        """Take the solved variants.

        Args:
            solution: of all variants, that of the spec first.
            variants: their assumptions.
        """
        self.solution, self.variants = solution, tuple(variants)

    @cached_property
    def exit(self) -> Ranges:
        """Range of each column at the end of the chute, by name."""
        ends = self.solution.exit_columns(COLUMNS)
        return {name: _range(ends[name], self._alike) for name in COLUMNS}

    @cached_property
    def segments(self) -> dict[str, dict[str, Ranges]]:
        """Ranges by segment, by ``entry``, ``exit``, ``minimum`` and ``maximum``, and by column."""
        return {segment.name: _ranges(segment) for segment in self.solution.segments}

    @cached_property
    def stops(self) -> list[Stop]:
        """Where variants end that do not end as the chute as written does."""
        found: dict[tuple[str, str], list[tuple[float, Variant]]] = {}
        for number in np.flatnonzero(~self._alike):
            name, s = self._end(int(number))
            found.setdefault((str(self.solution.status[number]), name), []).append((s, self.variants[number]))
        return [
            Stop(
                status,
                segment,
                _range(np.array([s for s, _ in ends]), np.full(len(ends), True)),
                tuple(variant for _, variant in ends),
            )
            for (status, segment), ends in found.items()
        ]

    def along(self, shares: Array) -> Iterator[tuple[Array, dict[str, tuple[Array, Array]]]]:
        """Yield for each part of the stream its distance from the inlet and the least and largest of each column.

        Variants are compared at the same shares of what they travel on a part.

        Args:
            shares: of the part travelled, shape (stations,).
        """
        for part in self.solution.trajectory.parts:
            status = np.broadcast_to(part.status(), (len(self.variants),))
            values = part.at(shares, ["s_m", *COLUMNS])
            shape = (len(shares), len(self.variants))
            s = np.broadcast_to(values["s_m"], shape)[:, 0]
            if np.isfinite(s).all():
                yield (
                    s,
                    {
                        name: _extremes(np.where(status == status[0], np.broadcast_to(values[name], shape), np.nan))
                        for name in COLUMNS
                    },
                )

    @property
    def _alike(self) -> Mask:
        """Whether each variant ends as the chute as written does."""
        alike: Mask = self.solution.status == self.solution.status[0]
        return alike

    def _end(self, number: int) -> tuple[str, float]:
        """Return the segment on which a variant ends, and how far it comes, m."""
        reached = [segment for segment in self.solution.segments if segment.status[number] != "not_reached"]
        distances = [float(segment.exit["s_m"][number]) for segment in reached]
        return reached[-1].name, max((s for s in distances if s == s), default=0.0)

    def __repr__(self) -> str:
        velocity = self.exit["velocity_m_s"]
        ends = f"exit velocity {velocity.least:.4g} to {velocity.largest:.4g} m/s"
        return f"<Band of {len(self.variants)} variants: {ends}>"


def _ranges(segment: SegmentResult) -> dict[str, Ranges]:
    """Return the ranges of a segment: after its start without variants that end on it in another manner."""
    alike = segment.status == segment.status[0]
    there = np.full(len(alike), True)
    rows = (
        ("entry", segment.entry, there),
        ("exit", segment.exit, alike),
        ("minimum", segment.minimum, alike),
        ("maximum", segment.maximum, alike),
    )
    return {row: {name: _range(numbers[name], chosen) for name in COLUMNS} for row, numbers, chosen in rows}


def _range(values: Array, chosen: Mask) -> Range:
    """Return least and largest of the chosen values; NaN where there is none."""
    least, largest = _extremes(np.where(chosen, values, np.nan)[None])
    return Range(float(least[0]), float(largest[0]))


def _extremes(values: Array) -> tuple[Array, Array]:
    """Return least and largest along the last axis, leaving out what is NaN."""
    return np.fmin.reduce(values, axis=-1), np.fmax.reduce(values, axis=-1)
