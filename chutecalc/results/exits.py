"""The stream at the end of many designs, without what lies before it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from chutecalc.design import Contact, Design, Status, stretched
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.belts import receiver_numbers
from chutecalc.results.columns import COLUMNS
from chutecalc.results.described import html_table, number, outcomes, status_text
from chutecalc.results.segment_context import SegmentContext
from chutecalc.results.stream_column import Needs
from chutecalc.results.trajectory import Trajectory
from chutecalc.solver.chain import run_chain, run_ends
from chutecalc.solver.chain_input import design_rows, layout_of
from chutecalc.solver.contact_profile import EndContactProfile
from chutecalc.solver.flight_profile import EndFlightProfile
from chutecalc.solver.segment_solution import Ends


@dataclass(frozen=True, repr=False, eq=False)
class Exits:
    """The ends of n designs; arrays of shape (designs,), NaN in the numbers of those that fail."""

    status: Any
    """``ok``, ``stall``, ``choke``, ``contact_lost`` or ``missed`` for each design, as text."""
    ok: Mask
    """Whether the stream of each design reaches the end of the chute."""
    error_estimate: Array
    """Estimated relative error of the last velocity; after a stall that of its position, as a share of the segment's
    length."""
    exit: Numbers
    """The stream at the end of the chute, by column name."""
    receiver: Numbers
    """What it does to the receiving belt, as :attr:`chutecalc.Solution.receiver`; empty without one."""

    def __repr__(self) -> str:
        """Return how many designs end how.

        >>> import chutecalc
        >>> chutecalc.exits(chutecalc.parse(chutecalc.STARTER))
        <Exits of 1 design: 1 ok>
        """
        return f"<{self._described()}>"

    def _repr_html_(self) -> str:
        """Return a table of the columns, for notebooks: of several designs their ranges."""
        named = {"exit": self.exit, "receiver": self.receiver}
        rows = [(part, name, number(values)) for part, numbers in named.items() for name, values in numbers.items()]
        return html_table(self._described(), ("", "column", "value" if len(self.ok) == 1 else "range"), rows)

    def _described(self) -> str:
        """Return how many designs end how, as text."""
        count = len(self.ok)
        return f"Exits of {count} design{'s' if count != 1 else ''}: {outcomes(self.status)}"


def solve_exits(design: Design, rtol: float, names: Sequence[str], count: int) -> Exits:
    """Solve designs for their exits.

    Args:
        design: the chutes.
        rtol: as for :func:`chutecalc.solve`.
        names: of columns at the exit, among :data:`chutecalc.results.columns.AT_EXIT`.
        count: number of designs.
    """
    if design.segments[-1].may_end_elsewhere:
        segment_solutions, ends = run_chain(design, rtol, dense_output=False)
        found = Trajectory(design, segment_solutions, ends, count).exit_columns(names)
    else:
        ends = run_ends(layout_of(design), design_rows(design), rtol, *exit_needs(names))
        found = at_exit(design, ends, names)
    belt = receiver_numbers(design, ends)

    def whole(numbers: Numbers) -> Numbers:
        return {name: stretched(values, (count,)) for name, values in numbers.items()}

    status_numbers, error = (stretched(values, (count,)) for values in (ends.status, ends.error))
    return Exits(
        status=status_text(status_numbers),
        ok=status_numbers == Status.OK,
        error_estimate=error,
        exit=whole(found),
        receiver=whole(belt),
    )


def at_exit(design: Design, ends: Ends, names: Iterable[str]) -> Numbers:
    """Return columns at the end of the chute.

    Args:
        design: the chutes.
        ends: how they end, solved with what :func:`exit_needs` gives for these columns.
        names: of columns, among :data:`chutecalc.results.columns.AT_EXIT`.

    Returns:
        Arrays of shape (designs,) by name, NaN where a design fails.
    """
    last = design.segments[-1]
    context, ok = SegmentContext(last, design, isinstance(last, Contact)), ends.status == Status.OK
    profile = EndContactProfile if context.guided else EndFlightProfile
    at = profile(ends, design.volume_rate)
    with np.errstate(all="ignore"):
        columns = {name: COLUMNS[name].values(context, at)[0] for name in names}
    return {name: np.where(ok, values, np.nan) for name, values in columns.items()}


def exit_needs(names: Iterable[str]) -> tuple[bool, bool]:
    """Return what the solver must work out at the exit for some columns.

    Args:
        names: of columns.

    Returns:
        Whether they need how the stream fills the section, and what the walls carry.
    """
    needs = [COLUMNS[name].needs for name in names]
    return any(Needs.DEPTH in each for each in needs), any(Needs.WALLS in each for each in needs)


def output_numbers(exit_: Numbers, belt: Numbers, error: Array) -> Numbers:
    """Return numbers by the names that columns of sweeps and outputs of functions have.

    Args:
        exit_: columns at the exit.
        belt: receiver columns.
        error: error estimate, dimensionless, shape (designs,).
    """
    numbers = {f"exit_{name}": values for name, values in exit_.items()}
    return numbers | {f"receiver_{name}": values for name, values in belt.items()} | {"error_estimate": error}
