"""Slips in the value of a key: what is wrong with it, and what to write instead.

Each is a pattern of the whole value, and what was meant by it. What is meant is a value that TOML takes.
"""

import re
import tomllib
import unicodedata
from collections.abc import Callable
from typing import NamedTuple

from chutecalc.errors import Fault

LONGEST = 300
"""Characters of a line in which slips are looked for. Some of the patterns take a time that grows with its square."""
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_QUOTES = "“”„‟«»‹›‘’‚`´"
_DASHES = "−–—‒‑"
_COMMENT = r"(?://+|/\*+|;+|--+|!+)\s*.*"


class Slip(NamedTuple):
    """A slip that people make."""

    pattern: str
    """Of the whole value."""
    problem: str
    meant: Callable[[re.Match[str]], str] | None = None
    """Gives the value that was meant."""
    remedy: str = ""
    """What to do, where there is no value to suggest."""


def _plain(text: str) -> str:
    """Return a number as TOML takes it, from one without separators."""
    sign, digits = (text[0], text[1:]) if text[:1] in "+-" else ("", text)
    whole, point, decimals = digits.partition(".")
    return sign.replace("+", "") + (whole.lstrip("0") or "0") + (f".{decimals or '0'}" if point else "")


def _separated(found: re.Match[str]) -> str:
    """Return a number without separators of thousands; of comma and point the last one is before the decimals."""
    text = re.sub(r"['’\s_]", "", found[0])
    if "," in text and "." in text:
        mark = "," if text.rfind(",") > text.rfind(".") else "."
        text = text.replace("." if mark == "," else ",", "").replace(mark, ".")
    elif text.count(",") == 1:
        text = text.replace(",", ".")
    elif text.count(",") > 1 or text.count(".") > 1:
        text = text.replace(",", "").replace(".", "")
    return _plain(text)


_AMBIGUOUS = r"[+-]?[1-9]\d{0,2},\d{3}"
_LEFT_OUT = "write a value, or delete the line"
SLIPS = (
    Slip("", "has no value", remedy=_LEFT_OUT),
    Slip(r"(?i)null|none|nil|n/?a|tbd|\?+|\.\.\.|…|-+", "is no value", remedy=_LEFT_OUT),
    Slip(rf"[{_QUOTES}]+(.*?)[{_QUOTES}\"']*", "is in quotes that TOML does not know", lambda found: f'"{found[1]}"'),
    Slip(rf"[{_DASHES}]\s*(\d.*)", "has a dash that is not a minus sign", lambda found: f"-{_plain(found[1])}"),
    Slip("(?i)true|yes|on", "must be true or false, in small letters", lambda found: "true"),
    Slip("(?i)false|no|off", "must be true or false, in small letters", lambda found: "false"),
    Slip(
        rf"{_NUMBER}(?:\s*[,;]\s+{_NUMBER})+",
        "is several numbers, which must be in brackets",
        lambda found: f"[{', '.join(map(_plain, re.findall(_NUMBER, found[0])))}]",
    ),
    Slip(
        r"[+-]?\d+(?:,\d+)?(?:\s*;\s*[+-]?\d+(?:,\d+)?)+",
        "is several numbers, which must be in brackets, with decimal points",
        lambda found: (
            f"[{', '.join(_plain(each.replace(',', '.')) for each in re.findall(r'[+-]?[0-9,]+', found[0]))}]"
        ),
    ),
    Slip(
        _AMBIGUOUS,
        "is not a number: a comma is no part of one",
        lambda found: found[0].replace(",", "") + ", or with a decimal point " + found[0].replace(",", "."),
    ),
    Slip(r"[+-]?\d+,\d+", "is not a number: the decimal mark is a point", _separated),
    Slip(r"[+-]?\d[\d.,'’_]*(?:\s\d[\d.,'’_]*)*(?<![,'’_])", "is not a number as TOML writes it", _separated),
    Slip(r"[+-]?\.\d+", "needs a digit before the point", lambda found: _plain(found[0])),
    Slip(
        rf"({_NUMBER})\s*%",
        "must be a number alone",
        lambda found: f"{float(found[1]) / 100:g} if a share is meant, or {_plain(found[1])}",
    ),
    Slip(rf"({_NUMBER})\s*/\s*({_NUMBER})", "must be one number", lambda found: _ratio(found[1], found[2])),
    Slip(
        rf"[~≈<>±]\s*{_NUMBER}.*|{_NUMBER}\s*(?:±|\+/-|\.\.\.?|to|bis|-|–)\s*{_NUMBER}.*",
        "must be one number",
        remedy="write one number; how uncertain it is goes into [uncertainty]",
    ),
    Slip(
        rf"({_NUMBER}|\"[^\"]*\"|'[^']*'|true|false)[,;]?\s+[A-Za-z_][\w.-]*\s*=.*",
        "has another key in its line",
        remedy="write each key on a line of its own",
    ),
    Slip(r"(\S.*?)\s*[,;]", "has something behind it that is not TOML", lambda found: found[1]),
    Slip(rf"(\S.*?)\s*{_COMMENT}", "has something behind it; comments begin with #", lambda found: found[1]),
    Slip(
        rf"({_NUMBER})\s*[^\W\d].*|({_NUMBER})\s*[°º'\"′″].*",
        "must be a number alone: its unit is in the name of the key",
        lambda found: _plain(found[1] or found[2]),
    ),
    Slip(r"=\s*(.*)", "has two equals signs", lambda found: found[1]),
    Slip(r"\"(.*\\.*)\"", "has a backslash in double quotes; single quotes take it", lambda found: f"'{found[1]}'"),
    Slip(r"\"([^\"]*)'?|'([^']*)\"?", "is in quotes that do not close", lambda found: f'"{found[1] or found[2]}"'),
    Slip(r"\[[^\]]*", "is a list without an end", remedy="close it with ]"),
    Slip(r"\[.*\]", "is not a list as TOML writes it", remedy="write it such as [1.5, 2.5], with decimal points"),
    Slip(r"\{[^}]*", "is a table in braces, which must end in its line", remedy="close it with }"),
    Slip(r"\{.*\}", "is not a table as TOML writes it", remedy="write it such as { normal = [25, 2] }"),
    Slip(r"([^\W\d].*?)[\"']?", "must be in quotes if it is text", lambda found: f'"{found[1]}"'),
)
"""In the order in which they are looked for."""


