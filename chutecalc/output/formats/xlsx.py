"""Excel workbooks: a sheet of rows, numbers as numbers, empty cells where a quantity does not exist."""

import math
from datetime import datetime
from typing import IO

from chutecalc.errors import UsageError
from chutecalc.output.dataset import Block, Dataset
from chutecalc.output.extras import Extra
from chutecalc.output.formats import OutputFormat

ROWS_OF_A_SHEET = 1_048_576
"""Rows that Excel allows, the heading among them."""
CREATED = datetime(2000, 1, 1)
"""Date of creation in every file, so that the same rows give the same bytes."""
OPTIONS = {"constant_memory": True, "strings_to_formulas": False, "strings_to_urls": False}
"""Rows go to disk as they come; text stays text, whatever it begins with."""


class XlsxRows:
    """Writes rows under a heading that stays in view.

    Args:
        stream: where to write.
        dataset: the dataset, for its columns.
    """

    def __init__(self, stream: IO[bytes], dataset: Dataset) -> None:
        from xlsxwriter import Workbook

        self._names, self._row = list(dataset.columns), 0
        self._workbook = Workbook(stream, OPTIONS)
        self._workbook.set_properties({"created": CREATED})
        self._sheet = self._workbook.add_worksheet("rows")
        for number, name in enumerate(self._names):
            self._sheet.set_column(number, number, max(len(name) + 1, 10))
        self._sheet.freeze_panes(1, 0)
        self._sheet.write_row(0, 0, self._names, self._workbook.add_format({"bold": True}))

    def write(self, block: Block) -> None:
        """Write the next block.

        Args:
            block: the block, with all columns of the dataset.

        Raises:
            UsageError: there are more rows than a sheet holds.
        """
        for values in zip(*(block[name].tolist() for name in self._names), strict=True):
            self._row += 1
            if self._row >= ROWS_OF_A_SHEET:
                self.close()  # its temporary files go
                raise UsageError(f"a sheet of Excel holds {ROWS_OF_A_SHEET:,} rows: use --csv or --parquet")
            for number, value in enumerate(values):
                if isinstance(value, str) or not math.isfinite(value):
                    self._sheet.write_string(self._row, number, "" if value != value else str(value))
                else:
                    self._sheet.write_number(self._row, number, value)

    def close(self) -> None:
        """Write the workbook."""
        self._workbook.close()


FORMAT = OutputFormat(
    "xlsx",
    "Write the rows as an Excel workbook (extra xlsx).",
    XlsxRows,
    extra=Extra("xlsx", "XlsxWriter"),
    binary=True,
    standard_output=False,
)
