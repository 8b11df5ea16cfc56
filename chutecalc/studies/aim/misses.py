"""By how much designs miss what is wanted."""

from collections.abc import Mapping, Sequence

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Mask
from chutecalc.studies.digits import rounded
from chutecalc.studies.keys import Key
from chutecalc.studies.limit import check_column
from chutecalc.studies.variants import Variants

RTOL = 1e-12
"""Relative tolerance of the velocity, so that errors of the solver do not count; a miss below it is none."""
WITHIN = 1e-9
"""Error of a target that is met, in its unit, or as a share of it where it is above 1."""
CLOSER = 0.5
"""Share of that error, and of the distance below, that rounding may take."""
SAME = 1e-6
"""Distance, as a share of the bounds, within which solutions are one."""


class Misses:
    """The distances of designs from targets, as a function of their place within the bounds.

    Attributes:
        statuses: how the designs of the first call end.
        closest: place of the design that comes closest, of all that were solved, shape (1, keys); empty for none.
    """

    def __init__(self, variants: Variants, keys: Sequence[Key], targets: Mapping[str, float]) -> None:
        """Take what varies and what is wanted.

        Args:
            variants: solves designs in one state.
            keys: all continuous.
            targets: wanted values by name of the column.
        """
        self.variants, self.names = variants, list(targets)
        self.low, self.high = np.array([key.bounds for key in keys]).T
        self.wanted = np.array([*targets.values()], dtype=float)
        self.scale = np.zeros(0)
        self.statuses: list[str] = []
        self.closest, self._least = np.empty((0, len(keys))), np.inf

    def __call__(self, places: Array) -> Array:
        """Return by how much each column misses its target, as a share of its spread in the first call.

        Args:
            places: 0 to 1 from the lower to the upper bound of each key, shape (designs, keys).

        Returns:
            Shape (designs, targets); NaN where a design fails.

        Raises:
            UsageError: in the first call, no design has a value of a target.
        """
        if not len(places):
            return np.empty((0, len(self.wanted)))
        missed, statuses = self._missed(self.values(places))
        missed[np.abs(missed) <= RTOL * np.abs(self.wanted)] = 0.0
        if not self.scale.size:
            known = missed[np.isfinite(missed).all(axis=1)]
            spread = np.ptp(known, axis=0) if len(known) else np.zeros(len(self.wanted))
            self.scale = np.where(spread > 0.0, spread, 1.0)
            self.statuses = statuses
            ok = np.array(statuses) == Status.OK_LABEL
            for name, exists in zip(self.names, np.isfinite(missed[ok]).T, strict=True):
                check_column(self.variants.chute.source, name, exists, "choose another target")
        missed = np.where(np.isfinite(missed).all(axis=1, keepdims=True), missed / self.scale, np.nan)
        size = np.linalg.norm(np.where(np.isnan(missed), np.inf, missed), axis=1)
        best = int(size.argmin()) if size.size else 0
        if size.size and size[best] < self._least:
            self.closest, self._least = places[best : best + 1].copy(), float(size[best])
        return missed

    def values(self, places: Array) -> Array:
        """Return the values of the keys, in their units.

        Args:
            places: as for a call, dimensionless.
        """
        return np.asarray(self.low + places * (self.high - self.low))

    def rounded(self, places: Array) -> Array:
        """Return the values of the keys with as few digits as keep what is met, and solutions apart.

        Args:
            places: as for a call, dimensionless.
        """
        values = self.values(places)
        if not len(places):
            return values
        limits = np.maximum(self._off(values), CLOSER * WITHIN) * (1.0 + CLOSER * WITHIN)
        apart = CLOSER * SAME * (self.high - self.low)

        def one(number: int) -> Array:
            def is_good(tried: Array) -> Mask:
                near = (np.abs(tried - values[number]) <= apart) & (self.low <= tried) & (tried <= self.high)
                good: Mask = near.all(axis=1)
                good[good] = self._off(tried[good]) <= limits[number]
                return good

            return rounded(values[number], np.maximum(np.abs(self.low), np.abs(self.high)), is_good)

        return np.array([one(number) for number in range(len(values))])

    def _off(self, values: Array) -> Array:
        """Return the largest error of the targets, as :data:`WITHIN` counts it, of values; infinite for failures."""
        if not len(values):
            return np.empty(0)
        off = np.abs(self._missed(values)[0]) / np.maximum(np.abs(self.wanted), 1.0)
        return np.asarray(np.where(np.isnan(off), np.inf, off).max(axis=1))

    def _missed(self, values: Array) -> tuple[Array, list[str]]:
        """Return by how much columns miss targets, shape (designs, targets), NaN for failures, and how designs end."""
        block = self.variants(list(values.T))
        return np.stack([block[name][0] for name in self.names], axis=1) - self.wanted, block["status"][0].tolist()

    def met(self, places: Array) -> Array:
        """Return those places at which all targets are met, each once, in the order of the first key.

        Args:
            places: where to look, dimensionless, shape (designs, keys).
        """
        if not len(places):
            return places
        worst = self._off(self.values(places))
        kept: list[Array] = []
        for place in places[np.argsort(worst, kind="stable")[: int((worst <= WITHIN).sum())]]:
            if all(np.abs(place - other).max() > SAME for other in kept):
                kept.append(place)
        return np.array(sorted(kept, key=tuple)).reshape(-1, places.shape[1])
