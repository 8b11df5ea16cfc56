"""The operating states of a chute in its picture: lines, marks, legend and notes say what their solutions say."""

import numpy as np
import pytest

import chutecalc
from chutecalc.output.plots.flights import STATIONS
from chutecalc.output.plots.layout import PANELS
from chutecalc.output.plots.run import draw_run
from chutecalc.output.plots.style import INK
from chutecalc.results.columns import COLUMNS
from tests.conftest import chute
from tests.unit.test_plot import by_name, drawn, explained, load

G = 9.80665


def states(name):
    return {
        each: solution for each, solution in chutecalc.solve_cases(load(name)).solutions.items() if each != "design"
    }


@pytest.mark.parametrize("units", ["metric", "us"])
def test_each_case_is_a_line_of_its_own_with_the_numbers_of_its_solution(units):
    _, axes, _ = drawn(load("transfer_90"), units=units)
    for panel in PANELS:
        lines = by_name(axes[panel], "case")
        for line, solution in zip(lines, states("transfer_90").values(), strict=True):
            stations = solution.stations(points=STATIONS)
            reached = np.isfinite(stations["s_m"][0]) & (stations["segment"][0] != "receiver:flight")
            count = int(reached.sum())  # behind them comes the flight to the belt
            for values, column in ((line.get_xdata(), "s_m"), (line.get_ydata(), panel)):
                expected = COLUMNS[column].converted(stations[column][0][reached], units)
                assert np.array_equal(values[:count], expected, equal_nan=True)
        assert len({(line.get_color(), line.get_linestyle()) for line in lines}) == len(lines)
    assert len({line.get_marker() for line in by_name(axes["side"], "case end")}) == 4
    assert {"design point", "dry", "wet", "surge", "slow_belt"} <= named(axes)
    assert INK not in {line.get_color() for line in by_name(axes["side"], "case")}


def named(axes):
    """Return the entries of both legends."""
    legends = [child for child in axes["key"].get_children() if type(child).__name__ == "Legend"]
    return {text.get_text() for legend in legends for text in legend.get_texts()}


def test_a_case_is_drawn_at_half_its_depth_above_its_surface():
    _, axes, _ = drawn(load("transfer_90"))
    for line, solution in zip(by_name(axes["side"], "case"), states("transfer_90").values(), strict=True):
        at = {name: values[0] for name, values in solution.stations(points=STATIONS).items()}
        guided = np.flatnonzero(np.isfinite(at["depth_m"]))
        side = np.where(at["segment"][guided] == "hood", -1.0, 1.0)
        slope = np.radians(at["slope_deg"][guided])
        half = 0.5 * side * at["depth_m"][guided]
        assert np.allclose(line.get_xdata()[guided], at["x_m"][guided] + half * np.sin(slope), rtol=0, atol=1e-12)
        assert np.allclose(line.get_ydata()[guided], at["z_m"][guided] + half * np.cos(slope), rtol=0, atol=1e-12)


def test_the_steel_and_the_stream_of_the_design_point_are_those_without_cases():
    loaded = load("transfer_90")
    alone = chutecalc.parse({key: table for key, table in loaded.data.items() if key != "cases"})
    (_, axes, _), (_, plain, _) = drawn(loaded), drawn(alone)
    for gid in ("surface", "free surface", "edge"):
        for one, other in zip(by_name(axes["side"], gid), by_name(plain["side"], gid), strict=True):
            assert np.array_equal(one.get_xydata(), other.get_xydata(), equal_nan=True)
    assert not by_name(plain["side"], "case")
    assert "design point" not in named(plain)
    assert explained(axes) == explained(plain)


