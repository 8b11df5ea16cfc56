"""docs/nomenclature.md has every symbol, column and key, as the code has them."""

import re

from chutecalc.fields.table import Table
from chutecalc.glossary.columns import CATALOGUES, ROW_PREFIXES
from chutecalc.glossary.key_symbols import OF_KEYS
from chutecalc.results.finding_columns import ALL_COLUMNS
from chutecalc.results.findings import CRITERIA
from chutecalc.sections.registry import SHAPES
from chutecalc.segments.registry import KINDS
from chutecalc.spec import chute_spec as model
from chutecalc.studies.sweep.columns import row_columns
from tests.nomenclature import PAGE, renewed

TEXT = PAGE.read_text(encoding="utf-8")


def test_tables_are_those_of_the_code():
    assert renewed(TEXT) == TEXT, "python -m tests.nomenclature"


def test_every_column_and_every_symbol_stands_there():
    symbols = {symbol for row in re.findall(r"^\| ([^|`-]+) \|", TEXT, re.MULTILINE) for symbol in row.split(", ")}
    for column in (*ALL_COLUMNS.values(), *(column for each in CATALOGUES.values() for column in each.values())):
        assert f"| `{column.name}` | {column.words} |" in TEXT
        assert not column.symbol or {*column.symbol.split("/")} <= symbols, column.symbol
        assert re.fullmatch(r"(Paper Eq \d+|Roberts \(2003\))?", column.source), column.source
    assert {*OF_KEYS.values()} - {""} <= symbols


def test_every_column_of_a_sweep_stands_there():
    pattern = "|".join(ROW_PREFIXES)
    for name in row_columns():
        assert f"| `{re.sub(f'^({pattern})', '', name)}` |" in TEXT, name


def test_every_finding_stands_there():
    codes = [criterion.code for criterion in CRITERIA]
    assert len(codes) == len(set(codes))
    assert [code for code in codes if f"| `{code}` |" not in TEXT] == []


def test_a_criterion_needs_columns_that_there_are():
    assert {name for criterion in CRITERIA for name, _ in criterion.needs} <= set(ALL_COLUMNS)


def test_every_key_of_a_table_stands_there():
    every = vars(model).values()
    tables = [item for item in (*every, *SHAPES.values(), *KINDS.values()) if isinstance(item, type)]
    tables = [item for item in tables if issubclass(item, Table)]
    keys = {key for table in tables for key in table.model_fields} - {"kind", "shape"}
    assert len(keys) > 30
    assert [key for key in sorted(keys) if f"`{key}`" not in TEXT] == []
