"""``chutecalc run`` through ``main``: tables, files, streams and statuses."""

import csv
import io
import json
import os
import subprocess
import sys

import numpy as np
import pytest

import chutecalc
from chutecalc.cli import main
from chutecalc.results.columns import COLUMNS
from tests.conftest import LEVEL, ROOT

STALLS = LEVEL.replace("friction_deg = 25 ", "friction_deg = 40 ").replace("drop_m = 2.0", "drop_m = 0.2")


@pytest.fixture
def stalling(tmp_path):
    path = tmp_path / "stalls.toml"
    path.write_text(STALLS, encoding="utf-8")
    return path


def test_tables_of_the_worked_example(capsys):
    assert main(["run", str(ROOT / "specs/paper/r3_d55_chamfered.toml")]) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    for word in ("R = 3 m", "velocity", "depth", "μ_e", "time", "6.263", "3.878", "0.1399", "6.607", "below_cut_off"):
        assert word in shown.out
    assert all(line == line.rstrip() for line in shown.out.splitlines())


@pytest.mark.parametrize(
    ("receiver", "printed"),
    [
        (
            ["receiver.slope_deg=-60", "receiver.friction_deg=70", "receiver.velocity_m_s=0.1"],
            "runs back first, then reaches belt speed 0.003515 m behind the loading point, with ",
        ),
        (["receiver.slope_deg=-60", "receiver.friction_deg=40"], "never reaches belt speed, with "),
        ([], "reaches belt speed after 0.1387 m, with -0.3866 kW; after friction at the impact: 5 m/s along"),
    ],
)
def test_where_the_stream_reaches_the_speed_of_the_belt(capsys, receiver, printed):
    settings = [text for setting in receiver for text in ("--set", setting)]
    main(["run", str(ROOT / "specs/belt_hood_spoon.toml"), *settings])
    out = capsys.readouterr().out
    assert f"receiver  {printed}" in out
    assert "along the belt, 1.031 times its speed;" in out or receiver


def test_several_specs_add_a_comparison(capsys, starter, stalling):
    assert main(["run", str(starter), str(stalling)]) == 1
    out = capsys.readouterr().out
    comparison = out[out.index("comparison") :]
    assert "ok" in comparison
    assert "stall" in comparison


def test_a_failing_chute_still_shows_what_was_computed(capsys, stalling):
    assert main(["run", str(stalling), "--points", "5"]) == 1
    out = capsys.readouterr().out
    assert "failure stall" in out
    assert out.count("\nspoon ") >= 5


def test_csv_says_what_the_solution_says(capsys, tmp_path, starter):
    target = tmp_path / "out.csv"
    assert main(["run", str(starter), "--csv", str(target), "--points", "3"]) == 0
    text = target.read_bytes().decode("utf-8")
    assert text.count("\r\n") == 7  # RFC 4180: header and two segments of three stations
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == list(COLUMNS)
    stations = chutecalc.solve(chutecalc.load(starter)).stations(points=3)
    for name in ("s_m", "velocity_m_s", "depth_m", "time_s"):
        written = [float(row[name]) if row[name] else float("nan") for row in rows]
        assert np.array_equal(written, stations[name][0], equal_nan=True), name
    assert {row["spec"] for row in rows} == {str(starter)}
    assert rows[0]["depth_m"] == ""


def test_csv_without_points_has_101_stations_a_segment(capsys, starter):
    assert main(["run", str(starter), "--csv", "-"]) == 0
    out = capsys.readouterr().out
    assert len(out.splitlines()) == 1 + 2 * 101
    assert "spec,case,segment,kind,s_m" in out.splitlines()[0]


