"""``chutecalc optimise``: what it prints, writes, draws and refuses."""

import json
import shutil

import pytest
from matplotlib.figure import Figure

import chutecalc
from chutecalc.cli import main
from chutecalc.studies.optimise.plot import draw_optimum, neighbourhood
from chutecalc.studies.sweep.solved_blocks import solve_block
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


def test_pictures(tmp_path, spec):
    chute = chutecalc.load(spec)
    found = chutecalc.optimise(chute, {RADIUS: (1, 4), BETA: (20, 89)}, minimise="exit_velocity_m_s")
    sweep, best = neighbourhood(found)
    assert best == [found.values[RADIUS][0], found.values[BETA][0]]
    assert sweep.count == 33 * 33
    assert solve_block(sweep, 0)["exit_velocity_m_s"].min() >= found.worst["exit_velocity_m_s"][0] * (1.0 - 1e-9)
    figure = draw_optimum(found)
    assert isinstance(figure, Figure)
    (mark,) = [line for line in figure.axes[0].lines if line.get_gid() == "best"]
    assert (mark.get_xdata()[0], mark.get_ydata()[0]) == tuple(best)
    file = tmp_path / "front.svg"
    given = ["--minimise", "max_depth_m", "--maximise", "exit_velocity_m_s", "--points", "3", "--plot", str(file)]
    assert main(["optimise", str(spec), "rate=500:1500", *given]) == 0
    assert file.stat().st_size > 1000


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
