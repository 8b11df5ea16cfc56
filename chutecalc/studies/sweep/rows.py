"""Rows of a sweep to files, block after block: CSV, JSON and Parquet never hold more than a few blocks."""

import csv
import json
import math
from collections.abc import Mapping, Sequence
from typing import IO, Any, Protocol

import numpy as np

from chutecalc import __version__
from chutecalc.output.csv import cells
from chutecalc.output.json import FORMAT
from chutecalc.studies.sweep.block import TEXT, Block
from chutecalc.studies.sweep.sweep import Sweep

GROUP = 131_072
"""Rows of a group in Parquet, at most a block more."""


class Rows(Protocol):
    """What takes the rows of a sweep."""

    def write(self, block: Block) -> None:
        """Takes a block."""

    def close(self) -> None:
        """Nothing follows."""


class CsvRows:
    """Rows as CSV."""

    def __init__(self, stream: IO[str], header: Sequence[str]) -> None:
        self.writer = csv.writer(stream)
        self.writer.writerow(header)

    def write(self, block: Block) -> None:
        """Takes a block."""
        self.writer.writerows(zip(*map(cells, block.values()), strict=True))

    def close(self) -> None:
        """Nothing follows."""


class JsonRows:
    """Rows as JSON, an object each on a line of its own, after what was asked."""

    def __init__(self, stream: IO[str], sweep: Sweep) -> None:
        self.stream, self.comma = stream, ""
        said = {
            "chutecalc": __version__,
            "format": FORMAT,
            "source": sweep.chute.source,
            "spec": sweep.chute.data,
            "tolerance": sweep.rtol,
            "parameters": [
                {"name": parameter.name, "paths": parameter.paths, "values": len(parameter.values)}
                for parameter in sweep.parameters
            ],
            "zip": sweep.parallel,
            "keep": sweep.keep,
        }
        head = json.dumps(said, indent=2, allow_nan=False, ensure_ascii=False).removesuffix("\n}")
        stream.write(f'{head},\n  "rows": [')

    def write(self, block: Block) -> None:
        """Takes a block."""
        for row in zip(*map(_plain, block.values()), strict=True):
            text = json.dumps(dict(zip(block, row, strict=True)), allow_nan=False, ensure_ascii=False)
            self.stream.write(f"{self.comma}\n    {text}")
            self.comma = ","

    def close(self) -> None:
        """Nothing follows."""
        self.stream.write("\n  ]\n}\n")


class KeptRows:
    """Rows as they are, for a picture."""

    def __init__(self) -> None:
        self._blocks: list[Block] = []

    def write(self, block: Block) -> None:
        """Takes a block."""
        self._blocks.append(block)

    def close(self) -> None:
        """Nothing follows."""

    @property
    def block(self) -> Block:
        """All of them."""
        return joined(self._blocks)


class ParquetRows:
    """Rows as Parquet, in groups."""

    def __init__(self, stream: IO[bytes], header: Sequence[str]) -> None:
        import pyarrow
        from pyarrow import parquet

        self.arrow = pyarrow
        kinds = {True: pyarrow.dictionary(pyarrow.int32(), pyarrow.string()), False: pyarrow.float64()}
        self.schema = pyarrow.schema([(name, kinds[name in TEXT]) for name in header])
        # Doubles differ in their last digits: a dictionary of them is work for nothing.
        texts = [name for name in header if name in TEXT]
        self.writer = parquet.ParquetWriter(stream, self.schema, use_dictionary=texts or False)
        self.waiting: list[Any] = []

    def write(self, block: Block) -> None:
        """Takes a block."""
        columns = [self._column(name, values) for name, values in block.items()]
        self.waiting.append(self.arrow.Table.from_arrays(columns, schema=self.schema))
        if sum(map(len, self.waiting)) >= GROUP:
            self._flush()

    def close(self) -> None:
        """Nothing follows."""
        self._flush()
        self.writer.close()

    def _column(self, name: str, values: Any) -> Any:
        """An array as Arrow has it, null where there is no number."""
        if name not in TEXT:
            return self.arrow.array(values, from_pandas=True)
        words: dict[str, int] = {}
        codes = [words.setdefault(word, len(words)) for word in values.tolist()]  # sorting takes five times as long
        return self.arrow.DictionaryArray.from_arrays(np.array(codes, dtype=np.int32), np.array([*words], dtype=object))

    def _flush(self) -> None:
        if self.waiting:
            table = self.arrow.concat_tables(self.waiting).unify_dictionaries()
            self.writer.write_table(table, row_group_size=len(table) or None)
            self.waiting = []


def _plain(values: Any) -> list[Any]:
    """A column as JSON has it."""
    if values.dtype.kind != "f":
        return list(values.tolist())
    return [value if math.isfinite(value) else None for value in values.tolist()]


def joined(blocks: Sequence[Mapping[str, Any]]) -> Block:
    """Blocks as one."""
    return {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]} if blocks else {}
