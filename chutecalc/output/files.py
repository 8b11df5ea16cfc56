"""The one writer of files: held from before anything is solved, written whole or not at all."""

import io
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

from chutecalc.errors import OutputError, WriteError
from chutecalc.output.held import is_special, lock, named, real_file, take, temporary
from chutecalc.output.locks import Lock
from chutecalc.output.targets import STANDARD_STREAM


@contextmanager
def open_whole(target: str, mode: str = "w", read: bytes | None = None) -> Iterator[IO[Any]]:
    """Open a stream that becomes the file when the block ends, and leaves no trace when the block fails.

    Args:
        target: a path, or ``-`` for standard output.
        mode: ``w`` for text, ``wb`` for bytes.
        read: content that the file had when it was read; where it has another by now, it is left as it is.

    Raises:
        OutputError: it cannot be opened, or another process is writing it.
        WriteError: it was opened, and then could not be written, or its content is not the one that was read.
    """
    if target == STANDARD_STREAM:
        yield sys.stdout.buffer if "b" in mode else sys.stdout
    elif is_special(path := real_file(target)):
        with named(target):
            raw = open(path, "wb", buffering=0)  # noqa: SIM115 - closed below
        with raw, _stream(raw.fileno(), target, mode) as stream:  # a device or a pipe: nothing to replace
            yield stream
            stream.flush()
    else:
        with _replacing(path, target, mode, fresh=False, read=read) as stream:
            yield stream


@contextmanager
def open_new(target: str) -> Iterator[IO[Any]]:
    """Open a stream that becomes a new file when the block ends; a file that exists is never overwritten.

    Args:
        target: a path, or ``-`` for standard output.

    Raises:
        OutputError: it exists, or cannot be opened.
        WriteError: it was opened, and then could not be written.
    """
    if target == STANDARD_STREAM:
        yield sys.stdout
        return
    path = real_file(target)
    if os.path.lexists(path):
        raise OutputError(_exists(target))
    with _replacing(path, target, "w", fresh=True) as stream:
        yield stream


@contextmanager
def _replacing(path: Path, target: str, mode: str, fresh: bool, read: bytes | None = None) -> Iterator[IO[Any]]:
    """Open a file beside a path that takes its place at the end."""
    held = take(temporary(path))
    if held is None:
        with named(target):
            held = lock(temporary(path), target)
    try:
        held.empty()
        with _stream(held.descriptor, target, mode) as stream:
            yield stream
            stream.flush()
            if read is not None and _content(path) != read:
                raise changed(target)
            with named(target, WriteError):
                os.fsync(held.descriptor)
                _move(held, path, target, fresh)
    finally:
        held.release()


def _move(held: Lock, path: Path, target: str, fresh: bool) -> None:
    """Put what is written in its place, with the permissions of what was there."""
    with suppress(OSError):  # there was nothing, or the file system knows no permissions
        os.chmod(held.path, path.stat().st_mode & 0o7777)
    try:
        held.move(path, fresh)
    except FileExistsError:
        raise OutputError(_exists(target)) from None
    except PermissionError as error:
        opened = " Is it open in another program? Close it there and repeat." if sys.platform == "win32" else ""
        raise WriteError(f"{target} could not be written: {error.strerror}.{opened}") from None


def changed(target: str) -> WriteError:
    """Return the error of a file that somebody has edited since it was read.

    Args:
        target: its name.
    """
    return WriteError(f"{target} has changed since it was read, and is left as it is. Repeat the command.")


def _content(path: Path) -> bytes | None:
    """Return what is in a file; None where it cannot be read any more."""
    with suppress(OSError):
        return path.read_bytes()
    return None


def _exists(target: str) -> str:
    return f"{target} already exists and was not changed. Choose another name."


class _NamedFile(io.FileIO):
    """A file that is written, whose errors name it. What else fails meanwhile keeps its own errors.

    Once it is done it takes everything and writes nothing: after an error, libraries write on while they are removed.

    Args:
        descriptor: of the file; it stays open.
        target: its name.
    """

    done = False
    """Whether the descriptor may be that of another file by now."""

    def __init__(self, descriptor: int, target: str) -> None:
        super().__init__(descriptor, "wb", closefd=False)
        self._target = target

    def write(self, content: Any) -> int:
        """Write bytes; how many is returned.

        Args:
            content: the bytes.
        """
        if self.done:
            return len(content)
        with named(self._target, WriteError):
            return super().write(content)

    def seekable(self) -> bool:
        """Return that nobody can go back in it: that would need the descriptor, and all formats can do without."""
        return False

    def tell(self) -> int:
        """Refuse to tell a place to go back to.

        Raises:
            UnsupportedOperation: always.
        """
        raise io.UnsupportedOperation("tell")


@contextmanager
def _stream(descriptor: int, target: str, mode: str) -> Iterator[IO[Any]]:
    """Yield a stream of bytes or text, which is not closed at the end: see :class:`_NamedFile`."""
    raw = _NamedFile(descriptor, target)
    stream: Any = io.BufferedWriter(raw)
    if "b" not in mode:
        # names of files may hold bytes that are no text: they stand as escapes, which JSON reads back
        stream = io.TextIOWrapper(stream, encoding="utf-8", errors="backslashreplace", newline="")
    try:
        yield stream
    finally:
        raw.done = True
