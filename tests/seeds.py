"""Where random cases come from, and how many there are.

Without ``CHUTECALC_SEED`` every random case has its own fixed seed, and a run is the same as the last. With a number
there, all of them follow that number; ``random`` draws one, which pytest prints. ``CHUTECALC_STRESS`` says how many
cases: 5 without it, 50 for ten times as many.
"""

import os
import secrets
from collections.abc import Callable
from typing import Any, TypeVar

import hypothesis
import numpy as np
import pytest

SEED, STRESS = "CHUTECALC_SEED", "CHUTECALC_STRESS"
USUAL = 5
Test = TypeVar("Test", bound=Callable[..., Any])


def settle() -> None:
    """Draw the seed where a random one is requested: once, before any worker starts, because workers inherit it."""
    if os.environ.get(SEED) == "random":
        os.environ[SEED] = str(secrets.randbelow(10**9))
    chosen()
    stress()


def _number(name: str, least: int, otherwise: str = "") -> int | None:
    """Return the number in a variable; None where it is not set."""
    text = os.environ.get(name, "")
    if text and not (text.isascii() and text.isdigit() and int(text) >= least):
        raise pytest.UsageError(f"{name}={text}: must be a whole number from {least} on{otherwise}")
    return int(text) if text else None


def chosen() -> int | None:
    """Return the seed that all random cases follow; None where each has its own."""
    return _number(SEED, 0, ", or random")


def stress() -> int:
    """Return how many cases to draw, as a number to hold against the usual 5."""
    return _number(STRESS, 1) or USUAL


def times(count: int) -> int:
    """Return how many cases to draw where the usual number is given."""
    return max(1, count * stress() // USUAL)


def generator(*own: int) -> np.random.Generator:
    """Return a generator seeded by a case, and by the chosen seed where there is one."""
    number = chosen()
    return np.random.default_rng(own if number is None else (number, *own))


def replay() -> str:
    """Return the start of a command that repeats the same cases; empty for the fixed ones."""
    names = [name for name in (SEED, STRESS) if os.environ.get(name)]
    return " ".join(f"{name}={os.environ[name]}" for name in names)


def fuzzed(examples: int = 150, suppress: tuple[hypothesis.HealthCheck, ...] = ()) -> Callable[[Test], Test]:
    """Return the settings of a Hypothesis test. Put it above ``@given``. Runs share no examples."""

    def decorate(test: Test) -> Test:
        test = hypothesis.settings(
            max_examples=times(examples),
            deadline=None,
            derandomize=True,  # a seed goes before it
            database=None,
            suppress_health_check=[hypothesis.HealthCheck.too_slow, *suppress],
        )(test)
        number = chosen()
        return test if number is None else hypothesis.seed(number)(test)

    return decorate
