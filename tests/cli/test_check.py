"""``chutecalc check`` through ``main``: every kind of difference, its message and its status."""

import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest
import tomli_w

import chutecalc
from chutecalc.cli import main
from chutecalc.errors import SpecError
from chutecalc.studies.regression.baseline import RowKey, column_of
from chutecalc.studies.regression.check import check
from chutecalc.studies.regression.compare import compare
from chutecalc.studies.regression.designs import find_designs
from chutecalc.studies.regression.record import baseline_of, baseline_path, read_baseline
from tests.conftest import LEVEL, ROOT, STANDARD_DESIGNS


@pytest.fixture
def folder(tmp_path, monkeypatch, capsys):
    """Return a folder with one design, spoon.toml, and its baseline."""
    monkeypatch.chdir(tmp_path)
    Path("spoon.toml").write_text(LEVEL, encoding="utf-8")
    assert main(["check", "--update"]) == 0
    assert capsys.readouterr().out == "wrote spoon.baseline.toml\n1 design: 1 written\n"
    return tmp_path


def edit(file, old, new):
    text = Path(file).read_text(encoding="utf-8")
    assert old in text
    Path(file).write_text(text.replace(old, new, 1), encoding="utf-8")


def baseline():
    return tomllib.loads(Path("spoon.baseline.toml").read_text(encoding="utf-8"))


def rewrite(document):
    Path("spoon.baseline.toml").write_text(tomli_w.dumps(document), encoding="utf-8")


def outcome(capsys, *arguments):
    """Return the status, the outcome of the one design, and its messages."""
    capsys.readouterr()
    status = main(["check", *arguments, "--json", "-"])
    (design,) = json.loads(capsys.readouterr().out)["designs"]
    return status, design["outcome"], [change["message"] for change in design["changes"]] + design["notes"]


def test_what_is_as_it_was_passes_and_is_left_alone(folder, capsys):
    written = (folder / "spoon.baseline.toml").stat().st_mtime_ns
    assert main(["check"]) == 0
    assert capsys.readouterr().out == "1 design: 1 ok\n"
    assert main(["check", "--update"]) == 0
    assert capsys.readouterr().out == "1 design: 1 ok\n"
    assert (folder / "spoon.baseline.toml").stat().st_mtime_ns == written


def test_comments_layout_and_line_ends_are_no_edit(folder, capsys):
    text = LEVEL.replace("\n", "   # as before\r\n").replace("rate_t_h = 1000", "rate_t_h   =  1000")
    Path("spoon.toml").write_bytes(text.encode())
    assert main(["check"]) == 0


