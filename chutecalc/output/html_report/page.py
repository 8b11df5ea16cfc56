"""The page itself: the parts of a report put into its template."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from chutecalc import __version__
from chutecalc.output.html_report.reported import Reported
from chutecalc.output.html_report.worked import with_subscripts
from chutecalc.printable import printable

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
    """Return the templates of this package. What they are given is made printable and escaped, unless it is HTML."""
    from jinja2 import Environment, PackageLoader, StrictUndefined
    from markupsafe import Markup, escape

    def formula(text: str) -> Markup:
        parts = with_subscripts(shown(text))
        return Markup("".join(f"<sub>{escape(part)}</sub>" if low else str(escape(part)) for part, low in parts))

    def css_text(text: str) -> Markup:
        plain = Markup(text).unescape()  # a block's text is escaped for HTML, which a style sheet is not
        return Markup(re.sub(r"[^A-Za-z0-9]", lambda one: f"\\{ord(one[0]):06x}", plain))

    def shown(value: Any) -> Any:
        return printable(value, keep="\n") if isinstance(value, str) and not isinstance(value, Markup) else value

    found = Environment(
        loader=PackageLoader(__package__ or "", "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=shown,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters |= {"formula": formula, "css_text": css_text}
    return found
