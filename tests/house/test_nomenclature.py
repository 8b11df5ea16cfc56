"""docs/nomenclature.md has every symbol, column and key, as the code has them."""

import re

from chutecalc.fields.table import Table
from chutecalc.results.columns import COLUMNS, RECEIVER_COLUMNS
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec import chute_spec as model
from tests.nomenclature import PAGE, renewed

TEXT = PAGE.read_text(encoding="utf-8")


def test_tables_are_those_of_the_code():
    assert renewed(TEXT) == TEXT, "python -m tests.nomenclature"


def test_every_column_and_every_symbol_stands_there():
    symbols = {symbol for row in re.findall(r"^\| ([^|`-]+) \|", TEXT, re.MULTILINE) for symbol in row.split(", ")}
    for column in (*COLUMNS.values(), *RECEIVER_COLUMNS.values()):
        assert f"| `{column.name}` |" in TEXT
        assert not column.symbol or column.symbol in symbols, column.symbol


def test_every_key_of_a_table_stands_there():
    every = vars(model).values()
    tables = [item for item in (*every, *SHAPES.values(), *KINDS.values()) if isinstance(item, type)]
    tables = [item for item in tables if issubclass(item, Table)]
    keys = {key for table in tables for key in table.model_fields} - {"kind", "shape"}
    assert len(keys) > 30
    assert [key for key in sorted(keys) if f"`{key}`" not in TEXT] == []
