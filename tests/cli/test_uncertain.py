"""``chutecalc uncertain`` and ``run --sensitivity`` through ``main``: tables, files, pictures, what is refused."""

import csv
import json
import re
from pathlib import Path

import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.output.printer import PIPE_WIDTH
from tests.conftest import LEVEL, ROOT

HOOD = str(ROOT / "specs/coal_hood_spoon.toml")
TABLE = """
[cases.wet]
"liners.ceramic.friction_deg" = 29

[uncertainty]
"liners.ceramic.friction_deg" = { normal = 4.0 }
"flow.rate_t_h" = 100
"segments.spoon.radius_m" = { uniform = [2.9, 3.1] }
"""


@pytest.fixture
def spoon(tmp_path):
    path = tmp_path / "spoon.toml"
    path.write_text(LEVEL + TABLE, encoding="utf-8")
    return str(path)


def told(capsys, *arguments, status=0):
    assert main([*arguments]) == status
    return capsys.readouterr().out


def test_the_report(capsys, spoon):
    out = told(capsys, "uncertain", spoon, "--samples", "5000")
    lines = out.splitlines()
    assert lines[1] == f"{spoon}: 8,192 samples, seed 1"
    assert max(map(len, lines[2:])) <= PIPE_WIDTH
    assert "what comes out, over the samples that do not fail" in out
    assert "which keys decide whether it fails" in out
    share = float(next(line for line in lines if line.startswith("stall")).split()[1])
    assert 1.0 < share < 2.0


def test_units_and_a_case(capsys, spoon):
    out = told(capsys, "uncertain", spoon, "--samples", "256", "--units", "us", "--case", "wet")
    assert "exit velocity, fpm" in out
    assert "spoon.toml, case wet: 256 samples" in out


def test_columns_that_do_not_exist_and_errors(capsys, spoon):
    names = "error_estimate,max_fill,segments.spoon.max_depth_m"
    out = told(capsys, "uncertain", spoon, "--samples", "256", "--columns", names)
    assert "max fill, " not in out
    assert "\nspoon max depth, m, 0.1399 in the spec: each key alone" in out
    assert re.search(r"^error, \de-\d\d in the spec", out, re.MULTILINE)


def test_no_indices_are_told(capsys, spoon, tmp_path):
    text = (tmp_path / "spoon.toml").read_text(encoding="utf-8")
    pair = 'correlation = [["flow.rate_t_h", "segments.spoon.radius_m", 0.5]]\n'
    (tmp_path / "spoon.toml").write_text(text + pair, encoding="utf-8")
    out = told(capsys, "uncertain", spoon, "--samples", "256")
    assert "correlation of flow.rate_t_h and segments.spoon.radius_m: 0.5" in out
    assert "no shares of the variance: keys that are correlated" in out


def test_the_same_seed_gives_the_same_bytes(capsys, spoon, tmp_path):
    files = {}
    for name, jobs, seed in (("one", 1, 5), ("two", 2, 5), ("other", 2, 6)):
        options = {"csv": "--csv"} if name == "other" else {"csv": "--csv", "json": "--json", "svg": "--plot"}
        target = [tmp_path / f"{name}.{ending}" for ending in options]
        options = [text for pair in zip(options.values(), map(str, target), strict=True) for text in pair]
        told(capsys, "uncertain", spoon, "--samples", "512", "--jobs", str(jobs), "--seed", str(seed), *options)
        files[name] = [own.read_bytes() for own in target]
    assert files["one"] == files["two"]
    assert files["one"][0] != files["other"][0]


def test_rows_and_document(capsys, spoon, tmp_path):
    rows = list(csv.DictReader(told(capsys, "uncertain", spoon, "--samples", "300", "--csv", "-").splitlines()))
    assert len(rows) == 512
    assert list(rows[0])[-3:] == ["status", "exit_velocity_m_s", "exit_depth_m"]
    assert all((row["exit_depth_m"] == "") == (row["status"] != "ok") for row in rows)
    document = json.loads(told(capsys, "uncertain", spoon, "--json", "-"))
    assert document["samples"] == 16_384
    assert [key["path"] for key in document["keys"]] == [
        "liners.ceramic.friction_deg",
        "flow.rate_t_h",
        "segments.spoon.radius_m",
    ]
    own = document["columns"]["exit_velocity_m_s"]
    assert own["quantiles"][0] < own["mean"] < own["quantiles"][2]
    assert own["alone"][0][0] > own["spec"] > own["alone"][0][1]
    shares = {status: each["share"] for status, each in document["chances"].items()}
    assert shares["ok"] + shares["fails"] == shares["ok"] + shares["stall"] == 1.0
    assert list(document["indices"]) == ["fails"]
    assert document["no_indices"] is None


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ([HOOD], "does not say what is uncertain: add [uncertainty]"),
        (["SPOON", "--samples", "10"], "samples must be 256"),
        (["SPOON", "--columns", "exit_speed"], "unknown column exit_speed"),
        (["SPOON", "--case", "dry"], "has no case dry. It has design, wet"),
        (["SPOON", "--plot", "x.doc"], "x.doc"),
    ],
)
def test_what_is_refused(capsys, spoon, arguments, problem):
    assert main(["uncertain", *(spoon if each == "SPOON" else each for each in arguments)]) == 2
    assert problem in capsys.readouterr().err


