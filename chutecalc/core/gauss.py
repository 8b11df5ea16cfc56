"""Gauss-Legendre rules on a panel (0, 1) for the compiled solver, and polynomials through their knots.

The numbers come from :mod:`chutecalc.solver.collocation`.
"""

import math
from array import array

from chutecalc.core import floats, matrix


class Rule:
    """A rule of N nodes; its knots are the panel's start, its nodes and its end."""

    def __init__(self, count: int, knots: list[float], weights: list[float], integral: list[list[float]]) -> None:
        if count + 5 > matrix.ROOM:
            raise ValueError(f"there is no room for a rule of {count} nodes")
        self.count = count
        self.last = count + 1
        """Index of the last knot."""
        self.knots = array("d", knots)
        self.weights = array("d", weights)
        """Barycentric weights of the knots."""
        self.integral = matrix.Matrix(integral)
        """Matrix from values at the nodes to integrals up to each node and to the end."""
        half = [0, 1, *range(3, count // 2 + 1, 2)]
        chords = sorted({*half, *(count + 1 - number for number in half)})
        self.chords = len(chords)
        self.chord = array("i", chords)
        """Knots between which chords show where a solution ceases to be smooth: every second one, and all at the ends,
        where layers hide."""


class RulePair:
    """Two nested rules; the coarse one gives the first iterate and the error estimate of the fine one."""

    def __init__(self, coarse: Rule, fine: Rule, transfer: list[list[float]]) -> None:
        self.coarse, self.fine = coarse, fine
        self.transfer = matrix.Matrix(transfer)
        """Matrix from values at the coarse knots to those at the fine nodes."""


class Equation:
    """A linear equation u' = forcing + jacobian u over a panel of width 1, at the nodes of a rule; and work arrays."""

    def __init__(self) -> None:
        self.forcing, self.jacobian = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM)
        self.derivative, self.system = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM * matrix.ROOM)


class Iterate:
    """A solution over a panel."""

    def __init__(self) -> None:
        self.solution = floats.zeros(matrix.ROOM)
        """Values at the knots: the panel's start, nodes and end."""
        self.sensitivity = floats.zeros(matrix.ROOM)
        """Derivatives of the solution at nodes and end by its value at the start."""


def integrate(rule: Rule, equation: Equation, start: float, curve: Iterate) -> None:
    """Solve an equation by its integrating factor, exp ∫ jacobian."""
    matrix.multiply(rule.integral, equation.jacobian, curve.sensitivity, 0)
    for i in range(rule.last):
        curve.sensitivity[i] = floats.power(curve.sensitivity[i])
    for j in range(rule.count):
        equation.derivative[j] = floats.quotient(equation.forcing[j], curve.sensitivity[j])
    matrix.multiply(rule.integral, equation.derivative, curve.solution, 1)
    curve.solution[0] = start
    for i in range(rule.last):
        curve.solution[i + 1] = (curve.solution[i + 1] + start) * curve.sensitivity[i]


def integrate_stiff(rule: Rule, equation: Equation, start: float, curve: Iterate) -> None:
    """Solve a stiff equation by collocation as a dense system; Gauss rules are A-stable, so any step is stable."""
    nodes = rule.count
    width = nodes + 2  # the matrix, and two right-hand sides: the residual and ones
    for i in range(nodes):
        curve.solution[i + 1] = 0.0
        equation.derivative[i] = equation.forcing[i]
    for _ in range(2):  # forcing and jacobian u nearly cancel: the second pass regains the digits that this costs
        for i in range(nodes):
            rise = 0.0
            for j in range(nodes):
                coefficient = matrix.entry(rule.integral, i, j)
                rise += coefficient * equation.derivative[j]
                equation.system[i * width + j] = (1.0 if i == j else 0.0) - coefficient * equation.jacobian[j]
            equation.system[i * width + nodes] = rise + start - curve.solution[i + 1]
            equation.system[i * width + nodes + 1] = 1.0
        eliminate(equation.system, nodes)
        rise = start
        for j in range(nodes):
            rise += matrix.entry(rule.integral, nodes, j) * equation.derivative[j]
        end_sensitivity = 1.0
        for j in range(nodes):
            update, unit_response = equation.system[j * width + nodes], equation.system[j * width + nodes + 1]
            curve.solution[j + 1] += update
            equation.derivative[j] = equation.forcing[j] + equation.jacobian[j] * curve.solution[j + 1]
            coefficient = matrix.entry(rule.integral, nodes, j) * equation.jacobian[j]
            rise += coefficient * update
            end_sensitivity += coefficient * unit_response
            curve.sensitivity[j] = unit_response
    curve.solution[0] = start
    curve.solution[nodes + 1] = rise
    curve.sensitivity[nodes] = end_sensitivity


def eliminate(system: "array[float]", nodes: int) -> None:
    """Solve a system by Gauss-Jordan elimination with partial pivoting; each row has two right-hand sides."""
    width = nodes + 2
    for k in range(nodes):
        best = k
        for i in range(k + 1, nodes):
            if math.fabs(system[i * width + k]) > math.fabs(system[best * width + k]):
                best = i
        if best != k:
            for j in range(width):
                swapped = system[k * width + j]
                system[k * width + j] = system[best * width + j]
                system[best * width + j] = swapped
        pivot = system[k * width + k]
        for j in range(k, width):
            system[k * width + j] = floats.quotient(system[k * width + j], pivot)
        for i in range(nodes):
            factor = system[i * width + k]
            if i != k and factor != 0.0:
                for j in range(k, width):
                    system[i * width + j] -= factor * system[k * width + j]


def evaluate(rule: Rule, values: "array[float]", offset: int, at: float) -> float:
    """Return the polynomial through values at the knots, which begin at an offset, at a position in the panel."""
    top, bottom = 0.0, 0.0
    for k in range(rule.last + 1):
        gap = at - rule.knots[k]
        if gap == 0.0:
            return float(values[offset + k])
        term = rule.weights[k] / gap
        top += term * values[offset + k]
        bottom += term
    return float(top / bottom)


def find_value(rule: Rule, values: "array[float]", offset: int, target: float, low: float, high: float) -> float:
    """Return where that polynomial has a value, between two positions on either side of it, by the Illinois rule.

    It is the lower position where the value is already reached or passed there.
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


def derivative_at(rule: Rule, values: "array[float]", knot: int) -> float:
    """Return the derivative of that polynomial at a knot, per panel width."""
    total = 0.0
    for k in range(rule.last + 1):
        if k != knot:
            gap = rule.knots[knot] - rule.knots[k]
            total += rule.weights[k] / rule.weights[knot] / gap * (values[k] - values[knot])
    return total
