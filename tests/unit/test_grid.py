"""Tables as plain lines are laid out as rich draws them."""

import io

import numpy as np
import pytest
from rich.console import Console

from chutecalc.output.cells import shortened, width
from chutecalc.output.grid import GAP, Grid

WORDS = ("", "s", "velocity", "μ_e\nW/m²", "depth\nm", "石炭", "e\u0301tage", "ที่", "a\u200bb", "0.1", "-12.345")


def drawn(grid):
    """Return what rich makes of it where nothing is cut, without what is at the end of lines."""
    stream = io.StringIO()
    Console(file=stream, width=10_000, color_system=None).print(grid.drawn())
    return [line.rstrip() for line in stream.getvalue().splitlines()]


@pytest.mark.parametrize("seed", range(20))
def test_as_rich_draws_it(seed):
    random = np.random.default_rng(seed)
    grid = Grid("a title" if seed % 3 == 0 else "", GAP if seed % 2 else "")
    for k in range(random.integers(1, 6)):
        grid.column("x" * (8 if k == 0 else 0) + str(random.choice(WORDS)), left=bool(random.random() < 0.4))
    for _ in range(random.integers(0, 5)):
        grid.row(str(random.choice(WORDS)).replace("\n", " ") for _ in range(random.integers(1, len(grid.columns) + 1)))
    assert list(grid.lines()) == drawn(grid)


def test_how_wide_letters_are():
    assert [width(text) for text in WORDS] == [0, 1, 8, 8, 7, 4, 5, 1, 2, 3, 7]


def cells(parts):
    """Return the cells beside the labels, column by column."""
    return [
        [row[k] for row in part.rows if row[k]]
        for part in parts
        for k, column in enumerate(part.columns)
        if not column.label
    ]


@pytest.mark.parametrize("seed", range(40))
def test_a_wide_table_becomes_several_that_fit_and_lose_nothing(seed):
    random = np.random.default_rng(seed)
    grid = Grid(indent=GAP if seed % 2 else "")
    labels = int(random.integers(0, 3))
    for k in range(labels + int(random.integers(1, 12))):
        grid.column("x" * int(random.integers(1, 9)) + "\nm", left=k < labels, label=k < labels)
    for _ in range(random.integers(1, 6)):
        grid.row("" if random.random() < 0.2 else f"{random.normal():.{random.integers(0, 6)}f}" for _ in grid.columns)
    whole = grid.fitted(10_000)
    assert [list(part.lines()) for part in whole] == [list(grid.lines())]
    parts = grid.fitted(40)
    assert cells(parts) == cells(whole)
    assert all(sum(column.label for column in part.columns) == labels for part in parts)
    for part in parts:
        alone = len(part.columns) == labels + 1  # a column that does not fit beside the labels stands alone
        assert alone or max(map(width, part.lines())) <= 40
    wide = max(map(width, grid.lines()))
    assert (len(parts) == 1) == (wide <= 40 or len(grid.columns) == labels + 1)


def test_words_are_broken_where_they_must_and_numbers_never():
    grid = Grid()
    grid.column("name", left=True, label=True)
    grid.column("meaning", left=True, words=True)
    grid.column("m")
    grid.row(["depth", "flow depth normal to the centre section of the chute", "0.1399"])
    (part,) = grid.fitted(40)
    assert list(part.lines()) == [
        "name   meaning                        m",
        "depth  flow depth normal to the  0.1399",
        "       centre section of the",
        "       chute",
    ]
    narrow = [line for part in grid.fitted(10) for line in part.lines()]
    assert any(line.endswith("0.1399") for line in narrow)
    broken = " ".join(line.split()[-1] for line in narrow[1:11])
    assert broken == "flow depth normal to the centre section of the chute"


def test_a_row_of_labels_alone_is_in_the_first_table_only():
    grid = Grid()
    for k, heading in enumerate(("segment", "velocity", "depth")):
        grid.column(heading, left=k == 0, label=k == 0)
    grid.row(["fall", "4.0", ""])
    grid.row(["spoon", "3.878", "0.1399"])
    assert [[row[0] for row in part.rows] for part in grid.fitted(20)] == [["fall", "spoon"], ["spoon"]]


def test_names_give_way_to_numbers_and_keep_their_ends():
    grid = Grid()
    for heading, left, label in (("case", True, True), ("status", True, True), ("velocity\nm/s", False, False)):
        grid.column(heading, left=left, label=label)
    grid.row(["a" + "-" * 40 + "b", "ok", "-1234567.891234567e-12"])
    grid.row(["worst", "", "c" + "-" * 40 + "d"])
    (part,) = grid.fitted(50)
    lines = list(part.lines())
    assert [width(line) for line in lines[-2:]] == [50, 50]
    assert lines[-2].startswith("a-----")
    assert lines[-2].endswith("-----b  ok      -1234567.891234567e-12")
    assert lines[-1].endswith("  c----------…---------d")
    grid.columns[0] = grid.columns[0]._replace(left=False)
    grid.row(["0.12345678901234567", "", ""])
    assert grid.fitted(30)[0].rows[-1][0] == "0.12345678901234567"
    assert shortened("石炭石炭石炭", 7) == "石炭…炭"
    assert shortened("spoon", 5) == "spoon"
