"""The stream at the end of designs, and what it does to the belt that it goes to."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.along import Numbers, asked, at_exit
from chutecalc.belts import received
from chutecalc.design import Design, stretched
from chutecalc.physics.arrays import Array, Index
from chutecalc.solution import Solution
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
    """What it does to the belt there, as :attr:`chutecalc.solution.Solution.receiver`."""


def at_ends(design: Design, rtol: float, names: Sequence[str], count: int) -> Exits:
    """Those of designs.

    Args:
        design: of so many designs as ``count`` says.
        rtol: as of :func:`chutecalc.solve`.
        names: of columns, without time; velocity and slope among them where there is a receiver.
        count: how many.
    """
    if design.segments[-1].kind == "plate":  # where the stream is as the impact on it leaves it
        legs, ends = run_chain(design, rtol, complete=False)
        found = Solution(design, tuple(legs), ends, rtol, count).exit_columns(names)
    else:
        ends = run_ends(kinds_of(design), numbers_of(design), rtol, *asked(names))
        found = at_exit(design, ends, names)
    belt: Numbers = {}
    if design.receiver is not None:
        belt = received(design.receiver, design, found["velocity_m_s"], np.radians(found["slope_deg"]))
    whole = [stretched(values, (count,)) for values in (ends.status, ends.error)]
    both = ({name: stretched(values, (count,)) for name, values in numbers.items()} for numbers in (found, belt))
    return Exits(*whole, *both)
