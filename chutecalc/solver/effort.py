"""How hard to work: the rules of collocation that the compiled solver takes, and the errors it allows."""

from functools import cache

from chutecalc.core import gauss, state
from chutecalc.solver.collocation import rule, transfer

Pair = tuple[int, int]
FINEST = (16, 24)  # for the whole stretch where a coarser pair does not solve it, and for a panel in r


@cache
def effort(rtol: float, complete: bool) -> state.Effort:
    """What it takes to have velocities right within a relative error.

    Args:
        rtol: relative error allowed.
        complete: keep the panels, right at every place and not at the ends alone; go on past a choke.
    """
    first = (6, 8) if rtol >= 1e-7 else (6, 12) if rtol >= 1e-9 else (8, 16)
    return effort_with(*(((8, 24), (8, 24)) if complete else (first, (8, 16))), rtol, complete)


def effort_with(first: Pair, later: Pair, rtol: float, complete: bool) -> state.Effort:
    """The same with other rules for the whole stretch in one panel, and for the panels where that does not do."""
    own = state.Effort(_pair(*first), _pair(*FINEST), _pair(*later), _pair(*FINEST))
    own.tolerance, own.share = rtol, max(1e-3 * rtol, 3e-15)
    own.complete = complete
    return own


@cache
def compiled_rule(count: int) -> gauss.Rule:
    """The rule of so many nodes as the compiled solver holds it."""
    own = rule(count)
    return gauss.Rule(count, own.knots.tolist(), own.weights.tolist(), own.integral.tolist())


@cache
def _pair(coarse: int, fine: int) -> gauss.Pair:
    return gauss.Pair(compiled_rule(coarse), compiled_rule(fine), transfer(coarse, fine).tolist())
