"""Charts for terminals, of numbers far beyond the axis too."""

import numpy as np
import pytest

from chutecalc.output.chart import chart_lines
from chutecalc.results.columns import COLUMNS

X = np.linspace(0.0, 5.0, 60)


@pytest.mark.parametrize(
    "values",
    [
        np.where(np.arange(60) == 30, 1e12, 1.0),  # one outlier
        np.where(np.arange(60) == 30, 1e12, 0.0),  # and nothing else
        1e8 / (X + 1e-9),  # as the depth from next to rest on
        -X,  # a height
        np.full(60, -1e9),
        np.zeros(60),
    ],
    ids=["outlier", "outlier over zeros", "from rest", "negative", "far below", "zero"],
)
def test_a_chart_is_drawn_at_once_and_within_its_height(values):
    """Dots beyond the axis once took as many steps as the value is axes high: for ever."""
    lines = chart_lines(X, values, COLUMNS["depth_m"], 80, "metric", COLUMNS["s_m"])
    assert len(lines) < 20
    assert max(map(len, lines)) <= 80


def test_the_axis_takes_numbers_below_zero():
    lines = chart_lines(X, -X, COLUMNS["z_m"], 80, "metric", COLUMNS["s_m"])
    assert any("-5.000" in line for line in lines)
    assert sum("⠀" < letter <= "⣿" for line in lines for letter in line) > 20