def test_a_changed_liner_is_an_edited_spec_and_all_that_drifted_is_told_with_its_place(folder, capsys):
    edit("spoon.toml", "friction_deg = 25", "friction_deg = 26")
    assert main(["check"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == [
        "spoon.toml: edited (tolerance 1e-09)",
        "  the spec has been edited since its baseline was written; if that is intended, run check --update",
    ]
    numbers, places = (line.split() for line in lines if line.split()[:1] == ["velocity_m_s"])  # two tables: 80 columns
    before = chutecalc.solve(chutecalc.parse(LEVEL)).exit_velocity[0]
    after = chutecalc.solve(chutecalc.load("spoon.toml")).exit_velocity[0]
    # it is right at the start of the spoon, off at the first station behind it, and most at its end
    places = [*numbers[4:], *places[1:]]
    assert [places[k] for k in (0, 1, 2, 4, 5, 6, 7, 9)] == ["spoon,", "s", "=", "m", "spoon,", "s", "=", "m"]
    assert float(places[8]) == pytest.approx(2.0 + 3.0 * 3.14159265 / 8.0, abs=1e-3)
    assert float(places[3]) == pytest.approx(2.0 + 3.0 * 3.14159265 / 2.0, abs=1e-3)
    assert (float(numbers[1]), float(numbers[2])) == (pytest.approx(before, rel=1e-3), pytest.approx(after, rel=1e-3))
    scale = baseline()["segments"][1]["maximum"]["velocity_m_s"]
    assert float(numbers[3]) == pytest.approx((before - after) / scale, rel=0.05)
    assert lines[-1] == "1 design: 1 edited"


def test_a_changed_result_of_the_same_spec_has_drifted(folder, capsys):
    document = baseline()
    document["segments"][1]["stations"][2]["depth_m"] *= 1.0 + 1e-6
    rewrite(document)
    assert main(["check"]) == 1
    shown = capsys.readouterr().out
    assert shown.startswith("spoon.toml: drifted (tolerance 1e-09)\n")
    assert "edited" not in shown
    assert outcome(capsys) == (1, "drifted", [])
    main(["check", "--json", "-"])
    (drift,) = json.loads(capsys.readouterr().out)["designs"][0]["drifts"]
    assert (drift["segment"], drift["row"], drift["column"]) == ("spoon", "station 3", "depth_m")
    deepest = max(station["depth_m"] for station in document["segments"][1]["stations"])
    assert drift["off_by"] == pytest.approx(abs(drift["was"] - drift["is"]) / deepest)


def test_drift_is_measured_against_the_scale_of_the_column_and_the_tolerance_of_the_baseline(folder, capsys):
    document = baseline()
    entry, end = document["segments"][0]["stations"][0], document["segments"][1]["stations"][4]
    assert entry["velocity_m_s"] == 0.0  # nothing is relative to 0, so the scale of the column counts
    scale = document["segments"][1]["maximum"]["velocity_m_s"]
    for off, status in ((0.8e-9, 0), (1.2e-9, 1)):
        entry["velocity_m_s"] = off * scale
        rewrite(document)
        assert main(["check"]) == status
    document["tolerance"] = 1e-6
    end["velocity_m_s"] += 0.9e-6 * scale
    rewrite(document)
    assert main(["check"]) == 0
    end["velocity_m_s"] += 0.2e-6 * scale
    rewrite(document)
    assert main(["check", "--update"]) == 0
    assert baseline()["tolerance"] == 1e-6  # stays as it was set
    assert len(str(baseline()["segments"][1]["stations"][4]["velocity_m_s"])) == len("3.8779197")


def test_a_number_that_came_to_be_or_ceased_to_has_drifted(folder, capsys):
    document = baseline()
    del document["segments"][1]["stations"][4]["velocity_m_s"]
    document["segments"][0]["stations"][0]["depth_m"] = 0.1
    rewrite(document)
    assert main(["check"]) == 1
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    values = {row[0]: row[1:3] for row in reversed(rows) if len(row) > 3}  # the first table has the numbers
    assert values["velocity_m_s"][0] == "none"
    assert values["depth_m"][1] == "none"


def test_an_extreme_that_only_one_keeps_is_held_to_the_stations_of_the_other(folder):
    chute = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    now = baseline_of(chute, chutecalc.solve(chute), [])
    number, name = next((k, name) for k, segment in enumerate(now.segments) for name in segment.maximum)
    was = now.model_copy(deep=True)
    station = max(row[name] for row in now.segments[number].stations if name in row)
    del was.segments[number].maximum[name]
    now.segments[number].maximum[name] = station * (1.0 + 1.5e-6)  # on the border it is kept or not by rounding
    assert compare(was, now) == ([], [])
    now.segments[number].maximum[name] = station * 1.1
    _, (drift,) = compare(was, now)
    assert (drift.column, drift.was) == (name, station)
    assert drift.off == pytest.approx(0.1 / 1.1)


def test_a_column_that_the_baseline_does_not_know_is_a_note_and_one_that_is_gone_fails(folder, capsys):
    """As after an update of chutecalc that stores more."""
    document = baseline()
    rows = [row for segment in document["segments"] for row in segment["stations"]]
    for row in rows:
        row.pop("depth_m", None)
    for segment in document["segments"]:
        for extremes in ("minimum", "maximum"):
            segment.get(extremes, {}).pop("depth_m", None)
    rewrite(document)
    note = "not compared, because the baseline does not have it until --update adds it: depth_m"
    assert outcome(capsys) == (0, "ok", [note])
    assert main(["check"]) == 0
    assert f"{note}: 1 design unchanged" in capsys.readouterr().out
    assert main(["check", "--update"]) == 0
    assert any("depth_m" in row for segment in baseline()["segments"] for row in segment["stations"])
    document = baseline()
    document["segments"][1]["stations"][4]["older_m"] = 1.0
    rewrite(document)
    capsys.readouterr()
    assert outcome(capsys) == (1, "drifted", [])


def test_the_inlet_and_impacts_are_held_too_and_an_impact_is_where_its_segment_begins(folder):
    chute = chutecalc.load(ROOT / "specs" / "impact_plate.toml")
    solution = chutecalc.solve(chute)
    now = baseline_of(chute, solution, [])
    was = now.model_copy(deep=True)
    assert compare(was, now) == ([], [])
    was.segments[1].impact["incidence_deg"] += 1.0
    was.inlet["velocity_m_s"] *= 1.5
    del was.segments[1].impact["velocity_after_m_s"]
    _, drifts = compare(was, now)
    found = {drift.column: drift for drift in drifts}
    assert found.keys() == {"incidence_deg", "velocity_m_s", "velocity_after_m_s"}
    assert found["velocity_m_s"].key == RowKey("inlet", 1, "")
    assert found["incidence_deg"].key == found["velocity_after_m_s"].key == ("plate", 1, "impact")
    struck = solution.segments[1].entry["s_m"][0]
    assert found["incidence_deg"].s_m == found["velocity_after_m_s"].s_m == struck
    assert found["velocity_after_m_s"].off == 1.0  # it came to be
    largest = max(row["slope_deg"] for _, row in now.rows() if "slope_deg" in row)  # of all angles in this chute
    assert found["incidence_deg"].off == pytest.approx(1.0 / max(largest, was.segments[1].impact["incidence_deg"]))


def test_numbers_of_a_segment_that_only_one_has_are_not_listed_and_the_receivers_are(folder):
    chute = chutecalc.load(ROOT / "specs" / "belt_hood_spoon.toml")
    now = baseline_of(chute, chutecalc.solve(chute), [])
    was = now.model_copy(deep=True)
    gone = was.segments.pop()
    was.receiver["velocity_ratio"] += 0.1
    changes, (drift,) = compare(was, now)
    assert [change.message for change in changes] == [f"segment {gone.name} is not in the baseline"]
    assert (drift.key, drift.column) == (("receiver", 1, ""), "velocity_ratio")


def test_what_is_empty_or_minus_nothing_is_not_written(folder):
    chute = chutecalc.load("spoon.toml")
    now = baseline_of(chute, chutecalc.solve(chute), [])
    now.inlet["x_m"] = -1e-30
    document = now.document()
    assert str(document["inlet"]["x_m"]) == "0.0"
    assert "receiver" not in document  # the spec has none
    for segment in document["segments"]:
        assert all(segment.values()), segment


def test_a_removed_segment(folder, capsys):
    document = baseline()
    kept = document["segments"]
    document["segments"] = kept[:1]
    rewrite(document)
    assert outcome(capsys) == (1, "changed", ["segment spoon is not in the baseline"])
    document["segments"] = [*kept, kept[1] | {"name": "apron"}]
    rewrite(document)
    assert outcome(capsys) == (1, "changed", ["segment apron is in the baseline only"])
    assert main(["check", "spoon.toml", "--json", "-"]) == 1
    (change,) = json.loads(capsys.readouterr().out)["designs"][0]["changes"]
    assert change["segment"] == "apron"
    document["segments"] = [kept[0], kept[1] | {"kind": "straight"}]
    rewrite(document)
    assert outcome(capsys) == (1, "changed", ["segment spoon is a curve; in the baseline it is a straight"])
    edit("spoon.toml", LEVEL[LEVEL.index('[[segments]]\nname = "spoon"') :], "")
    status, word, messages = outcome(capsys)
    assert (status, word) == (1, "edited")
    assert "segment spoon is in the baseline only" in messages


def test_another_end(folder, capsys):
    document = baseline()
    document["status"] = document["segments"][1]["status"] = "stall"
    rewrite(document)
    messages = [
        "the status is ok; in the baseline it is stall",
        "the status of segment spoon is ok; in the baseline it is stall",
    ]
    assert outcome(capsys) == (1, "changed", messages)


def test_new_and_gone_findings(folder, capsys):
    document = baseline()
    document["findings"] = [{"severity": "warning", "code": "thick_stream", "segment": "spoon"}]
    rewrite(document)
    status, word, (new, note, gone) = outcome(capsys)
    assert (status, word) == (1, "changed")
    assert new.startswith("new finding: warning below_cut_off in spoon: the spoon ends at 0°, flatter than")
    assert note.startswith("new finding: note will_not_clear in spoon: after a stop, ")
    assert gone == "finding in the baseline only: warning thick_stream in spoon"


def test_a_baseline_of_another_version_is_noted_and_holds_where_the_numbers_do(folder, capsys):
    edit("spoon.baseline.toml", f'chutecalc = "{chutecalc.__version__}"', 'chutecalc = "0.0.1"')
    note = f"the baseline was written by chutecalc 0.0.1; this is {chutecalc.__version__}"
    assert outcome(capsys) == (0, "ok", [note])
    assert main(["check"]) == 0
    assert capsys.readouterr().out == f"{note}: 1 design unchanged\n1 design: 1 ok\n"
    edit("spoon.baseline.toml", "velocity_m_s = 6.", "velocity_m_s = 6.1")
    assert outcome(capsys) == (1, "drifted", [note])
    assert main(["check", "--update"]) == 0
    assert outcome(capsys) == (0, "ok", [])


def test_a_changed_solver_tolerance_is_noted_and_counts_where_it_shows(folder, capsys):
    note = "solved with rtol 0.001; the baseline with 1e-10"
    assert outcome(capsys, "--rtol", "1e-3") == (0, "ok", [note])
    spout = (ROOT / "specs" / "grain_spout.toml").read_text(encoding="utf-8")
    Path("spoon.toml").write_text(spout, encoding="utf-8")
    assert main(["check", "--update"]) == 0
    edit("spoon.baseline.toml", "tolerance = 1e-09", "tolerance = 1e-13")
    assert main(["check", "--update"]) == 0  # more digits
    assert outcome(capsys)[:2] == (0, "ok")
    assert outcome(capsys, "--rtol", "1e-3") == (1, "drifted", [note])


def test_no_baseline(folder, capsys):
    Path("spoon.baseline.toml").unlink()
    message = "there is none to compare with. Write it: chutecalc check --update spoon.toml"
    assert outcome(capsys) == (1, "no_baseline", [message])
    assert main(["check"]) == 1
    assert capsys.readouterr().out == f"spoon.toml: no baseline: {message}\n1 design: 1 no baseline\n"


def test_no_spec(folder, capsys):
    Path("spoon.toml").unlink()
    for arguments in ([], ["--update"], ["spoon.baseline.toml"]):
        assert main(["check", *arguments]) == 1
        assert "spoon.baseline.toml: no spec: spoon.toml does not exist" in capsys.readouterr().out
    assert Path("spoon.baseline.toml").exists()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("format = 1", "<<<<<<< HEAD", "spoon.baseline.toml:2: <<<<<<< HEAD is the mark of a merge"),
        ("format = 1", "format = 2", "spoon.baseline.toml:2: format = 2 must be 1"),
        ("tolerance = 1e-09", "tolerance = 7", "tolerance = 7 must be at least 1e-13 and at most 0.1"),
        ("velocity_m_s = 6.", 'velocity_m_s = "6"\n#', "must be a number"),
        ("velocity_m_s = 6.", "velocity_m_s = nan\n#", "must be a finite number"),
        ('kind = "curve"', "", "kind is missing"),
    ],
)
def test_a_broken_baseline(folder, capsys, old, new, message):
    edit("spoon.baseline.toml", old, new)
    status, word, messages = outcome(capsys)
    assert (status, word) == (1, "broken_baseline")
    assert message in messages[0]
    assert messages[-1] == "correct it, or write a new one with --update"
    assert main(["check", "--update"]) == 0
    assert outcome(capsys) == (0, "ok", [])


