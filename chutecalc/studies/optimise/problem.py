"""What is to be best, within which limits, in which states."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.design import Status
from chutecalc.errors import UsageError
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.studies.digits import rounded
from chutecalc.studies.keys import Key
from chutecalc.studies.limit import Limit, check_column
from chutecalc.studies.optimise.objective import Objective
from chutecalc.studies.variants import Variants
from chutecalc.workers import Threads

OK = Status.OK_LABEL
FAILURE, WARNING, MOST = 1000.0, 1.0, 100.0
"""What counts as violation: a state that fails, a warning, and a limit at most, as shares of it."""
FEASIBLE = 1.0
"""What the merit of a feasible design is below, and that of any other above."""
WORSE = 1e-9
"""Share of the objective, and violation, that rounding may add."""


class Rows(NamedTuple):
    """What designs do, with an entry for each design last."""

    values: Array
    """The objective, its sign turned where it is maximised, shape (states, designs)."""
    margins: Array
    """Distance from each limit as a share of it, negative where it is violated, shape (limits, states, designs);
    :data:`MOST` where the column has no value, which keeps any limit."""
    faults: Array
    """What is violated beside limits, see :data:`FAILURE`, shape (designs,)."""
    block: Block
    """``status``, the columns of objectives and limits, ``warnings`` if they count, shape (states, designs) each."""

    @property
    def stands(self) -> Mask:
        """Whether a design neither fails nor lacks a value of an objective, shape (states, designs)."""
        return np.asarray(~np.isnan(self.values))

    @property
    def worst(self) -> Array:
        """The objective in the worst state of each design, in the unit of its column."""
        return np.asarray(self.values.max(axis=0))

    @property
    def violation(self) -> Array:
        """Sum of all violations of each design, dimensionless, 0 where it is feasible."""
        short = np.clip(-self.margins, 0.0, MOST)
        return np.asarray(self.faults + short.sum(axis=(0, 1)))


class Problem:
    """A chute whose keys may change, and what is wanted of it."""

    def __init__(
        self,
        chute: Chute,
        keys: Sequence[Key],
        objective: Objective,
        limits: Sequence[Limit],
        states: Sequence[str],
        no_warnings: bool = False,
        jobs: int | None = None,
        others: Sequence[Objective] = (),
    ) -> None:
        """Check the columns; nothing is solved yet.

        Args:
            chute: a chute of one design.
            keys: what may change.
            objective: what is to be best, in the worst of the states.
            limits: that hold in each state.
            states: operating states.
            no_warnings: whether warnings are violations.
            jobs: number of threads.
            others: further objectives: a design needs a value of each.

        Raises:
            UsageError: a column does not exist or is text, or a key has one choice only.
        """
        self.chute, self.keys, self.objective, self.limits = chute, tuple(keys), objective, tuple(limits)
        self.no_warnings, self.jobs = no_warnings, jobs
        self.needed = list(dict.fromkeys(each.column for each in (objective, *others)))
        self.columns = list(dict.fromkeys([*self.needed, *(limit.column for limit in limits)]))
        columns = [*self.columns, *(["warnings"] if no_warnings else [])]
        self.variants = Variants(chute, [key.parameter for key in keys], columns, states, pool=Threads(jobs))
        if texts := [name for name in self.columns if name in self.variants.sweep.texts]:
            raise UsageError(f"{', '.join(texts)}: objectives and limits need columns of numbers")
        if single := [key.name for key in keys if len({*key.parameter.values.tolist()}) == 1]:
            raise UsageError(f"{', '.join(single)}: one value leaves no choice; put it into the spec")
        self.low, self.high = np.array([key.bounds for key in keys]).T
        self.continuous = np.array([key.is_continuous for key in keys])
        self.unit = 1.0
        """Typical size of the objective."""

    def rows(self, places: Array) -> Rows:
        """Solve designs.

        Args:
            places: of the designs, in the units of the keys as :meth:`Key.at` takes them, shape (designs, keys).
        """
        block = self.variants([key.at(own) for key, own in zip(self.keys, places.T, strict=True)])
        values = self.objective.sign * block[self.objective.column]
        margins = np.array([limit.margin(block[limit.column]) / limit.scale for limit in self.limits]).reshape(
            len(self.limits), *values.shape
        )
        margins = np.nan_to_num(margins, nan=MOST, posinf=MOST, neginf=-MOST)
        exists = np.all([np.isfinite(block[name]) for name in self.needed], axis=0)
        fails = (block["status"] != OK) | ~exists
        faults = FAILURE * fails.sum(axis=0)
        if self.no_warnings:
            counts = np.vectorize(lambda codes: len(codes.split()), otypes=[float])(block["warnings"])
            faults = faults + WARNING * counts.sum(axis=0)
        return Rows(np.where(fails, np.nan, values), margins, faults, block)

    def check_values(self, rows: Rows) -> None:
        """Check that each objective and the column of each limit have a value in any design that does not fail.

        Args:
            rows: of designs from all over the bounds.

        Raises:
            UsageError: one has none.
        """
        ok = rows.block["status"] == OK
        for name in self.needed:
            check_column(self.chute.source, name, np.isfinite(rows.block[name][ok]), "choose another objective")
        for limit in self.limits:
            exists = ~np.isnan(rows.block[limit.column][ok])
            check_column(self.chute.source, limit.column, exists, f"leave out the limit {limit.text}")

    def merit(self, rows: Rows) -> Array:
        """Return one number for each design by Deb's rule: of feasible ones the better is less, all others come after.

        Args:
            rows: of the designs.
        """
        share = rows.worst / self.unit
        violation = rows.violation
        return np.where(violation > 0.0, FEASIBLE + violation, share / (1.0 + np.abs(share)))

    def clipped(self, places: Array) -> Array:
        """Return places within the bounds, those of choices whole.

        Args:
            places: in the units of the keys, shape (designs, keys).
        """
        inside = np.clip(places, self.low, self.high)
        return np.where(self.continuous, inside, np.rint(inside))

    def rounded(self, place: Array) -> Array:
        """Return a place with the digits that matter: no limit breaks, and the objective is as good to :data:`WORSE`.

        Args:
            place: of a design, in the units of the keys, shape (keys,).
        """
        if not self.continuous.any():
            return place
        own = self.rows(place[None])
        best, violation = own.worst[0], own.violation[0]
        most = violation * (1.0 + WORSE)

        def put(tried: Array) -> Array:
            places = np.repeat(place[None], len(tried), axis=0)
            places[:, self.continuous] = tried
            return places

        def is_good(tried: Array) -> Mask:
            places = put(tried)
            rows = self.rows(places)
            with np.errstate(invalid="ignore"):
                worse = rows.worst > best + WORSE * abs(best)
            inside = (places == self.clipped(places)).all(axis=1)
            return np.asarray((rows.violation <= most) & ~worse & inside)

        scales = np.maximum(np.abs(self.low), np.abs(self.high))[self.continuous]
        return np.asarray(put(rounded(place[self.continuous], scales, is_good)[None])[0])

    def all_choices(self, most: int) -> Array | None:
        """Return all designs where every key is a choice and they are few.

        Args:
            most: number of designs.
        """
        counts: Index = (self.high + 1.0).astype(int)
        if self.continuous.any() or np.prod(counts.astype(float)) > most:
            return None
        return np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), -1).reshape(-1, len(counts)).astype(float)
