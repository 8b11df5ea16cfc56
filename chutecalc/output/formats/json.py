"""JSON: full double precision, and null where a quantity does not exist or is infinite.

What does not print stands as an escape sequence of JSON, so that text comes back as it was.
"""

import re
from typing import IO

from chutecalc.output.dataset import Block, Dataset, numbers
from chutecalc.output.formats import OutputFormat
from chutecalc.printable import printable


class JsonRows:
    """Writes rows as objects, each on a line of its own, after what was asked for.

    Args:
        stream: where to write.
        dataset: the dataset, for what was asked and the names of its columns.
    """

    def __init__(self, stream: IO[str], dataset: Dataset) -> None:
        import json

        self._stream, self._names, self._comma = stream, list(dataset.columns), ""
        self._encode = json.JSONEncoder(allow_nan=False, ensure_ascii=False).encode
        head = dataset.head | dict(dataset.asked)
        text = json.dumps(head, indent=2, allow_nan=False, ensure_ascii=False).removesuffix("\n}")
        stream.write(f'{_escaped(text)},\n  "rows": [')

    def write(self, block: Block) -> None:
        """Write the next block.

        Args:
            block: the block, with all columns of the dataset.
        """
        for row in zip(*(numbers(block[name]) for name in self._names), strict=True):
            text = self._encode(dict(zip(self._names, row, strict=True)))
            self._stream.write(f"{self._comma}\n    {_escaped(text)}")
            self._comma = ","

    def close(self) -> None:
        """Close the list and the object."""
        self._stream.write("\n  ]\n}\n")


def write_document(stream: IO[str], dataset: Dataset) -> None:
    """Write the document of a dataset, indented.

    Args:
        stream: where to write.
        dataset: the dataset, which has one.
    """
    import json

    assert dataset.document is not None
    encoder = json.JSONEncoder(indent=2, allow_nan=False, ensure_ascii=False)
    for piece in encoder.iterencode(dataset.head | dict(dataset.document())):
        stream.write(_escaped(piece))
    stream.write("\n")


def _escaped(text: str) -> str:
    """Return a piece of JSON in which no text holds a character that does not print, but as its escape sequence."""
    if text.isprintable():
        return text
    import json

    return re.sub(r"[^\n -~]", lambda one: one[0] if printable(one[0]) == one[0] else json.dumps(one[0])[1:-1], text)


FORMAT = OutputFormat("json", "Write all results as JSON; - for standard output.", JsonRows, write_document)
