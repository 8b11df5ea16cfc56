"""Compare the error estimate of a panel with its error, and find which pair of rules suits which tolerance.

    python benchmarks/estimates.py [--quick] [--out FOLDER]

Each pair of rules solves whole segments in one panel: random ones up to the bounds of every key, as
tests/robustness/test_edges.py draws them, and the spoons of batches.py. The error is that of v² at the exit, compared
with chutecalc's own complete solution at 1e-13, which that test compares with 80-bit numbers; errors below a few 1e-13
say nothing. Panels that do not converge, or contain an event, are left out. The least ratio of estimate to error
matters: below 1 a panel would be accepted that is worse than it claims. The table also has the share of designs whose
panel would be accepted at a tolerance.
"""

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from batches import batch, chute
from measure import Report

from chutecalc.design import Design, Status
from chutecalc.solver.chain import Chain, run_chain
from chutecalc.solver.options import options_with

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.robustness.test_edges import CASES
from tests.robustness.test_edges import batch as edges

PAIRS = ((4, 8), (6, 8), (6, 12), (8, 12), (8, 16), (8, 24), (16, 24))
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13)
ANYHOW = 1e300
"""A tolerance at which every panel that converges is accepted."""
KNOWN = 1e-12
"""Relative error estimate of a velocity up to which it serves as the reference."""
LEAST_ERROR = 3e-13
"""Smaller errors are those of the reference and do not count."""


class Errors(NamedTuple):
    """Errors of v² and their estimates, by pair of rules; arrays of shape (designs,)."""

    error: np.ndarray
    estimate: np.ndarray


def panels(design: Design) -> Iterator[tuple[tuple[int, int], Errors]]:
    """Solve the first segment that a stream enters in contact with each pair of rules."""
    segment_solutions, _ = run_chain(design, 1e-13)
    solved = next(solved for solved in segment_solutions if solved.contact)
    known = (solved.status == Status.OK) & (solved.exit.error < KNOWN)
    for pair in PAIRS:
        found = Chain(design, options_with(pair, (16, 24), ANYHOW, False)).segment_solutions()[solved.number]
        one = known & (found.contact.end.attempts == 1) & (found.contact.end.share == 1.0)
        error = np.abs((found.exit.velocity[one] / solved.exit.velocity[one]) ** 2 - 1.0)
        yield pair, Errors(error, 2.0 * found.exit.error[one])


def main() -> None:
    """Measure and print."""
    report = Report("estimates", __doc__)
    count = 50 if report.quick else 2000
    kinds = {"edges": [edges(*case, count, 7)[0].design for case in CASES], "spoons": [chute(batch(count)).design]}
    rows = []
    for kind, designs in kinds.items():
        found: dict[tuple[int, int], list[Errors]] = {}
        for design in designs:
            for pair, errors in panels(design):
                found.setdefault(pair, []).append(errors)
        for pair, parts in found.items():
            error, estimate = (np.concatenate(column) for column in zip(*parts, strict=True))
            counted = error > LEAST_ERROR
            ratios = np.sort(estimate[counted] / error[counted])
            low = [ratios[min(rank, len(ratios) - 1)] for rank in (0, 1, 2, 5)] if len(ratios) else [np.nan] * 4
            taken = [float(np.mean(estimate <= tolerance)) for tolerance in TOLERANCES]
            rows.append((kind, f"{pair[0]}, {pair[1]}", len(error), int(counted.sum()), *low, *taken))
    header = ["kind", "rules", "segments", "errors counted", "least estimate/error", "2nd", "3rd", "6th"]
    header += [f"taken at {tolerance:.0e}" for tolerance in TOLERANCES]
    report.write(header, rows, ("", "", "", "", *[".2g"] * 4, *[".3f"] * len(TOLERANCES)), by=1)


if __name__ == "__main__":
    main()
