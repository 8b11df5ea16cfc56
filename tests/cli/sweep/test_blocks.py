"""Rows do not depend on the blocks and the threads that solve them."""

import itertools

import pytest

import chutecalc
from chutecalc.studies.sweep import sweep as rows_of
from chutecalc.studies.sweep.parameters import read_parameters
from chutecalc.studies.sweep.solved_blocks import solve_blocks
from chutecalc.workers import Threads
from tests.cli.sweep.commands import SPOON, swept


@pytest.mark.parametrize(("size", "columns"), [("WHOLE", ()), ("CHUNK", ("--columns", "exit_depth_m"))])
def test_rows_depend_on_neither_blocks_nor_threads(capsys, monkeypatch, size, columns):
    arguments = ("radius=1:4:#9", "phi=20:40:#7", SPOON, *columns)
    whole = swept(capsys, *arguments)
    monkeypatch.setattr(rows_of, size, 4)
    assert swept(capsys, *arguments, "--jobs", "3") == whole
    assert swept(capsys, *arguments, "--jobs", "1") == whole


def test_columns_of_segments_do_not_depend_on_blocks(capsys, monkeypatch):
    names = "segments.spoon.max_wear_w_m2,segments.spoon.status"
    arguments = ("radius=1:4:#9", "phi=20:40:#5", SPOON, "--columns", names)
    whole = swept(capsys, *arguments)
    monkeypatch.setattr(rows_of, "WHOLE", 4)
    assert swept(capsys, *arguments) == whole


def test_a_few_blocks_are_solved_ahead_of_the_one_that_is_told(monkeypatch):
    chute = chutecalc.load(SPOON)
    sweep = rows_of.Sweep(chute, read_parameters(["radius=1,2"], chute))
    monkeypatch.setattr("chutecalc.studies.sweep.solved_blocks.solve_block", lambda sweep, number: {"number": number})
    asked = []
    blocks = solve_blocks(sweep, (asked.append(number) or number for number in itertools.count()), Threads(3))
    for number in range(20):
        assert next(blocks) == (number, {"number": number})
        assert len(asked) <= number + 4
    blocks.close()
    numbers = [4, 0, 7, 1, 9]
    assert list(solve_blocks(sweep, numbers, Threads(3))) == [(number, {"number": number}) for number in numbers]


def test_a_block_of_profiles_has_a_quarter_of_a_million_stations():
    chute = chutecalc.load(SPOON)  # a fall and a spoon
    for points, designs in ((2, rows_of.CHUNK), (101, 262_144 // 202), (200_000, 1)):
        sweep = rows_of.Sweep(chute, read_parameters(["radius=1:4:#9"], chute), points=points)
        assert sweep.block_size == designs
        assert sweep.block_count == -(-9 // designs)
