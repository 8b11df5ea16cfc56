"""Reads what a user gives as a file or through standard input: regular files alone, and no more than is allowed."""

import stat
import sys
from difflib import get_close_matches
from pathlib import Path
from typing import IO

from chutecalc.errors import Fault, SpecError

BASELINE_SUFFIX = ".baseline.toml"
"""Ending of a baseline's file, in place of the ``.toml`` of the spec beside it."""
STANDARD_INPUT = "standard input"
"""What messages call it."""
LARGEST = 10_000_000
"""Bytes that a file may have: a thousand times what a spec of twenty segments takes."""
KINDS = {stat.S_IFIFO: "a named pipe", stat.S_IFSOCK: "a socket", stat.S_IFCHR: "a device", stat.S_IFBLK: "a device"}
"""What may have the name of a file and is none, by its type."""


def read_bytes(path: Path, most: int = LARGEST) -> bytes:
    """Return the content of a file.

    Args:
        path: of the file.
        most: bytes that it may have.

    Raises:
        SpecError: The file does not exist, is none, is too large, or cannot be read.
    """
    try:
        kind = stat.S_IFMT(path.stat().st_mode)
        if kind == stat.S_IFDIR:
            raise SpecError([Fault("", "is a folder", "name a .toml file in it")], str(path))
        if kind != stat.S_IFREG:  # which may have no end, and opening it may wait for ever
            problem = f"is {KINDS.get(kind, 'something else')}, not a file"
            raise SpecError([Fault("", problem, "name a file, or write - and pipe the text in")], str(path))
        with open(path, "rb") as stream:
            return _within(stream, most, str(path))
    except FileNotFoundError:
        raise SpecError([Fault("", "there is no such file", _meant(path))], str(path)) from None
    except (OSError, ValueError) as error:  # a ValueError for a name with a null character
        reason = getattr(error, "strerror", None) or str(error)
        raise SpecError([Fault("", f"cannot be read: {reason}", "check the path")], str(path)) from None


def read_standard_input() -> bytes:
    """Return all of standard input.

    Raises:
        SpecError: It is closed, too large, or cannot be read.
    """
    if sys.stdin is None:  # closed before the start
        raise SpecError([Fault("", "is closed", "pipe the text in, or name a file")], STANDARD_INPUT)
    try:
        return _within(sys.stdin.buffer, LARGEST, STANDARD_INPUT)
    except OSError as error:
        fault = Fault("", f"cannot be read: {error.strerror}", "pipe the text in, or name a file")
        raise SpecError([fault], STANDARD_INPUT) from None


def _within(stream: IO[bytes], most: int, source: str) -> bytes:
    """Return the content of a stream, or refuse it after one byte too many."""
    content = stream.read(most + 1)
    if len(content) > most:
        raise SpecError([too_large(most)], source)
    return content


def too_large(most: int = LARGEST) -> Fault:
    """Return the fault of a text that has more bytes than are allowed.

    Args:
        most: bytes that it may have.
    """
    return Fault("", f"is larger than {most / 1e6:g} MB", "check that it is the right file")


def _meant(path: Path) -> str:
    """Return what to do about a file that does not exist."""
    name = str(path)
    if name[:1] in "–—":
        return f"if it is an option, write --{name.lstrip('–—-')}, with two minus signs"
    if "=" in name:
        return f"to change a key write --set {name}"
    there = [each.name for each in path.parent.glob("*.toml") if not each.name.endswith(BASELINE_SUFFIX)]
    if close := get_close_matches(path.name, there, n=1) or get_close_matches(f"{path.name}.toml", there, n=1):
        return f"did you mean {path.with_name(close[0])}?"
    return "check the name, or create one with chutecalc new"
