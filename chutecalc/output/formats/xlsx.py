"""Excel workbooks: a sheet of rows and one for each further table, numbers as numbers, empty where there is none."""

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from datetime import datetime
from typing import IO, Any

from chutecalc.errors import UsageError, WriteError
from chutecalc.extras import XLSX
from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.formats import OutputFormat
from chutecalc.output.held import named
from chutecalc.output.scratch import remove_scratch, scratch_folder
from chutecalc.printable import printable

ROWS_OF_A_SHEET = 1_048_576
"""Rows that Excel allows, the heading among them."""
CREATED = datetime(2000, 1, 1)
"""Date of creation in every file, so that the same rows give the same bytes."""
OPTIONS = {"constant_memory": True, "strings_to_formulas": False, "strings_to_urls": False}
"""Rows go to disk as they come; text stays text, whatever it begins with."""


class Sheet:
    """A sheet of rows under a heading that stays in view.

    Args:
        workbook: a workbook of XlsxWriter.
        name: of the sheet.
        columns: headings.
    """

    def __init__(self, workbook: Any, name: str, columns: Iterable[str]) -> None:
        self._names, self._row = list(columns), 0
        self._sheet = workbook.add_worksheet(name)
        for number, heading in enumerate(self._names):
            self._sheet.set_column(number, number, max(len(heading) + 1, 10))
        self._sheet.freeze_panes(1, 0)
        self._sheet.write_row(0, 0, self._names, workbook.add_format({"bold": True}))

    def write(self, block: Block) -> None:
        """Write the next block.

        Args:
            block: the block, with all columns of the sheet.

        Raises:
            UsageError: there are more rows than a sheet holds.
        """
        for values in zip(*(block[name].tolist() for name in self._names), strict=True):
            self._row += 1
            if self._row >= ROWS_OF_A_SHEET:
                raise UsageError(f"a sheet of Excel holds {ROWS_OF_A_SHEET:,} rows: use --csv or --parquet")
            for number, value in enumerate(values):
                if isinstance(value, bool):
                    self._sheet.write_boolean(self._row, number, value)
                elif value in ("", None) or value != value:
                    continue  # an empty cell
                elif isinstance(value, str) or not math.isfinite(value):
                    self._sheet.write_string(self._row, number, printable(str(value), keep="\n"))
                else:
                    self._sheet.write_number(self._row, number, value)


class XlsxRows:
    """Writes rows as the last sheet of a workbook, behind a sheet for each further table.

    Args:
        stream: where to write.
        dataset: the dataset, for its columns and its further tables.
    """

    def __init__(self, stream: IO[bytes], dataset: Dataset) -> None:
        from xlsxwriter import Workbook

        with _temporary_files_told():
            self._workbook = Workbook(stream, OPTIONS | {"tmpdir": scratch_folder()})
            self._workbook.set_properties({"created": CREATED})
            for table in dataset.tables():
                Sheet(self._workbook, table.name, table.columns).write(table.block)
            self._sheet = Sheet(self._workbook, dataset.name, dataset.columns)

    def write(self, block: Block) -> None:
        """Write the next block.

        Args:
            block: the block, with all columns of the dataset.

        Raises:
            UsageError: there are more rows than a sheet holds.
            WriteError: there is no room for temporary files.
        """
        try:
            with _temporary_files_told():
                self._sheet.write(block)
        except UsageError:
            with suppress(UsageError, WriteError):  # temporary files that are open do not go
                self.close()
            raise

    def close(self) -> None:
        """Write the workbook.

        Raises:
            UsageError: it is larger than a workbook may be.
            WriteError: there is no room for it, or for temporary files.
        """
        from xlsxwriter.exceptions import FileSizeError

        try:
            with _temporary_files_told():
                self._workbook.close()
        except FileSizeError:
            raise UsageError("the rows are larger than a workbook may be: use --csv or --parquet") from None
        remove_scratch()


@contextmanager
def _temporary_files_told() -> Iterator[None]:
    """Say that temporary files cannot be written: the workbook itself, which names its errors, may have room."""
    from xlsxwriter.exceptions import FileCreateError

    with named("a temporary file of the workbook", WriteError):
        try:
            yield
        except FileCreateError as error:  # holds the error of the system
            raise error.args[0] from None


FORMAT = OutputFormat(
    "xlsx",
    "Write the rows as an Excel workbook (needs XlsxWriter).",
    XlsxRows,
    extra=XLSX,
    binary=True,
    standard_output=False,
)
