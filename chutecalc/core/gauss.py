"""Gauss-Legendre rules on a panel (0, 1), as the compiled solver holds them, and polynomials through their knots.

The numbers come from :mod:`chutecalc.solver.collocation`.
"""

import math
from array import array

from chutecalc.core import floats, matrix


class Rule:
    """A rule of N nodes: knots are the panel's start, its nodes and its end."""

    def __init__(self, count: int, knots: list[float], weights: list[float], integral: list[list[float]]) -> None:
        if count + 5 > matrix.MOST:
            raise ValueError(f"there is no room for a rule of {count} nodes")
        self.count = count
        self.last = count + 1
        """The number of the last knot."""
        self.knots = array("d", knots)
        self.weights = array("d", weights)
        """Barycentric, of the knots."""
        self.integral = matrix.Matrix(integral)
        """From values at the nodes to integrals up to each node and the end."""
        half = [0, 1, *range(3, count // 2 + 1, 2)]
        chords = sorted({*half, *(count + 1 - number for number in half)})
        self.chords = len(chords)
        self.chord = array("i", chords)
        """The knots between which chords are laid to see where a solution may end to be smooth: every second will do,
        and at the ends, where layers hide, each."""


class Pair:
    """Two rules, the coarser for the start and the error of the finer."""

    def __init__(self, coarse: Rule, fine: Rule, transfer: list[list[float]]) -> None:
        self.coarse, self.fine = coarse, fine
        self.transfer = matrix.Matrix(transfer)
        """From values at the coarse knots to those at the fine nodes."""


class Equation:
    """A linear equation u' = forcing + rate u over a panel of width 1, at the nodes of a rule; and room to solve it."""

    def __init__(self) -> None:
        self.forcing, self.rate = floats.zeros(matrix.MOST), floats.zeros(matrix.MOST)
        self.rises, self.system = floats.zeros(matrix.MOST), floats.zeros(matrix.MOST * matrix.MOST)


class Curve:
    """A solution over a panel."""

    def __init__(self) -> None:
        self.knots = floats.zeros(matrix.MOST)
        """At the rule's start, nodes and end."""
        self.growth = floats.zeros(matrix.MOST)
        """What a small change at the start has become at nodes and end."""


def integrate(rule: Rule, equation: Equation, start: float, curve: Curve) -> None:
    """Solves an equation by its integrating factor, exp ∫ rate."""
    matrix.multiply(rule.integral, equation.rate, curve.growth, 0)
    for i in range(rule.last):
        curve.growth[i] = floats.power(curve.growth[i])
    for j in range(rule.count):
        equation.rises[j] = floats.quotient(equation.forcing[j], curve.growth[j])
    matrix.multiply(rule.integral, equation.rises, curve.knots, 1)
    curve.knots[0] = start
    for i in range(rule.last):
        curve.knots[i + 1] = (curve.knots[i + 1] + start) * curve.growth[i]


def integrate_stiff(rule: Rule, equation: Equation, start: float, curve: Curve) -> None:
    """The same with the equation collocated: any step through a stream that clings to a balance, Gauss is A-stable."""
    nodes = rule.count
    width = nodes + 2  # the matrix, with the rise wanted and with ones beside it
    for i in range(nodes):
        curve.knots[i + 1] = 0.0
        equation.rises[i] = equation.forcing[i]
    for _ in range(2):  # forcing and growth u nearly cancel: the second time regains the digits that this has cost
        for i in range(nodes):
            rise = 0.0
            for j in range(nodes):
                share = matrix.entry(rule.integral, i, j)
                rise += share * equation.rises[j]
                equation.system[i * width + j] = (1.0 if i == j else 0.0) - share * equation.rate[j]
            equation.system[i * width + nodes] = rise + start - curve.knots[i + 1]
            equation.system[i * width + nodes + 1] = 1.0
        eliminate(equation.system, nodes)
        rise = start
        for j in range(nodes):
            rise += matrix.entry(rule.integral, nodes, j) * equation.rises[j]
        spread = 1.0
        for j in range(nodes):
            update, one = equation.system[j * width + nodes], equation.system[j * width + nodes + 1]
            curve.knots[j + 1] += update
            equation.rises[j] = equation.forcing[j] + equation.rate[j] * curve.knots[j + 1]
            share = matrix.entry(rule.integral, nodes, j) * equation.rate[j]
            rise += share * update
            spread += share * one
            curve.growth[j] = one
    curve.knots[0] = start
    curve.knots[nodes + 1] = rise
    curve.growth[nodes] = spread


def eliminate(system: "array[float]", nodes: int) -> None:
    """Gauss-Jordan with partial pivoting, of a matrix of rows with two right-hand sides beside it."""
    width = nodes + 2
    for k in range(nodes):
        best = k
        for i in range(k + 1, nodes):
            if math.fabs(system[i * width + k]) > math.fabs(system[best * width + k]):
                best = i
        if best != k:
            for j in range(width):
                kept = system[k * width + j]
                system[k * width + j] = system[best * width + j]
                system[best * width + j] = kept
        pivot = system[k * width + k]
        for j in range(k, width):
            system[k * width + j] = floats.quotient(system[k * width + j], pivot)
        for i in range(nodes):
            share = system[i * width + k]
            if i != k and share != 0.0:
                for j in range(k, width):
                    system[i * width + j] -= share * system[k * width + j]


def evaluate(rule: Rule, values: "array[float]", offset: int, at: float) -> float:
    """The polynomial through values at the knots, which begin at an offset, at a place in the panel."""
    top, bottom = 0.0, 0.0
    for k in range(rule.last + 1):
        gap = at - rule.knots[k]
        if gap == 0.0:
            return float(values[offset + k])
        term = rule.weights[k] / gap
        top += term * values[offset + k]
        bottom += term
    return float(top / bottom)


def solve(rule: Rule, values: "array[float]", offset: int, target: float, low: float, high: float) -> float:
    """Where that polynomial has a value, between two places on either side of it, by the Illinois rule.

    The lower place where it has that already there, or has passed it.
    """
    sign = 1.0 if evaluate(rule, values, offset, high) >= target else -1.0
    f_low = sign * (evaluate(rule, values, offset, low) - target)
    f_high = sign * (evaluate(rule, values, offset, high) - target)
    if f_low >= 0.0:
        return low
    at, last = high, 0
    for _ in range(100):
        at = low + (high - low) * floats.quotient(f_low, f_low - f_high)
        f = sign * (evaluate(rule, values, offset, at) - target)
        if f < 0.0:
            gap = at - low
            low, f_low = at, f
            if last == 1:
                f_high *= 0.5
            last = 1
        else:
            gap = high - at
            high, f_high = at, f
            if last == 2:
                f_low *= 0.5
            last = 2
        if f == 0.0 or min(gap, high - low) <= 4e-16 * math.fabs(at):
            break
    return at


def slope_at(rule: Rule, values: "array[float]", knot: int) -> float:
    """Derivative of that polynomial at one of the knots, per panel width."""
    total = 0.0
    for k in range(rule.last + 1):
        if k != knot:
            gap = rule.knots[knot] - rule.knots[k]
            total += rule.weights[k] / rule.weights[knot] / gap * (values[k] - values[knot])
    return total
