"""The solutions of a chute in all its operating states."""

from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.results.cases import DESIGN_POINT, Cases


def solve_cases(chute: Chute, rtol: float = 1e-10) -> Cases:
    r"""Solve a chute at its design point and in each of its ``[cases]``, on the same steel.

    Args:
        chute: the chute, or n variants of it.
        rtol: relative error allowed to the velocity, as for :func:`chutecalc.solve`.

    Returns:
        The solutions by name, ``design`` first, and which state is worst in what.

    Raises:
        SpecError: as for :func:`chutecalc.solve`.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER + '[cases.wet]\n"liners.ceramic.friction_deg" = 32')
    >>> chutecalc.solve_cases(spoon)
    <Cases: design 1 ok; wet 1 ok>
    """
    return Cases({name: solve(state, rtol) for name, state in {DESIGN_POINT: chute, **chute.cases}.items()})
