"""``chutecalc optimise``: what it prints, writes, draws and refuses."""

import json
import shutil

import numpy as np
import pytest
from matplotlib.figure import Figure

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.optimise.neighbourhood import neighbourhood
from chutecalc.studies.optimise.plot import draw_optimum
from tests.conftest import ROOT

SPOON = ROOT / "specs" / "paper" / "r3_d55_chamfered.toml"
RADIUS, BETA = "segments.spoon.radius_m", "sections.spoon.chamfer_deg"
SLOWEST = ["--minimise", "exit_velocity_m_s"]


@pytest.fixture
def spec(tmp_path):
    return shutil.copy(SPOON, tmp_path / "chute.toml")


def test_the_best_is_printed_with_what_binds_and_written(capsys, spec):
    given = ["optimise", str(spec), "beta=20:89", "radius=1:4", *SLOWEST, "--subject", "max_depth_m<=0.15"]
    assert main([*given, "--write"]) == 0
    out = capsys.readouterr().out
    assert "least exit_velocity_m_s, subject to max_depth_m<=0.15\n" in out
    assert "keys at the optimum" in out
    assert "max_depth_m<=0.15 binds: exit_velocity_m_s changes by -" in out
    solution = chutecalc.solve(chutecalc.load(spec))
    best = chutecalc.optimise(
        chutecalc.load(SPOON), {"beta": (20, 89), "radius": (1, 4)}, "exit_velocity_m_s", subject=["max_depth_m<=0.15"]
    )
    assert solution.exit_velocity[0] == pytest.approx(best.worst["exit_velocity_m_s"][0], rel=1e-9)
    assert solution.exit["depth_m"][0] <= 0.15 * (1.0 + 1e-12)


