"""What this process keeps others from writing, from before anything is solved until it is written."""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from chutecalc.errors import OutputError, WriteError
from chutecalc.output.locks import OPEN, HeldError, Lock
from chutecalc.output.scratch import remove_scratch
from chutecalc.output.targets import STANDARD_STREAM

SUFFIX = ".chutecalc"
"""Ending of the file that is written first. One that a killed process has left is taken by who writes next."""


_held: dict[Path, Lock] = {}
"""What this process holds until it writes it or ends its command, by path."""


def hold(path: Path, what: str) -> None:
    """Hold a file until :func:`take` or :func:`release`.

    Args:
        path: of the file.
        what: what nobody else may write meanwhile, for the message.

    Raises:
        OutputError: another process holds it, or this one already.
        OSError: it cannot be opened, or nothing can be written to it.
    """
    _held[path] = lock(path, what)


def lock(path: Path, what: str) -> Lock:
    """Return a lock that its user releases.

    Args:
        path: as for :func:`hold`.
        what: as for :func:`hold`.

    Raises:
        OutputError: as for :func:`hold`.
        OSError: as for :func:`hold`.
    """
    try:
        return Lock(path)
    except HeldError as held:
        if held.process == os.getpid():
            raise OutputError(f"{what} is written twice: give one of the outputs another name") from None
        number = f" {held.process}" if held.process else ""
        raise OutputError(
            f"another process{number} of chutecalc is writing {what}. Wait for its end, or stop it, and repeat."
        ) from None


def take(path: Path) -> Lock | None:
    """Return a lock that is held, which its user releases from now on; None if this one is not held.

    Args:
        path: of its file.
    """
    return _held.pop(path, None)


def release() -> None:
    """Release all that this process has locked, and remove its temporary files: its command is at its end."""
    remove_scratch()
    _held.clear()
    for each in list(OPEN):
        each.release()


def reserve(target: str | None) -> None:
    """Check that a file can be written, and keep other processes from writing it until it is written.

    Args:
        target: its path, ``-`` for standard output, or None for no output.

    Raises:
        OutputError: it cannot be written, or another process is writing it.
        WriteError: the disk is full.
    """
    if target in (None, STANDARD_STREAM):
        return
    path = real_file(str(target))
    if not is_special(path):
        with named(str(target)):
            hold(temporary(path), str(target))
    elif not os.access(path, os.W_OK):
        raise OutputError(f"{target} cannot be written: {os.strerror(errno.EACCES)}")


def hold_folder(folder: str, what: str) -> None:
    """Keep other processes that do the same out of a folder, until the command ends.

    Args:
        folder: its path.
        what: what nobody else may write there meanwhile, for the message.

    Raises:
        OutputError: another process does so, or the folder cannot be written.
        WriteError: the disk is full.
    """
    with named(what):
        hold(Path(folder, SUFFIX), what)


def make_folder(folder: Path) -> None:
    """Create a folder, and those above it, where they are not there.

    Args:
        folder: its path.

    Raises:
        OutputError: it cannot be created.
        WriteError: the disk is full.
    """
    with named(str(folder)):
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except FileExistsError as error:  # a file, or a link that leads nowhere
            raise FileExistsError(error.errno, f"{error.filename} is no folder: remove or rename it") from None


@contextmanager
def held_folder(folder: Path, what: str) -> Iterator[None]:
    """Keep other processes that do the same out of a folder for a while.

    Args:
        folder: as for :func:`hold_folder`.
        what: as for :func:`hold_folder`.

    Raises:
        OutputError: as for :func:`hold_folder`.
        WriteError: as for :func:`hold_folder`.
    """
    hold_folder(str(folder), what)
    try:
        yield
    finally:
        let_folder_go(str(folder))


def let_folder_go(folder: str) -> None:
    """End what :func:`hold_folder` began.

    Args:
        folder: its path.
    """
    if held := take(Path(folder, SUFFIX)):
        held.release()


def real_file(target: str) -> Path:
    """Return the file that a target means: a link's own target, unless it is a device or a pipe; never a folder.

    Args:
        target: a path.

    Raises:
        OutputError: it is a folder, or cannot be.
    """
    with named(target):
        if is_special(Path(target)):
            return Path(target)  # what /dev/stdout leads to has no name that can be opened
        path = Path(os.path.realpath(target))
        os.stat(path.parent)
        if path.is_dir():
            raise OutputError(f"{target} is a folder: name a file in it")
    return path


def is_special(path: Path) -> bool:
    """Return whether a path is that of a device or a pipe.

    Args:
        path: of what may be there.
    """
    return os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path)


def temporary(path: Path) -> Path:
    """Return the file that is written first, and then takes the place of another.

    Args:
        path: of the other.
    """
    return path.with_name(f".{path.name}{SUFFIX}")


@contextmanager
def named(target: str, kind: type[OutputError | WriteError] = OutputError) -> Iterator[None]:
    """Turn errors of the system into those that name the target.

    Args:
        target: its name.
        kind: what becomes of them; where the disk is full it is a WriteError.

    Raises:
        OutputError: the target cannot be written.
        WriteError: the disk is full, or nothing else was asked for.
    """
    try:
        yield
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG) or kind is WriteError:
            raise WriteError(f"{target} could not be written: {error.strerror}") from None
        absent = isinstance(error, FileNotFoundError | NotADirectoryError) and _absent_folder(target)
        raise OutputError(f"{target} cannot be written: {absent or error.strerror}") from None


def _absent_folder(target: str) -> str | None:
    """Return which folder of a file is missing, and what to do; None if all are there."""
    try:
        paths = (target, os.path.realpath(target))  # the folder of a link, and its own
    except FileNotFoundError:
        return "the folder that you are in was removed. Change to another one."
    absent = next((folder for folder in (Path(path).parent for path in paths) if not folder.is_dir()), None)
    if absent is None:
        return None
    if absent.exists():
        return f"{absent} is no folder. Name another one."
    return f"there is no folder {absent}. Create it first."