def value_fault(key: str, value: str) -> Fault | None:
    """Return what is wrong with a value that TOML does not take.

    Args:
        key: that it is of.
        value: as written, without a comment.

    >>> value_fault("radius_m", "3 m").text("spoon.toml")
    'spoon.toml: radius_m = 3 m must be a number alone: its unit is in the name of the key. Write radius_m = 3.'
    """
    if len(value) > LONGEST:
        return None
    if fault := invisible_fault(re.sub(r"\"[^\"]*\"|'[^']*'", "", value)):
        return fault._replace(path=key)
    for slip in SLIPS:
        if (found := re.fullmatch(slip.pattern, value)) and (remedy := _remedy(slip, found, key)):
            return Fault(key, slip.problem, remedy, value)
    return None


def _remedy(slip: Slip, found: re.Match[str], key: str) -> str:
    """Return what to write; empty where that would be no value of TOML either."""
    if slip.meant is None:
        return slip.remedy
    meant = slip.meant(found)
    try:
        tomllib.loads(f"value = {re.split(', or | if ', meant)[0]}")
    except tomllib.TOMLDecodeError:
        return ""
    return f"write {key} = {meant}"


def _ratio(over: str, under: str) -> str:
    """Return a fraction as a number; empty where there is none."""
    return f"{float(over) / float(under):.6g}" if float(under) else ""


def invisible_fault(text: str) -> Fault | None:
    """Return the fault of a character that does not show.

    Args:
        text: outside of quotes and comments.

    >>> invisible_fault("radius_m\u00a0").problem
    'has a character that does not show, U+00A0'
    """
    for each in text:
        if each not in " \t" and unicodedata.category(each) in {"Cc", "Cf", "Zs", "Zl", "Zp"}:
            name = re.sub(r"[^\w.]+", "", text, flags=re.ASCII)
            problem = f"has a character that does not show, U+{ord(each):04X}"
            return Fault(name, problem, "delete it, or type the line anew")
    return None


def without_comment(line: str) -> str:
    """Return a line without the comment at its end.

    Args:
        line: of TOML.

    >>> without_comment("title = 'No. #3'  # a chute")
    "title = 'No. #3'  "
    """
    found = re.match(r"""(?:[^#"']++|"[^"]*+"|'[^']*+')*+(?:["'][^#]*+)?+""", line)
    return found[0] if found else line
