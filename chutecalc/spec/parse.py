"""Reads the text of a spec from a file, and parses it."""

import tomllib
from codecs import BOM_UTF8, BOM_UTF16_BE, BOM_UTF16_LE
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.spec.syntax import syntax_fault

BASELINE_SUFFIX = ".baseline.toml"
"""Ending of a baseline's file, in place of the ``.toml`` of the spec beside it."""


def read_text(path: Path) -> str:
    """Return the text of a spec file.

    Args:
        path: of the file.

    Raises:
        SpecError: The file does not exist, cannot be read, or is not UTF-8.
    """
    return decode(read_bytes(path), str(path))


def read_bytes(path: Path) -> bytes:
    """Return the content of a spec file.

    Args:
        path: of the file.

    Raises:
        SpecError: The file does not exist, or cannot be read.
    """
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise SpecError([Fault("", "there is no such file", _meant(path))], str(path)) from None
    except IsADirectoryError:
        raise SpecError([Fault("", "is a folder", "name a .toml file in it")], str(path)) from None
    except OSError as error:
        raise SpecError([Fault("", f"cannot be read: {error.strerror}", "check the path")], str(path)) from None


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


def decode(data: bytes, source: str) -> str:
    """Return the text of a spec's bytes, which are UTF-8 whatever the locale; line ends become line feeds.

    Args:
        data: content of the file, with or without a byte order mark.
        source: what messages call the spec.

    Raises:
        SpecError: The bytes are not UTF-8.
    """
    try:
        return data.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
            problem, line = "is UTF-16, which editors on Windows call Unicode", None
        else:
            problem, line = "has a character that is not UTF-8", data.count(b"\n", 0, error.start) + 1
        raise SpecError([Fault("", problem, "save the file as UTF-8", line=line)], source) from None


def encode(text: str, like: bytes) -> bytes:
    r"""Return text as the content of a file, with the byte order mark and the line ends of another.

    Args:
        text: with line feeds at the ends of its lines.
        like: content of the other file; its first line end counts.

    >>> encode("title = 'Spoon'\n", like=b"title = 'Chute'\r\n")
    b"title = 'Spoon'\r\n"
    """
    mark = BOM_UTF8 if like.startswith(BOM_UTF8) else b""
    ends = "\r\n" if like.partition(b"\n")[0].endswith(b"\r") else "\n"
    return mark + text.replace("\n", ends).encode()


def parse_text(text: str, source: str) -> dict[str, Any]:
    r"""Return a spec's text as nested tables.

    Args:
        text: TOML.
        source: what messages call the spec.

    Raises:
        SpecError: The text is not TOML; the fault has the line where that is known.

    >>> parse_text("[flow]\nrate_t_h = 1000", "spoon.toml")
    {'flow': {'rate_t_h': 1000}}
    """
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SpecError([syntax_fault(text, str(error))], source) from None
    except RecursionError:
        raise SpecError([Fault("", "is nested too deeply", "use at most four levels of tables")], source) from None
    except ValueError as error:  # what tomllib lets through: an integer of thousands of digits
        raise SpecError([Fault("", f"is not valid TOML: {error}", "see https://toml.io")], source) from None
    if not data:
        raise SpecError([Fault("", "is empty", "run chutecalc new, which writes one to start from")], source)
    return data
