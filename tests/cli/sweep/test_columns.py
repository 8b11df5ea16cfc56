"""Columns of a sweep: of the whole stream, of its ends, of one segment, of the receiving belt."""

import pytest

import chutecalc
from chutecalc.output.run import run_dataset
from chutecalc.results.cases import Cases
from chutecalc.results.segment_columns import segment_columns
from chutecalc.spec.operating import DESIGN_POINT
from chutecalc.studies.sweep.checks import DEFAULT, DEFAULT_ON_BELT
from chutecalc.studies.sweep.columns import ALONE
from tests.cli.sweep.commands import BELT, HOOD, SPOON, refused, swept
from tests.conftest import ROOT


def test_extremes_inside_a_segment_are_those_of_a_run(capsys):
    for row in swept(capsys, "segments.hood.radius_m=1,1.3", HOOD, "--columns", "max_depth_m,min_velocity_m_s"):
        chute = chutecalc.load(HOOD).vary({"segments.hood.radius_m": float(row["segments.hood.radius_m"])})
        segments = [segment for segment in chutecalc.solve(chute).segments if segment.kind != "fall"]
        deepest = max(segment.maximum["depth_m"][0] for segment in segments)
        slowest = min(segment.minimum["velocity_m_s"][0] for segment in segments)
        assert float(row["max_depth_m"]) == pytest.approx(deepest, rel=1e-10)  # as extremes promise
        assert float(row["min_velocity_m_s"]) == pytest.approx(slowest, rel=1e-10)


def test_what_stands_at_the_exit_alone_is_not_solved_for_more(capsys, monkeypatch):
    (whole,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_depth_m,error_estimate,max_depth_m")
    (clock,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_time_s")  # needs the whole path
    assert float(clock["exit_time_s"]) == chutecalc.solve(chutecalc.load(SPOON)).exit["time_s"][0]
    monkeypatch.setattr("chutecalc.studies.sweep.design_rows.solve", lambda *_: 1 / 0)
    (row,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_depth_m,error_estimate")
    assert float(row["exit_depth_m"]) == pytest.approx(float(whole["exit_depth_m"]), rel=1e-9)  # rtol is 1e-10


def test_findings_and_ends(capsys):
    (row,) = swept(
        capsys, "radius=3", SPOON, "--columns", "findings,exit_froude,exit_time_s,error_estimate,max_wear_w_m2"
    )
    run = chutecalc.solve(chutecalc.load(SPOON))
    assert row["findings"].split() == [finding.code for finding in run.findings()]
    assert float(row["exit_time_s"]) == run.exit["time_s"][0]
    assert float(row["max_wear_w_m2"]) == run.segments[-1].maximum["wear_w_m2"][0]
    (fast,) = swept(capsys, "radius=3", SPOON, "--columns", "exit_froude")
    assert float(fast["exit_froude"]) == pytest.approx(float(row["exit_froude"]), rel=1e-9)  # rtol is 1e-10
    belt = str(ROOT / "specs/belt_hood_spoon.toml")
    (row,) = swept(capsys, "rate=1800", belt, "--columns", "receiver_velocity_ratio")
    assert float(row["receiver_velocity_ratio"]) > 0.5
    names = ["receiver_velocity_ratio", "max_depth_m", "exit_depth_m"]
    (mixed,) = swept(capsys, "rate=1800", belt, "--columns", ",".join(names))
    assert list(mixed) == ["rate_t_h", "status", *names]
    assert float(mixed["receiver_velocity_ratio"]) == pytest.approx(float(row["receiver_velocity_ratio"]), rel=1e-9)


def test_what_the_belt_gets_is_shown_by_default(capsys):
    (row,) = swept(capsys, "rate=1800", BELT)
    assert list(row) == ["rate_t_h", "status", *DEFAULT, *DEFAULT_ON_BELT]
    run = chutecalc.solve(chutecalc.load(BELT))
    for name in DEFAULT_ON_BELT:
        assert float(row[name]) == run.receiver[name.removeprefix("receiver_")][0]


ALL_OF_SPOON = ",".join(f"segments.spoon.{name}" for name in segment_columns())


def test_columns_of_a_segment_are_its_results(capsys):
    rows = swept(capsys, "rate=1500,1800", BELT, "--columns", ALL_OF_SPOON)
    for row in rows:
        state = chutecalc.solve(chutecalc.load(BELT).vary({"flow.rate_t_h": float(row["rate_t_h"])}))
        spoon = run_dataset([Cases({DESIGN_POINT: state})], None).document()["chutes"][0]["segments"][-1]
        found = {name: spoon[name] for name in ALONE}
        for prefix, part in (("entry", "entry"), ("exit", "exit"), ("min", "minimum"), ("max", "maximum")):
            found |= {f"{prefix}_{name}": value for name, value in spoon[part].items()}
        found |= {f"impact_{name}": value for name, value in spoon["impact"].items()} | spoon.get("loads", {})
        shown = {name: "" if value is None else str(value) for name, value in found.items()}
        assert {name.removeprefix("segments.spoon."): value for name, value in row.items() if "spoon" in name} == shown


def test_a_segment_goes_by_name_or_by_number_and_need_not_be_struck(capsys):
    names = "segments.spoon.max_wear_w_m2,segments.4.max_wear_w_m2,segments.throw.impact_incidence_deg"
    (row,) = swept(capsys, "rate=1500", BELT, "--columns", names)
    assert row["segments.spoon.max_wear_w_m2"] == row["segments.4.max_wear_w_m2"] != ""
    assert row["segments.throw.impact_incidence_deg"] == ""


def test_where_a_design_fails_its_segments_say(capsys):
    names = "segments.spoon.status,segments.fall.status,segments.spoon.max_depth_m"
    rows = swept(capsys, "phi=20,40,44", SPOON, "--columns", names)
    assert [row["segments.spoon.status"] for row in rows] == [row["status"] for row in rows] == ["ok", "stall", "stall"]
    assert {row["segments.fall.status"] for row in rows} == {"ok"}
    assert [bool(row["segments.spoon.max_depth_m"]) for row in rows] == [True, False, False]
    best = ["--columns", names, "--top", "2", "--by", "segments.spoon.max_depth_m:min"]
    assert [row["friction_deg"] for row in swept(capsys, "phi=20,25,44", SPOON, *best)] == ["20.0", "25.0"]


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ("segments.spon.max_depth_m", "there is no segment spon. Did you mean spoon? Use 1 (fall), 2 (spoon)."),
        ("segments.3.max_depth_m", "there is no segment 3."),
        ("segments.0.max_depth_m", "there is no segment 0."),
        ("segments.spoon.max_depth", "a segment has no column max_depth. Did you mean max_depth_m? Use entry_"),
        ("segments.spoon", "write segments.SEGMENT.COLUMN, such as segments.spoon.exit_velocity_m_s."),
    ],
)
def test_unknown_columns_of_segments(names, words, capsys):
    assert words in refused(capsys, "radius=1,2", SPOON, "--columns", names)
    assert "--by needs a column of numbers" in refused(
        capsys, "radius=1,2", SPOON, "--top", "1", "--by", "segments.spoon.status:max"
    )
    assert "unknown column segments.spoon.max_depth_m" in refused(
        capsys, "radius=1,2", SPOON, "--points", "3", "--columns", "segments.spoon.max_depth_m"
    )
