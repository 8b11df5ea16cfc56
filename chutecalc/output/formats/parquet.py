"""Apache Parquet: typed columns, and null where a quantity does not exist."""

from typing import IO, Any

from chutecalc.extras import PARQUET
from chutecalc.fields.units import TEXT, unit_of
from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.formats import OutputFormat
from chutecalc.printable import encodable

ROWS_OF_A_GROUP = 131_072
"""A row group is written once it has as many rows; it has at most one block more."""


KEY = "chutecalc"
"""Key of the metadata of a file: JSON of the version, the command and what was asked, the specs among it."""


def unit_metadata(name: str) -> dict[str, str] | None:
    """Return the metadata of a column: its unit as people write it; None where it has none.

    Args:
        name: of the column.

    >>> unit_metadata("exit_velocity_m_s"), unit_metadata("fill")
    ({'unit': 'm/s'}, None)
    """
    unit = unit_of(name)
    return {"unit": TEXT.get(unit, unit)} if unit else None


class ParquetRows:
    """Writes rows in groups.

    Args:
        stream: where to write.
        dataset: the dataset, for its columns and what was asked.
    """

    def __init__(self, stream: IO[bytes], dataset: Dataset) -> None:
        import json

        import pyarrow
        from pyarrow import parquet

        self._arrow = pyarrow
        text = pyarrow.dictionary(pyarrow.int32(), pyarrow.string())
        types = {str: text, float: pyarrow.float64(), int: pyarrow.int64()}
        fields = [
            pyarrow.field(name, types[kind], metadata=unit_metadata(name) if kind is not str else None)
            for name, kind in dataset.columns.items()
        ]
        told = encodable(json.dumps(dataset.head | dict(dataset.asked), allow_nan=False, ensure_ascii=False))
        self._schema = pyarrow.schema(fields, metadata={KEY: told})
        # Floating-point results rarely repeat: a dictionary of them would be work for nothing.
        texts = [name for name, kind in dataset.columns.items() if kind is str]
        self._writer = parquet.ParquetWriter(stream, self._schema, use_dictionary=texts or False)
        self._waiting: list[Any] = []

    def write(self, block: Block) -> None:
        """Take the next block, and write a group if there are enough rows.

        Args:
            block: the block, with all columns of the dataset.
        """
        columns = [self._column(block[name], self._schema.field(name).type) for name in self._schema.names]
        self._waiting.append(self._arrow.Table.from_arrays(columns, schema=self._schema))
        if sum(map(len, self._waiting)) >= ROWS_OF_A_GROUP:
            self._flush()

    def close(self) -> None:
        """Write the last group and the footer."""
        self._flush()
        self._writer.close()

    def _column(self, values: Any, kind: Any) -> Any:
        """Return an array as Arrow holds it."""
        if not self._arrow.types.is_dictionary(kind):
            return self._arrow.array(values, kind, from_pandas=True)
        words: dict[str, int] = {}
        codes = [words.setdefault(word, len(words)) for word in values.tolist()]  # five times as fast as sorting them
        indices = self._arrow.array(codes, self._arrow.int32())
        known = self._arrow.array([*map(encodable, words)], self._arrow.string())
        return self._arrow.DictionaryArray.from_arrays(indices, known)

    def _flush(self) -> None:
        if self._waiting:
            table = self._arrow.concat_tables(self._waiting).unify_dictionaries()
            self._writer.write_table(table, row_group_size=len(table) or None)
            self._waiting = []


FORMAT = OutputFormat(
    "parquet",
    "Write the rows as Parquet (needs PyArrow).",
    ParquetRows,
    extra=PARQUET,
    binary=True,
    standard_output=False,
)
