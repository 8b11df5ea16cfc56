"""How large the parts of a text may be, looked at before the parser is: one pass, whose time grows as the text does.

The parser and what follows it take time and memory that grow with the square of some of these, or recurse into them.
"""

import re
from collections.abc import Mapping
from typing import Any

from chutecalc.errors import Fault
from chutecalc.printable import abbreviated
from chutecalc.spec.reader import LARGEST, too_large

MOST = 1_000_000
"""Words, numbers, texts, line ends and marks such as = in a text. A spec of 10,000 segments has half as many."""
DEEPEST = 50
"""Tables and lists within each other, parts of a dotted key among them. A spec needs six."""
DIGITS = 40
"""Characters of a number. A double has 17 digits."""
LONGEST_KEY = 200
"""Characters of a part of a key, which may be a key path in quotes."""
LONGEST_TEXT = 10_000
"""Characters of a text in quotes, such as the notes of a title block."""
SHOWN = 20
"""Characters of what is too long that a message shows."""
_TOKEN = re.compile(
    r'''
      (?P<comment> \#[^\n]*+ )
    | (?P<text> """ (?: [^"\\]++ | \\. | "(?!"") )*+ (?:"{3,5})?+ | \'\'\' (?: [^']++ | '(?!'') )*+ (?:'{3,5})?+
              | " (?: [^"\\\n]++ | \\[^\n] )*+ "?+ | ' [^'\n]*+ '?+ )
    | (?P<word> [^\s"'#=,.\[\]{}]++ )
    | (?P<end> \n\s*+ )
    | (?P<mark> [=,.\[\]{}] )
    ''',
    re.VERBOSE | re.DOTALL,
)
"""Every alternative is possessive: none is tried twice at a place."""


def excess(text: str) -> Fault | None:
    """Return the fault of the first part of a text that is larger than it may be; None if there is none.

    Args:
        text: TOML, or what should be.

    >>> excess("rate_t_h = 1" + 5000 * "0").problem
    'has a number of 5,001 digits, 1000000000…0000000000, and at most 40 are allowed'
    """
    if len(text) > LARGEST:
        return too_large()
    above: list[int] = []  # dots of the key before each bracket that is open
    depth, dots, last = 0, 0, ""
    for number, found in enumerate(_TOKEN.finditer(text)):
        kind, part, fault = found.lastgroup, found[0], None
        if kind == "comment":
            continue
        if kind != "mark":
            fault = _too_long(part, kind)
        elif part in ".=" and len(last) > LONGEST_KEY:
            fault = _length("a key", last, "characters", LONGEST_KEY)
        if part == ".":
            depth, dots = depth + 1, dots + 1
        elif part in ("[", "{"):
            above.append(dots)
            depth, dots = depth + 1, 0
        elif kind in ("mark", "end") and part != "=":  # the next key or value begins
            depth, dots = depth - dots, 0
            if part in ("]", "}") and above:
                depth, dots = depth - 1, above.pop()
        if depth > DEEPEST:
            fault = too_deep()
        if number == MOST:
            fault = Fault("", f"has more than {MOST:,} words and marks up to here", "make it several specs")
        if fault:
            return fault._replace(line=text.count("\n", 0, found.start()) + 1)
        last = part
    return None


def too_deep() -> Fault:
    """Return the fault of tables and lists that are nested too deep."""
    problem = f"is nested more than {DEEPEST} deep, parts of dotted keys included"
    return Fault("", problem, "use at most four levels of tables")


def excess_of_tables(data: Any) -> Fault | None:
    """Return the fault of tables that are nested too deep, in themselves for example, or have too much in them.

    Args:
        data: what a caller gives as tables.

    >>> excess_of_tables({"flow": {"rate_t_h": 1000}})
    """
    level, count = [data], 0
    for _ in range(DEEPEST + 1):
        tables = [each for each in level if isinstance(each, Mapping | list | tuple)]
        count += sum(map(len, tables))
        if not tables:
            return None
        if count > MOST:
            return Fault("", f"has more than {MOST:,} items", "make it several specs")
        level = [item for each in tables for item in (each.values() if isinstance(each, Mapping) else each)]
    return too_deep()


def _too_long(part: str, kind: str | None) -> Fault | None:
    """Return the fault of a text in quotes, or of a word, that is too long."""
    if kind == "end":
        return None
    if kind == "text":
        return _length("a text", part, "characters", LONGEST_TEXT) if len(part) > LONGEST_TEXT else None
    if part[0] in "+-0123456789" and len(part) > DIGITS:
        return _length("a number", part, "digits", DIGITS)
    return _length("a word", part, "characters", LONGEST_KEY) if len(part) > LONGEST_KEY else None


def _length(what: str, part: str, unit: str, most: int) -> Fault:
    """Return the fault of something that is too long, of which it shows the ends."""
    problem = f"has {what} of {len(part):,} {unit}, {abbreviated(part, SHOWN + 1)}, and at most {most:,} are allowed"
    return Fault("", problem, "shorten it")
