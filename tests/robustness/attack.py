"""Attack with hostile specs and command lines, and count: ``python -m tests.robustness.attack [SPECS [COMMANDS]]``.

``CHUTECALC_SEED`` sets the seed; a run with the same seed tries the same cases.
"""

import sys
import time
import warnings
from collections import Counter
from collections.abc import Callable
from typing import Any

import hypothesis
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tests import seeds
from tests.robustness.commands import command_lines, judge
from tests.robustness.hostile import contents
from tests.robustness.test_fuzz import judge_content

SPECS, COMMANDS = 10_000, 1000
"""How many there are where nothing is said."""


class Tally:
    """Tries random cases, and counts how they end.

    Args:
        what: the cases are.
    """

    def __init__(self, what: str) -> None:
        self.what = what
        self.ends: Counter[str] = Counter()
        self.faults: dict[str, Any] = {}
        self.slowest, self.seconds = 0.0, 0.0

    def attempt(self, judge: Callable[[Any], str], case: Any) -> None:
        """Judge a case, and note its fault if it has one. Of faults alike the first is kept."""
        start = time.perf_counter()
        try:
            self.ends[judge(case)] += 1
        except Exception as error:
            self.ends["fault"] += 1
            self.faults.setdefault(f"{type(error).__name__}: {str(error)[:200]}", case)
        self.slowest = max(self.slowest, time.perf_counter() - start)

    def __str__(self) -> str:
        count = self.ends.total()
        ends = ", ".join(f"{number:,} {end}" for end, number in sorted(self.ends.items()))
        pace = f"{count / self.seconds:.1f} a second, the slowest {self.slowest:.1f} s"
        return f"{count:,} {self.what} in {self.seconds:.0f} s, {pace}: {ends}; {self.ends['fault']:,} faults"


def attack(what: str, cases: st.SearchStrategy[Any], judge: Callable[[Any], str], count: int) -> Tally:
    """Try random cases.

    Args:
        what: they are.
        cases: where they come from.
        judge: returns how a case ends, and raises where that is a fault.
        count: how many.
    """
    tally, checks = Tally(what), [*HealthCheck]

    @hypothesis.seed(seeds.chosen() or 0)
    @settings(max_examples=count, deadline=None, database=None, phases=[Phase.generate], suppress_health_check=checks)
    @given(cases)
    def attempt(case: Any) -> None:
        tally.attempt(judge, case)

    start = time.perf_counter()
    attempt()
    tally.seconds = time.perf_counter() - start
    return tally


def main() -> int:
    """Attack, print the figures, and return 1 if there are faults."""
    warnings.simplefilter("ignore")
    seeds.settle()
    counts = [*map(int, sys.argv[1:]), *(SPECS, COMMANDS)[len(sys.argv) - 1 :]]
    status = 0
    for what, cases, how, count in (
        ("specs", contents, judge_content, counts[0]),
        ("command lines", command_lines(), lambda line: f"with status {judge(line).status}", counts[1]),
    ):
        if not count:
            continue
        tally = attack(what, cases, how, count)
        sys.stdout.write(f"{tally}\n")
        sys.stdout.flush()
        sys.stdout.writelines(f"  {fault}\n    {case!r}\n" for fault, case in tally.faults.items())
        status |= bool(tally.faults)
    return status


if __name__ == "__main__":
    sys.exit(main())
