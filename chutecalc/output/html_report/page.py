"""The page itself: the parts of a report put into its template."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from chutecalc import __version__
from chutecalc.output.html_report.reported import Reported
from chutecalc.output.html_report.worked import with_subscripts

if TYPE_CHECKING:
    from jinja2 import Environment

OF_ONE, OF_SEVERAL = "report.html.j2", "comparison.html.j2"
"""Templates."""


def report_html(chutes: Sequence[Reported], units: str) -> str:
    """Return a report of one chute, or one that compares several, as a page of HTML that needs nothing else.

    Args:
        chutes: at least one.
        units: ``metric`` or ``us``.
    """
    if len(chutes) == 1:
        from chutecalc.output.html_report.contents import contents

        return _rendered(OF_ONE, contents(chutes[0], units))
    from chutecalc.output.html_report.compared import compared

    return _rendered(OF_SEVERAL, compared(chutes, units))


def _rendered(template: str, values: dict[str, Any]) -> str:
    """Return a template with its values; text of users is escaped."""
    return environment().get_template(template).render(values, version=__version__)


@cache
def environment() -> Environment:
    """Return the templates of this package. What they are given is escaped unless it is marked as HTML."""
    from jinja2 import Environment, PackageLoader, StrictUndefined
    from markupsafe import Markup, escape

    def formula(text: str) -> Markup:
        pieces = (f"<sub>{escape(piece)}</sub>" if low else str(escape(piece)) for piece, low in with_subscripts(text))
        return Markup("".join(pieces))

    def css_text(text: str) -> Markup:
        plain = Markup(text).unescape()  # a block's text is escaped for HTML, which a style sheet is not
        return Markup(re.sub(r"[^A-Za-z0-9]", lambda one: f"\\{ord(one[0]):06x}", plain))

    found = Environment(
        loader=PackageLoader(__package__ or "", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters |= {"formula": formula, "css_text": css_text}
    return found
