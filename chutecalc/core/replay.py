"""A list of operations on numbers, done again with others: what a spec makes of its numbers before a stream is solved.

:mod:`chutecalc.api.tape` writes it down; the numbers of many designs go through it some designs at a time.
"""

import math
from array import array
from typing import Any

from chutecalc.core import floats

ADD, SUBTRACT, MULTIPLY, DIVIDE, LESS, LESS_EQUAL, EQUAL, AND, OR, NOT, CHOOSE = range(11)
ROOT, SINE, COSINE, TANGENT, ARCCOSINE, CHECK = range(11, 17)
NAMES = (
    *("add", "subtract", "multiply", "divide", "less", "less_equal", "equal", "and", "or", "not", "choose"),
    *("root", "sine", "cosine", "tangent", "arccosine", "check"),
)
"""Operations as Python sees them, by their number."""
STEP = 5
"""Numbers of a step: the operation, where its three arguments stand, and where its result goes."""
WIDTH = 64
"""Designs at once, where there are many."""


class Recipe:
    """Steps, and a place for each number that they take and make."""

    def __init__(self, steps: list[int], values: list[float], taken: list[int], varied: int, width: int) -> None:
        self.steps = array("i", steps or [0])
        self.count = len(steps) // STEP
        self.varied, self.width = varied, width
        self.values = array("d", [value for value in values for _ in range(width)])
        """The numbers that are varied come first; among the others stand those that never change. Of each as many as
        there are designs at once."""
        self.taken = array("i", taken)
        """Places of what is asked for."""


def replay(recipe: Recipe, numbers: Any, out: Any) -> int:
    """Does the steps for a row of varied numbers each, and writes down what is asked for.

    A recipe is of one thread at a time: compiled, the interpreter's lock is held meanwhile.

    Returns:
        How many rows are done: fewer than there are where one of the next group gives a check another answer.
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
    """Does one step for a group of rows; false only for a check that has another answer than it has to have."""
    what, to = recipe.steps[at], recipe.width * recipe.steps[at + 4]
    one, other, third = (
        recipe.width * recipe.steps[at + 1],
        recipe.width * recipe.steps[at + 2],
        recipe.width * recipe.steps[at + 3],
    )
    if what == CHECK:
        for row in range(rows):
            if recipe.values[one + row] != recipe.values[other + row]:
                return False
    elif what == MULTIPLY:
        for row in range(rows):
            recipe.values[to + row] = recipe.values[one + row] * recipe.values[other + row]
    elif what == DIVIDE:
        for row in range(rows):
            recipe.values[to + row] = floats.quotient(recipe.values[one + row], recipe.values[other + row])
    elif what == ADD:
        for row in range(rows):
            recipe.values[to + row] = recipe.values[one + row] + recipe.values[other + row]
    elif what == SUBTRACT:
        for row in range(rows):
            recipe.values[to + row] = recipe.values[one + row] - recipe.values[other + row]
    elif what == CHOOSE:
        for row in range(rows):
            recipe.values[to + row] = (
                recipe.values[other + row] if recipe.values[one + row] != 0.0 else recipe.values[third + row]
            )
    elif what < ROOT:
        for row in range(rows):
            recipe.values[to + row] = truth(what, recipe.values[one + row], recipe.values[other + row])
    else:
        for row in range(rows):
            recipe.values[to + row] = function(what, recipe.values[one + row])
    return True


def truth(what: int, one: float, other: float) -> float:
    """A question."""
    yes = one != 0.0 and other != 0.0
    if what == LESS:
        yes = one < other
    elif what == LESS_EQUAL:
        yes = one <= other
    elif what == EQUAL:
        yes = one == other
    elif what == OR:
        yes = one != 0.0 or other != 0.0
    elif what == NOT:
        yes = one == 0.0
    return 1.0 if yes else 0.0


def function(what: int, one: float) -> float:
    """A root, a function of an angle, or the angle of a cosine."""
    if what == ROOT:
        return floats.root(one)
    if not math.fabs(one) < floats.INFINITY or (what == ARCCOSINE and math.fabs(one) > 1.0):
        return floats.NAN
    if what == SINE:
        return math.sin(one)
    if what == COSINE:
        return math.cos(one)
    return math.tan(one) if what == TANGENT else math.acos(one)
