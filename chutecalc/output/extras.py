"""Optional dependencies: what outputs need beyond what is always installed."""

from importlib.util import find_spec
from typing import NamedTuple

from chutecalc.errors import ExtraMissingError


class Extra(NamedTuple):
    """An optional dependency of the package."""

    name: str
    """Extra as pip takes it, ``parquet`` in ``chutecalc[parquet]``."""
    library: str
    """The library that it installs. Its module has this name in lower case."""


CHART = Extra("chart", "Plotille")
PLOT = Extra("plot", "Matplotlib")
REPORT = Extra("report", "Jinja2")
PDF = Extra("pdf", "WeasyPrint")
DXF = Extra("dxf", "ezdxf")


def require_extra(needed_by: str, extra: Extra) -> None:
    """Check that an optional dependency is installed. Its library is not imported, which would take time.

    Args:
        needed_by: what needs it, such as ``--plot``.
        extra: the dependency.

    Raises:
        ExtraMissingError: it is not installed.
    """
    if find_spec(extra.library.lower()) is None:
        raise ExtraMissingError(f"{needed_by} needs {extra.library}. Install it: pip install 'chutecalc[{extra.name}]'")
