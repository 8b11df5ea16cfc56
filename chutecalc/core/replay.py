"""Repeat a list of operations with other numbers: what a spec makes of its numbers before a stream is solved.

:mod:`chutecalc.api.tape` records it; the numbers of many designs go through it in groups.
"""

import math
from array import array
from typing import Any

from chutecalc.core import floats

ADD, SUBTRACT, MULTIPLY, DIVIDE, LESS, LESS_EQUAL, EQUAL, AND, OR, NOT, CHOOSE = range(11)
ROOT, SINE, COSINE, TANGENT, ARCCOSINE, EXPONENTIAL, CHECK = range(11, 18)
NAMES = (
    *("add", "subtract", "multiply", "divide", "less", "less_equal", "equal", "and", "or", "not", "choose"),
    *("root", "sine", "cosine", "tangent", "arccosine", "exponential", "check"),
)
"""Names of operations, by their number."""
STEP = 5
"""Numbers of a step: the operation, the slots of its three arguments, and the slot of its result."""
WIDTH = 64
"""Designs at once, where there are many."""


class Recipe:
    """Steps, and a slot for each number that they take and make."""

    def __init__(self, steps: list[int], values: list[float], taken: list[int], varied: int, width: int) -> None:
        self.steps = array("i", steps or [0])
        self.count = len(steps) // STEP
        self.varied, self.width = varied, width
        self.values = array("d", [value for value in values for _ in range(width)])
        """The varied numbers come first; constants stand among the others. Each slot holds as many as there are
        designs at once."""
        self.taken = array("i", taken)
        """Slots of the results."""


def replay(recipe: Recipe, numbers: Any, out: Any) -> int:
    """Carry out the steps for each row of varied numbers, and write the results.

    For one thread at a time: compiled, the interpreter's lock is held meanwhile.

    Returns:
        How many rows are done: fewer than there are where a check in the next group has another result.
    """
    first = 0
    while first < numbers.shape[0]:
        rows = min(recipe.width, numbers.shape[0] - first)
        for k in range(recipe.varied):
            for row in range(rows):
                recipe.values[recipe.width * k + row] = numbers[first + row, k]
        for number in range(recipe.count):
            if not follow(recipe, STEP * number, rows):
                return first
        for k in range(out.shape[1]):
            for row in range(rows):
                out[first + row, k] = recipe.values[recipe.width * recipe.taken[k] + row]
        first += rows
    return int(numbers.shape[0])


def follow(recipe: Recipe, at: int, rows: int) -> bool:
    """Carry out one step for a group of rows; return False only where a check has another result."""
    code, result = recipe.steps[at], recipe.width * recipe.steps[at + 4]
    first_operand, second_operand, third_operand = (
        recipe.width * recipe.steps[at + 1],
        recipe.width * recipe.steps[at + 2],
        recipe.width * recipe.steps[at + 3],
    )
    if code == CHECK:
        for row in range(rows):
            if recipe.values[first_operand + row] != recipe.values[second_operand + row]:
                return False
    elif code == MULTIPLY:
        for row in range(rows):
            recipe.values[result + row] = recipe.values[first_operand + row] * recipe.values[second_operand + row]
    elif code == DIVIDE:
        for row in range(rows):
            recipe.values[result + row] = floats.quotient(
                recipe.values[first_operand + row], recipe.values[second_operand + row]
            )
    elif code == ADD:
        for row in range(rows):
            recipe.values[result + row] = recipe.values[first_operand + row] + recipe.values[second_operand + row]
    elif code == SUBTRACT:
        for row in range(rows):
            recipe.values[result + row] = recipe.values[first_operand + row] - recipe.values[second_operand + row]
    elif code == CHOOSE:
        for row in range(rows):
            recipe.values[result + row] = (
                recipe.values[second_operand + row]
                if recipe.values[first_operand + row] != 0.0
                else recipe.values[third_operand + row]
            )
    elif code < ROOT:
        for row in range(rows):
            recipe.values[result + row] = truth(
                code, recipe.values[first_operand + row], recipe.values[second_operand + row]
            )
    else:
        for row in range(rows):
            recipe.values[result + row] = function(code, recipe.values[first_operand + row])
    return True


def truth(code: int, first_operand: float, second_operand: float) -> float:
    """Return a comparison or a logical operation, 1 or 0."""
    yes = first_operand != 0.0 and second_operand != 0.0
    if code == LESS:
        yes = first_operand < second_operand
    elif code == LESS_EQUAL:
        yes = first_operand <= second_operand
    elif code == EQUAL:
        yes = first_operand == second_operand
    elif code == OR:
        yes = first_operand != 0.0 or second_operand != 0.0
    elif code == NOT:
        yes = first_operand == 0.0
    return 1.0 if yes else 0.0


def function(code: int, operand: float) -> float:
    """Return a square root, an exponential, a trigonometric function, or an arc cosine."""
    if code == ROOT:
        return floats.root(operand)
    if code == EXPONENTIAL:
        return floats.power(operand)
    if not math.fabs(operand) < floats.INFINITY or (code == ARCCOSINE and math.fabs(operand) > 1.0):
        return floats.NAN
    if code == SINE:
        return math.sin(operand)
    if code == COSINE:
        return math.cos(operand)
    return math.tan(operand) if code == TANGENT else math.acos(operand)
