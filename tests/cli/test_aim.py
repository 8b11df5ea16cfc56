"""``chutecalc aim``: what it prints, writes and refuses."""

import json
import shutil
import tomllib

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.output.printer import PIPE_WIDTH
from tests.conftest import ROOT

SPOON = ROOT / "specs" / "paper" / "r3_d55_chamfered.toml"
RADIUS = "segments.spoon.radius_m"


@pytest.fixture
def spec(tmp_path):
    return shutil.copy(SPOON, tmp_path / "chute.toml")


def test_the_spec_that_it_writes_gives_what_was_asked_and_keeps_its_comments(capsys, spec):
    before = spec.read_text(encoding="utf-8")
    assert main(["aim", str(spec), "radius=1:4", "--target", "exit_velocity_m_s=3.7", "--write"]) == 0
    assert "1 solution within the bounds\nwrote segments.spoon.radius_m = 2.398" in capsys.readouterr().out
    after = spec.read_text(encoding="utf-8")
    changed = [(one, other) for one, other in zip(before.split("\n"), after.split("\n"), strict=True) if one != other]
    assert [other.startswith("radius_m = 2.398") for _, other in changed] == [True]
    assert chutecalc.solve(chutecalc.load(spec)).exit_velocity[0] == pytest.approx(3.7, rel=1e-9)


def test_a_written_value_has_the_digits_that_the_target_needs(spec):
    for keys, targets in (
        ({"beta": (20, 89)}, {"exit_velocity_m_s": 3.88}),
        ({RADIUS: (1, 4), "rate": (500, 1500)}, {"exit_velocity_m_s": 3.7, "exit_depth_m": 0.15}),
        ({RADIUS: (2.5, 4)}, {"exit_x_m": 2.5}),
    ):
        found = chutecalc.aim(chutecalc.load(spec), keys, targets)
        assert found.count
        for take in range(1, found.count + 1):
            solution = chutecalc.solve(chutecalc.parse(found.text(take)))
            for name, wanted in targets.items():
                error = abs(solution.exit[name.removeprefix("exit_")][0] - wanted)
                assert error <= 1e-9 * max(1.0, wanted)
            assert max(len(repr(value)) for value in found.changes(take).values()) <= 13
    assert found.changes() == {RADIUS: 2.5}
    nearest = chutecalc.aim(chutecalc.load(spec), {"beta": (20, 89)}, {"exit_velocity_m_s": 3.0}).nearest
    assert nearest is not None
    assert len(repr(nearest.changes()["sections.spoon.chamfer_deg"])) <= 9


def test_lines_fit_80_columns(capsys, spec):
    arguments = [f"{RADIUS}=1.123456:4.123456", "sections.spoon.chamfer_deg=20.123456:89.123456"]
    given = ["--target", "exit_velocity_m_s=3.7", "--target", "exit_depth_m=0.15", "--write"]
    assert main(["aim", str(spec), *arguments, *given]) == 0
    out = capsys.readouterr().out
    path = str(spec)
    assert all(len(line) <= PIPE_WIDTH for line in out.splitlines() if path not in line)
    assert f"{RADIUS} 1.12346 to" in " ".join(out.split())


def test_a_solution_in_another_unit_replaces_the_key(spec):
    assert main(["aim", "radius_ft=3:13", str(spec), "--target", "exit_velocity_m_s=3.7", "--write"]) == 0
    segment = tomllib.loads(spec.read_text(encoding="utf-8"))["segments"][1]
    assert "radius_m" not in segment
    assert segment["radius_ft"] == pytest.approx(2.3984533 / 0.3048)
    assert chutecalc.solve(chutecalc.load(spec)).exit_velocity[0] == pytest.approx(3.7, rel=1e-9)


