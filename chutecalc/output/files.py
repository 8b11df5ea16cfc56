"""Output files: checked before anything is solved, and written whole or not at all."""

import errno
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

from chutecalc.errors import OutputError, UsageError, WriteError

STANDARD_STREAM = "-"


def check_targets(outputs: Mapping[str, str | None], inputs: Sequence[str | None]) -> None:
    """Check that no two outputs are the same, and that no output is an input.

    Args:
        outputs: files that are written, by option; None for an output that was not asked for.
        inputs: files that are read; None for one that was not given.

    Raises:
        UsageError: the outputs that are the same, or the output that is an input.
    """
    given = {option: output for option, output in outputs.items() if output}
    if list(given.values()).count(STANDARD_STREAM) > 1:
        raise UsageError("only one output can go to standard output (-)")
    if list(inputs).count(STANDARD_STREAM) > 1:
        raise UsageError("only one spec can come from standard input (-)")
    files: dict[str, str] = {}
    for option, output in given.items():
        if output == STANDARD_STREAM:
            continue
        file = os.path.realpath(output)
        if file in files:
            raise UsageError(f"{files[file]} and {option} both write to {output}. Give one of them another name.")
        files[file] = option
    for file in files:
        if file in {os.path.realpath(name) for name in inputs if name not in (None, STANDARD_STREAM)}:
            raise UsageError(f"{file} is an input, and the output would overwrite it: choose another name")


def check_openable(target: str | None) -> None:
    """Check that a file can be written.

    Args:
        target: its path, ``-`` for standard output, or None for no output.

    Raises:
        OutputError: it cannot be written.
    """
    if target in (None, STANDARD_STREAM):
        return
    path = _file(str(target))
    if not path.parent.is_dir():
        raise OutputError(f"{target} cannot be written: there is no folder {path.parent}")
    try:
        if path.exists() and not path.is_file():  # a device or a pipe
            if not os.access(path, os.W_OK):
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        else:
            part = _part_of(path)
            part.touch()
            part.unlink()
    except OSError as error:
        raise OutputError(f"{target} cannot be written: {error.strerror}") from None


def _file(target: str) -> Path:
    """Return the file that a target means: a link's own target, never a folder."""
    path = Path(os.path.realpath(target))
    if path.is_dir():
        raise OutputError(f"{target} is a folder: name a file in it")
    return path


def _part_of(path: Path) -> Path:
    """Return the file that is written first, and then takes the place of the target."""
    return path.with_name(f".{path.name}.{os.getpid()}.part")


@contextmanager
def open_whole(target: str, mode: str = "w") -> Iterator[IO[Any]]:
    """Open a stream that becomes the file when the block ends, and leaves no trace when the block fails.

    Args:
        target: a path, or ``-`` for standard output.
        mode: ``w`` for text, ``wb`` for bytes.

    Raises:
        OutputError: it cannot be opened.
        WriteError: it was opened, and then could not be written.
    """
    if target == STANDARD_STREAM:
        yield sys.stdout.buffer if "b" in mode else sys.stdout
    elif os.path.exists(target) and not os.path.isfile(target) and not os.path.isdir(target):
        with _opened(target, target, mode) as stream:  # a device or a pipe: nothing to rename
            yield stream
    else:
        yield from _replacing(target, mode)


@contextmanager
def open_new(target: str) -> Iterator[IO[Any]]:
    """Open a stream that becomes a new file when the block ends; a file that exists is never overwritten.

    Args:
        target: a path, or ``-`` for standard output.

    Raises:
        OutputError: it exists, or cannot be opened.
        WriteError: it was opened, and then could not be written.
    """
    if target != STANDARD_STREAM:
        path = _file(target)
        try:
            path.open("x").close()  # from now on the name is taken
        except FileExistsError:
            raise OutputError(f"{target} already exists and was not changed. Choose another name.") from None
        except FileNotFoundError:
            folder = Path(target).parent
            raise OutputError(f"{target} cannot be written: there is no folder {folder}. Create it first.") from None
        except OSError as error:
            raise OutputError(f"{target} cannot be written: {error.strerror}") from None
    try:
        with open_whole(target) as stream:
            yield stream
    except BaseException:
        if target != STANDARD_STREAM:
            path.unlink(missing_ok=True)
        raise


def _replacing(target: str, mode: str) -> Iterator[IO[Any]]:
    """Open a new file beside the target, and replace the target with it at the end."""
    path = _file(target)
    part = _part_of(path)
    try:
        with _opened(str(part), target, mode) as stream:
            yield stream
            try:
                stream.flush()
                os.fsync(stream.fileno())
            except OSError as error:
                raise WriteError(f"{target} could not be written: {error.strerror}") from None
        if path.exists():
            os.chmod(part, path.stat().st_mode & 0o7777)
        os.replace(part, path)
    finally:
        with suppress(FileNotFoundError):
            part.unlink()


@contextmanager
def _opened(file: str, target: str, mode: str) -> Iterator[IO[Any]]:
    """Open a file whose errors name the target."""
    try:
        encoding, newline = (None, None) if "b" in mode else ("utf-8", "")
        stream = open(file, mode, encoding=encoding, newline=newline)  # noqa: SIM115 - closed below; other errors are others
    except OSError as error:
        raise OutputError(f"{target} cannot be written: {error.strerror}") from None
    try:
        with stream:
            yield stream
    except OSError as error:
        raise WriteError(f"{target} could not be written: {error.strerror}") from None
