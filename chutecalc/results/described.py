"""Text of chutes and solutions for interpreters and notebooks."""

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Index

_LABELS = np.array(Status.LABELS)


def status_text(status_numbers: Index) -> Any:
    """Return statuses as users read them.

    Args:
        status_numbers: as :class:`chutecalc.design.Status` has them, of any shape.

    Returns:
        Text of the same shape.

    >>> status_text(np.array([0, 1])).tolist()
    ['ok', 'stall']
    """
    return _LABELS[status_numbers]


def status_words(status: object) -> str:
    """Return the name of a status, or of what ended, as people read it.

    Args:
        status: its name.

    >>> status_words("contact_lost")
    'contact lost'
    """
    return str(status).replace("_", " ")


def outcomes(statuses: Iterable[Any]) -> str:
    """Count how designs end, those that get through first.

    Args:
        statuses: of the designs.

    >>> outcomes(["ok", "stall", "ok"])
    '2 ok, 1 stall'
    """
    counts = Counter(map(str, statuses))
    return ", ".join(
        f"{counts[word]} {word}" for word in sorted(counts, key=lambda word: (word != Status.OK_LABEL, word))
    )


def number(values: Any, unit: str = "", digits: int = 4) -> str:
    """Format a number of one design, or the range of several.

    Args:
        values: numbers of the designs; NaN is left out.
        unit: appended to the text, as people write it.
        digits: significant digits.

    Returns:
        The text; a dash where there is no number.

    >>> number([3.87789], "m/s"), number([1.0, 2.5]), number([float("nan")])
    ('3.878 m/s', '1 to 2.5', '–')
    """
    known = [float(value) for value in values if value == value]
    if not known:
        return "–"
    ends = dict.fromkeys(f"{value:z.{digits}g}" for value in (min(known), max(known)))
    return f"{' to '.join(ends)} {unit}".rstrip()


def html_table(caption: str, headings: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return an HTML table, with all text escaped.

    Args:
        caption: above the table.
        headings: of the columns.
        rows: cells of the rows.

    >>> html_table("a < b", ["x"], [["1"]])
    '<table><caption>a &lt; b</caption><tr><th>x</th></tr><tr><td>1</td></tr></table>'
    """
    from html import escape  # with its entities, which a run does not need

    head = "".join(f"<th>{escape(text)}</th>" for text in headings)
    body = "".join("<tr>" + "".join(f"<td>{escape(text)}</td>" for text in row) + "</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><tr>{head}</tr>{body}</table>"
