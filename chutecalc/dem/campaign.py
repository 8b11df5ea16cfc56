"""Campaigns: beds are made level with the first seed, then all seeds are run; no case on disk is run twice."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import dataclass, replace
from typing import NamedTuple

from chutecalc.dem.bed import LEVEL, Bed
from chutecalc.dem.case import Case
from chutecalc.dem.engine import Engine, RunError
from chutecalc.dem.pour import steps
from chutecalc.dem.store import Store
from chutecalc.errors import OutputError, UsageError, WriteError
from chutecalc.output.held import held_folder
from chutecalc.workers import Pool

LEVEL_ENOUGH = 0.5 * LEVEL
"""Unevenness of the first seed's bed, over its depth, at which its pour is used for the other seeds."""
ROUNDS = 4
"""Pours tried with the first seed."""
LARGEST_SPREAD = 0.9
"""Largest magnitude of the spread e, which lies between -1 and 1."""
PARTICLE_STEPS_PER_SECOND = 2.5e6
"""Particles times time steps that a core computes in a second, roughly."""


@dataclass(frozen=True)
class Group:
    """One bed with several seeds."""

    case: Case
    """The case with the first seed; the other seeds count up from it."""
    seeds: int
    """Number of seeds."""


class Outcome(NamedTuple):
    """The state of a group."""

    beds: tuple[Bed, ...]
    """Beds of the seeds that have been run with the chosen pour."""
    needed: tuple[Case, ...]
    """Cases to run next."""
    errors: tuple[str, ...]
    """Messages of cases that did not run to their end."""


class Campaign:
    """Groups of cases and the folder that stores them.

    Args:
        groups: The groups to run.
        store: The folder of cases.

    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> group = Group(case, seeds=3)
    >>> campaign = Campaign([group], Store("no-such-folder"))
    >>> campaign.outcome(group).needed == (case,)  # its bed must be level before other seeds are poured
    True
    """

    def __init__(self, groups: Sequence[Group], store: Store) -> None:
        self.groups, self.store = tuple(groups), store
        self._errors: dict[str, str] = {}
        self._beds: dict[str, Bed] = {}

    def outcome(self, group: Group) -> Outcome:
        """Return the state of a group, from disk and from failures of this campaign.

        Args:
            group: One of the campaign's groups.
        """
        tried: list[Bed] = []
        for case in self._trials(group.case, tried):
            if (error := self._errors.get(case.name)) is not None:
                return Outcome(beds=(), needed=(), errors=(error,))
            bed = self._bed(case)
            if bed is None:
                return Outcome(beds=(), needed=(case,), errors=())
            tried.append(bed)
        taken = min(tried, key=lambda bed: abs(bed.unevenness)).case
        cases = [replace(taken, seed=group.case.seed + number) for number in range(group.seeds)]
        beds = [self._bed(case) for case in cases]
        errors = tuple(self._errors[case.name] for case in cases if case.name in self._errors)
        needed = [case for case, bed in zip(cases, beds, strict=True) if bed is None and case.name not in self._errors]
        return Outcome(tuple(bed for bed in beds if bed is not None), tuple(needed), errors)

    def _trials(self, case: Case, tried: list[Bed]) -> Iterator[Case]:
        """Yield the first seed with one spread after another until its bed is level; ``tried`` grows in between."""
        yield case
        for _ in range(ROUNDS - 1):
            if abs(tried[-1].unevenness) <= LEVEL_ENOUGH:
                return
            yield replace(case, spread=_next_spread([(bed.case.spread, bed.unevenness) for bed in tried]))

    def _bed(self, case: Case) -> Bed | None:
        """Read a bed from disk, once."""
        if case.name not in self._beds:
            bed = self.store.read(case)
            if bed is None:
                return None
            self._beds[case.name] = bed
        return self._beds[case.name]

    def write(self) -> list[Case]:
        """Write the cases to run next, without running them, and return them."""
        needed = [case for group in self.groups for case in self.outcome(group).needed]
        for case in needed:
            self.store.write(case)
        return needed

    def run(self, engine: Engine, pool: Pool, report_progress: Callable[[int, int], None]) -> None:
        """Run all cases that are needed.

        Args:
            engine: Runs a case in its folder.
            pool: Where cases run. Workers of a Dask scheduler need the folder of the cases under the same path.
            report_progress: Called with the number of cases that are done and the number known to be needed, at the
                start and after each case.

        A case that fails is reported in the :class:`Outcome` of its group; the others go on.
        """
        with pool.workers() as workers:
            try:
                self._run_all(workers.executor, engine, report_progress)
            except BaseException:  # interrupted: threads would wait for what runs
                workers.executor.shutdown(wait=False, cancel_futures=True)
                engine.stop()
                raise

    def _run_all(self, executor: Executor, engine: Engine, report_progress: Callable[[int, int], None]) -> None:
        started: set[str] = set()
        running: dict[Future[None], Case] = {}
        while True:
            outcomes = [self.outcome(group) for group in self.groups]
            for case in (case for outcome in outcomes for case in outcome.needed):
                if case.name not in started:
                    started.add(case.name)
                    running[executor.submit(run_case, self.store, engine, case)] = case
            report_progress(len(started) - len(running), len(started) + self._waiting(outcomes))
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                case = running.pop(future)
                try:
                    future.result()
                except (RunError, UsageError, OutputError, WriteError, OSError) as error:
                    self._errors[case.name] = f"{case.name}: {error}"

    def _waiting(self, outcomes: Sequence[Outcome]) -> int:
        """Count the cases that wait for a level pour of their group."""
        return sum(
            group.seeds - 1
            for group, outcome in zip(self.groups, outcomes, strict=True)
            if not outcome.beds and outcome.needed
        )


def run_case(store: Store, engine: Engine, case: Case) -> None:
    """Run a case in its folder.

    Args:
        store: Where the folder is.
        engine: Runs it.
        case: The case.

    Raises:
        RunError: It failed, or has not written all results.
        OutputError: Another process runs it.
    """
    folder = store.write(case)
    with held_folder(folder, str(folder)):
        engine.run(folder)
    if store.read(case) is None:
        raise RunError(f"LAMMPS ended without writing all results. Is the disk full? See {folder}")


def expected_seconds(campaign: Campaign) -> tuple[int, float]:
    """Estimate the number of cases to run, and their time on one core.

    For a group without a level pour that is one case more than it has seeds.

    Args:
        campaign: The campaign, of which only what is not on disk must be run.

    Returns:
        Number of cases, and seconds, roughly.

    >>> case = Case(base=0.2, lengths=(), inclinations=(), area=0.01, friction=0.75, pour="rain", seed=1)
    >>> count, seconds = expected_seconds(Campaign([Group(case, seeds=3)], Store("no-such-folder")))
    >>> count, f"{seconds:.0f} s"
    (4, '7 s')
    """
    left = []
    for group in campaign.groups:
        outcome = campaign.outcome(group)
        if outcome.needed:
            left.append((group.case, len(outcome.needed) if outcome.beds else group.seeds + 1))
    work = sum(number * steps(case) * case.count for case, number in left)
    return sum(number for _, number in left), work / PARTICLE_STEPS_PER_SECOND


def _next_spread(tried: Sequence[tuple[float, float]]) -> float:
    """Estimate the spread that makes the bed level by the secant through the last two pours.

    After the first pour the slope is taken as 1: without any sliding, a bed poured with spread e ends uneven by e.

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