def test_the_document_says_all_of_it(capsys, spec):
    assert main(["optimise", str(spec), "beta=20:89", *SLOWEST, "--json", "-"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["solutions"] == [{"chamfer_deg": pytest.approx(49.5008, abs=1e-3)}]
    assert document["outcome"][0]["exit_velocity_m_s"] == pytest.approx(document["worst"]["exit_velocity_m_s"][0])
    assert document["feasible"] is True
    assert document["binding"] == [[]]
    low, high = document["keys_at_optimum"]["chamfer_deg"]["within_1_per_cent"]
    assert low < 49.0 < 50.0 < high
    assert document["keys_at_optimum"]["chamfer_deg"]["on_bound"] is None


def test_a_key_on_its_bound_is_told(capsys, spec):
    assert main(["optimise", str(spec), f"{RADIUS}=1:4", "--maximise", "exit_velocity_m_s"]) == 0
    out = capsys.readouterr().out
    assert "spoon radius m     4  upper" in out
    assert "no limit binds" in out


def test_nothing_feasible_is_said_and_not_written(capsys, spec):
    before = spec.read_bytes()
    given = ["optimise", str(spec), "radius=1:4", *SLOWEST, "--subject", "max_depth_m<=0.01", "--write"]
    assert main(given) == 1
    assert "no feasible design within the bounds; this one lacks least:" in capsys.readouterr().out
    assert spec.read_bytes() == before


def explained(figure):
    """Return the entries of the legend."""
    return [text.get_text().replace("\n", " ") for text in figure.legends[0].get_texts()]


def drawn_as(figure, gid):
    axes = figure.axes[0]
    return [each for each in (*axes.lines, *axes.patches, *axes.collections) if each.get_gid() == gid]


def test_pictures(tmp_path, spec):
    chute = chutecalc.load(spec)
    found = chutecalc.optimise(chute, {RADIUS: (1, 4), BETA: (20, 89)}, minimise="exit_velocity_m_s")
    near = neighbourhood(found)
    assert near.best == [found.values[RADIUS][0], found.values[BETA][0]]
    assert near.worst.shape == (33 * 33,)
    assert near.worst.min() >= found.worst["exit_velocity_m_s"][0] * (1.0 - 1e-9)
    figure = draw_optimum(found)
    assert isinstance(figure, Figure)
    (mark,) = drawn_as(figure, "best")
    assert (mark.get_xdata()[0], mark.get_ydata()[0]) == tuple(near.best)
    assert explained(figure) == ["best design"]
    file = tmp_path / "front.svg"
    given = ["--minimise", "max_depth_m", "--maximise", "exit_velocity_m_s", "--points", "3", "--plot", str(file)]
    assert main(["optimise", str(spec), "rate=500:1500", *given]) == 0
    assert file.stat().st_size > 1000


def test_what_limits_and_warnings_exclude_is_hatched_and_named(spec):
    keys = {RADIUS: (1, 4), BETA: (20, 89)}
    chute = chutecalc.load(spec)
    found = chutecalc.optimise(chute, keys, "exit_velocity_m_s", subject=["max_depth_m<=0.15"])
    near = neighbourhood(found)
    (margin,) = near.margins.values()
    radius, beta = (each.values for each in near.sweep.parameters)
    for k in (0, 40, 500, 1088):
        one = chutecalc.solve(chute.put({RADIUS: radius[k // 33], BETA: beta[k % 33]}))
        assert margin[k] == pytest.approx(0.15 - np.nanmax(one.stations(points=101)["depth_m"]), abs=1e-5)
    figure = draw_optimum(found)
    assert explained(figure) == ["best design", "excluded: max_depth_m > 0.15"]
    assert len(drawn_as(figure, "excluded")) == 1
    assert 0 < (margin < 0.0).sum() < margin.size
    unlimited = np.where(margin < 0.0, np.inf, near.worst)
    assert unlimited.min() >= found.worst["exit_velocity_m_s"][0] * (1.0 - 1e-9)
    assert near.worst.min() < found.worst["exit_velocity_m_s"][0]  # where the limit excludes it
    strict = chutecalc.optimise(chute, keys, "exit_velocity_m_s", no_warnings=True)
    words = explained(draw_optimum(strict))
    assert any(text.startswith("excluded: warnings (") and "below_cut_off" in text for text in words)


def test_the_picture_shows_the_worst_case_of_each_design_and_says_so():
    chute = chutecalc.load(ROOT / "specs" / "transfer_90.toml")
    found = chutecalc.optimise(
        chute, {"segments.spoon.to_slope_deg": (20, 40)}, "receiver_velocity_into_m_s", subject=["exit_depth_m<=0.17"]
    )
    near = neighbourhood(found)
    assert set(found.states) == {"design", "dry", "wet", "surge", "slow_belt"}
    (slope,) = near.sweep.parameters
    middle = chute.put({"segments.spoon.to_slope_deg": slope.values[100]})
    states = chutecalc.solve_cases(middle)
    into = {name: states[name].receiver["velocity_into_m_s"][0] for name in found.states}
    assert near.worst[100] == pytest.approx(max(into.values()), rel=1e-9)
    assert found.states[near.state[100]] == max(into, key=into.get)
    figure = draw_optimum(found)
    assert figure.axes[0].get_title(loc="left").endswith(", in its worst case")
    assert "each is shown in the worst of design, dry, wet, surge, slow_belt; " in figure.get_supxlabel()
    assert any(text.startswith("excluded: exit_depth_m > 0.17 in ") for text in explained(figure))
    alone = chutecalc.optimise(chute, {"segments.spoon.to_slope_deg": (20, 40)}, "exit_velocity_m_s", case="wet")
    assert draw_optimum(alone).axes[0].get_title(loc="left").endswith(", case wet")


def test_one_key_is_drawn_as_a_line_and_choices_alone_are_not(spec):
    chute = chutecalc.load(spec)
    figure = draw_optimum(chutecalc.optimise(chute, {RADIUS: (1, 4)}, minimise="exit_velocity_m_s"))
    assert [line.get_gid() for line in figure.axes[0].lines].count("best") == 1
    with pytest.raises(chutecalc.UsageError, match="a key with bounds"):
        draw_optimum(chutecalc.optimise(chute, {RADIUS: (1, 4, 1)}, minimise="exit_velocity_m_s"))


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["radius=1:4"], "give one column to minimise or to maximise"),
        (["radius=1:4", *SLOWEST, "--maximise", "exit_velocity_m_s"], "two different ones for a front"),
        (["radius=1:4", *SLOWEST, "--subject", "max_depth_m<0.2"], "a limit is COLUMN<=VALUE"),
        (["radius=1:4", *SLOWEST, "--subject", "depth<=0.2"], "unknown column depth"),
        (["radius=1:4", "--minimise", "findings"], "need columns of numbers"),
        (["radius=3", *SLOWEST], "one value leaves no choice"),
        (["radius=1:4", *SLOWEST, "--case", "wet"], "the spec has no cases"),
        (["radius=1:4", *SLOWEST, "--take", "1"], "add --write"),
        (SLOWEST, "nothing may change"),
    ],
)
def test_what_makes_no_sense_is_told(capsys, arguments, problem):
    assert main(["optimise", str(SPOON), *arguments]) == 2
    assert problem in capsys.readouterr().err
