"""The stream at the end of many designs, without what lies before it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from chutecalc.design import Design, Status, stretched
from chutecalc.physics.arrays import Array, Mask, Numbers
from chutecalc.results.belts import receiver_numbers
from chutecalc.results.described import html_table, number, outcomes, status_text
from chutecalc.results.part import at_exit, exit_needs
from chutecalc.results.trajectory import Trajectory
from chutecalc.solver.chain import run_chain, run_ends
from chutecalc.solver.chain_input import design_rows, layout_of


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
        status_numbers = stretched(ends.status, (count,))
        found = Trajectory(design, segment_solutions, status_numbers, count).exit_columns(names)
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


def output_numbers(exit_: Numbers, belt: Numbers, error: Array) -> Numbers:
    """Return numbers by the names that columns of sweeps and outputs of functions have.

    Args:
        exit_: columns at the exit.
        belt: receiver columns.
        error: error estimate, dimensionless, shape (designs,).
    """
    numbers = {f"exit_{name}": values for name, values in exit_.items()}
    return numbers | {f"receiver_{name}": values for name, values in belt.items()} | {"error_estimate": error}
