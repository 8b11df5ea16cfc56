"""A list of operations on numbers, done again with others: what a spec makes of its numbers before a stream is solved.

:mod:`chutecalc.tape` writes it down; the numbers of many designs go through it one design after the other.
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


class Recipe:
    """Steps, and a place for each number that they take and make."""

    def __init__(self, steps: list[int], values: list[float], taken: list[int], varied: int) -> None:
        self.steps = array("i", steps or [0])
        self.count = len(steps) // STEP
        self.varied = varied
        self.values = array("d", values)
        """The numbers that are varied come first; among the others stand those that never change."""
        self.taken = array("i", taken)
        """Places of what is asked for."""


def replay(recipe: Recipe, numbers: Any, out: Any) -> int:
    """Does the steps for a row of varied numbers each, and writes down what is asked for.

    A recipe is of one thread at a time: compiled, the interpreter's lock is held meanwhile.

    Returns:
        How many rows are done: fewer than there are where the next gives a check another answer.
    """
    for row in range(numbers.shape[0]):
        for k in range(recipe.varied):
            recipe.values[k] = numbers[row, k]
        if not follow(recipe, recipe.values):
            return row
        for k in range(out.shape[1]):
            out[row, k] = recipe.values[recipe.taken[k]]
    return int(numbers.shape[0])


def follow(recipe: Recipe, values: "array[float]") -> bool:
    """Does the steps; whether every check has the answer that it has to have."""
    for number in range(recipe.count):
        at = STEP * number
        what = recipe.steps[at]
        one, other = values[recipe.steps[at + 1]], values[recipe.steps[at + 2]]
        if what == CHECK:
            if one != other:
                return False
        else:
            values[recipe.steps[at + 4]] = result(what, one, other, values[recipe.steps[at + 3]])
    return True


def result(what: int, one: float, other: float, third: float) -> float:
    """One operation; what is true is 1, what is not is 0."""
    if what == MULTIPLY:
        return one * other
    if what == DIVIDE:
        return floats.quotient(one, other)
    if what == ADD:
        return one + other
    if what == SUBTRACT:
        return one - other
    if what == CHOOSE:
        return other if one != 0.0 else third
    if what == ROOT:
        return floats.root(one)
    if what < ROOT:
        return truth(what, one, other)
    return trigonometric(what, one)


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


def trigonometric(what: int, one: float) -> float:
    """A function of an angle, or the angle of a cosine."""
    if not math.fabs(one) < floats.INFINITY or (what == ARCCOSINE and math.fabs(one) > 1.0):
        return floats.NAN
    if what == SINE:
        return math.sin(one)
    if what == COSINE:
        return math.cos(one)
    return math.tan(one) if what == TANGENT else math.acos(one)
