"""How chutes and solutions show themselves in an interpreter and in a notebook."""

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any


def outcomes(statuses: Iterable[Any]) -> str:
    """How many designs end how, the good ones first.

    >>> outcomes(["ok", "stall", "ok"])
    '2 ok, 1 stall'
    """
    counts = Counter(map(str, statuses))
    return ", ".join(f"{counts[word]} {word}" for word in sorted(counts, key=lambda word: (word != "ok", word)))


def number(values: Any, unit: str = "", digits: int = 4) -> str:
    """A number of one design, or the range of several; a dash where there is none.

    >>> number([3.87789], "m/s"), number([1.0, 2.5]), number([float("nan")])
    ('3.878 m/s', '1 to 2.5', '–')
    """
    known = [float(value) for value in values if value == value]
    if not known:
        return "–"
    ends = dict.fromkeys(f"{value:.{digits}g}" for value in (min(known), max(known)))
    return f"{' to '.join(ends)} {unit}".rstrip()


def html_table(caption: str, headings: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table, all text escaped.

    >>> html_table("a < b", ["x"], [["1"]])
    '<table><caption>a &lt; b</caption><tr><th>x</th></tr><tr><td>1</td></tr></table>'
    """
    from html import escape  # with its entities, which a run does not need

    head = "".join(f"<th>{escape(text)}</th>" for text in headings)
    body = "".join("<tr>" + "".join(f"<td>{escape(text)}</td>" for text in row) + "</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><tr>{head}</tr>{body}</table>"