def test_sensitivity_of_a_run(capsys, tmp_path):
    file = tmp_path / "run.json"
    out = told(capsys, "run", HOOD, "--sensitivity", "--json", str(file))
    table = out[out.index("change of the exit velocity of 6.338 m/s, in % of it, where one key rises") :].splitlines()
    assert max(map(len, table)) <= PIPE_WIDTH
    found = json.loads(file.read_text(encoding="utf-8"))["chutes"][0]["sensitivity"]
    assert found["column"] == "exit_velocity_m_s"
    assert [line.split()[0] for line in table[3:]] == [key["path"] for key in found["keys"]]
    exact = chutecalc.sensitivity(chutecalc.load(HOOD))
    assert [key["percent_per_percent"] for key in found["keys"]] == exact.per_percent.tolist()
    assert "fails on one side" in out
    assert json.loads(told(capsys, "run", HOOD, "--json", "-"))["chutes"][0]["sensitivity"] is None


def test_sensitivity_of_a_case_and_of_a_chute_that_fails(capsys, spoon):
    dry, wet = (told(capsys, "run", spoon, "--sensitivity", "--case", name) for name in ("design", "wet"))
    assert "change of the exit velocity of 3.878 m/s" in dry
    assert "liners.ceramic.friction_deg" in wet
    assert "change of the exit velocity of 3.878 m/s" not in wet
    out = told(capsys, "run", spoon, "--set", "liners.ceramic.friction_deg=50", "--sensitivity", status=1)
    assert "no sensitivity: a chute that fails has no exit velocity" in out


def test_limits_margins_and_warnings(capsys, spoon, tmp_path):
    file = tmp_path / "told.json"
    limits = ["--limit", "max_depth_m<=0.15", "--limit", "exit_velocity_m_s >= 3"]
    asked = ["--margins", *limits, "--warnings", "--samples", "256", "--json", str(file)]
    lines = told(capsys, "uncertain", spoon, *asked).splitlines()
    assert "no sample has: max fill" in lines
    table = lines[lines.index("how likely limits are exceeded, over the samples that do not fail") :]
    names = ["max_depth_m<=0.15", "exit_velocity_m_s>=3", "of all: fails or exceeds any"]
    assert [line.partition("  ")[0] for line in table[3:6]] == names
    found = json.loads(file.read_text(encoding="utf-8"))
    assert list(found["exceeded"]) == [*names[:2], "any"]
    shown = [line.split()[-6] for line in table[3:6]]
    assert shown == [f"{100 * own['share']:.4g}" for own in found["exceeded"].values()]
    assert "how likely findings warn, over the samples that do not fail" in lines
    assert found["warnings"]["below_cut_off"]["share"] == 1.0
    assert "segments.spoon.landing_margin_m" in found["columns"]
    plain = told(capsys, "uncertain", spoon, "--samples", "256")
    assert "how likely" not in plain


def test_a_chute_that_ends_in_a_fall_has_no_row_of_depth(capsys, tmp_path):
    file = tmp_path / "fall.toml"
    fall = '\n[[segments]]\nname = "end"\nkind = "fall"\ndrop_m = 1.0\n'
    file.write_text(LEVEL + fall + '\n[uncertainty]\n"flow.rate_t_h" = 100\n', encoding="utf-8")
    lines = told(capsys, "uncertain", str(file), "--samples", "256").splitlines()
    assert not any(line.startswith("exit depth") for line in lines)
    assert "no sample has: exit depth" in lines


def test_where_every_sample_fails_that_is_said(capsys, tmp_path):
    file = tmp_path / "stalls.toml"
    text = LEVEL.replace("friction_deg = 25 ", "friction_deg = 70 ")
    file.write_text(text + '\n[uncertainty]\n"flow.rate_t_h" = 100\n', encoding="utf-8")
    lines = told(capsys, "uncertain", str(file), "--samples", "256", "--limit", "max_depth_m<=0.2").splitlines()
    assert "nothing comes out: every sample fails" in lines
    assert "max_depth_m<=0.2" in lines
    assert lines[lines.index("max_depth_m<=0.2") + 1].startswith("of all: fails or exceeds any   100 %")


def test_what_is_infinite_is_no_value(capsys, tmp_path):
    """A belt without friction never brings the stream to its speed."""
    file = tmp_path / "slip.toml"
    text = (ROOT / "specs" / "transfer_90.toml").read_text(encoding="utf-8")
    file.write_text(text.replace("friction_deg = 30\nat_m", "friction_deg = 0\nat_m"), encoding="utf-8")
    columns = "receiver_acceleration_length_m,exit_velocity_m_s"
    out = told(capsys, "uncertain", str(file), "--samples", "256", "--columns", columns)
    assert "no sample has: belt slip" in out
    assert "∞" not in out


def test_what_is_cut_off_is_told(capsys, tmp_path):
    file = tmp_path / "cut.toml"
    table = '\n[uncertainty]\n"liners.ceramic.friction_deg" = { normal = 12 }\n"flow.rate_t_h" = 100\n'
    file.write_text(LEVEL + table, encoding="utf-8")
    document = str(tmp_path / "cut.json")
    out = " ".join(told(capsys, "uncertain", str(file), "--samples", "256", "--json", document).split())
    path = "liners.ceramic.friction_deg"
    assert f"{path} must be at least 0° and at most 85°: 1.9 % of its values would not be, and are cut off" in out
    assert "flow.rate_t_h must" not in out
    keys = json.loads(Path(document).read_text(encoding="utf-8"))["keys"]
    assert keys[0]["cut_off"] == pytest.approx(0.0186, rel=0.01)  # below -25/12 standard deviations
    assert keys[1]["cut_off"] == pytest.approx(0.0, abs=1e-12)
