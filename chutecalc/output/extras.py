"""What outputs need beyond what is always installed."""

from importlib.util import find_spec

from chutecalc.errors import ExtraMissingError

LIBRARIES = {"chart": "Plotille", "parquet": "PyArrow", "plot": "Matplotlib"}
"""By extra; the option that needs one is called as it is, and its module too, in small letters."""


def require_extra(extra: str, needed_by: str = "") -> None:
    """That the library of an extra is installed; it is not imported, which takes time.

    Args:
        extra: its name.
        needed_by: what the message names as needing it; the option of the extra's name by default.

    Raises:
        ExtraMissingError: it is not.
    """
    library = LIBRARIES[extra]
    if find_spec(library.lower()) is None:
        raise ExtraMissingError(f"{needed_by or f'--{extra}'} needs {library}: pip install 'chutecalc[{extra}]'")
