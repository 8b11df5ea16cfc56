"""Writes a report as a page of HTML, or as a PDF of that page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from chutecalc.errors import UsageError
from chutecalc.extras import PDF, PLOT, REPORT, require_extra
from chutecalc.output.files import open_whole

if TYPE_CHECKING:
    from chutecalc.output.html_report.reported import Reported

FORMATS = {"html": (REPORT, PLOT), "pdf": (REPORT, PLOT, PDF)}
"""What each format needs, by the ending of its files."""


def check_report(file: str) -> str:
    """Return the format that the ending of a file names, and check that what it needs is installed.

    Args:
        file: path of the report.

    Raises:
        UsageError: the ending names no format.
        ExtraMissingError: a library is not installed.
    """
    ending = Path(file).suffix.lower().removeprefix(".")
    if ending not in FORMATS:
        raise UsageError(f"--report cannot write {file}: the name must end in .html or .pdf")
    for extra in FORMATS[ending]:
        require_extra("--report", extra)
    return ending


def write_report(file: str, chutes: Sequence[Reported], units: str) -> None:
    """Write a report of one chute, or one that compares several.

    Args:
        file: its path, from which follows the format.
        chutes: at least one.
        units: ``metric`` or ``us``.

    Raises:
        UsageError: the ending of the file names no format.
        ExtraMissingError: a library is not installed.
        OutputError: the file cannot be opened.
        WriteError: it could not be written.
    """
    from chutecalc.output.html_report.page import report_html

    ending = check_report(file)
    html = report_html(chutes, units)
    with open_whole(file, "wb") as stream:
        if ending == "html":
            stream.write(html.encode())
        else:
            from weasyprint import HTML

            stream.write(HTML(string=html).write_pdf(pdf_variant="pdf/ua-1"))
