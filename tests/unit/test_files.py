"""The one writer of files: what it holds, what it leaves, and what other systems would do."""

import errno
import os
import sys
import types
from pathlib import Path

import pytest

from chutecalc.errors import OutputError, UsageError, WriteError
from chutecalc.output import held, locks
from chutecalc.output.files import open_new, open_whole
from chutecalc.output.held import hold_folder, release, reserve
from chutecalc.output.targets import check_targets


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    yield tmp_path
    release()


def written(target, text="new"):
    with open_whole(target) as stream:
        if isinstance(text, BaseException):
            stream.write("half")
            raise text
        stream.write(text)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def other_process(path, number=4711):
    """Lock a file as another process does."""
    lock = locks.Lock(Path(path))
    lock.empty()
    os.write(lock.descriptor, f"chutecalc process {number}\n".encode())
    return lock


def test_a_file_is_held_from_its_reservation_until_it_is_written(folder):
    reserve("a.csv")
    assert names(folder) == [".a.csv.chutecalc"]
    with pytest.raises(locks.HeldError):
        locks.Lock(folder / ".a.csv.chutecalc")
    written("a.csv")
    assert names(folder) == ["a.csv"]
    assert not locks.OPEN
    written("a.csv", "again")
    assert (folder / "a.csv").read_text(encoding="utf-8") == "again"


def test_what_another_process_writes_is_refused_and_left_alone(folder):
    lock = other_process(folder / ".a.csv.chutecalc")
    for attempt in (reserve, written):
        with pytest.raises(OutputError, match=r"another process 4711 of chutecalc is writing a.csv. Wait"):
            attempt("a.csv")
    hold_folder(str(folder), "the folder")
    with pytest.raises(OutputError, match="written twice"):
        hold_folder(str(folder), "the folder")
    lock.release()
    written("a.csv")
    release()
    assert names(folder) == ["a.csv"]


def test_what_a_killed_process_has_left_is_taken(folder):
    (folder / ".a.csv.chutecalc").write_text("half of some other rows, longer than what comes now", encoding="utf-8")
    written("a.csv")
    assert names(folder) == ["a.csv"]
    assert (folder / "a.csv").read_text(encoding="utf-8") == "new"


def test_a_lock_on_what_is_not_there_any_more_is_taken_again(folder, monkeypatch):
    first, calls = locks.Lock(folder / "lock"), []
    lock = locks._lock

    def late(descriptor):
        calls.append(descriptor)
        if len(calls) == 1:
            first.release()  # between the opening and the locking of another
        lock(descriptor)

    monkeypatch.setattr(locks, "_lock", late)
    second = locks.Lock(folder / "lock")
    assert len(calls) == 2
    assert os.path.samestat(os.fstat(second.descriptor), os.stat("lock"))


def test_without_locks_files_are_written_all_the_same(folder, monkeypatch):
    def none(*_):
        raise OSError(errno.ENOLCK, "no locks")

    monkeypatch.setattr("fcntl.flock", none, raising=False)
    written("a.csv")
    assert names(folder) == ["a.csv"]


@pytest.mark.parametrize("failure", [ValueError("x"), KeyboardInterrupt(), BrokenPipeError(32, "of standard output")])
def test_what_fails_meanwhile_keeps_its_error_and_leaves_nothing(folder, failure):
    (folder / "a.csv").write_text("old", encoding="utf-8")
    with pytest.raises(type(failure)):
        written("a.csv", failure)
    assert names(folder) == ["a.csv"]
    assert (folder / "a.csv").read_text(encoding="utf-8") == "old"


@pytest.mark.parametrize("mode", ["w", "wb"])
def test_what_is_written_after_the_end_is_lost(folder, mode):
    """As libraries do it while they are removed: the descriptor may be that of another file by then."""
    with pytest.raises(KeyboardInterrupt), open_whole("a", mode) as stream:
        raise KeyboardInterrupt
    with open("b", "w", encoding="utf-8"):
        stream.write("more" if mode == "w" else b"more")
        stream.close()
    assert names(folder) == ["b"]
    assert (folder / "b").read_bytes() == b""


def test_only_what_is_open_for_writing_is_synchronised(folder, monkeypatch):
    asked, fsync = [], os.fsync

    def windows(descriptor):
        os.write(descriptor, b"")  # where a file is open for reading only, this is the error that Windows has
        asked.append(descriptor)
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", windows)
    written("a.csv")
    with open_whole("b.bin", "wb") as stream:
        stream.write(b"1")
    assert len(asked) == 2


def test_a_file_that_another_program_has_open_stays_as_it_is(folder, monkeypatch):
    (folder / "a.csv").write_text("old", encoding="utf-8")

    def windows(*_):
        raise PermissionError(errno.EACCES, "The process cannot access the file")

    monkeypatch.setattr(os, "replace", windows)
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setitem(sys.modules, "msvcrt", types.SimpleNamespace(locking=lambda *_: None, LK_NBLCK=2))
    with pytest.raises(WriteError, match=r"a.csv could not be written: The process .* open in another program\? Close"):
        written("a.csv")
    assert names(folder) == ["a.csv"]
    assert (folder / "a.csv").read_text(encoding="utf-8") == "old"