def test_the_document_has_solutions_and_their_outcome(capsys, spec):
    assert main(["aim", str(spec), f"{RADIUS}=1:4", "--target", "exit_velocity_m_s=3.7", "--json", "-"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["solutions"] == [{RADIUS: pytest.approx(2.3984533)}]
    assert document["outcome"][0]["exit_velocity_m_s"] == pytest.approx(3.7, rel=1e-9)
    assert document["outcome"][0]["status"] == "ok"
    assert document["targets"] == {"exit_velocity_m_s": 3.7}
    assert document["keys"][RADIUS] == {"paths": [RADIUS], "bounds": [1.0, 4.0], "choices": None}


def test_none_is_said_with_the_nearest_and_nothing_is_written(capsys, spec):
    before = spec.read_bytes()
    assert main(["aim", str(spec), "radius=1:4", "--target", "exit_velocity_m_s=9", "--write"]) == 1
    out = capsys.readouterr().out
    assert "no solution within the bounds\ndesigns tried: 257 ok\nthe nearest that can be had:" in out
    assert "     4  ok         4.159" in out
    assert spec.read_bytes() == before
    assert main(["aim", str(spec), "phi=60:70", "--target", "exit_velocity_m_s=3"]) == 1
    assert capsys.readouterr().out.endswith("no solution within the bounds\ndesigns tried: 257 stall\n")


def test_of_several_one_is_taken(capsys, spec):
    given = ["aim", str(spec), "beta=20:89", "--target", "exit_velocity_m_s=3.88"]
    assert main(given) == 0
    out = capsys.readouterr().out
    assert "2 solutions within the bounds" in out
    assert out.count(" ok ") == 4  # two rows, in two tables
    before, file = spec.read_bytes(), spec.with_name("found.json")
    for take, problem in ([], "there are 2 solutions: choose one"), (["--take", "3"], "there is no solution 3 to take"):
        assert main([*given, "--write", *take, "--json", str(file)]) == 2
        told = capsys.readouterr()
        assert "2 solutions within the bounds" in told.out
        assert f"nothing written into {spec}: {problem}" in told.err
        assert len(json.loads(file.read_text(encoding="utf-8"))["solutions"]) == 2
        assert spec.read_bytes() == before
        file.unlink()
    assert main([*given, "--write", "--take", "2"]) == 0
    angle = tomllib.loads(spec.read_text(encoding="utf-8"))["sections"]["spoon"]["chamfer_deg"]
    assert angle == pytest.approx(55.5005, abs=1e-4)


def test_a_case_may_have_to_meet_the_target(capsys, spec):
    with spec.open("a", encoding="utf-8") as stream:
        stream.write('\n[cases.wet]\n"material.internal_friction_deg" = 40\n')
    assert main(["aim", str(spec), "radius=1:4", "--target", "exit_velocity_m_s=3.5", "--case", "wet", "--write"]) == 0
    chute = chutecalc.load(spec)
    assert chutecalc.solve(chute.cases["wet"]).exit_velocity[0] == pytest.approx(3.5, rel=1e-9)
    assert abs(chutecalc.solve(chute).exit_velocity[0] - 3.5) > 0.01


TARGET = ["--target", "exit_velocity_m_s=3.7"]


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ([SPOON, "radius=1:4"], "1 key for 0 targets: an aim takes as many keys as targets"),
        ([SPOON, "radius=1:4", "beta=1:80", *TARGET], "2 keys for 1 target"),
        ([SPOON, *TARGET], "nothing may change: add a key with its bounds"),
        ([SPOON, "radius=4:1", *TARGET], "the lower bound must be below the upper one"),
        ([SPOON, "radius=1,4", *TARGET], "an aim needs bounds, radius_m=LOW:HIGH"),
        ([SPOON, "case=wet:dry", *TARGET], "choose a state with --case"),
        ([SPOON, "radius=a:b", *TARGET], "not a number"),
        (["radius=1:4", *TARGET], "name one spec"),
        ([SPOON, "radius=1:4", "--target", "status=ok"], "ok is not a number"),
        ([SPOON, "radius=1:4", "--target", "status=1"], "a target needs a column of numbers"),
        ([SPOON, "radius=1:4", "--target", "velocity=1"], "unknown column velocity"),
        ([SPOON, "radius=1:4", "--target", "exit_velocity_m_s"], "takes COLUMN=VALUE"),
        ([SPOON, "radius=1:4", *TARGET, *TARGET], "given twice"),
        ([SPOON, "radius=1:4", *TARGET, "--case", "wet"], "the spec has no cases"),
        ([SPOON, "radius=1:4", *TARGET, "--take", "1"], "add --write"),
        (["-", "radius=1:4", *TARGET, "--write"], "not standard input"),
        ([SPOON, "phi=10:20", "--target", "exit_slope_deg=0"], "more than 50 solutions"),
        ([SPOON, "radius=1:4", "--target", "max_fill=0.5"], "no max_fill in any design that was tried: choose another"),
    ],
)
def test_what_makes_no_sense_is_told(capsys, arguments, problem):
    assert main(["aim", *map(str, arguments)]) == 2
    assert problem in capsys.readouterr().err


def test_an_aim_in_python_is_shown_and_written(spec):
    chute = chutecalc.load(spec)
    found = chutecalc.aim(chute, {RADIUS: (1, 4)}, {"exit_velocity_m_s": 3.7}, columns=["exit_depth_m"])
    assert repr(found) == "<Aim at exit_velocity_m_s = 3.7: 1 solution>"
    assert list(found.outcome) == ["status", "exit_velocity_m_s", "exit_depth_m", "warnings"]
    assert "<td>2.39845</td>" in found._repr_html_()
    found.write()
    assert spec.read_text(encoding="utf-8") == found.text()
    assert chutecalc.load(spec).spec.segments[1].radius_m == found.values[RADIUS][0]
    with pytest.raises(chutecalc.UsageError, match="no file"):
        chutecalc.aim(chutecalc.parse(chutecalc.STARTER), {RADIUS: (1, 4)}, {"exit_velocity_m_s": 3.7}).write()
    with pytest.raises(chutecalc.UsageError, match="give bounds"):
        chutecalc.aim(chute, {RADIUS: 3}, {"exit_velocity_m_s": 3.7})
