"""CSV by RFC 4180: full double precision, and an empty cell where a quantity does not exist.

Spreadsheets take text that begins in some ways for a formula, and run it. Such text has an apostrophe before it, and so
has text that would look as if it had: whoever reads the file takes one away from what :data:`FORMULA` matches.
"""

import re
from typing import IO, Any

from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.formats import OutputFormat
from chutecalc.printable import printable

FORMULA = re.compile(r"'*+(?:[=@]|[+-](?![\d.,]++ ?%?$))")
"""Beginning of a text that a spreadsheet may take for a formula; a number with a sign is none."""


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
        self._writer.writerow(map(guarded, self._names))

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
    if values.dtype.kind in "UO":
        words = values.tolist()
        written = {word: guarded(word) for word in set(words)}  # few are told apart
        return [written[word] for word in words]
    if values.dtype.kind != "f":
        return list(values.tolist())
    return ["" if value != value else value for value in values.tolist()]


def guarded(text: Any) -> Any:
    r"""Return text as a cell holds it: what does not print as its escape sequence, and no formula.

    Args:
        text: any text; what is no text stays as it is.

    >>> guarded("=cmd()"), guarded("'=cmd()"), guarded("-10 %"), guarded("a\n")
    ("'=cmd()", "''=cmd()", '-10 %', 'a\\n')
    """
    if not isinstance(text, str):
        return text
    text = printable(text)
    return f"'{text}" if FORMULA.match(text) else text


FORMAT = OutputFormat("csv", "Write the rows as CSV; - for standard output.", CsvRows)