@pytest.mark.parametrize("mine", [LEVEL, "notes of mine", "\xff"])
def test_what_is_no_baseline_is_not_written_over(folder, capsys, mine):
    """A spec, for example, that is the baseline of somebody's own."""
    path = Path("spoon.baseline.toml")
    path.write_text(mine, encoding="latin-1")
    assert main(["check", "--update"]) == 1
    assert path.read_text(encoding="latin-1") == mine
    assert "--update leaves it alone: give it another name, or delete it" in capsys.readouterr().out


def test_a_bad_spec_ends_with_2_and_nothing_is_written(folder, capsys):
    Path("other.toml").write_text(LEVEL.replace("radius_m = 3.0", "radius_m = -3.0"), encoding="utf-8")
    assert main(["check", "--update", "--junit", "check.xml"]) == 2
    line = 1 + Path("other.toml").read_text(encoding="utf-8").splitlines().index("radius_m = -3.0")
    assert f"other.toml:{line}: segments.2.radius_m = -3.0 must be at least 0.001 m" in capsys.readouterr().err
    assert sorted(path.name for path in folder.iterdir()) == ["other.toml", "spoon.baseline.toml", "spoon.toml"]


def test_a_fault_that_shows_only_in_solving_is_told_too(folder, capsys):
    text = LEVEL.replace('kind = "curve" ', 'kind = "hood" ').replace("to_slope_deg = 0", "to_slope_deg = 80")
    text = text.replace("velocity_m_s = 0.0", "velocity_m_s = 1.0").replace("slope_deg = 90", "slope_deg = 60")
    Path("hood.toml").write_text(text, encoding="utf-8")
    with pytest.raises(SpecError) as raised:
        chutecalc.solve(chutecalc.load("hood.toml"))
    assert main(["check"]) == 2
    assert capsys.readouterr().err == f"{raised.value}\n"