def test_a_case_that_misses_has_a_cross_where_it_passes_the_steel():
    _, axes, _ = drawn(load("rock_box_slow_belt"))
    slow = states("rock_box_slow_belt")["slow_belt"]
    (end,) = by_name(axes["side"], "case end")
    (path,) = by_name(axes["side"], "case lost")
    x, z = end.get_xdata()[0], end.get_ydata()[0]
    assert end.get_marker() == "X"
    time = (x - slow.inlet["x_m"][0]) / slow.inlet["velocity_m_s"][0]  # it leaves the belt level
    assert z == pytest.approx(slow.inlet["z_m"][0] - 0.5 * G * time**2, rel=1e-12)
    # next to the start of the bed, to half a station of the path
    fallen = np.linspace(0.0, 2.0, 200_001)
    nearest = np.hypot(
        slow.inlet["x_m"][0] + slow.inlet["velocity_m_s"][0] * fallen - 1.6,
        slow.inlet["z_m"][0] - 0.5 * G * fallen**2 + 1.4,
    ).min()
    step = np.hypot(*np.diff(path.get_xydata(), axis=0).T).max()
    to_bed = np.hypot(x - 1.6, z + 1.4)
    assert nearest <= to_bed <= nearest + step
    assert "slow_belt (missed)" in named(axes)
    notes = axes["notes"].texts[0].get_text()
    assert "case slow_belt: status missed" in notes
    assert "failure missed: bed" in notes


def test_notes_name_the_warnings_that_a_case_has_to_tell():
    _, axes, _ = drawn(load("transfer_90"))
    notes = axes["notes"].texts[0].get_text().split("\n")
    assert any(
        line.startswith("case dry: status ok") and line.endswith("warning hard_landing, off_speed") for line in notes
    )
    assert not any(line.startswith("case wet") and "hard_landing" in line for line in notes)  # worst where it is dry


def test_a_case_that_goes_further_is_inside_the_panels():
    straight = {"kind": "straight", "slope_deg": 40.0, "length_m": 9.0, "name": "chute"}
    stalls = chute(
        inlet={"velocity_m_s": 1.0, "slope_deg": 40.0},
        liners={"wall": {"friction_deg": 45.0}},
        segments=[straight],
        cases={"smooth": {"liners.wall.friction_deg": 20.0}},
    )
    _, axes, (solution,) = drawn(stalls)
    assert solution.status[0] == "stall"
    assert axes["velocity_m_s"].get_xlim()[1] == pytest.approx(9.0, rel=1e-9)
    (end,) = by_name(axes["velocity_m_s"], "case end")
    assert axes["velocity_m_s"].get_ylim()[1] > end.get_ydata()[0]
    assert "smooth" in named(axes)


def test_a_case_that_stalls_has_a_cross_where_it_stops():
    straight = {"kind": "straight", "slope_deg": 40.0, "length_m": 9.0, "name": "chute"}
    rough = {"rough": {"liners.wall.friction_deg": 45.0}}
    _, axes, _ = drawn(chute(inlet={"velocity_m_s": 1.0, "slope_deg": 40.0}, segments=[straight], cases=rough))
    (end,), (stopped,) = by_name(axes["side"], "case end"), by_name(axes["velocity_m_s"], "case end")
    assert end.get_marker() == stopped.get_marker() == "X"
    assert stopped.get_ydata()[0] == 0.0
    assert np.hypot(end.get_xdata()[0], end.get_ydata()[0]) == pytest.approx(stopped.get_xdata()[0], rel=1e-12)
    assert "rough (stall)" in named(axes)


def test_a_solution_plots_itself_without_cases():
    axes = {each.get_label(): each for each in chutecalc.solve(load("transfer_90")).plot().axes}
    assert not by_name(axes["side"], "case")


def test_one_case_alone_is_drawn_as_the_chute_and_named_in_the_title():
    loaded = load("transfer_90")
    figure = draw_run([chutecalc.solve_cases(loaded, only="wet")])
    axes = {each.get_label(): each for each in figure.axes}
    assert figure.get_suptitle() == "90° transfer: coal, 1800 t/h — case wet"
    assert not by_name(axes["side"], "case")
    (line,) = by_name(axes["velocity_m_s"], "velocity_m_s")
    wet = states("transfer_90")["wet"].stations(points=STATIONS)
    own = wet["segment"][0] != "receiver:flight"
    assert np.array_equal(line.get_ydata()[: np.count_nonzero(own)], wet["velocity_m_s"][0, own])


def test_names_that_matplotlib_would_hide_are_in_the_legend():
    loaded = load("transfer_90")
    hidden = chutecalc.parse(loaded.data | {"cases": {"_full": {"flow.rate_t_h": 2000.0}}})
    _, axes, _ = drawn(hidden)
    assert "_full" in named(axes)
