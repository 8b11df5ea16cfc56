"""Which values of some keys give what is wanted: all solutions within bounds."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from reprlib import repr as short
from typing import Any

from chutecalc.api.chute import Chute, check_chute
from chutecalc.errors import UsageError
from chutecalc.results.described import outcomes
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.aim.bracket import bracketed_roots
from chutecalc.studies.aim.line import dead_targets, line_text
from chutecalc.studies.aim.misses import RTOL, Misses
from chutecalc.studies.aim.refine import refined, refined_roots
from chutecalc.studies.found import Found, solved
from chutecalc.studies.keys import Key, key_arguments, read_keys
from chutecalc.studies.sweep.checks import selected_columns
from chutecalc.studies.variants import Variants
from chutecalc.workers import Threads

MOST = 50
"""Most solutions; more lie on a line or a plane, and there is no end of them."""


@dataclass(frozen=True, repr=False, eq=False)
class Aim(Found):
    """All solutions of an aim, in the order of the first key."""

    targets: dict[str, float]
    """What was wanted, by name of the column."""
    nearest: Found | None
    """Where there is no solution: the design that comes closest; None where no design gets through."""
    tried: str
    """How the designs of the search end, as text."""

    def _described(self) -> str:
        """Return what was found, as text."""
        wanted = ", ".join(f"{name} = {value:g}" for name, value in self.targets.items())
        count = f"{self.count} solution{'' if self.count == 1 else 's'}" if self.count else "no solution"
        return f"Aim at {wanted}: {count}"

    def document(self) -> dict[str, Any]:
        """Return the aim, its solutions and the outcome of each; without any the design that comes closest."""
        found = {"targets": self.targets, "case": self.states[0], "tried": self.tried} | super().document()
        if self.nearest is None:
            return found | {"nearest": None}
        nearest = self.nearest.document()
        return found | {"nearest": {"values": nearest["solutions"][0], "outcome": nearest["outcome"][0]}}


def aim(
    chute: Chute,
    keys: Mapping[str, Any],
    targets: Mapping[str, float],
    case: str = DESIGN_POINT,
    columns: Sequence[str] = (),
    jobs: int | None = None,
) -> Aim:
    """Find all values of some keys, within bounds, with which a chute gives what is wanted.

    Args:
        chute: a chute of one design.
        keys: bounds ``(low, high)`` by spec path, in the unit of the path, or by a short name of sweeps.
        targets: wanted values by name of a column of sweeps, as many as there are keys.
        case: name of the operating state that is to meet them; ``design`` for the spec as written.
        columns: names of further columns of the outcome; those that a sweep shows if left out.
        jobs: number of threads; one for each core by default.

    Returns:
        The solutions, each of which meets the targets to 1e-9.

    Raises:
        UsageError: keys and targets do not go together, or there is no end of solutions.
        SpecError: a path is not in the spec, or a bound is not a value that it takes.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER)
    >>> found = chutecalc.aim(spoon, {"segments.spoon.radius_m": (1, 4)}, {"exit_velocity_m_s": 6.0})
    >>> found, found.values["segments.spoon.radius_m"].round(4)
    (<Aim at exit_velocity_m_s = 6: 1 solution>, array([2.6297]))
    """
    check_chute(chute)
    return find_aim(chute, read_keys(key_arguments(keys), chute), targets, case, columns, jobs)


def find_aim(
    chute: Chute,
    keys: Sequence[Key],
    targets: Mapping[str, float],
    case: str = DESIGN_POINT,
    columns: Sequence[str] = (),
    jobs: int | None = None,
) -> Aim:
    """Find all solutions of an aim, see :func:`aim`.

    Args:
        chute: as there.
        keys: what may change.
        targets: as there.
        case: as there.
        columns: as there.
        jobs: as there.
    """
    _check(keys, targets)
    parameters, states = [key.parameter for key in keys], (case,)
    missing = Variants(chute, parameters, list(targets), states, RTOL, Threads(jobs))
    if texts := [name for name in targets if name in missing.sweep.texts]:
        raise UsageError(f"{', '.join(texts)}: a target needs a column of numbers")
    misses = Misses(missing, keys, targets)
    if len(keys) == 1:
        places = bracketed_roots(lambda places: misses(places[:, None])[:, 0])[:, None]
    else:
        places = refined_roots(misses, len(keys))
    places = misses.met(places)
    dead = dead_targets(misses, places[:MOST]) if len(keys) > 1 and len(places) else None
    if dead is not None:
        raise UsageError(line_text([*targets], dead))
    if len(places) > MOST:
        raise UsageError(
            f"{', '.join(targets)}: more than {MOST} solutions, so they lie side by side without end. Choose keys"
            " that change the target"
        )
    shown = [*targets, *(name for name in columns or selected_columns([], chute, False) if name not in targets)]
    outcome = Variants(chute, parameters, [*shown, "warnings"], states, RTOL, Threads(jobs))
    nearest = None
    if not len(places) and len(misses.closest):
        refined(misses, misses.closest)  # which takes note of the closest
        nearest = Found(chute, tuple(keys), states, *solved(outcome, keys, misses.rounded(misses.closest)))
    found = solved(outcome, keys, misses.rounded(places))
    return Aim(chute, tuple(keys), states, *found, dict(targets), nearest, outcomes(misses.statuses))


def _check(keys: Sequence[Key], targets: Mapping[str, float]) -> None:
    """Check that there are as many targets as keys, all of numbers.

    Raises:
        UsageError: there are not.
    """
    if not isinstance(targets, Mapping):
        raise UsageError(f'give wanted values by column, such as {{"exit_velocity_m_s": 4}}, not {short(targets)}')
    for name, wanted in targets.items():
        if not isinstance(wanted, int | float) or not isfinite(wanted):
            raise UsageError(f"{name} must be a number, not {wanted!r}")
    if len(keys) != len(targets):
        raise UsageError(
            f"{len(keys)} key{'s' * (len(keys) != 1)} for {len(targets)} target{'s' * (len(targets) != 1)}:"
            f" an aim takes as many keys as targets. Given: {', '.join(key.name for key in keys)} for"
            f" {', '.join(targets) or 'nothing'}"
        )
    for key in keys:
        if not key.is_continuous:
            raise UsageError(f"{key.name}: an aim needs bounds, {key.name}=LOW:HIGH")