def test_what_a_folder_holds(folder, capsys):
    Path("deep/er").mkdir(parents=True)
    Path(".hidden").mkdir()
    Path("deep/er/one.toml").write_text(LEVEL, encoding="utf-8")
    Path(".hidden/two.toml").write_text(LEVEL, encoding="utf-8")
    Path("settings.toml").write_text("[tool]\nline = 1\n", encoding="utf-8")
    found = find_designs(["deep", ".", "spoon.baseline.toml", "spoon.toml"])
    assert [chute.source for chute in found.chutes] == [os.path.join("deep", "er", "one.toml"), "spoon.toml"]
    assert main(["check", "settings.toml"]) == 2  # named, it must be one
    assert "flow is missing" in capsys.readouterr().err
    Path("deep/er/one.toml").unlink()
    for arguments, words in ((["deep"], "there is no spec in deep"), (["nowhere"], "no such file")):
        assert main(["check", *arguments]) == 2
        assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--junit", "-", "--json", "-"], "only one output"),
        (["--json", "spoon.toml"], "overwrite"),
        (["--json", "spoon.baseline.toml"], "overwrite"),
        (["--junit", "no/such/folder.xml"], "cannot be written"),
        (["--rtol", "1"], "1e-13"),
    ],
)
def test_wrong_commands_end_with_2_and_change_nothing(folder, capsys, arguments, words):
    before = {path: path.read_bytes() for path in folder.iterdir()}
    assert main(["check", "--update", *arguments]) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert shown.out == ""
    assert {path: path.read_bytes() for path in folder.iterdir()} == before


