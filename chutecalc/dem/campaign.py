"""Which cases are to be run: beds made level first, then all seeds; whatever is kept on disk is not run again."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from typing import NamedTuple

from chutecalc.dem.bed import LEVEL, Bed
from chutecalc.dem.case import Case
from chutecalc.dem.engine import Engine, RunError
from chutecalc.dem.pour import steps
from chutecalc.dem.store import Store
from chutecalc.errors import UsageError

LEVEL_ENOUGH = 0.5 * LEVEL
"""Unevenness of the first seed's bed with which its pour is taken for the others."""
ROUNDS = 4
LARGEST_SPREAD = 0.9
"""Of the spread e, which lies between -1 and 1."""
PARTICLE_STEPS_PER_SECOND = 2.5e6
"""Particles times steps that a core does in a second, about."""


@dataclass(frozen=True)
class Group:
    """The same bed with several seeds."""

    case: Case
    """With the first seed; the others count on from it."""
    seeds: int


class Outcome(NamedTuple):
    """What is known of a group."""

    beds: tuple[Bed, ...]
    """Of all seeds run with the pour that was taken."""
    needed: tuple[Case, ...]
    """To be run next."""
    errors: tuple[str, ...]
    """Of cases that did not run to their end."""


class Campaign:
    """Groups of cases, and what a folder holds of them.

    Args:
        groups: what is wanted.
        store: where cases are kept.
    """

    def __init__(self, groups: Sequence[Group], store: Store) -> None:
        self.groups, self.store = tuple(groups), store
        self._errors: dict[str, str] = {}
        self._beds: dict[str, Bed] = {}

    def outcome(self, group: Group) -> Outcome:
        """What is known of a group, from disk and from failures in this call."""
        tried: list[Bed] = []
        for case in self._trials(group.case, tried):
            if (error := self._errors.get(case.name)) is not None:
                return Outcome((), (), (error,))
            bed = self._bed(case)
            if bed is None:
                return Outcome((), (case,), ())
            tried.append(bed)
        taken = min(tried, key=lambda bed: abs(bed.unevenness)).case
        cases = [replace(taken, seed=group.case.seed + number) for number in range(group.seeds)]
        beds = [self._bed(case) for case in cases]
        errors = tuple(self._errors[case.name] for case in cases if case.name in self._errors)
        needed = [case for case, bed in zip(cases, beds, strict=True) if bed is None and case.name not in self._errors]
        return Outcome(tuple(bed for bed in beds if bed is not None), tuple(needed), errors)

    def _trials(self, case: Case, tried: list[Bed]) -> Iterator[Case]:
        """The first seed with one spread after the other until its bed is level; ``tried`` grows between the steps."""
        yield case
        for _ in range(ROUNDS - 1):
            if abs(tried[-1].unevenness) <= LEVEL_ENOUGH:
                return
            yield replace(case, spread=_next_spread([(bed.case.spread, bed.unevenness) for bed in tried]))

    def _bed(self, case: Case) -> Bed | None:
        """A bed from disk, read once."""
        if case.name not in self._beds:
            bed = self.store.read(case)
            if bed is None:
                return None
            self._beds[case.name] = bed
        return self._beds[case.name]

    def write(self) -> list[Case]:
        """Writes the cases that are needed next, and runs nothing."""
        needed = [case for group in self.groups for case in self.outcome(group).needed]
        for case in needed:
            self.store.write(case)
        return needed

    def run(self, engine: Engine, jobs: int, report_progress: Callable[[int, int], None]) -> None:
        """Runs all that is needed, so many cases at once.

        Args:
            engine: what runs them.
            jobs: how many at once.
            report_progress: called with the number of cases that are done and the number known to be needed, at the
                start and after each case.
        """
        with ThreadPoolExecutor(jobs) as pool:
            try:
                self._run_all(pool, engine, report_progress)
            except BaseException:  # interrupted: the pool waits for what runs
                pool.shutdown(wait=False, cancel_futures=True)
                engine.stop()
                raise

    def _run_all(self, pool: ThreadPoolExecutor, engine: Engine, report_progress: Callable[[int, int], None]) -> None:
        started: set[str] = set()
        running: dict[Future[None], Case] = {}
        while True:
            outcomes = [self.outcome(group) for group in self.groups]
            for case in (case for outcome in outcomes for case in outcome.needed):
                if case.name not in started:
                    started.add(case.name)
                    running[pool.submit(self._run_one, engine, case)] = case
            report_progress(len(started) - len(running), len(started) + self._waiting(outcomes))
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                case = running.pop(future)
                try:
                    future.result()
                except (RunError, UsageError, OSError) as error:
                    self._errors[case.name] = f"{case.name}: {error}"

    def _run_one(self, engine: Engine, case: Case) -> None:
        folder = self.store.write(case)
        engine.run(folder)
        if self.store.read(case) is None:
            raise RunError(f"has not written all its results: is the disk full? See {folder}")

    def _waiting(self, outcomes: Sequence[Outcome]) -> int:
        """Cases of groups whose pour is not yet known to be level."""
        return sum(
            group.seeds - 1
            for group, outcome in zip(self.groups, outcomes, strict=True)
            if not outcome.beds and outcome.needed
        )


def expected_seconds(campaign: Campaign) -> tuple[int, float]:
    """How many cases are to be run, and how long that takes on one core, about: one more than the seeds for each group.

    Args:
        campaign: what is wanted, and what is on disk.
    """
    left = []
    for group in campaign.groups:
        outcome = campaign.outcome(group)
        if outcome.needed:
            left.append((group.case, len(outcome.needed) if outcome.beds else group.seeds + 1))
    work = sum(number * steps(case) * case.count for case, number in left)
    return sum(number for _, number in left), work / PARTICLE_STEPS_PER_SECOND


def _next_spread(tried: Sequence[tuple[float, float]]) -> float:
    """The spread that would make the bed level, by the last two, or by the unevenness itself after the first.

    With no sliding at all a bed poured with spread e ends uneven by e.

    >>> _next_spread([(0.0, -0.06)]), round(_next_spread([(0.0, -0.06), (0.06, -0.02)]), 6)
    (0.06, 0.09)
    """
    (spread, uneven) = tried[-1]
    gain = 1.0
    if len(tried) > 1:
        before, was = tried[-2]
        gain = (uneven - was) / (spread - before) if spread != before else 1.0
    step = -uneven / max(gain, 0.25)
    return max(-LARGEST_SPREAD, min(LARGEST_SPREAD, round(spread + step, 4)))