def test_json_of_one_and_of_several(capsys, starter, stalling):
    assert main(["run", str(starter), "--json", "-"]) == 0
    document = json.loads(capsys.readouterr().out)
    (one,) = document["chutes"]
    assert (document["command"], one["status"], document["tolerance"]) == ("run", "ok", 1e-10)
    assert one["exit"]["velocity_m_s"] == pytest.approx(3.877919736892825, rel=1e-12)
    assert [segment["name"] for segment in one["segments"]] == ["fall", "spoon"]
    assert one["segments"][0]["exit"]["depth_m"] is None
    assert one["findings"][0]["code"] == "below_cut_off"
    assert one["spec"]["segments"][1]["radius_m"] == 3.0

    assert main(["run", str(starter), str(stalling), "--json", "-", "--points", "4"]) == 1
    both = json.loads(capsys.readouterr().out)["chutes"]
    assert [item["status"] for item in both] == ["ok", "stall"]
    assert both[1]["exit"]["velocity_m_s"] is None
    assert both[1]["segments"][1]["status"] == "stall"
    assert len(both[0]["segments"][1]["stations"]) == 4
    assert both[1]["segments"][1]["stations"][-1]["velocity_m_s"] == 0.0


def test_a_flight_that_is_no_segment_stands_under_the_segment_it_leads_to(capsys, tmp_path):
    text = LEVEL.replace('kind = "curve" ', 'kind = "straight" ').replace("radius_m = 3.0", "length_m = 3.0")
    text = text.replace("to_slope_deg = 0", "slope_deg = 50").replace("velocity_m_s = 0.0", "velocity_m_s = 3.0")
    path = tmp_path / "edge.toml"
    path.write_text(
        text.replace('kind = "fall" ', 'kind = "straight" ').replace("drop_m = 2.0", "slope_deg = 20\nlength_m = 0.5")
    )
    assert main(["run", str(path), "--json", "-", "--set", "inlet.slope_deg=20"]) == 0
    (document,) = json.loads(capsys.readouterr().out)["chutes"]
    assert len(document["segments"]) == 2
    assert document["segments"][1]["flight"]["kind"] == "flight"
    assert document["segments"][1]["flight"]["name"] == "spoon:flight"


def test_set_changes_a_key_and_its_unit_twin_replaces_it(capsys, starter):
    assert main(["run", str(starter), "--json", "-", "--set", "segments.spoon.radius_mm=2000"]) == 0
    (twin,) = json.loads(capsys.readouterr().out)["chutes"]
    assert main(["run", str(starter), "--json", "-", "--set", "segments.2.radius_m=2"]) == 0
    assert json.loads(capsys.readouterr().out)["chutes"][0]["exit"] == twin["exit"]
    assert main(["run", str(starter), "--set", "segments.spoon.radius_m=0"]) == 2
    assert "--set segments.spoon.radius_m=0 must be at least 0.001 m" in capsys.readouterr().err
    assert main(["run", str(starter), "--set", "segments.slide.radius_m=1"]) == 2
    assert "segments has no item 'slide'. Use 1 (fall) or spoon." in capsys.readouterr().err
    assert main(["run", str(starter), "--set", "radius_mm=1"]) == 2
    expected = "--set radius_mm=1 is not a key of the spec. Did you mean segments.spoon.radius_mm?"
    assert expected in capsys.readouterr().err
    assert main(["run", str(starter), "--set", "nothing"]) == 2
    assert "PATH=VALUE" in capsys.readouterr().err


@pytest.mark.parametrize("path", ["title.x", "title.1", "flow.rate_t_h.x_m", "segments.spoon.kind."])
def test_what_is_no_table_holds_no_key(path, capsys, starter):
    assert main(["run", str(starter), "--set", f"{path}=1"]) == 2
    above = path.rpartition(".")[0]
    fault = f"--set {path}=1 does not exist: {above} is a value, not a table. Use the path {above}."
    assert capsys.readouterr().err == f"{starter}: {fault}\n"


