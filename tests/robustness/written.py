"""What commands print and write, held against what users are promised of it."""

import csv
import io
import json
import zipfile
from typing import Any
from xml.etree import ElementTree

from chutecalc.output.formats.csv import FORMULA
from chutecalc.printable import printable
from tests.robustness.hostile import FORGED


def check_lines(text: str) -> None:
    """Hold text against what a terminal may be sent."""
    for each in text.split("\n"):
        assert printable(each) == each, each
        assert not each.startswith(FORGED), each


def _read_csv(content: bytes) -> None:
    rows = list(csv.reader(io.StringIO(content.decode("utf-8"), newline="")))
    assert len({len(row) for row in rows}) == 1
    for cell in (cell for row in rows for cell in row):
        assert printable(cell) == cell, cell
        if FORMULA.match(cell):
            assert cell.startswith("'") or _is_number(cell), cell


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _read_parquet(content: bytes) -> None:
    from pyarrow import parquet

    parquet.read_table(io.BytesIO(content))


def _read_xlsx(content: bytes) -> None:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        for name in archive.namelist():
            ElementTree.fromstring(archive.read(name))


def _read_dxf(content: bytes) -> None:
    import ezdxf

    assert not ezdxf.read(io.StringIO(content.decode("utf-8"))).audit().has_errors


def _read_html(content: bytes) -> None:
    text = content.decode("utf-8")
    assert printable(text, keep="\n") == text


READERS: dict[str, Any] = {
    "csv": _read_csv,
    "json": json.loads,
    "xml": ElementTree.fromstring,
    "svg": ElementTree.fromstring,
    "html": _read_html,
    "parquet": _read_parquet,
    "xlsx": _read_xlsx,
    "dxf": _read_dxf,
}
"""Checks of files by their ending."""
