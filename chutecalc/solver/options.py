"""Choose the collocation rules and tolerances of the compiled solver."""

from functools import cache

from chutecalc.core import gauss, state
from chutecalc.solver.collocation import rule, transfer

RuleSizes = tuple[int, int]
FINEST = (16, 24)  # for a whole segment that a coarser pair does not solve, and for panels in r


@cache
def solver_options(rtol: float, dense_output: bool) -> state.SolverOptions:
    """Return the options that keep velocities within a relative error.

    Args:
        rtol: relative error allowed.
        dense_output: keep the panels, accurate at every share and not at their ends alone, and continue past a choke.
    """
    first_sizes = (6, 8) if rtol >= 1e-7 else (6, 12) if rtol >= 1e-9 else (8, 16)
    return options_with(*(((8, 24), (8, 24)) if dense_output else (first_sizes, (8, 16))), rtol, dense_output)


def options_with(first_sizes: RuleSizes, step_sizes: RuleSizes, rtol: float, dense_output: bool) -> state.SolverOptions:
    """Return options with given rules.

    Args:
        first_sizes: numbers of nodes, coarse and fine, for a whole segment as one panel.
        step_sizes: likewise for the panels of a segment that takes several.
        rtol, dense_output: as in :func:`solver_options`.
    """
    options = state.SolverOptions(
        first_pair=_rule_pair(*first_sizes),
        second_pair=_rule_pair(*FINEST),
        step_pair=_rule_pair(*step_sizes),
        r_pair=_rule_pair(*FINEST),
    )
    options.tolerance, options.panel_tolerance = rtol, max(1e-3 * rtol, 3e-15)
    options.dense_output = dense_output
    return options


@cache
def compiled_rule(count: int) -> gauss.Rule:
    """Return a collocation rule as the compiled solver holds it.

    Args:
        count: its number of nodes.
    """
    source = rule(count)
    knots, weights, integral = source.knots.tolist(), source.weights.tolist(), source.integral.tolist()
    return gauss.Rule(count, knots=knots, weights=weights, integral=integral)


@cache
def _rule_pair(coarse: int, fine: int) -> gauss.RulePair:
    return gauss.RulePair(compiled_rule(coarse), compiled_rule(fine), transfer(coarse, fine).tolist())