def test_set_gives_what_the_spec_leaves_out_and_its_faults_blame_no_line(capsys, starter, tmp_path):
    text = starter.read_text()
    path = tmp_path / "template.toml"
    path.write_text("\n".join("" if row.startswith("rate_t_h") else row for row in text.splitlines()))
    assert main(["run", str(path)]) == 2
    assert "flow.rate_t_h is missing" in capsys.readouterr().err
    assert main(["run", str(path), "--set", "flow.rate_t_h=1000"]) == 0
    capsys.readouterr()
    assert main(["run", str(starter), "--set", "flow.rate_t_h=-1"]) == 2
    assert capsys.readouterr().err.startswith(f"{starter}: --set flow.rate_t_h=-1 must be at least 0.001 t/h")


def test_stations_by_distance(capsys, starter):
    assert main(["run", str(starter), "--csv", "-", "--stations", "1.5"]) == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [round(float(row["s_m"]), 6) for row in rows if row["segment"] == "spoon"] == [2.0, 3.5, 5.0, 6.5, 6.712389]


def test_us_units_are_for_people_only(capsys, starter):
    assert main(["run", str(starter), "--units", "us"]) == 0
    us = capsys.readouterr().out
    assert "fpm" in us
    assert "763.4" in us  # 3.878 m/s
    assert main(["run", str(starter), "--units", "us", "--csv", "-"]) == 0
    american = capsys.readouterr().out
    assert main(["run", str(starter), "--csv", "-"]) == 0
    assert capsys.readouterr().out == american


def test_strict_makes_warnings_count(capsys, starter):
    assert main(["run", str(starter)]) == 0
    assert main(["run", str(starter), "--strict"]) == 1


