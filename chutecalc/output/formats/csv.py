"""CSV by RFC 4180: full double precision, and an empty cell where a quantity does not exist."""

from typing import IO, Any

from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.formats import OutputFormat


class CsvRows:
    """Writes rows as lines.

    Args:
        stream: where to write.
        dataset: the dataset, for the names of its columns.
    """

    def __init__(self, stream: IO[str], dataset: Dataset) -> None:
        import csv

        self._names = list(dataset.columns)
        self._writer = csv.writer(stream)
        self._writer.writerow(self._names)

    def write(self, block: Block) -> None:
        """Write the next block.

        Args:
            block: the block, with all columns of the dataset.
        """
        self._writer.writerows(zip(*(cells(block[name]) for name in self._names), strict=True))

    def close(self) -> None:
        """Do nothing: every row is written."""


def cells(values: Any) -> list[Any]:
    """Return a column as CSV holds it. Python's text of a float is the shortest that reads back as the same number.

    Args:
        values: array of numbers or text, of one dimension.

    >>> import numpy
    >>> cells(numpy.array([0.1, float("nan")]))
    [0.1, '']
    """
    if values.dtype.kind != "f":
        return list(values.tolist())
    return ["" if value != value else value for value in values.tolist()]


FORMAT = OutputFormat("csv", "Write the rows as CSV; - for standard output.", CsvRows)
