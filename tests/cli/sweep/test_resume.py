"""What an interrupted or killed sweep leaves, and how it goes on from there."""

import signal
import subprocess
import sys
import time

import pytest

from chutecalc.cli import main
from tests.cli.sweep.commands import SPOON, refused, written

LONG = ["radius=2:4:#300", "phi=15:24:#300"]


def started(target, *more):
    """Start a long sweep in a process of its own."""
    command = [sys.executable, "-m", "chutecalc", "sweep", *LONG, SPOON, "--csv", str(target), "--jobs", "1", *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def stopped(target, how):
    """Stop a long sweep by a signal once it has blocks; return its status and its output."""
    process = started(target)
    folder = target.with_name(f"{target.name}.part")
    while process.poll() is None and len(list(folder.glob("[0-9]*.npz"))) < 2:
        time.sleep(0.02)
    process.send_signal(how)
    message = process.communicate()[1]
    return process.returncode, message


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    file = tmp_path_factory.mktemp("whole") / "whole.csv"
    assert main(["sweep", *LONG, SPOON, "--csv", str(file)]) == 0
    return file.read_bytes()


def test_killed_and_resumed_is_the_same_file(whole, tmp_path, capsys):
    target = tmp_path / "rows.csv"
    status, _ = stopped(target, signal.SIGKILL)
    assert status == -signal.SIGKILL
    assert sorted(path.name for path in tmp_path.glob("[!.]*")) == ["rows.csv.part"]
    capsys.readouterr()
    assert "--resume" in refused(capsys, *LONG, SPOON, "--csv", str(target))
    other = refused(capsys, LONG[0], "phi=15:25:#300", SPOON, "--csv", str(target), "--resume")
    assert "another sweep, which differs in the parameters" in other
    before = {path.name: path.stat().st_mtime_ns for path in (tmp_path / "rows.csv.part").glob("[0-9]*")}
    assert 0 < len(before) < 6
    assert main(["sweep", *LONG, SPOON, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole
    assert sorted(path.name for path in tmp_path.iterdir()) == ["rows.csv"]


@pytest.mark.skipif(sys.platform == "win32", reason="signals are others there")
def test_interrupted_it_leaves_what_it_has(whole, tmp_path):
    target = tmp_path / "rows.csv"
    status, message = stopped(target, signal.SIGINT)
    assert status == 130
    assert "--resume continues from" in message
    part = target.read_bytes()
    assert part == whole[: len(part)]
    assert 1 < part.count(b"\r\n") < 90_001
    assert main(["sweep", *LONG, SPOON, "--csv", str(target), "--resume"]) == 0
    assert target.read_bytes() == whole


def test_without_blocks_there_is_nothing_to_resume(tmp_path, capsys):
    target = tmp_path / "rows.csv"
    arguments = ["phi=20,30", SPOON, "--csv", str(target)]
    assert f"there is no {target}.part to continue. To start the sweep anew" in refused(capsys, *arguments, "--resume")
    assert main(["sweep", *arguments]) == 0
    finished = target.read_bytes()
    capsys.readouterr()
    assert f"there is no {target}.part to continue" in refused(capsys, "phi=20", *arguments[1:], "--resume")
    assert target.read_bytes() == finished
    assert [path.name for path in tmp_path.iterdir()] == ["rows.csv"]


LIBRARY = "[liners.a]\nfriction_deg = 20\n[liners.b]\nfriction_deg = {}\n"


@pytest.mark.parametrize("varied", ["liners.wall.use=a,b", "case"])
def test_another_library_is_not_resumed(varied, tmp_path, capsys, monkeypatch):
    target, library = tmp_path / "rows.csv", tmp_path / "chute-library.toml"
    cases = {"wet": {"liners.wall.use": "b"}}
    path = written(tmp_path, liners={"wall": {"use": "a"}}, cases=cases)
    library.write_text(LIBRARY.format(25), encoding="utf-8")
    command = ["sweep", varied, path, "--columns", "exit_velocity_m_s", "--csv", str(target)]
    with monkeypatch.context() as patch:
        patch.setattr("chutecalc.studies.sweep.block_store.BlockStore.remove", lambda self: None)
        assert main(command) == 0
    library.write_text(LIBRARY.format(30), encoding="utf-8")
    capsys.readouterr()
    assert "another sweep, which differs in the library." in refused(capsys, *command[1:], "--resume")
    library.write_text(LIBRARY.format(25), encoding="utf-8")
    assert main([*command, "--resume"]) == 0


def test_another_spec_or_version_is_not_resumed(tmp_path, capsys, monkeypatch):
    target = tmp_path / "rows.csv"
    monkeypatch.setattr("chutecalc.studies.sweep.block_store.BlockStore.remove", lambda self: None)
    assert main(["sweep", "phi=20,30", SPOON, "--csv", str(target)]) == 0
    capsys.readouterr()
    again = ["phi=20,30", SPOON, "--csv", str(target), "--resume"]
    assert main(["sweep", *again]) == 0
    capsys.readouterr()
    square = [word.replace("chamfered", "square") for word in again]
    assert "differs in the spec" in refused(capsys, *square)
    assert "differs in --columns" in refused(capsys, *again, "--columns", "exit_depth_m")
    monkeypatch.setattr("chutecalc.studies.sweep.sweep.__version__", "0.0.1")
    assert "the version of chutecalc" in refused(capsys, *again)
