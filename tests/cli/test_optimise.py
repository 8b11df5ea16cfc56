"""``chutecalc optimise``: what it prints, writes, draws and refuses."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

import chutecalc
from chutecalc.cli import main
from chutecalc.output.printer import PIPE_WIDTH
from chutecalc.studies.optimise.neighbourhood import neighbourhood
from chutecalc.studies.optimise.plot import draw_optimum
from tests.conftest import ROOT
from tests.robustness.processes import run

SPOON = ROOT / "specs" / "paper" / "r3_d55_chamfered.toml"
RADIUS, BETA = "segments.spoon.radius_m", "sections.spoon.chamfer_deg"
SLOWEST = ["--minimise", "exit_velocity_m_s"]


@pytest.fixture
def spec(tmp_path):
    return shutil.copy(SPOON, tmp_path / "chute.toml")


def test_the_best_is_printed_with_what_decides_and_written(capsys, spec):
    given = ["optimise", str(spec), "beta=20:89", "radius=1:4", *SLOWEST, "--subject", "max_depth_m<=0.15"]
    assert main([*given, "--write"]) == 0
    out = capsys.readouterr().out
    assert "least exit_velocity_m_s, subject to max_depth_m<=0.15, no failure" in " ".join(out.split())
    assert "keys at the optimum" in out
    table = out.partition("limits that decide\n")[2].splitlines()
    assert [line.split() for line in table[:2]] == [
        ["1", "more", "changes"],
        ["limit", "state", "value", "exit_velocity_m_s", "by"],
    ]
    assert table[2].split()[:3] == ["max_depth_m<=0.15", "design", "0.15"]
    assert float(table[2].split()[3]) < 0.0
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
    assert document["violations"] == []
    assert document["subject"] == ["no failure"]
    low, high = document["keys_at_optimum"]["chamfer_deg"]["within_1_per_cent"]
    assert low < 49.0 < 50.0 < high
    assert document["keys_at_optimum"]["chamfer_deg"]["on_bound"] is None


def test_a_key_on_its_bound_is_told(capsys, spec):
    assert main(["optimise", str(spec), f"{RADIUS}=1:4", "--maximise", "exit_velocity_m_s"]) == 0
    out = capsys.readouterr().out
    assert "spoon radius m     4  upper" in out
    assert "no limit decides" in out


def table_below(out, title):
    """Return the cells of the rows of a table, those of words in one."""
    lines = out.partition(f"{title}\n")[2].split("\n\n")[0].splitlines()
    return [re.split(r"  +", line.strip()) for line in lines]


def test_nothing_feasible_is_said_with_all_that_is_violated_and_not_written(capsys, spec):
    with spec.open("a", encoding="utf-8") as stream:
        stream.write('\n[cases.rough]\n"liners.wall.friction_deg" = 27\n')
    before = spec.read_bytes()
    limits = ["--subject", "max_depth_m<=0.01", "--subject", "exit_velocity_m_s>=4.1", "--no-warnings", "--write"]
    file = spec.with_name("found.json")
    assert main(["optimise", str(spec), "radius=1:4", *SLOWEST, *limits, "--json", str(file)]) == 1
    out = capsys.readouterr().out
    assert spec.read_bytes() == before
    header = "subject to max_depth_m<=0.01, exit_velocity_m_s>=4.1, no failure, no warnings, worst of design, rough"
    assert header in " ".join(out.split())
    assert "no design within the bounds keeps all limits; this one comes closest:" in out
    document = json.loads(file.read_text(encoding="utf-8"))
    (radius,) = document["solutions"][0].values()
    solutions = chutecalc.solve_cases(chutecalc.load(spec).put({RADIUS: radius})).solutions
    depths = {state: own.segments["spoon"].maximum["depth_m"][0] for state, own in solutions.items()}
    told = {(each["limit"], each["state"]): (each["value"], each["by"]) for each in document["violations"]}
    for state, depth in depths.items():
        assert told["max_depth_m<=0.01", state] == (pytest.approx(depth), pytest.approx(depth - 0.01))
        velocity = solutions[state].exit_velocity[0]
        if velocity < 4.1:
            assert told["exit_velocity_m_s>=4.1", state] == (pytest.approx(velocity), pytest.approx(4.1 - velocity))
        else:
            assert ("exit_velocity_m_s>=4.1", state) not in told
        assert "below_cut_off" in told["no warnings", state][0]
    first, second = document["violations"][:2]
    assert first["limit"] == second["limit"] == "max_depth_m<=0.01"  # 13 times too deep comes first
    assert first["by"] > second["by"]
    rows = table_below(out, "limits violated, the worst first")[2:]
    assert [row[:2] for row in rows if len(row) > 1] == [list(each) for each in told]


def test_a_state_that_fails_is_among_what_is_violated(capsys, spec):
    with spec.open("a", encoding="utf-8") as stream:
        stream.write('\n[cases.sticky]\n"liners.wall.friction_deg" = 60\n')
    assert main(["optimise", str(spec), "radius=1:4", *SLOWEST]) == 1
    out = capsys.readouterr().out
    assert table_below(out, "limits violated, the worst first")[-1] == ["no failure", "sticky", "stall"]
    assert main(["optimise", str(spec), "radius=1:4", *SLOWEST, "--case", "design"]) == 0
    assert "no failure, design point alone" in " ".join(capsys.readouterr().out.split())


def test_a_limit_of_what_there_is_not_is_kept_as_in_a_study_of_uncertainty():
    """A steep ledge is flown past without an impact."""
    text = (ROOT / "specs" / "short_ledge.toml").read_text(encoding="utf-8")
    path, column = "segments.ledge.slope_deg", "segments.ledge.impact_incidence_deg"
    limit, most = f"{column}<=4", f"{column}<=90"
    chute = chutecalc.parse(text + f'\n[uncertainty]\n"{path}" = {{ uniform = [5, 60] }}\n')
    found = chutecalc.optimise(chute, {path: (5, 60)}, maximise="exit_velocity_m_s", subject=[limit])
    assert found.feasible
    assert np.isnan(found.outcome[column][0, 0])
    free = chutecalc.optimise(chute, {path: (5, 60)}, maximise="exit_velocity_m_s")
    assert found.worst["exit_velocity_m_s"][0] == pytest.approx(free.worst["exit_velocity_m_s"][0], rel=1e-9)
    samples = chutecalc.uncertain(chute, 1024, limits=[limit, most])
    assert samples.ok.all()
    assert np.isnan(samples.columns[column]).any()
    assert samples.exceeded[limit].share == (samples.columns[column] > 4.0).mean() > 0.0
    assert samples.exceeded[most].share == 0.0


def test_the_edge_of_a_failure_is_told_with_how_near_it_is(capsys, spec):
    """The rougher the wall the slower the exit, until the stream stalls."""
    found = chutecalc.optimise(chutecalc.load(spec), {"phi": (20, 60)}, "exit_velocity_m_s")
    ((bound,),) = found.binding
    assert bound.limit == "no failure"
    assert bound.values == {"design": "stall"}
    (edge,) = found.answers["friction_deg"].fails
    assert bound.edge == edge
    best = found.values["friction_deg"][0]
    assert edge.distance == pytest.approx((edge.value - best) / 40.0)
    assert 0.0 < edge.distance < 1e-4
    chute = chutecalc.load(spec)
    (path,) = found.keys[0].parameter.paths
    assert chutecalc.solve(chute.put({path: edge.value})).status[0] == "stall"
    assert chutecalc.solve(chute.put({path: best})).status[0] == "ok"
    assert main(["optimise", str(spec), "phi=20:60", *SLOWEST]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert re.search(r"this design is at the edge of a failure: φ \+\S+ ° \(\+\S+ %\) gives stall in design", out)
    assert "keep a margin: limit what leads to it, such as --subject 'min_velocity_m_s>=1'" in out
    margin = chutecalc.optimise(chute, {"phi": (20, 60)}, "exit_velocity_m_s", subject=["min_velocity_m_s>=1"])
    assert [each.limit for each in margin.binding[0]] == ["min_velocity_m_s>=1"]
    (edge,) = margin.answers["friction_deg"].fails
    assert edge.distance > 1e-3


def test_true_and_false_may_be_chosen(tmp_path):
    spec = shutil.copy(ROOT / "specs" / "short_ledge.toml", tmp_path / "ledge.toml")
    path = "segments.ledge.may_be_passed"
    found = chutecalc.optimise(chutecalc.load(spec), {path: [False, True]}, maximise="exit_velocity_m_s")
    assert found.changes() == {path: True}
    assert found.document()["solutions"] == [{path: True}]
    given = ["optimise", str(spec), f"{path}=false,true", "segments.head.length_m=0.7:0.9", "--write"]
    assert main([*given, "--maximise", "exit_velocity_m_s"]) == 0
    assert "may_be_passed = true\n" in Path(spec).read_text(encoding="utf-8")


def test_written_values_have_the_digits_that_matter_and_keep_all_limits(spec):
    subject = ["max_depth_m<=0.15", "exit_velocity_m_s<=3.6"]
    found = chutecalc.optimise(
        chutecalc.load(spec), {"beta": (20, 89), "radius": (0.5, 4)}, "exit_velocity_m_s", subject=subject
    )
    assert found.values["radius_m"][0] == 0.5
    assert len(repr(found.values["chamfer_deg"][0].item())) <= 12
    solution = chutecalc.solve(chutecalc.parse(found.text()))
    assert solution.exit_velocity[0] == found.worst["exit_velocity_m_s"][0] <= 3.6
    assert solution.segments["spoon"].maximum["depth_m"][0] <= 0.15
    flat = chutecalc.optimise(chutecalc.load(spec), {"beta": (20, 89)}, "exit_velocity_m_s")
    assert len(repr(flat.values["chamfer_deg"][0].item())) <= 7


def test_lines_fit_80_columns(capsys, spec):
    keys = [f"{RADIUS}=1.123456:4.123456:#3", f"{BETA}=20.123456:89.123456:#4", "flow.rate_t_h=900:1000"]
    limits = ["--subject", "exit_slope_deg<=0.15", "--subject", "exit_x_m<=9.15"]
    for more in ([], ["--subject", "exit_velocity_m_s<=1"], ["--maximise", "exit_x_m", "--points", "2"]):
        main(["optimise", str(spec), *keys, *SLOWEST, *limits, *more])
        lines = capsys.readouterr().out.splitlines()
        assert max(len(line) for line in lines if str(spec) not in line) <= PIPE_WIDTH


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


SLIP = "receiver_acceleration_length_m"


@pytest.fixture(scope="module")
def downhill():
    """The spec of a transfer onto a belt that runs downhill: where that is smooth the stream slips without end."""
    text = (ROOT / "specs" / "transfer_90.toml").read_text(encoding="utf-8")
    return text.replace("[receiver]", "[receiver]\nslope_deg = -20")


def test_designs_of_a_front_have_both_objectives(downhill):
    """The end of the chute is the same on each belt, so the first objective alone would not care."""
    keys = {"receiver.friction_deg": (10, 30)}
    found = chutecalc.optimise(chutecalc.parse(downhill), keys, ["exit_x_m", SLIP], case="design", points=2)
    assert found.feasible
    assert 0.0 < found.worst[SLIP][0] < 10.0


@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_an_infinite_column_is_written_and_as_an_objective_no_value(capsys, downhill, tmp_path):
    spec, file = tmp_path / "downhill.toml", tmp_path / "found.json"
    spec.write_text(downhill, encoding="utf-8")
    key, state = "receiver.friction_deg", ["--case", "design", "--json", str(file)]
    assert (
        main(["optimise", str(spec), f"{key}=5:10", "--minimise", "exit_x_m", "--subject", f"{SLIP}<=3", *state]) == 1
    )
    (violation,) = json.loads(file.read_text(encoding="utf-8"))["violations"]
    assert violation == {"limit": f"{SLIP}<=3", "state": "design", "value": None, "by": None}
    assert table_below(capsys.readouterr().out, "limits violated, the worst first")[-1][2:] == ["∞", "∞"]
    assert main(["optimise", str(spec), f"{key}=5:30", "--maximise", SLIP, *state]) == 0
    document = json.loads(file.read_text(encoding="utf-8"))
    assert 10.0 < document["worst"][SLIP][0] < np.inf
    assert main(["optimise", str(spec), f"{key}=5:10", "--minimise", SLIP, *state]) == 2
    assert f"has no {SLIP} in any design that was tried" in capsys.readouterr().err
    with spec.open("a", encoding="utf-8") as stream:
        stream.write('\n[cases.smooth]\n"receiver.friction_deg" = 5\n')
    assert main(["optimise", str(spec), f"{RADIUS}=3:4", "--minimise", SLIP, "--json", str(file)]) == 1
    rows = table_below(capsys.readouterr().out, "limits violated, the worst first")
    assert rows[-1] == [f"a value of {SLIP}", "smooth", "none"]


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["radius=1:4"], "give one column to minimise or to maximise"),
        (["radius=1:4", *SLOWEST, "--maximise", "exit_velocity_m_s"], "two different ones for a front"),
        (["radius=1:4", *SLOWEST, "--subject", "max_depth_m<0.2"], "a limit is COLUMN<=VALUE"),
        (["radius=1:4", *SLOWEST, "--subject", "depth<=0.2"], "unknown column depth"),
        (["radius=1:4", "--minimise", "findings"], "need columns of numbers"),
        (["phi=20:30", *SLOWEST, "--maximise", "max_fill"], "no max_fill in any design that was tried: choose another"),
        (["phi=20:30", "--maximise", "max_fill"], "no max_fill in any design that was tried: choose another"),
        (["phi=20,30", "--maximise", "max_fill"], "no max_fill in any design that was tried: choose another"),
        (["phi=20:30", *SLOWEST, "--subject", "max_fill<=0.9"], "that was tried: leave out the limit max_fill<=0.9"),
        (["radius=3", *SLOWEST], "one value leaves no choice"),
        (["radius=3,3", *SLOWEST], "one value leaves no choice"),
        (["segments.spoon.liner=wall,wall", *SLOWEST], "one value leaves no choice"),
        (["radius=1:4", *SLOWEST, "--case", "wet"], "the spec has no cases"),
        (["radius=1:4", *SLOWEST, "--take", "1"], "add --write"),
        (SLOWEST, "nothing may change"),
    ],
)
def test_what_makes_no_sense_is_told(capsys, arguments, problem):
    assert main(["optimise", str(SPOON), *arguments]) == 2
    assert problem in capsys.readouterr().err


def test_a_date_for_other_programs_that_is_none_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")  # which NumPy takes for a number once SciPy asks it for all it has
    ended = run("optimise", str(SPOON), "radius=2:4", "--minimise", "max_depth_m", folder=tmp_path)
    assert (ended.status, ended.err) == (0, ""), ended
