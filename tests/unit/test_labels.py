"""Labels of pictures: they cover neither each other nor what is drawn, and stay on the axes."""

import itertools

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

import chutecalc
from chutecalc.output.plots.labels import Label, dense, place_labels
from chutecalc.output.plots.run import draw_run
from chutecalc.output.plots.style import lay_out, styled
from chutecalc.output.plots.text import fitted, legend_rows, width_of
from tests.conftest import ROOT, chute

SPECS = [
    path.relative_to(ROOT / "specs").as_posix().removesuffix(".toml")
    for path in sorted((ROOT / "specs").glob("**/*.toml"))
    if "baseline" not in path.name and "paper" not in path.parts
]


def boxes(axes):
    """Return the boxes of the labels of axes, as drawn by Agg, pixels."""
    renderer = FigureCanvasAgg(axes.figure).get_renderer()
    axes.figure.draw(renderer)
    return [Text.get_window_extent(text, renderer) for text in axes.texts]  # without the lines that lead there


@pytest.mark.parametrize("name", SPECS)
def test_labels_keep_apart_and_on_the_axes(name):
    figure = draw_run([chutecalc.solve_cases(chutecalc.load(ROOT / "specs" / f"{name}.toml"))])
    side = next(axes for axes in figure.axes if axes.get_label() == "side")
    found = boxes(side)
    assert found
    for one, other in itertools.combinations(found, 2):
        assert not one.overlaps(other)
    frame = side.get_window_extent()
    for box in found:
        assert frame.x0 - 1 <= box.x0
        assert box.x1 <= frame.x1 + 1
        assert frame.y0 - 1 <= box.y0
        assert box.y1 <= frame.y1 + 1


def test_names_of_short_segments_stand_at_the_end_of_a_line():
    straights = [
        {"kind": "straight", "slope_deg": slope, "length_m": length, "name": name}
        for slope, length, name in [
            (60.0, 4.0, "upper"),
            (55.0, 0.1, "kink"),
            (50.0, 0.1, "bend"),
            (45.0, 4.0, "lower"),
        ]
    ]
    states = chutecalc.solve_cases(chute(inlet={"velocity_m_s": 3.0, "slope_deg": 60.0}, segments=straights))
    side = next(axes for axes in draw_run([states]).axes if axes.get_label() == "side")
    leads = {text.get_text(): text.arrow_patch is not None for text in side.texts}
    assert leads["kink"]
    assert leads["bend"]
    assert not leads["upper"]
    assert not leads["lower"]


def test_a_label_takes_the_side_that_is_free():
    with styled():
        figure = Figure(figsize=(4.0, 4.0))
        axes = figure.subplots()
        axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
        lay_out(figure)
        wall = [np.array([[0.0, 1.0], [level, level]]) for level in np.linspace(0.5, 1.0, 60)]
        place_labels(axes, [Label("word", 0.5, 0.5, (0.0, 1.0))], wall)
    assert axes.texts[0].xyann[1] < 0.0  # above is best, but taken


def test_points_along_a_path_leave_out_what_is_unknown():
    path = np.array([[0.0, 0.0], [np.nan, 1.0], [0.0, 10.0]])
    assert np.isfinite(dense(path)).all()
    assert np.diff(dense(path)[:, 1]).max() <= 2.0
    assert dense(path[1:2]).shape == (0, 2)


def test_fitted_text_is_as_wide_as_it_may_be():
    lines = fitted("the stream strikes the surface " * 20, 10.0).split("\n")
    assert max(width_of(line) for line in lines) <= 720.0
    assert min(width_of(line) for line in lines[:-1]) > 500.0
    assert fitted("a b " * 100, 1.0, most=2).count("\n") == 1


def test_rows_of_a_legend_are_those_of_its_tallest_column():
    assert legend_rows(["a", "b", "c\nd", "e"], 2) == 3
    assert legend_rows(["a"] * 5, 2) == 3
