"""Turns what a user gives into tables: the one way to TOML, for specs, libraries, baselines and single values."""

import tomllib
from codecs import BOM_UTF8, BOM_UTF16_BE, BOM_UTF16_LE
from pathlib import Path
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.spec.bounded import excess
from chutecalc.spec.reader import read_bytes
from chutecalc.spec.syntax import syntax_fault


def read_text(path: Path) -> str:
    """Return the text of a spec file.

    Args:
        path: of the file.

    Raises:
        SpecError: The file does not exist, cannot be read, or is not UTF-8.
    """
    return decode(read_bytes(path), str(path))


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
    if fault := excess(text):
        raise SpecError([fault], source)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SpecError([syntax_fault(text, str(error))], source) from None
    if not data:
        raise SpecError([Fault("", "is empty", "run chutecalc new, which writes one to start from")], source)
    return data


class NotValue(Exception):  # noqa: N818 - it says what a text is
    """Raised for a text that is not a value of TOML."""


def parse_value(text: str) -> Any:
    """Return the value that a text is, as TOML writes it.

    Args:
        text: in one line.

    Raises:
        SpecError: It is larger than it may be.
        NotValue: It is none.

    >>> parse_value("[1.5, 2]")
    [1.5, 2]
    """
    if fault := excess(text):
        raise SpecError([fault._replace(line=None)])
    try:
        data = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        raise NotValue(text) from None
    if len(data) > 1:  # a second line with another key
        raise NotValue(text)
    return data["value"]
