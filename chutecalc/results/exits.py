"""The stream at the end of designs, and what it does to the belt that it goes to."""

from collections.abc import Sequence
from typing import NamedTuple

from chutecalc.design import Design, stretched
from chutecalc.physics.arrays import Array, Index
from chutecalc.results.belts import TAKEN, received
from chutecalc.results.solution import Solution
from chutecalc.results.trajectory import Numbers, asked, at_exit
from chutecalc.solver.chain import run_chain, run_ends
from chutecalc.solver.course import kinds_of, numbers_of


class Exits(NamedTuple):
    """The ends of n designs; arrays of shape (designs,), NaN in the numbers of those that fail."""

    codes: Index
    """The :class:`~chutecalc.design.Status` of each design."""
    error_estimate: Array
    """Of the last velocity, relative; after a stall of its place, as a share of the segment."""
    exit: Numbers
    """The stream at the end of the chute, by column name."""
    receiver: Numbers
    """What it does to the belt there, as :attr:`chutecalc.results.solution.Solution.receiver`."""


NOT_AT_EXIT = ("spec", "segment", "kind", "time_s")
"""Columns that there are not at an exit."""


def asked_of(design: Design, names: Sequence[str]) -> list[str]:
    """Columns at the exit that some take, and what the belt does."""
    return [*dict.fromkeys([*names, *(TAKEN if design.receiver else ())])]


def at_ends(design: Design, rtol: float, names: Sequence[str], count: int) -> Exits:
    """Those of designs.

    Args:
        design: of so many designs as ``count`` says.
        rtol: as of :func:`chutecalc.solve`.
        names: of columns, without time.
        count: how many.
    """
    taken = asked_of(design, names)
    if design.segments[-1].deflects:  # where the stream is as the impact on it leaves it
        legs, ends = run_chain(design, rtol, complete=False)
        found = Solution(design, tuple(legs), ends, rtol, count).exit_columns(taken)
    else:
        ends = run_ends(kinds_of(design), numbers_of(design), rtol, *asked(taken))
        found = at_exit(design, ends, taken)
    belt = received(design, found)

    def whole(numbers: Numbers) -> Numbers:
        return {name: stretched(values, (count,)) for name, values in numbers.items()}

    codes, error = (stretched(values, (count,)) for values in (ends.status, ends.error))
    return Exits(codes, error, whole({name: found[name] for name in names}), whole(belt))


def named(exit_: Numbers, belt: Numbers, error: Array) -> Numbers:
    """The same by the names that columns of sweeps and outputs of functions have."""
    numbers = {f"exit_{name}": values for name, values in exit_.items()}
    return numbers | {f"receiver_{name}": values for name, values in belt.items()} | {"error_estimate": error}
