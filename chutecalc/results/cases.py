"""A chute in several operating states on the same steel: what each gives, and which of them is worst in what."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array, Index
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import html_table, number, outcomes
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Finding
from chutecalc.results.solved import SolvedChute


class Measure(NamedTuple):
    """A number by which operating states are compared."""

    column: Column
    source: str
    """Column of the catalogue that it is taken from."""
    badness: Any
    """Function of its values, the larger the worse; None where neither direction is."""


def _extreme(prefix: str, name: str, badness: Any) -> Measure:
    column = COLUMNS[name]
    known = replace(column, name=f"{prefix}_{name}", heading=f"{prefix} {column.heading}")
    return Measure(known, name, badness)


def _received(name: str, badness: Any) -> Measure:
    return Measure(replace(RECEIVER_COLUMNS[name], name=f"receiver_{name}"), name, badness)


MEASURES = (
    _extreme("exit", "velocity_m_s", None),
    _extreme("min", "velocity_m_s", np.negative),
    _extreme("max", "depth_m", np.positive),
    _extreme("max", "fill", np.positive),
    _extreme("max", "pressure_kpa", np.positive),
    _extreme("max", "wear_w_m2", np.positive),
    _extreme("min", "sliding_life_h", np.negative),
    _received("velocity_ratio", lambda ratio: np.abs(ratio - 1.0)),
    _received("velocity_into_m_s", np.positive),
)
"""What states are compared by, in this order."""
_SIGNS = {"min": LEAST, "max": LARGEST}


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
        per_state = [_numbers(solution) for solution in self.solutions.values()]
        found = {
            measure.column.name: np.stack([numbers[measure.column.name] for numbers in per_state])
            for measure in MEASURES
        }
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
                badness = np.where(np.isnan(badness), -np.inf, badness)
                spread = badness.max(axis=0) > badness.min(axis=0)
                found[name] = self._named(badness.argmax(axis=0), spread)
        return found

    def _named(self, state: Index, known: Any) -> Any:
        return np.where(known, np.array(self.names)[state], "")

    def findings(self, name: str) -> list[Finding]:
        """Return the findings of a state that the one shown in full does not have.

        Args:
            name: of the state.
        """
        known = {(finding.code, finding.segment, finding.severity) for finding in self.main_solution.findings()}
        return [
            finding
            for finding in self[name].findings()
            if (finding.code, finding.segment, finding.severity) not in known
        ]

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


def _numbers(solution: SolvedChute) -> dict[str, Array]:
    """Return the numbers of one state by column name, each of shape (designs,)."""
    none = np.full(solution.count, np.nan)
    extremes_of = [(m.source, _SIGNS[m.column.name[:3]]) for m in MEASURES if m.column.name[:3] in _SIGNS]
    extremes = solution.trajectory.extreme_columns(extremes_of)
    found = {}
    for measure in MEASURES:
        name = measure.column.name
        if name.startswith("exit_"):
            found[name] = solution.exit_columns((measure.source,))[measure.source]
        elif name.startswith("receiver_"):
            found[name] = solution.receiver.get(measure.source, none)
        else:
            found[name] = np.broadcast_to(extremes[measure.source, _SIGNS[name[:3]]], solution.count)
    return found
