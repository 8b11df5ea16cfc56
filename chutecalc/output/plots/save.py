"""Pictures as files: which formats there are, and what they take."""

from pathlib import Path
from typing import IO, TYPE_CHECKING

from chutecalc.errors import UsageError
from chutecalc.output.extras import require_extra

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = {"svg": {"Date": None}, "png": {}, "pdf": {"CreationDate": None}}
"""Endings of files, each with the metadata that would differ from one day to the next."""


def picture_format(file: str) -> str:
    """The format that a file's ending names, once it is known that it can be drawn.

    Raises:
        UsageError: the ending names none.
        ExtraMissingError: Matplotlib is not installed.
    """
    ending = Path(file).suffix.lower().removeprefix(".")
    if ending not in FORMATS:
        raise UsageError(f"--plot draws .svg, .png or .pdf, told by the file's ending: {file} has none of them")
    require_extra("plot")
    return ending


def save(figure: "Figure", stream: IO[bytes], ending: str) -> None:
    """Writes a figure, the same bytes each time.

    Args:
        figure: to write.
        stream: to write to.
        ending: the format, as :func:`picture_format` tells it.
    """
    from chutecalc.output.plots.style import styled

    with styled():
        figure.savefig(stream, format=ending, metadata=FORMATS[ending])
