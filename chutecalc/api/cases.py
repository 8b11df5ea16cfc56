"""The solutions of a chute in all its operating states."""

from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.solve import solve
from chutecalc.errors import UsageError
from chutecalc.results.cases import Cases
from chutecalc.spec.operating import DESIGN_POINT


def solve_cases(chute: Chute, rtol: float = 1e-10, only: str | None = None) -> Cases:
    r"""Solve a chute at its design point and in each of its ``[cases]``, on the same steel.

    Args:
        chute: the chute, or n variants of it.
        rtol: relative error allowed to the velocity, as for :func:`chutecalc.solve`.
        only: name of one state to solve; None for all.

    Returns:
        The solutions by name, ``design`` first, and which state is worst in what.

    Raises:
        SpecError: as for :func:`chutecalc.solve`.
        UsageError: the chute has no such case.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[cases.wet]\n"liners.ceramic.friction_deg" = 32')
    >>> chutecalc.solve_cases(spoon)
    <Cases: design 1 ok; wet 1 ok>
    """
    check_chute(chute)
    states = {DESIGN_POINT: chute, **chute.cases} if only is None else {only: state_of(chute, only)}
    return Cases({name: solve(state, rtol) for name, state in states.items()})


def state_of(chute: Chute, name: str) -> Chute:
    """Return a chute in one of its operating states.

    Args:
        chute: the chute.
        name: of a case, or ``design`` for the spec as written.

    Raises:
        UsageError: the chute has no such case.
    """
    states = {DESIGN_POINT: chute, **chute.cases}
    if name not in states:
        raise UsageError(f"{chute.source} has no case {name}. It has {', '.join(states)}")
    return states[name]
