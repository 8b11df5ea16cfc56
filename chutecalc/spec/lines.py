"""Finds the line of each table and key in the text of a spec."""

import re
import tomllib
from collections.abc import Iterator
from contextlib import suppress
from typing import NamedTuple

from chutecalc.fields.faults import Location

PART = r"""(?:[A-Za-z0-9_-]++|"[^"]*+"|'[^']*+')"""
"""Part of a dotted key. This and what follows is possessive, so that no line takes longer than its length."""
KEY = rf"{PART}(?:\s*+\.\s*+{PART})*+"
"""A key, dotted or not."""
_HEADER = r"\s*+(\[\[?+)([^\]]++)\]"
_ASSIGNMENT = rf"\s*+({KEY})\s*+=(.*+)"


class Place(NamedTuple):
    """Where a table or a key stands."""

    line: int
    """From 1."""
    location: Location
    header: str
    """``[`` or ``[[`` of a table, empty for a key."""

    @property
    def path(self) -> str:
        """Its path as messages have it, items of lists from 1."""
        return ".".join(str(part + 1) if isinstance(part, int) else part for part in self.location)


def places(text: str) -> Iterator[Place]:
    """Yield each table and key, as well as a pass over the lines can tell.

    Args:
        text: TOML. Lines inside a value of several lines count as the line of its key.
    """
    counts: dict[Location, int] = {}
    table: Location = ()
    quote = ""
    for number, line in enumerate(text.split("\n"), 1):
        if quote:
            quote = "" if quote in line else quote
            continue
        if header := re.match(_HEADER, line):
            table = _numbered(_keys(header[2]), counts, is_list=header[1] == "[[")
            yield Place(number, table, header[1])
        elif key := re.match(_ASSIGNMENT, line):
            yield Place(number, table + _keys(key[1]), "")
            quote = next((mark for mark in ('"""', "'''") if key[2].count(mark) == 1), "")


def key_lines(text: str) -> dict[Location, int]:
    r"""Return the line, from 1, of each table and key where it is given first.

    Args:
        text: TOML.

    >>> key_lines("[flow]\nrate_t_h = 1000")
    {('flow',): 1, ('flow', 'rate_t_h'): 2}
    """
    lines: dict[Location, int] = {}
    for place in places(text):
        for depth in range(1, len(place.location) + 1):
            lines.setdefault(place.location[:depth], place.line)
    return lines


def _keys(dotted: str) -> Location:
    """Return the parts of a dotted key."""
    return tuple(_unquoted(part) for part in re.findall(PART, dotted))


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
