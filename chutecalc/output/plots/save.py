"""Pictures as files: which formats there are, and what they take."""

import io
from pathlib import Path
from typing import IO, TYPE_CHECKING

from chutecalc.errors import UsageError
from chutecalc.extras import PLOT, require_extra

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURE_FORMATS = {"svg": {"Date": None}, "png": {}, "pdf": {"CreationDate": None}}
"""Metadata by file ending; None leaves out an entry that would differ from one day to the next."""


def picture_format(file: str) -> str:
    """Return the format that the ending of a file names, and check that Matplotlib is installed.

    Args:
        file: path of the picture.

    Raises:
        UsageError: the ending names no format.
        ExtraMissingError: Matplotlib is not installed.
    """
    ending = Path(file).suffix.lower().removeprefix(".")
    if ending not in PICTURE_FORMATS:
        raise UsageError(f"--plot cannot draw {file}: the name must end in .svg, .png or .pdf")
    require_extra("--plot", PLOT)
    return ending


def save(figure: "Figure", stream: IO[bytes], ending: str) -> None:
    """Write a figure, the same bytes each time.

    Args:
        figure: the picture.
        stream: where it goes.
        ending: its format, from :func:`picture_format`.
    """
    from chutecalc.output.plots.style import write

    drawn = io.BytesIO()  # on a full disk, Matplotlib's own errors would hide the one of the file
    write(figure, drawn, ending, PICTURE_FORMATS[ending])
    stream.write(drawn.getvalue())
