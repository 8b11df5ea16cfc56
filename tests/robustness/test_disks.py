"""Disks that are full, streams that nobody reads or that are closed: what is written is whole, and the status true."""

import json
import os
import re
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest

from chutecalc.cli import main
from chutecalc.studies.sweep import sweep as rows_of
from tests.conftest import ROOT
from tests.robustness.processes import end, run, start

VEE = str(ROOT / "specs/vee.toml")
FULL = Path("/dev/full")
on_unix = pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
with_full = pytest.mark.skipif(not FULL.exists(), reason="no device that is always full on this system")


@contextmanager
def limited(size):
    """Let no file grow beyond a size, in this process and those that it starts."""
    import resource

    before, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, most))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (before, most))


COMMANDS = {
    "run --csv": ["run", VEE, "--csv", "x"],
    "run --parquet": ["run", VEE, "--parquet", "x"],
    "run --xlsx": ["run", VEE, "--xlsx", "x"],
    "run --plot pdf": ["run", VEE, "--plot", "x.pdf"],
    "run --report pdf": ["run", VEE, "--report", "x.pdf"],
    "sweep --csv": ["sweep", "phi=15:24:#100", VEE, "--csv", "x"],
    "new": ["new", "x.toml"],
}


@on_unix
@pytest.mark.parametrize("name", COMMANDS)
def test_on_a_full_disk_there_is_no_half_file(name, tmp_path):
    with limited(600 if name == "run --csv" else 3000):
        ended = run(*COMMANDS[name], folder=tmp_path)
    assert ended.status == 74, ended
    files = r"x|x\.part/.*|x\.pdf|chute\.schema\.json|a temporary file of the workbook"
    assert re.fullmatch(f"chutecalc: ({files}) could not be written: File too large\n", ended.err), ended.err
    left = {path.name for path in tmp_path.iterdir()}
    assert left <= {"x.part"}  # what a sweep goes on from, once there is room


@on_unix
@pytest.mark.parametrize("name", ["run --csv", "run --xlsx", "new"])
def test_a_working_folder_that_was_removed_is_told(name, tmp_path):
    gone = tmp_path / "gone"
    gone.mkdir()
    code = "import os; os.rmdir(os.getcwd()); from chutecalc.__main__ import entry; entry()"
    ended = run(*COMMANDS[name], folder=gone, code=code)
    told = f"chutecalc: {COMMANDS[name][-1]} cannot be written: the folder that you are in was removed."
    assert (ended.status, ended.err) == (2, f"{told} Change to another one.\n"), ended


