"""Whatever has the name of the folder of a sweep's blocks: it is said what to do, and nothing of it is touched."""

import errno
import os
import shutil

import pytest

from chutecalc.cli import main
from chutecalc.errors import OutputError, WriteError
from chutecalc.output.held import release
from chutecalc.studies.sweep.block_store import BlockStore
from chutecalc.studies.sweep.part_folder import part_folder
from tests.robustness.conftest import SWEEP


def missing_identity(folder):
    (folder / "sweep.json").unlink()


def folder_for_identity(folder):
    missing_identity(folder)
    (folder / "sweep.json").mkdir()


def link_for_identity(folder):
    (folder / "sweep.json").rename(folder.with_name("other.json"))
    (folder / "sweep.json").symlink_to("../other.json")


def pipe_for_identity(folder):
    missing_identity(folder)
    os.mkfifo(folder / "sweep.json") if hasattr(os, "mkfifo") else (folder / "sweep.json").mkdir()


def file_for_folder(folder):
    shutil.rmtree(folder)
    folder.write_text("mine", encoding="utf-8")


def link_for_folder(folder):
    folder.rename(folder.with_name("elsewhere"))
    folder.symlink_to("elsewhere", target_is_directory=True)


def link_to_nothing(folder):
    shutil.rmtree(folder)
    folder.symlink_to("elsewhere")


IN_THE_WAY = {
    missing_identity: "does not belong to a sweep, since sweep.json in it is missing, or no file. Remove or rename it",
    folder_for_identity: "does not belong to a sweep",
    link_for_identity: "does not belong to a sweep",
    pipe_for_identity: "does not belong to a sweep",
    file_for_folder: "is no folder, and the blocks of the sweep need one of that name. Remove or rename it",
    link_for_folder: "is a link, and blocks are kept in no other place. Put the folder that it leads to in its place",
    link_to_nothing: "is a link",
}


@pytest.mark.parametrize("put", IN_THE_WAY, ids=lambda each: each.__name__)
def test_what_is_in_the_way_of_the_folder_is_said_alike_with_and_without_resume(put, stopped, capsys):
    target, whole = stopped
    folder = target.with_name("rows.csv.part")
    put(folder)
    there = sorted(target.parent.rglob("*"))
    told = []
    for more in ([], ["--resume"]):
        assert main([*SWEEP, "--csv", str(target), *more]) == 2
        told.append(capsys.readouterr().err)
    assert f"{folder} {IN_THE_WAY[put]}" in told[0]
    assert "leave out --resume" in told[0]
    assert told[0] == told[1]
    assert sorted(target.parent.rglob("*")) == there
    folder.rename(folder.with_name("renamed"))
    assert main([*SWEEP, "--csv", str(target)]) == 0
    assert target.read_bytes() == whole


def test_the_folder_of_a_link_is_beside_the_file_it_leads_to(stopped, capsys):
    target, whole = stopped
    link = target.with_name("link.csv")
    link.symlink_to("rows.csv")
    assert main([*SWEEP, "--csv", str(link)]) == 2
    assert f"{target.resolve()}.part is left from an interrupted sweep" in capsys.readouterr().err
    assert main([*SWEEP, "--csv", str(link), "--resume"]) == 0
    assert target.read_bytes() == whole


def test_an_empty_folder_is_used_and_cannot_be_continued(tmp_path, capsys):
    (tmp_path / "x.part").mkdir()
    command = [*SWEEP, "--csv", str(tmp_path / "x")]
    assert main([*command, "--resume"]) == 2
    assert f"there is nothing in {tmp_path / 'x'}.part to continue" in capsys.readouterr().err
    assert main(command) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["x"]


def test_a_store_that_cannot_be_begun_leaves_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(WriteError, match=r"^x\.part/sweep\.json could not be written: No space"):
        BlockStore("x", {"spec": {}}, resume=False)
    assert list(tmp_path.iterdir()) == []
    release()


def test_what_is_refused_because_nothing_can_be_continued_holds_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("chutecalc.output.held.hold", None)
    assert main([*SWEEP, "--csv", str(tmp_path / "x"), "--resume"]) == 2
    assert "to continue" in capsys.readouterr().err


def test_a_folder_that_is_in_use_is_not_said_to_be_left(tmp_path):
    """As that of a process which has written its file, and is about to remove the blocks."""
    target = str(tmp_path / "x.csv")
    store = BlockStore(target, {"spec": 1}, resume=False)
    with pytest.raises(OutputError, match="is written twice"):  # by this process; that of another is named
        part_folder(target, resume=False)
    store.remove()
    assert not list(tmp_path.iterdir())
