"""Tables as plain lines are laid out as rich draws them."""

import io

import numpy as np
import pytest
from rich.console import Console

from chutecalc.output.grid import GAP, Grid, width

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
