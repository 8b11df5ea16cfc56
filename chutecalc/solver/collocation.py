"""Compute Gauss-Legendre collocation rules and their matrices for the compiled solver.

The unknown of u' = f(p, u) is held at the Gauss nodes of a panel; an integral from the panel's start to each node and
to the end is one small matrix product. Newton's method (Newton-Kantorovich) needs no linear solver, because the
linearised equation is scalar: with J = ∂f/∂u and P = exp ∫J, the next iterate is P (u0 + ∫ (f - J u)/P). As f - J u
does not change with u to first order, the end value is exact to order 2N in the panel's width, the values between to
order N + 1.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.physics.arrays import Array

# The positive Gauss-Legendre nodes on (-1, 1) and their weights, 18 digits. Stored, because numpy's leggauss costs 7
# ms at its first call, and because weights computed from rounded nodes lose two digits near the ends.
_NODES = {
    4: (0.339981043584856265, 0.861136311594052575),
    6: (0.238619186083196909, 0.661209386466264514, 0.932469514203152028),
    8: (0.183434642495649805, 0.525532409916328986, 0.79666647741362674, 0.960289856497536232),
    12: (
        0.125233408511468915,
        0.367831498998180194,
        0.587317954286617447,
        0.769902674194304687,
        0.904117256370474857,
        0.981560634246719251,
    ),
    16: (
        0.0950125098376374402,
        0.281603550779258913,
        0.458016777657227386,
        0.617876244402643748,
        0.755404408355003034,
        0.865631202387831744,
        0.944575023073232576,
        0.989400934991649933,
    ),
    24: (
        0.0640568928626056261,
        0.191118867473616309,
        0.315042679696163374,
        0.433793507626045138,
        0.545421471388839536,
        0.648093651936975569,
        0.740124191578554364,
        0.820001985973902922,
        0.886415527004401034,
        0.938274552002732759,
        0.974728555971309498,
        0.99518721999702136,
    ),
}
_WEIGHTS = {
    4: (0.652145154862546143, 0.347854845137453857),
    6: (0.467913934572691047, 0.360761573048138608, 0.171324492379170345),
    8: (0.362683783378361983, 0.313706645877887287, 0.222381034453374471, 0.101228536290376259),
    12: (
        0.249147045813402785,
        0.233492536538354809,
        0.203167426723065922,
        0.160078328543346226,
        0.106939325995318431,
        0.0471753363865118272,
    ),
    16: (
        0.189450610455068496,
        0.182603415044923589,
        0.169156519395002538,
        0.149595988816576732,
        0.124628971255533872,
        0.0951585116824927848,
        0.0622535239386478929,
        0.0271524594117540949,
    ),
    24: (
        0.127938195346752157,
        0.125837456346828296,
        0.121670472927803391,
        0.115505668053725601,
        0.107444270115965635,
        0.0976186521041138883,
        0.0861901615319532759,
        0.0733464814110803057,
        0.0592985849154367807,
        0.0442774388174198062,
        0.0285313886289336632,
        0.0123412297999871995,
    ),
}


class Rule(NamedTuple):
    """Matrices of N-point collocation on the panel (0, 1)."""

    nodes: Array
    """Gauss nodes, shape (N,)."""
    knots: Array
    """The panel's start, its nodes and its end, shape (N + 2,): where a solved panel's values are held."""
    integral: Array
    """Matrix from values at the nodes to integrals from 0 to each node and to 1, shape (N + 1, N)."""
    weights: Array
    """Barycentric weights of the knots, shape (N + 2,)."""


@cache
def rule(count: int) -> Rule:
    """Return the rule of N Gauss nodes.

    Args:
        count: N, one of 4, 6, 8, 12, 16 and 24.

    >>> midpoint = rule(4)
    >>> bool(abs(midpoint.integral[-1] @ midpoint.nodes**7 - 1 / 8) < 1e-16)
    True
    """
    half = np.array(_NODES[count])
    x = np.concatenate([-half[::-1], half])
    upper = np.append(x, 1.0)
    degrees = np.arange(count)
    legendre = _legendre(upper, count)
    integrals = np.empty((count + 1, count))  # ∫ P_k from -1 to x = (P_k+1 - P_k-1)/(2k + 1)
    integrals[:, 0] = upper + 1.0
    integrals[:, 1:] = (legendre[:, 2:] - legendre[:, : count - 1]) / (2.0 * degrees[1:] + 1.0)
    gauss = np.concatenate([_WEIGHTS[count][::-1], _WEIGHTS[count]])
    coefficients = (legendre[:-1, :count] * gauss[:, None]).T * (degrees + 0.5)[:, None]
    knots = np.concatenate([[0.0], (x + 1.0) / 2.0, [1.0]])
    gaps = knots[:, None] - knots + np.eye(count + 2)
    return Rule(knots[1:-1], knots, np.ascontiguousarray(integrals @ coefficients) / 2.0, 1.0 / gaps.prod(axis=1))


def _legendre(x: Array, degree: int) -> Array:
    """Return P_0 to P_degree at x, shape (len(x), degree + 1), by their recurrence."""
    values = np.empty((len(x), degree + 1))
    values[:, 0], values[:, 1] = 1.0, x
    for k in range(1, degree):
        values[:, k + 1] = ((2 * k + 1) * x * values[:, k] - k * values[:, k - 1]) / (k + 1)
    return values


@cache
def transfer(coarse: int, fine: int) -> Array:
    """Return the matrix from values at the knots of one rule to those at the nodes of a finer one.

    It is the barycentric form of Lagrange interpolation, of shape (fine, coarse + 2).

    Args:
        coarse: number of nodes of the one.
        fine: number of nodes of the other.
    """
    coarse_rule = rule(coarse)
    gaps = rule(fine).nodes[:, None] - coarse_rule.knots
    exact = gaps == 0.0
    terms = coarse_rule.weights / np.where(exact, 1.0, gaps)
    matrix: Array = terms / terms.sum(axis=1, keepdims=True)
    matrix[exact.any(axis=1)] = exact[exact.any(axis=1)]
    return matrix
