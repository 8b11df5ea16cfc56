"""docs/nomenclature.md has every symbol, column and key, as the code has them."""

import re

from chutecalc.columns import COLUMNS, RECEIVER_COLUMNS
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
    for key in ("rate_t_h", "friction_deg", "yield_locus_kpa", "chamfer_deg", "radius_m", "to_slope_deg", "drop_m"):
        assert f"`{key}`" in TEXT
