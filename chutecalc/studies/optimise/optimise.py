"""The best values of some keys, in the worst of the states that a chute has to serve."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from chutecalc.api.chute import Chute
from chutecalc.errors import UsageError
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.found import Found, solved
from chutecalc.studies.keys import Key, key_arguments, read_keys
from chutecalc.studies.optimise.answer import Binding, KeyAnswer, binding, key_answers
from chutecalc.studies.optimise.front import front_places
from chutecalc.studies.optimise.problem import Limit, Objective, Problem, read_limit
from chutecalc.studies.optimise.search import best_place
from chutecalc.studies.sweep.checks import selected_columns
from chutecalc.studies.variants import Variants
from chutecalc.workers import Threads

POINTS = 9
"""Points of a front."""


@dataclass(frozen=True, repr=False, eq=False)
class Optimum(Found):
    """The best design, or the designs of a front of two objectives."""

    objectives: tuple[Objective, ...]
    """What is minimised or maximised: one, or two of a front."""
    limits: tuple[Limit, ...]
    """What it is subject to, in each state."""
    no_warnings: bool
    """Whether it is subject to having no warnings either."""
    worst: dict[str, Any]
    """Each objective in the worst state, an array of shape (designs,) by column."""
    binding: list[list[Binding]]
    """The limits that bind at each design; for a front in the problem of its first objective."""
    answers: dict[str, KeyAnswer]
    """What is said of each key; empty for a front."""
    violation: float
    """0 where the design is feasible. Otherwise no design that was found is, and this is the one that lacks least."""

    @property
    def feasible(self) -> bool:
        """Whether all limits hold in all states, and no state fails."""
        return self.violation == 0.0

    def _described(self) -> str:
        """Return what was found, as text."""
        if not self.feasible:
            return f"Optimum of {self.objectives[0].column}: no feasible design"
        if len(self.objectives) > 1:
            return f"Front of {' and '.join(each.column for each in self.objectives)}: {self.count} designs"
        (name, value), *_ = self.worst.items()
        keys = ", ".join(
            f"{key} {answer.value:.6g}" if isinstance(answer.value, float) else f"{key} {answer.value}"
            for key, answer in self.answers.items()
        )
        return f"Optimum of {name}: {value[0]:.6g} at {keys}"

    def document(self) -> dict[str, Any]:
        """Return the problem, the best designs and their outcome, what binds, and what is said of the keys."""
        told = {
            "objectives": {each.column: "minimise" if each.sign > 0 else "maximise" for each in self.objectives},
            "subject": [limit.text for limit in self.limits],
            "states": self.states,
            "feasible": self.feasible,
        }
        answers = {
            name: {
                "on_bound": answer.bound or None,
                "slope": None if np.isnan(answer.slope) else answer.slope,
                "within_1_per_cent": list(answer.range),
            }
            for name, answer in self.answers.items()
        }
        bound = [
            [{"limit": b.limit, "state": b.state, "price": None if np.isnan(b.price) else b.price} for b in each]
            for each in self.binding
        ]
        worst = {name: values.tolist() for name, values in self.worst.items()} if self.feasible else {}
        return told | super().document() | {"worst": worst, "binding": bound, "keys_at_optimum": answers}


def optimise(
    chute: Chute,
    keys: Mapping[str, Any],
    minimise: str | Sequence[str] = (),
    maximise: str | Sequence[str] = (),
    subject: Sequence[str] = (),
    case: str | None = None,
    no_warnings: bool = False,
    columns: Sequence[str] = (),
    points: int = POINTS,
    seed: int = 0,
    jobs: int | None = None,
) -> Optimum:
    """Find the best values of some keys, in the worst of all states, or the front of two objectives.

    No failure in any state is always a limit.

    Args:
        chute: a chute of one design.
        keys: by spec path or short name, in the unit of the path: bounds ``(low, high)``, bounds and a step, or a list
            of numbers or names to choose from.
        minimise: column of sweeps that is to be small.
        maximise: column that is to be large. Two columns in all make a front.
        subject: limits, ``COLUMN<=VALUE`` or ``COLUMN>=VALUE``, that hold in each state.
        case: name of the only state that counts; all ``[cases]`` and the design point if left out.
        no_warnings: whether warnings are not allowed either.
        columns: names of further columns of the outcome; those that a sweep shows if left out.
        points: number of points of a front.
        seed: of what is random in the search.
        jobs: number of threads; one for each core by default.

    Returns:
        The best design or the designs of the front, and what binds there.

    Raises:
        UsageError: there is no objective, more than two, or a column does not exist.
        SpecError: a path is not in the spec, or a bound is not a value that it takes.

    >>> import chutecalc
    >>> spoon = chutecalc.load("specs/paper/r3_d55_chamfered.toml")
    >>> best = chutecalc.optimise(spoon, {"beta": (20, 85)}, minimise="exit_velocity_m_s")
    >>> best
    <Optimum of exit_velocity_m_s: 3.87493 at chamfer_deg 49.5008>
    """
    wanted = objectives_of(minimise, maximise)
    limits = [read_limit(text) for text in ([subject] if isinstance(subject, str) else subject)]
    found = read_keys(key_arguments(keys), chute)
    return find_optimum(chute, found, wanted, limits, case, no_warnings, columns, points, seed, jobs)


def objectives_of(minimise: str | Sequence[str], maximise: str | Sequence[str]) -> list[Objective]:
    """Return the objectives.

    Args:
        minimise: columns that are to be small.
        maximise: columns that are to be large.

    Raises:
        UsageError: there is none, or there are more than two.
    """
    small, large = ([each] if isinstance(each, str) else list(each) for each in (minimise, maximise))
    found = [*(Objective(name, 1.0) for name in small), *(Objective(name, -1.0) for name in large)]
    if not 1 <= len({each.column for each in found}) == len(found) <= 2:
        raise UsageError("give one column to minimise or to maximise, or two different ones for a front")
    return found


def find_optimum(
    chute: Chute,
    keys: Sequence[Key],
    objectives: Sequence[Objective],
    limits: Sequence[Limit],
    case: str | None = None,
    no_warnings: bool = False,
    columns: Sequence[str] = (),
    points: int = POINTS,
    seed: int = 0,
    jobs: int | None = None,
) -> Optimum:
    """Find an optimum or a front, see :func:`optimise`.

    Args:
        chute: as there.
        keys: what may change.
        objectives: one, or two for a front.
        limits: that hold in each state.
        case: as there.
        no_warnings: as there.
        columns: as there.
        points: as there.
        seed: as there.
        jobs: as there.
    """
    states = (DESIGN_POINT, *chute.cases) if case is None else (case,)
    problem = Problem(chute, keys, objectives[0], limits, states, no_warnings, jobs)
    answers: dict[str, KeyAnswer] = {}
    if len(objectives) == 1:
        places = problem.rounded(best_place(problem, seed)[None])
        binds = [binding(problem, places[0])]
    else:
        places, binds = front_places(problem, objectives[1], points, seed)
        places = problem.rounded(places)
    violation = float(problem.rows(places).violation.min())
    if len(objectives) == 1 and violation == 0.0:
        answers = key_answers(problem, places[0], binds[0][1])
    named = [*(each.column for each in objectives), *(limit.column for limit in limits)]
    usual = columns or selected_columns([], chute, False)
    shown = list(dict.fromkeys([*named, *usual, "warnings"]))
    outcome = Variants(chute, [key.parameter for key in keys], shown, states, pool=Threads(jobs))
    found = solved(outcome, keys, places)
    worst = {each.column: each.sign * (each.sign * found[1][each.column]).max(axis=0) for each in objectives}
    bound = [each for each, _ in binds]
    return Optimum(
        chute,
        tuple(keys),
        states,
        *found,
        tuple(objectives),
        tuple(limits),
        no_warnings,
        worst,
        bound,
        answers,
        violation,
    )
