"""Random chutes as many as one likes: ``python -m tests.robustness.many --chutes 1000000``.

Each random spec is read and solved by itself, and all that is told of it is checked; most chutes are variants of one,
solved together, with up to four of its numbers drawn anew within their bounds. Prints how many were tried, what came of
them, and which took longest; what fails is saved as a spec.
"""

import argparse
import sys
import time
import warnings
from collections import Counter
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

import chutecalc
from chutecalc.spec.given import Given, given_quantities
from tests import seeds
from tests.robustness.chutes import Maker
from tests.robustness.faults import check_faults
from tests.robustness.holds import alone, check, check_told, check_variants

TOLD = 10
"""Specs of which one has its report and its files checked too: that takes as long as all the rest."""
VARIANTS = 150
"""Chutes of one random spec."""
MOST = 0.1
"""Seconds that no design may take; one that does is saved."""
SLOW = 0.02
"""Seconds of a batch from which on its designs are solved one by one, to find a slow one among them."""


class Tally:
    """What was tried, and what came of it."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.specs, self.undecided = folder, 0, 0
        self.outcomes: Counter[str] = Counter()
        self.faults: list[str] = []
        self.slowest: list[tuple[float, str]] = []

    def fault(self, error: BaseException, data: dict[str, Any], name: str) -> None:
        """Note a fault, and save its spec."""
        self.faults.append(f"{name}: {type(error).__name__} {str(error)[:200]}")
        self.save({"title": f"{name}: {type(error).__name__}"} | data, name)
        sys.stdout.write(f"{self.faults[-1]}\n")
        sys.stdout.flush()

    def save(self, data: dict[str, Any], name: str) -> None:
        """Save a spec."""
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / f"{name}.toml").write_text(tomli_w.dumps(data), encoding="utf-8")

    def took(self, seconds: float, name: str) -> None:
        """Note the time of a design, s."""
        self.slowest = sorted([*self.slowest, (seconds, name)])[-3:]

    def lines(self) -> list[str]:
        """The figures, as people read them."""
        refused = self.outcomes["refused"]
        tried = self.outcomes.total()
        ends = ", ".join(f"{count:,} {name}" for name, count in self.outcomes.most_common() if name != "refused")
        slow = ", ".join(f"{1000.0 * seconds:.0f} ms ({name})" for seconds, name in reversed(self.slowest))
        return [
            f"{tried:,} chutes of {self.specs:,} specs: {refused:,} refused, {ends}",
            f"{len(self.faults)} faults; {self.undecided} creep at less than 1 mm/s, or the last digit decides them",
            f"slowest: {slow}",
        ]


def run(chutes: int, first: int, folder: Path) -> Tally:
    """Try so many chutes, from a seed on."""
    tally, number = Tally(folder), first
    with suppress(KeyboardInterrupt):  # Ctrl-C ends a long run, and it still prints its figures
        while tally.outcomes.total() < chutes:
            try_spec(tally, number)
            number += 1
    return tally


def try_spec(tally: Tally, number: int) -> None:
    """Draw a spec and variants of it, each by its own seed, and check what comes of them."""
    maker, name = Maker(seeds.generator(number)), f"spec_{number}"
    data = maker.chute()
    tally.specs += 1
    try:
        chute = chutecalc.parse(data)
        solution, seconds = timed(chute)
        tally.took(seconds, name)
        check(solution)
        tally.outcomes[str(solution.status[0])] += 1
        if number % TOLD == 0:
            check_told(chute)
    except chutecalc.SpecError as error:
        tally.outcomes["refused"] += 1
        check_faults(error, data)
        return
    except Exception as error:
        tally.fault(error, data, name)
        return
    try_variants(tally, chute, maker, name)


def try_variants(tally: Tally, chute: chutecalc.Chute, maker: Maker, name: str) -> None:
    """Solve variants of a chute together."""
    given = [one for one in given_quantities(chute.spec, chute.data) if not one.quantity.shape and varies(one)]
    chosen = [given[k] for k in maker.random.permutation(len(given))[: maker.random.integers(1, 5)]]
    maker.usual = False
    changes = {one.path: np.array([maker.number(one.key, one.quantity) for _ in range(VARIANTS)]) for one in chosen}
    try:
        variants, refused = possible(chute, changes)
        tally.outcomes["refused"] += refused
        if variants is None:
            return
        began = time.process_time()
        status = chutecalc.exits(variants, columns=("velocity_m_s",), jobs=1).status
        if time.process_time() - began > SLOW:
            for k in range(variants.count):
                one = chute.vary({path: each[k : k + 1] for path, each in changes.items()})
                tally.took(timed(one)[1], f"{name}, variant {k}")
                if tally.slowest[-1][0] > MOST and tally.slowest[-1][1] == f"{name}, variant {k}":
                    tally.save(alone(one.data, 0), f"{name}_{k}_slow")
        tally.outcomes.update(status.tolist())
        tally.undecided += check_variants(variants)
    except chutecalc.SpecError:  # rules between keys that no single design tells of
        tally.outcomes["refused"] += VARIANTS
    except Exception as error:
        values = {path: each.tolist() for path, each in changes.items()}
        tally.fault(error, chute.data | {"title": f"varied: {values}"}, f"{name}_varied")


def varies(given: Given) -> bool:
    """Whether a number is the chute's own, rather than that of a case."""
    return given.path.split(".")[0] not in ("cases", "uncertainty", "limits")


def possible(chute: chutecalc.Chute, changes: dict[str, Any]) -> tuple[chutecalc.Chute | None, int]:
    """Return those variants that are chutes, and how many are refused, whose numbers are taken out of the changes."""
    refused = 0
    for _ in range(20):
        try:
            variants = chute.vary(changes)
            chutecalc.exits(variants, columns=("velocity_m_s",), jobs=1)
        except chutecalc.SpecError as error:
            if error.designs is None:
                raise
            count = len(next(iter(changes.values())))
            keep = ~np.broadcast_to(error.designs, count)
            refused += int(count - keep.sum())
            changes.update({path: each[keep] for path, each in changes.items()})
            if not keep.any():
                break
        else:
            return variants, refused
    return None, refused


def timed(chute: chutecalc.Chute) -> tuple[chutecalc.Solution, float]:
    """Solve a chute; the time of its processor, s, and the shorter of two where it is long, for what else runs."""
    began = time.process_time()
    solution = chutecalc.solve(chute)
    seconds = time.process_time() - began
    if seconds > SLOW:
        began = time.process_time()
        chutecalc.solve(chute)
        seconds = min(seconds, time.process_time() - began)
    return solution, seconds


def main() -> int:
    """Read the command line, and print the figures."""
    parser = argparse.ArgumentParser(prog="python -m tests.robustness.many", description=__doc__)
    parser.add_argument("--chutes", type=int, default=10_000, help="how many to try at least")
    parser.add_argument("--seed", type=int, default=0, help="number of the first spec; each has its own")
    parser.add_argument("--save", type=Path, default=Path("found"), help="folder for specs that fail")
    options = parser.parse_args()
    began = time.perf_counter()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tally = run(options.chutes, options.seed, options.save)
    last = f"{time.perf_counter() - began:.0f} s, specs {options.seed} to {options.seed + tally.specs - 1}"
    sys.stdout.write("\n".join([*tally.lines(), last, ""]))
    return 1 if tally.faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
