"""The best values of some keys, in the worst of the states that a chute has to serve."""

from collections.abc import Mapping, Sequence
from typing import Any

from chutecalc.api.chute import Chute, check_chute
from chutecalc.errors import UsageError
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.found import solved
from chutecalc.studies.keys import Key, key_arguments, read_keys
from chutecalc.studies.limit import Limit, read_limit
from chutecalc.studies.optimise.answer import KeyAnswer, key_answers
from chutecalc.studies.optimise.binding import binding
from chutecalc.studies.optimise.front import front_places
from chutecalc.studies.optimise.objective import Objective
from chutecalc.studies.optimise.optimum import Optimum
from chutecalc.studies.optimise.problem import Problem
from chutecalc.studies.optimise.search import best_place
from chutecalc.studies.optimise.violation import violations
from chutecalc.studies.sweep.checks import selected_columns
from chutecalc.studies.variants import Variants
from chutecalc.workers import Threads

POINTS, MOST_POINTS = 9, 1000
"""Points of a front, unless a caller says how many, and how many that may be."""


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
        The best design or the designs of the front, and the limits that decide there.

    Raises:
        UsageError: there is no objective, more than two, or a column does not exist.
        SpecError: a path is not in the spec, or a bound is not a value that it takes.

    >>> import chutecalc
    >>> spoon = chutecalc.load("specs/paper/r3_d55_chamfered.toml")
    >>> best = chutecalc.optimise(spoon, {"beta": (20, 85)}, minimise="exit_velocity_m_s")
    >>> best
    <Optimum of exit_velocity_m_s: 3.87493 at chamfer_deg 49.5>
    """
    check_chute(chute)
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
    if points > MOST_POINTS:
        raise UsageError(f"a front has at most {MOST_POINTS} points, not {points}. Use fewer.")
    states = (DESIGN_POINT, *chute.cases) if case is None else (case,)
    problem = Problem(chute, keys, objectives[0], limits, states, no_warnings, jobs, objectives[1:])
    answers: dict[str, KeyAnswer] = {}
    if len(objectives) > 1:
        places, bound = front_places(problem, objectives[1], points, seed)
    else:
        place = problem.rounded(best_place(problem, seed))
        places, bound = place[None], [[]]
    violated = violations(problem, places[0])
    if len(objectives) == 1 and not violated:
        at = binding(problem, places[0])
        bound, answers = [at.binding], key_answers(problem, places[0], at)
    named = [*(each.column for each in objectives), *(limit.column for limit in limits)]
    usual = columns or selected_columns([], chute, False)
    shown = list(dict.fromkeys([*named, *usual, "warnings"]))
    outcome = Variants(chute, [key.parameter for key in keys], shown, states, pool=Threads(jobs))
    found = solved(outcome, keys, places)
    worst = {each.column: each.sign * (each.sign * found[1][each.column]).max(axis=0) for each in objectives}
    wanted = tuple(objectives), tuple(limits), no_warnings
    return Optimum(chute, tuple(keys), states, *found, *wanted, worst, bound, answers, violated)
