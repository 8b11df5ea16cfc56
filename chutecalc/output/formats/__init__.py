"""Output formats: one file each in this package. A new file is a new option of all commands that write data.

A file defines ``FORMAT``, an :class:`OutputFormat`. It imports the library that it needs when it writes, not before:
all files of this package are loaded whenever a command starts.
"""

from collections.abc import Callable
from functools import cache
from typing import IO, Any, NamedTuple, Protocol

from chutecalc.extras import Extra
from chutecalc.output.dataset import Block, Dataset
from chutecalc.registry import by_name, load_modules


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
    document: Callable[[IO[Any], Dataset], None] | None = None
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

    Raises:
        ImportError: A module of this package cannot be imported.
        ValueError: Two formats have the same name.

    >>> [name for name in output_formats() if name in ("csv", "json", "parquet")]
    ['csv', 'json', 'parquet']
    """
    modules = load_modules(__name__, __path__)
    return by_name((module.FORMAT.name, module.FORMAT, module.__name__) for module in modules)