@on_unix
def test_a_sweep_goes_on_when_there_is_room_again(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(rows_of, "WHOLE", 100)
    command = ["sweep", "phi=15:24:#1000", VEE, "--columns", "segments.chute.status", "--csv", "x"]
    with limited(15_000):  # room for the blocks, not for the rows
        assert main(command) == 74
    assert (tmp_path / "x.part/00000009.npz").exists()
    assert main([*command, "--resume"]) == 0
    assert (tmp_path / "x").read_bytes().count(b"\n") == 1001
    assert [path.name for path in tmp_path.iterdir()] == ["x"]


@with_full
@pytest.mark.parametrize(
    ("arguments", "status", "told"),
    [
        (["run", VEE], 74, "standard output could not be written: No space left on device"),
        (["run", VEE, "--csv", "-"], 74, "standard output could not be written: No space left on device"),
        (["run", VEE, "--csv", "/dev/full"], 74, "/dev/full could not be written: No space left on device"),
        (["run", VEE, "--xlsx", "/dev/full"], 74, "/dev/full could not be written: No space left on device"),
        (["run", VEE, "--parquet", "/dev/full"], 74, "/dev/full could not be written: No space left on device"),
        (["--help"], 74, "standard output could not be written: No space left on device"),
    ],
)
def test_a_full_standard_output_is_said(arguments, status, told, tmp_path):
    with FULL.open("w") as full:
        ended = run(*arguments, folder=tmp_path, stdout=full)
    assert (ended.status, told in ended.err, ended.err.count("\n")) == (status, True, 1), ended


@with_full
@pytest.mark.parametrize(("arguments", "status"), [(["run", "none.toml"], 2), (["run", VEE], 0), (["sweep"], 2)])
def test_what_standard_error_does_not_take_changes_no_status(arguments, status, tmp_path):
    with FULL.open("w") as full:
        assert run(*arguments, folder=tmp_path, stderr=full).status == status


@on_unix
@pytest.mark.parametrize("more", [["--csv", "a.csv", "--json", "-"], ["--csv", "-", "--json", "a.json"]])
def test_a_reader_who_has_enough_stops_no_other_output(more, tmp_path, monkeypatch, capsys):
    arguments = ["run", VEE, "--points", "1000", *more]  # more than a pipe holds
    process = start(*arguments, folder=tmp_path)
    assert process.stdout is not None
    process.stdout.read(1)
    process.stdout.close()
    process.stdout = None
    ended = end(process)
    assert ended.status == 0
    assert "roken" not in ended.err
    name = next(word for word in more if word.startswith("a."))
    disturbed = (tmp_path / name).read_bytes()
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 0
    assert len(capsys.readouterr().out) > 200_000
    assert (tmp_path / name).read_bytes() == disturbed


def test_where_nobody_reads_a_sweep_to_standard_output_ends(monkeypatch, capsys):
    monkeypatch.setattr(rows_of, "WHOLE", 4)
    monkeypatch.setattr("chutecalc.cli.outputs.reader_is_gone", lambda: True)
    assert main(["sweep", "phi=15:24:#100", VEE, "--csv", "-"]) == 0
    assert capsys.readouterr().out.count("\n") == 1


@on_unix
@pytest.mark.parametrize("status", [0, 2])
def test_closed_streams(status, tmp_path):
    arguments = [VEE] if status == 0 else [VEE, "--csv", "-"]  # what was asked for must not vanish
    code = f"import os, sys; os.close(1); os.close(2); os.execv({sys.executable!r}, sys.argv[1:])"
    command = [sys.executable, "-m", "chutecalc", "run", *arguments]
    assert run(*command, folder=tmp_path, code=code).status == status


@on_unix
def test_pipes_and_devices_are_written_as_they_are(tmp_path, capsys):
    assert main(["run", VEE, "--csv", "-"]) == 0
    plain = capsys.readouterr().out
    assert plain.replace("\r\n", "\n") in run("run", VEE, "--csv", "/dev/stdout", folder=tmp_path).out
    os.mkfifo(tmp_path / "pipe")
    process = start("run", VEE, "--csv", "pipe", folder=tmp_path)
    with (tmp_path / "pipe").open(encoding="utf-8", newline="") as pipe:
        assert pipe.read().replace("\r\n", "\n") == plain.replace("\r\n", "\n")
    assert end(process).status == 0
    assert main(["run", VEE, "--csv", "/dev/null"]) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["pipe"]


@on_unix
def test_the_file_that_standard_output_goes_to_is_no_output(tmp_path):
    with (tmp_path / "out.csv").open("w") as stream:
        ended = run("run", VEE, "--csv", "out.csv", folder=tmp_path, stdout=stream)
    assert ended.status == 2
    assert "out.csv is where standard output goes" in ended.err


@on_unix
def test_names_of_files_that_are_no_text(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    spec, out = os.fsdecode(b"\xff.toml"), os.fsdecode(b"\xfe")
    try:
        (tmp_path / spec).write_bytes(Path(VEE).read_bytes())
    except OSError:
        pytest.skip("no file can have such a name here")
    outputs = [word for name in ("csv", "json", "parquet", "xlsx") for word in (f"--{name}", f"{out}.{name}")]
    assert main(["run", spec, *outputs]) == 0
    document = json.loads((tmp_path / f"{out}.json").read_text(encoding="utf-8"))
    assert document["chutes"][0]["source"] in (spec, spec.encode("utf-8", "backslashreplace").decode())