def test_locks_of_windows(folder, monkeypatch):
    held_bytes = set()

    def locking(descriptor, mode, count):
        assert (mode, count, os.lseek(descriptor, 0, os.SEEK_CUR)) == (2, 1, locks.FAR)
        key = os.fstat(descriptor).st_ino
        if key in held_bytes:
            raise PermissionError(errno.EACCES, "Permission denied")
        held_bytes.add(key)

    replace = os.replace

    def closed(source, target):
        assert all(lock.descriptor < 0 for lock in locks.OPEN), "an open file is not moved there"
        replace(source, target)

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(os, "replace", closed)
    monkeypatch.setitem(sys.modules, "msvcrt", types.SimpleNamespace(locking=locking, LK_NBLCK=2))
    reserve("a.csv")
    with pytest.raises(locks.HeldError) as refused:
        locks.Lock(folder / ".a.csv.chutecalc")
    assert refused.value.process == os.getpid()
    written("a.csv")
    assert names(folder) == ["a.csv"]


def test_two_names_of_one_file_where_capitals_do_not_count(folder, monkeypatch):
    monkeypatch.setattr(held, "temporary", lambda path: path.with_name(f".{path.name.lower()}.chutecalc"))
    reserve("a.csv")
    with pytest.raises(OutputError, match=r"A.csv is written twice: give one of the outputs another name"):
        reserve("A.csv")
    monkeypatch.setattr(os.path, "normcase", str.lower)
    with pytest.raises(UsageError, match=r"--csv and --json both write to A\.csv"):
        check_targets({"--csv": "a.csv", "--json": "A.csv"}, [])


def test_two_names_of_one_file_that_is_there(folder):
    (folder / "a.csv").write_text("old", encoding="utf-8")
    os.link("a.csv", "b.csv")
    with pytest.raises(UsageError, match=r"both write to b\.csv"):
        check_targets({"--csv": "a.csv", "--json": "b.csv"}, [])
    with pytest.raises(UsageError, match=r"a.csv is an input, and the output would overwrite it"):
        check_targets({"--csv": "b.csv"}, ["a.csv"])


def test_a_folder_that_vanishes_is_named(folder):
    (folder / "sub").mkdir()
    reserve("sub/a.csv")
    (folder / "sub/.a.csv.chutecalc").unlink()
    (folder / "sub").rmdir()
    with pytest.raises(OutputError, match=r"sub/a.csv cannot be written: there is no folder sub"):
        written("sub/a.csv")


def test_a_name_that_is_too_long_is_named():
    with pytest.raises(OutputError, match=r"x{300} cannot be written: File name too long"):
        reserve("x" * 300)


def in_the_way_link(path):
    path.with_name("precious").write_text("mine", encoding="utf-8")
    path.symlink_to("precious")


@pytest.mark.parametrize("put", [in_the_way_link, Path.mkdir, lambda path: os.mkfifo(path)])
def test_what_is_in_the_way_is_named_and_left_alone(folder, put):
    put(folder / ".a.csv.chutecalc")
    with pytest.raises(OutputError, match=r"a.csv cannot be written: .*\.a\.csv\.chutecalc is in the way: remove it"):
        reserve("a.csv")
    if (folder / "precious").exists():
        assert (folder / "precious").read_text(encoding="utf-8") == "mine"


def test_what_has_changed_since_it_was_read_is_not_overwritten(folder):
    (folder / "a.toml").write_text("as read", encoding="utf-8")
    with open_whole("a.toml", "wb", read=b"as read") as stream:
        stream.write(b"solved")
    assert (folder / "a.toml").read_bytes() == b"solved"
    for change in (lambda path: path.write_text("edited", encoding="utf-8"), Path.unlink):
        change(folder / "a.toml")
        with (
            pytest.raises(WriteError, match="has changed since it was read"),
            open_whole("a.toml", "wb", read=b"solved"),
        ):
            pass
    assert names(folder) == []


def test_a_new_file_takes_the_place_of_none(folder, monkeypatch):
    for no_links in (False, True):
        if no_links:
            monkeypatch.setattr(os, "link", lambda *_: (_ for _ in ()).throw(OSError(errno.EPERM, "no links")))
        exists = pytest.raises(OutputError, match="already exists and was not changed")
        with exists, open_new("a.toml"):
            (folder / "a.toml").write_text("of another program", encoding="utf-8")
        assert (folder / "a.toml").read_text(encoding="utf-8") == "of another program"
        (folder / "a.toml").unlink()
        with open_new("a.toml") as stream:
            stream.write("new")
        assert names(folder) == ["a.toml"]
        (folder / "a.toml").unlink()


def test_permissions_and_links_stay(folder):
    (folder / "a.csv").write_text("old", encoding="utf-8")
    (folder / "a.csv").chmod(0o640)
    (folder / "link.csv").symlink_to("a.csv")
    written("link.csv")
    assert (folder / "link.csv").is_symlink()
    assert (folder / "a.csv").read_text(encoding="utf-8") == "new"
    assert (folder / "a.csv").stat().st_mode & 0o777 == 0o640
