"""A chute in several operating states on the same steel: what each gives, and which of them is worst in what."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.results.described import html_table, number, outcomes
from chutecalc.results.finding import Finding, Severity
from chutecalc.results.measures import MEASURES, Measure
from chutecalc.results.solved import SolvedChute

ABSENT, LEAST_BAD = -np.inf, -1e30
"""Badness of a finding that a state does not have, and the least of one that it has."""
ALIKE = 1e-9
"""Relative difference of two numbers of which neither is worse: what rounding and tolerances leave."""
_SAME = ("code", "subject", "severity", "template")
"""What findings of two states have in common if only their numbers differ."""


class Cases:
    r"""The solutions of a chute in all its operating states, the design point first.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[cases.surge]\n"flow.rate_t_h" = 1500')
    >>> cases = chutecalc.solve_cases(spoon)
    >>> cases.names, cases.worst["max_depth_m"].tolist()
    (['design', 'surge'], ['surge'])
    """

    def __init__(self, solutions: Mapping[str, SolvedChute]) -> None:
        """Take the solutions.

        Args:
            solutions: by name of the state, the one to show in full first, all of the same number of designs.
        """
        self.solutions = dict(solutions)
        """Solution of each state by its name."""
        self.main = next(iter(self.solutions))
        """Name of the state that is shown in full: the design point, unless a user chose another."""

    @property
    def names(self) -> list[str]:
        """Names of the states; ``design`` is the spec as written."""
        return list(self.solutions)

    @property
    def main_solution(self) -> SolvedChute:
        """The solution of the state that is shown in full."""
        return self[self.main]

    def __getitem__(self, name: str) -> SolvedChute:
        """Return the solution of a state.

        Args:
            name: of the state.

        Raises:
            KeyError: there is no such state.
        """
        try:
            return self.solutions[name]
        except KeyError:
            raise KeyError(f"there is no case {name!r}: the chute has {', '.join(self.names)}") from None

    @cached_property
    def numbers(self) -> dict[str, Array]:
        """What states are compared by: arrays of shape (states, designs) by column name, NaN where there is none."""
        found = {}
        for measure in MEASURES:
            values = [(measure.of(solution), solution.count) for solution in self.solutions.values()]
            found[measure.column.name] = np.stack(
                [np.full(count, np.nan) if each is None else np.broadcast_to(each, count) for each, count in values]
            )
        return {name: values for name, values in found.items() if not np.isnan(values).all()}

    @cached_property
    def worst(self) -> dict[str, Any]:
        """Name of the worst state for each design, by column name; under ``status`` the first that fails.

        Text of shape (designs,), empty where there is none.
        """
        failing = np.stack([~solution.ok for solution in self.solutions.values()])
        found = {"status": self._named(failing.argmax(axis=0), failing.any(axis=0))}
        for measure in MEASURES:
            name = measure.column.name
            if measure.badness is not None and name in self.numbers:
                badness = measure.badness(self.numbers[name])
                known = ~np.isnan(badness)  # a state without the number is not better
                least = np.where(known, badness, np.inf).min(axis=0)
                badness = np.where(known, badness, -np.inf)
                largest = badness.max(axis=0)
                spread = (largest > least) & ~np.isclose(largest, least, rtol=ALIKE, atol=0.0)
                found[name] = self._named(badness.argmax(axis=0), spread)
        return found

    def _named(self, state: Index, known: Any) -> Any:
        return np.where(known, np.array(self.names)[state], "")

    @cached_property
    def _found(self) -> dict[str, list[Finding]]:
        """All findings by the name of the state."""
        return {name: solution.findings() for name, solution in self.solutions.items()}

    def findings(self, name: str) -> list[Finding]:
        """Return what a state has to tell beside the one shown in full.

        Those are the failures that that one does not have, and the warnings and notes that are worst in this state.

        Args:
            name: of the state.
        """
        own, told = self[name], []
        number = self.names.index(name)
        for finding in self._found[name] if own is not self.main_solution else ():
            badness = np.stack([self._badness(state, finding) for state in self.names])
            news = badness[0] == ABSENT if finding.severity == Severity.FAILURE else badness.argmax(axis=0) == number
            if (mask := finding.mask & news).any():
                told.append(replace(finding, mask=mask))
        return told

    def states_with(self, finding: Finding, design: int = 0) -> list[str]:
        """Return the names of the states that have a finding, whatever its numbers are there.

        Args:
            finding: of any state.
            design: index of the design, from 0.
        """
        return [name for name in self.names if self._badness(name, finding)[design] > ABSENT]

    def _badness(self, name: str, finding: Finding) -> Array:
        """Return how bad a finding is in a state, shape (designs,), with so few digits that rounding does not count."""
        worst = np.full(finding.mask.shape, ABSENT)
        for same in self._found[name]:
            if all(getattr(same, field) == getattr(finding, field) for field in _SAME):
                worst = np.where(same.mask, np.fmax(worst, np.fmax(same.badness, LEAST_BAD)), worst)
        return worst.astype(np.float32)

    def __repr__(self) -> str:
        ends = (f"{name} {outcomes(solution.status)}" for name, solution in self.solutions.items())
        return f"<Cases: {'; '.join(ends)}>"

    def _repr_html_(self) -> str:
        """Return a table of the states, for notebooks."""
        headings = ["case", "status", *(f"{m.column.heading}, {m.column.unit_text('metric')}" for m in self.measures)]
        rows = []
        for k, (name, solution) in enumerate(self.solutions.items()):
            values = (number(self.numbers[measure.column.name][k]) for measure in self.measures)
            rows.append([name, outcomes(solution.status), *values])
        return html_table(repr(self).strip("<>"), headings, rows)

    @property
    def measures(self) -> list[Measure]:
        """What these states can be compared by."""
        return [measure for measure in MEASURES if measure.column.name in self.numbers]