def test_a_spec_from_standard_input(capsys, monkeypatch):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(LEVEL.encode()), encoding="utf-8"))
    assert main(["run", "-"]) == 0
    assert "standard input" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "a.toml", "--json", "-", "--csv", "-"], "only one output"),
        (["run", "-", "-"], "only one spec"),
        (["run", "a.toml", "--json", "x", "--csv", "x"], "--csv and --json both write to x."),
        (["run", "a.toml", "--csv", "a.toml"], "overwrite"),
        (["run", "a.toml", "--points", "5", "--stations", "0.1"], "give one of them"),
        (["run", "a.toml", "--stations", "-1"], "greater than 0"),
        (["run", "a.toml", "--stations", "1e-9"], "more than 2000000: take a larger one"),
        (["run", "a.toml", "--csv", "no/such/folder/x.csv"], "cannot be written"),
        (["run", "a.toml", "--csv", "folder"], "is a folder"),
        (["run", "a.toml", "--rtol", "1e-20"], "1e-13"),
        (["run", "missing.toml"], "no such file"),
        (["run", "folder"], "is a folder"),
        (["run", "a.toml", "--nonsense"], "--nonsense"),
        (["nonsense"], "nonsense"),
        (["run"], "SPEC"),
    ],
)
def test_wrong_commands_end_with_2_say_why_and_leave_nothing(arguments, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.toml").write_text(LEVEL, encoding="utf-8")
    (tmp_path / "folder").mkdir()
    assert main(arguments) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert shown.out == ""
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.toml", "folder"]


def test_all_faults_of_all_specs_and_nothing_solved(capsys, tmp_path, starter):
    for name in ("one", "two"):
        text = LEVEL.replace("rate_t_h = 1000", "rate = 1000").replace("radius_m = 3.0", "radius_m = -3.0")
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
    assert main(["run", str(starter), str(tmp_path / "one.toml"), str(tmp_path / "two.toml")]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert len(shown.err.splitlines()) == 4
    assert shown.err.count("rate_t_h or rate_kg_s or rate_stph") == 2
    assert shown.err.count("radius_m = -3.0 must be at least 0.001 m") == 2


def test_an_existing_file_survives_a_failing_run(capsys, tmp_path, starter):
    target = tmp_path / "out.csv"
    target.write_text("precious", encoding="utf-8")
    assert main(["run", str(starter), "--csv", str(target), "--rtol", "7"]) == 2
    assert target.read_text(encoding="utf-8") == "precious"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["chute.toml", "out.csv"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no device that is always full on this system")
def test_a_full_disk_ends_with_74(capsys, starter):
    assert main(["run", str(starter), "--csv", "/dev/full"]) == 74
    assert "could not be written" in capsys.readouterr().err


def test_a_fault_of_the_program_ends_with_70_and_a_traceback_only_on_demand(capsys, monkeypatch, starter):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    assert main(["run", str(starter)]) == 70
    err = capsys.readouterr().err
    assert "ZeroDivisionError" in err
    assert chutecalc.__version__ in err
    assert "Traceback" not in err
    assert main(["run", str(starter), "--debug"]) == 70
    assert "Traceback" in capsys.readouterr().err


def test_ctrl_c_ends_with_130(capsys, monkeypatch, starter):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("chutecalc.api.solve.run_chain", interrupted)
    assert main(["run", str(starter)]) == 130


def process(*arguments, **more):
    return subprocess.run([sys.executable, "-m", "chutecalc", *arguments], capture_output=True, check=False, **more)


def test_of_a_closed_pipe_nothing_is_said(starter):
    reader, writer = os.pipe()
    os.close(reader)
    with subprocess.Popen(
        [sys.executable, "-m", "chutecalc", "run", str(starter), "--csv", "-", "--points", "5000"],
        stdout=writer,
        stderr=subprocess.PIPE,
    ) as run:
        os.close(writer)
        assert run.stderr is not None
        told = run.stderr.read()
    assert run.returncode == 0
    assert told == process("run", str(starter), "--csv", "-", "--points", "5000").stderr


@pytest.mark.parametrize("encoding", ["cp1252", "ascii"])
def test_piped_output_is_utf8_whatever_the_locale_says(starter, encoding):
    run = process("run", str(starter), env={**os.environ, "PYTHONIOENCODING": encoding})
    assert run.returncode == 0, run.stderr
    assert "δ 55°" in run.stdout.decode("utf-8")


def test_piped_output_has_no_colour_even_where_colour_is_forced(starter):
    plain = process("run", str(starter))
    forced = process("run", str(starter), env=os.environ | {"FORCE_COLOR": "1", "COLUMNS": "40", "TERM": "xterm"})
    assert forced.stdout == plain.stdout
    assert b"\x1b" not in plain.stdout


def test_nothing_heavy_is_loaded_on_the_way_of_run():
    code = (
        "import sys\nimport numpy\n"
        "usual = set(sys.modules)\n"  # old NumPy loads numpy.ma
        "from chutecalc.cli import main\n"
        f"assert main(['run', {str(ROOT / 'specs/paper/r3_d55_chamfered.toml')!r}]) == 0\n"
        "heavy = {'scipy', 'matplotlib', 'plotille', 'mpmath', 'tomli_w', 'numpy.ma', 'pyarrow'}\n"
        "heavy.add('chutecalc.cli.sweep')\n"
        "ours = set(sys.modules) - usual\n"
        "print(sorted({*ours, *(name.split('.')[0] for name in ours)} & heavy))\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "[]"


def test_help_loads_no_numpy():
    code = "import sys\nfrom chutecalc.cli import main\nmain(['--help'])\nprint('numpy' in sys.modules)\n"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "False"


def test_the_belt_and_the_edges_of_its_stream_are_told(capsys):
    assert main(["run", str(ROOT / "specs/troughed_belt_hood.toml")]) == 0
    lines = capsys.readouterr().out.splitlines()
    (load,) = [line for line in lines if line.startswith("belt  ")]
    assert load.startswith(
        "belt  a load of 0.1471 m² covers 1.004 m of the belt and is 0.1465 m deep on the pulley; fill"
    )
    assert load.endswith("middle roll taken as 0.41 m, a third of the width and 10 mm")
    edges = [line for line in lines if line.startswith("edge  ")]
    assert [line.split(":")[0] for line in edges] == ["edge  lower", "edge  middle", "edge  upper", "edge  free"]
    assert all("leaves at -8° and 4 m/s, lands on hood " in line for line in edges[:3])
    assert edges[3].startswith("edge  free: leaves hood at 75° and 4.614 m/s, 0.1159 m deep, and lands nowhere")
    assert main(["run", str(ROOT / "specs/surge_on_belt.toml"), "--set", "inlet.belt.roll_m=0.5"]) == 0
    surge = capsys.readouterr().out
    assert "edge  upper: leaves at -8° and 4 m/s and lands nowhere\n" in surge
    assert "middle roll taken as" not in surge


def test_edges_in_json(capsys):
    assert main(["run", str(ROOT / "specs/surge_on_belt.toml"), "--json", "-"]) == 0
    inlet = json.loads(capsys.readouterr().out)["chutes"][0]["inlet"]
    assert inlet["belt_fill"] > 1.0
    assert [(edge["name"], edge["segment"]) for edge in inlet["edges"]] == [
        ("lower", "hood"),
        ("middle", "hood"),
        ("upper", None),
    ]
    assert inlet["edges"][2]["landing_x_m"] is None
    assert inlet["edges"][2]["gap_m"] < 0.0
    assert inlet["edges"][0]["gap_m"] is None
    assert main(["run", str(ROOT / "specs/vee.toml"), "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["chutes"][0]["inlet"]["edges"] == []


def test_columns_of_tables_and_files(capsys, tmp_path, starter):
    chosen = ["--columns", "wear_number,velocity_m_s,chamfer_wetted_m"]
    assert main(["run", str(starter), str(starter), "--points", "3", *chosen]) == 0
    out = capsys.readouterr().out
    headings = [line.split() for line in out.splitlines() if line.lstrip().startswith(("N_WR", "segment ", "spec "))]
    for line in out.splitlines():
        assert "pressure" not in line or line.startswith(("warning", "note"))
    assert headings.count(["N_WR", "velocity", "chamfer"]) >= 4  # segments and stations of both
    solution = chutecalc.solve(chutecalc.load(starter))
    assert f"{solution.segments['spoon'].maximum['velocity_m_s'][0]:.3f}" in out
    assert f"{solution.exit['wear_number'][0]:.3f}" in out

    file = tmp_path / "rows.csv"
    assert main(["run", str(starter), "--csv", str(file), *chosen]) == 0
    rows = list(csv.DictReader(io.StringIO(file.read_text())))
    stations = solution.stations()
    assert list(rows[0]) == ["wear_number", "velocity_m_s", "chamfer_wetted_m"]
    assert [float(row["velocity_m_s"]) for row in rows] == stations["velocity_m_s"][0].tolist()

    capsys.readouterr()
    assert main(["run", str(starter), "--json", "-", "--points", "2", "--columns", "segment, s_m ,depth_m"]) == 0
    (document,) = json.loads(capsys.readouterr().out)["chutes"]
    assert [list(row) for row in document["segments"][1]["stations"]] == [["s_m", "depth_m"]] * 2
    assert set(document["segments"][1]["exit"]) == set(solution.exit)


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ("depth", "there is no column depth. Did you mean depth_m?"),
        ("thickness", "there is no column thickness."),  # findings alone ask for it
        ("depth_m,,s_m", "there is no column"),
    ],
)
def test_unknown_columns_are_refused(names, words, capsys, starter, monkeypatch):
    monkeypatch.setattr("chutecalc.api.solve.run_chain", lambda *_: 1 / 0)
    assert main(["run", str(starter), "--columns", names]) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert shown.out == ""


def test_tables_show_the_place(capsys):
    path = ROOT / "specs/belt_hood_spoon.toml"
    assert main(["run", str(path), "--points", "2", "--columns", "x_m,z_m"]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    for result in chutecalc.solve(chutecalc.load(path)).segments:
        for end in (result.entry, result.exit):
            place = [f"{end[name][0]:z.3f}" for name in ("x_m", "z_m")]
            assert sum(line[-2:] == place for line in lines) >= 2  # of segments, and of stations
