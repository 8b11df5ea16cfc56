"""Output formats: one file each in this package. A new file is a new option of all commands that write data.

A file defines ``FORMAT``, an :class:`OutputFormat`. It imports the library that it needs when it writes, not before:
all files of this package are loaded whenever a command starts.
"""

from collections.abc import Callable
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import IO, Any, NamedTuple, Protocol

from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.extras import Extra


class RowWriter(Protocol):
    """Takes the rows of a dataset, block after block."""

    def write(self, block: Block) -> None:
        """Take the next block.

        Args:
            block: the block, with all columns of the dataset.
        """

    def close(self) -> None:
        """Finish after the last block. The stream stays open."""


class OutputFormat(NamedTuple):
    """A format of data files."""

    name: str
    """Name of its option, ``csv`` for ``--csv``."""
    help: str
    """What the option does, for ``--help``."""
    rows: Callable[[IO[Any], Dataset], RowWriter]
    """Begins a file of rows. The writer holds at most a few blocks in memory."""
    document: Callable[[IO[Any], Any], None] | None = None
    """Writes nested data instead of rows, for datasets that have a document."""
    extra: Extra | None = None
    """The optional dependency that it needs."""
    binary: bool = False
    """Whether it writes bytes rather than text."""
    standard_output: bool = True
    """Whether ``-``, standard output, is allowed."""


@cache
def output_formats() -> dict[str, OutputFormat]:
    """Return all formats by name.

    >>> [name for name in output_formats() if name in ("csv", "json", "parquet")]
    ['csv', 'json', 'parquet']
    """
    modules = (import_module(f"{__name__}.{module.name}") for module in iter_modules(__path__))
    formats: list[OutputFormat] = [module.FORMAT for module in modules]
    return {each.name: each for each in formats}