def test_junit_tells_each_design_and_each_failure(folder, capsys):
    Path("other.toml").write_text(LEVEL, encoding="utf-8")
    edit("spoon.baseline.toml", "velocity_m_s = 6.", "velocity_m_s = 6.1")
    assert main(["check", "--junit", "check.xml"]) == 1
    (suite,) = ElementTree.parse("check.xml").getroot()
    assert (suite.tag, suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("testsuite", "2", "2", "0")
    other, spoon = suite
    assert (other.get("name"), spoon.get("name")) == ("other.toml", "spoon.toml")
    assert [failure.get("type") for case in suite for failure in case] == ["no_baseline", "drifted"]
    assert (
        spoon[0].get("message").startswith("drifted: velocity_m_s: first drift at fall, s = 2.000 m; largest at fall")
    )
    capsys.readouterr()
    assert main(["check", "spoon.toml", "--junit", "-"]) == 1
    assert ElementTree.fromstring(capsys.readouterr().out).get("failures") == "1"


def test_a_baseline_from_a_machine_with_other_last_digits_passes(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    belt = ROOT / "specs" / "belt_hood_spoon.toml"
    Path("spoon.toml").write_bytes(belt.read_bytes())
    solve, sign = chutecalc.solve, 1.0

    def elsewhere(chute, rtol):
        """Return the stream of a machine whose numbers are all off by 1e-12, up and down in turn: far too much."""
        nonlocal sign
        solution = solve(chute, rtol)
        results = solution.trajectory.results
        parts = [part for result in results for part in vars(result).values() if isinstance(part, dict)]
        for numbers in (*(one.columns for one in solution.trajectory.sampled), *parts):
            for name, values in numbers.items():
                sign = -sign
                numbers[name] = values * (1.0 + sign * 1e-12)
        return solution

    monkeypatch.setattr("chutecalc.studies.regression.check.solve", elsewhere)
    assert main(["check", "--update"]) == 0
    monkeypatch.undo()
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 0


def test_other_instructions_of_the_processor_change_nothing(capsys):
    """NumPy and BLAS choose their loops by what the processor can do; here they believe in the least."""
    least = {"OPENBLAS_CORETYPE": "Prescott", "NPY_DISABLE_CPU_FEATURES": "AVX2 FMA3"}
    run = subprocess.run(
        [sys.executable, "-W", "ignore", "-m", "chutecalc", "check", str(ROOT / "specs" / "fails")],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | least,
    )
    assert (run.returncode, run.stdout) == (0, "6 designs: 6 ok\n"), run.stderr


def test_no_more_digits_than_the_tolerance_needs():
    for path in STANDARD_DESIGNS:
        kept = read_baseline(baseline_path(path))
        scales = kept.scales()
        for key, row in kept.rows():
            for name, value in row.items():
                scale = scales[column_of(name)]
                assert value == 0.0 or round(value / (0.01 * kept.tolerance * scale)) != 0
                assert len(repr(abs(value)).replace(".", "").lstrip("0").split("e")[0]) <= 13, (path, key, name)


def test_many_designs_are_solved_by_several_processes_with_the_same_verdicts(folder):
    for number in range(6):
        text = LEVEL.replace("rate_t_h = 1000", f"rate_t_h = {1000 + number}")
        Path(f"design_{number}.toml").write_text(text, encoding="utf-8")
    chutes = find_designs(["."]).chutes
    alone = [item._replace(seconds=0.0) for item in check(chutes, update=True, processes=1)]
    together = [item._replace(seconds=0.0) for item in check(chutes, update=True, processes=2)]
    assert alone == together
    assert [item.outcome for item in alone] == ["no_baseline"] * 6 + ["ok"]
    assert [item.document is None for item in alone] == [False] * 6 + [True]
    assert all(item.document is None for item in check(chutes))  # nothing is written unasked


def test_faults_come_back_from_another_process(folder):
    chute = chutecalc.load("spoon.toml")
    with pytest.raises(chutecalc.UsageError, match="rtol"):
        list(check([chute] * 4, rtol=1.0, processes=2))


def test_run_takes_the_specs_of_a_glob_alone(folder, capsys):
    assert main(["run", "spoon.baseline.toml", "spoon.toml"]) == 0
    assert "comparison" not in capsys.readouterr().out
