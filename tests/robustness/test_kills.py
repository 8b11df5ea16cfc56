"""What python -m tests.robustness.kills tries a hundred times, once each."""

import sys

import pytest

from tests import seeds
from tests.robustness.kills import ATTACKS, FORMATS, attack

ONCE = [name for name in ATTACKS if not name.endswith(FORMATS[1:])]
"""The formats differ in nothing but what is written at the end: the long form tries the others too."""


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
@pytest.mark.parametrize("name", ATTACKS if seeds.stress() > seeds.USUAL else ONCE)
def test_a_file_is_whole_or_there_is_none(name):
    for number in range(max(1, seeds.stress() // seeds.USUAL)):
        outcome = attack(name, (seeds.chosen() or 0, number))
        assert not outcome.faults, (name, number, outcome)
