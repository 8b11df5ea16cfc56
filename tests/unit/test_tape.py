"""What NumPy does with numbers, written down and done again with others."""

import numpy as np
import pytest

from chutecalc.api.tape import Tape, run_recipe

X, Y = 0.7, -1.3
PROGRAMS = {
    "arithmetic": lambda x, y: (x + y) * x - y / x + 2.0 * -x,
    "a square": lambda x, y: x**2 + np.square(y),
    "angles": lambda x, y: np.sin(x) + np.cos(y) * np.tan(x) + np.arccos(x * 0.5),
    "an exponential": lambda x, y: np.exp(x - y),
    "a root": lambda x, y: np.sqrt(x * x + y * y),
    "size": lambda x, y: np.abs(y) + np.minimum(x, y) - np.maximum(x, 0.5 * y),
    "a choice": lambda x, y: np.where(x < y, x, np.where((y <= 0.0) & ~(x == 0.0), 2.0 * x, y)),
    "either": lambda x, y: np.where((x > y) | (x != 1.0), x, y) + np.where(x >= y, 1.0, y),
    "shapes": lambda x, y: np.atleast_1d(x)[None][0] + y,
}


def written(program):
    """Return a recipe of two numbers."""
    tape = Tape()
    return tape.recipe([program(tape.new_variable(X), tape.new_variable(Y))])


@pytest.mark.parametrize("name", PROGRAMS)
def test_done_again(name):
    """Each is one operation of C's after the other; their functions are right to a digit."""
    numbers = np.random.default_rng(4).uniform(-1.5, 1.5, (50, 2))
    found = run_recipe(written(PROGRAMS[name]), numbers)
    assert found[:, 0] == pytest.approx(PROGRAMS[name](*numbers.T), rel=1e-14, abs=1e-15)


@pytest.mark.parametrize("holds", [lambda x, y: x > y, lambda x, y: (x > y).all(), lambda x, y: np.any(np.less(y, x))])
def test_an_answer_that_changes(holds):
    def program(x, y):
        return 2.0 * x if holds(x, y) else y

    recipe = written(program)
    assert run_recipe(recipe, np.array([[3.0, 2.0]])).tolist() == [[6.0]]
    assert run_recipe(recipe, np.array([[3.0, 2.0], [2.0, 3.0]])) is None


@pytest.mark.parametrize(
    "program",
    [
        lambda x, y: np.arctan(x),
        lambda x, y: x**3,
        lambda x, y: x * np.ones(2),
        lambda x, y: np.sort(x),
        lambda x, y: np.add.reduce(x),
    ],
)
def test_what_a_tape_does_not_hold(program):
    with pytest.raises(TypeError):
        written(program)


def test_what_has_no_value_is_no_number():
    recipe = written(lambda x, y: np.arccos(x) + np.sin(y))
    assert np.isnan(run_recipe(recipe, np.array([[2.0, 0.0], [0.5, np.inf]]))).all()
