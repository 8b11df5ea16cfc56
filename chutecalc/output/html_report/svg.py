"""Pictures as SVG that stands in a page."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING

from chutecalc.printable import printable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NOTHING_MORE = dict.fromkeys(("Creator", "Date", "Format", "Type"))
"""Metadata that Matplotlib would add: what it is and where it comes from, which a page says itself."""


def inline_svg(figure: Figure, name: str, description: str) -> str:
    """Return a picture as an ``svg`` element, as wide as the page lets it be.

    Args:
        figure: the picture.
        name: of the picture in the page; it begins its identifiers, so that several pictures do not mix theirs.
        description: what it shows, for readers who do not see it; plain text.
    """
    from html import escape

    from chutecalc.output.plots.style import write

    stream = io.BytesIO()
    write(figure, stream, "svg", NOTHING_MORE)
    text = stream.getvalue().decode()
    text = text[text.index("<svg") :].strip()
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    used = set(re.findall(r'(?:href="|url\()#([^")]+)', text))
    text = re.sub(r' id="([^"]*)"', lambda found: found[0] if found[1] in used else "", text)
    text = re.sub(r'( id="|href="#|url\(#)', rf"\1{name}-", text)
    text = re.sub(r'(<svg[^>]*?) width="[^"]*" height="[^"]*"', r"\1", text, count=1)
    first, rest = text.split(">", 1)
    return f'{first} role="img">\n<title>{escape(printable(description))}</title>{rest}'
