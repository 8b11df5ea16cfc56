"""Reads the text of a spec from a file, parses it, and finds the line of each key."""

import re
import tomllib
from codecs import BOM_UTF8
from contextlib import suppress
from pathlib import Path
from typing import Any

from chutecalc.errors import Fault, SpecError
from chutecalc.fields.faults import Location

BASELINE_SUFFIX = ".baseline.toml"
"""Ending of a baseline's file, in place of the ``.toml`` of the spec beside it."""

_HEADER = r"^\s*(\[\[?)\s*([^\]]+?)\s*\]"
_KEY = r"""^\s*((?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*'))*)\s*=\s*(.*)$"""
_DECIMAL_COMMA = r"^\s*([A-Za-z0-9_.-]+)\s*=\s*([+-]?\d+),(\d+)\s*(?:#.*)?$"


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
        raise SpecError(
            [Fault("", "there is no such file", "check the name, or create one with chutecalc new")], str(path)
        ) from None
    except IsADirectoryError:
        raise SpecError([Fault("", "is a folder", "name a .toml file in it")], str(path)) from None
    except OSError as error:
        raise SpecError([Fault("", f"cannot be read: {error.strerror}", "check the path")], str(path)) from None


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
        problem = f"is not UTF-8 (byte {error.start})"
        raise SpecError([Fault("", problem, "save it as UTF-8")], source) from None


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
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        message = str(error)
        found = re.search(r"\(at line (\d+), column (\d+)\)", message)
        if found and (comma := re.match(_DECIMAL_COMMA, text.splitlines()[int(found[1]) - 1])):
            key, whole, decimals = comma.groups()
            remedy = f"write a decimal point: {whole}.{decimals}"
            raise SpecError(
                [Fault(key, "is not a number", remedy, f"{whole},{decimals}", int(found[1]))], source
            ) from None
        problem = "is not valid TOML: " + re.sub(r"\s*\(at .*\)$", "", message)
        if found:
            fault = Fault("", f"{problem}, column {found[2]}", "see https://toml.io", line=int(found[1]))
        else:
            fault = Fault("", problem, "see https://toml.io")
        raise SpecError([fault], source) from None
    except RecursionError:
        raise SpecError([Fault("", "is nested too deeply", "use at most four levels of tables")], source) from None
    except ValueError as error:  # what tomllib lets through: an integer of thousands of digits
        raise SpecError([Fault("", f"is not valid TOML: {error}", "see https://toml.io")], source) from None


def key_lines(text: str) -> dict[Location, int]:
    r"""Return the line, from 1, of each table and key, as well as a pass over the lines can tell.

    Args:
        text: TOML. Lines inside a value of several lines count as the line of its key.

    >>> key_lines("[flow]\nrate_t_h = 1000")
    {('flow',): 1, ('flow', 'rate_t_h'): 2}
    """
    lines: dict[Location, int] = {}
    counts: dict[Location, int] = {}
    table: Location = ()
    quote = ""
    for number, line in enumerate(text.split("\n"), 1):
        if quote:
            quote = "" if quote in line else quote
            continue
        if header := re.match(_HEADER, line):
            table = _numbered(_keys(header[2]), counts, is_list=header[1] == "[[")
            lines.setdefault(table, number)
        elif key := re.match(_KEY, line):
            lines.setdefault(table + _keys(key[1]), number)
            quote = next((mark for mark in ('"""', "'''") if key[2].count(mark) == 1), "")
    return lines


def _keys(dotted: str) -> Location:
    """Return the parts of a dotted key."""
    parts = re.findall(r"""[A-Za-z0-9_-]+|"[^"]*"|'[^']*'""", dotted)
    return tuple(_unquoted(part) for part in parts)


def _unquoted(key: str) -> str:
    """Return a key without its quotes, and with the characters that its escape sequences stand for."""
    if key.startswith('"') and "\\" in key:
        with suppress(tomllib.TOMLDecodeError):  # in a line that is part of a value
            return next(iter(tomllib.loads(f"{key} = 0")))
    return key.strip("\"'")


def _numbered(keys: Location, counts: dict[Location, int], is_list: bool) -> Location:
    """Return a table's location, with the index of each list item that it lies in."""
    location: Location = ()
    for depth, key in enumerate(keys, 1):
        location = (*location, key)
        if is_list and depth == len(keys):
            counts[location] = counts.get(location, -1) + 1
        if location in counts:
            location = (*location, counts[location])
    return location
