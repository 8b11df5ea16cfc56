"""The solution of a chute."""

from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.solution import Solution
from chutecalc.api.tolerance import check_tolerance
from chutecalc.errors import SpecError
from chutecalc.solver.chain import run_chain


def solve(chute: Chute, rtol: float = 1e-10) -> Solution:
    """Solve a chute, or each of n variants of it.

    Args:
        chute: from :func:`chutecalc.load`, :func:`chutecalc.parse` or :meth:`Chute.vary`.
        rtol: error allowed to the velocity everywhere, relative, or as a shift of the position by that share of the
            segment's length, whichever is larger; from 1e-13 to 1e-3.

    Returns:
        The solution. A design that fails says so in its status and does not affect the others.

    Raises:
        UsageError: ``rtol`` is out of range, or ``chute`` is no chute.
        SpecError: a hood is tangent to a falling stream that is steeper than the hood's end.

    >>> import chutecalc
    >>> solution = chutecalc.solve(chutecalc.parse(chutecalc.STARTER))
    >>> solution.status, solution.exit_velocity.round(3)
    (array(['ok'], dtype='<U12'), array([6.222]))
    """
    check_chute(chute)
    check_tolerance(rtol)
    try:
        segment_solutions, ends = run_chain(chute.design, rtol)
    except SpecError as error:
        raise SpecError(error.faults, chute.source, error.designs) from None
    return Solution(chute, segment_solutions, ends, rtol)
