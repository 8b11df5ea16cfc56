"""Write the tables of docs/nomenclature.md, from the catalogues of columns and findings and the models of a spec.

python -m tests.nomenclature
"""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path

from chutecalc.fields.units import TEXT, first_unit
from chutecalc.glossary.columns import CATALOGUES
from chutecalc.glossary.keys import NO_DEFAULT, allowed_text, default_text
from chutecalc.glossary.tables import spec_tables
from chutecalc.results.column import Column
from chutecalc.results.finding import Severity
from chutecalc.results.findings import CRITERIA
from chutecalc.results.symbols import SYMBOLS
from chutecalc.spec.limits import LIMITS

PAGE = Path(__file__).resolve().parents[1] / "docs" / "nomenclature.md"
MARK = "<!-- {} from the code: python -m tests.nomenclature -->"
Row = Sequence[str]


def table(headings: Row, rows: Iterable[Row]) -> str:
    """Return a table as Markdown."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def columns(catalogue: Mapping[str, Column]) -> str:
    """List columns: key, name, symbol, unit, meaning, formula and source."""
    rows = [
        (f"`{one.name}`", one.words, one.symbol, one.unit_text("metric"), one.meaning, one.equation, one.source)
        for one in catalogue.values()
    ]
    return table(("column", "name", "symbol", "unit", "meaning", "formula", "source"), rows)


def findings() -> str:
    """List findings: code, severity, meaning, limit and source."""
    rows = [
        (f"`{one.code}`", ", ".join(one.severities), one.summary, one.limit, one.source)
        for severity in Severity
        for one in CRITERIA
        if one.severities[0] is severity
    ]
    return table(("code", "severity", "meaning", "limit", "source"), rows)


def limits() -> str:
    """List limits: key, default, finding, meaning and source."""
    rows = [(f"`{one.key}`", one.text, f"`{one.finding}`", one.meaning, one.source) for one in LIMITS.values()]
    return table(("key", "default", "finding", "meaning", "source"), rows)


def keys() -> str:
    """List every key of a spec in its first unit, table by table."""
    rows = []
    for each in spec_tables():
        quantities = each.model.quantities()
        for key, symbol in each.described():
            unit = first_unit(quantities[key].dimension) if key in quantities else ""
            field = each.model.model_fields[key]
            allowed = allowed_text(field, quantities.get(key), unit)
            default = "required" if field.is_required() else default_text(field, quantities.get(key), unit)
            told = allowed, default.removesuffix(NO_DEFAULT), field.description or ""
            rows.append((each.name, f"`{key}`", symbol, TEXT.get(unit, unit), *told))
    headings = ("table", "key", "symbol", "unit", "allowed", "default", "meaning")
    return table(headings, sorted(rows, key=lambda row: row[0]))


def symbols() -> str:
    """List symbols: unit, meaning and source."""
    return table(("symbol", "unit", "meaning", "source"), SYMBOLS)


TABLES = {
    "symbols": symbols,
    **{name: partial(columns, catalogue) for name, catalogue in CATALOGUES.items()},
    "findings": findings,
    "limits": limits,
    "keys of a spec": keys,
}


def renewed(page: str) -> str:
    """Return the page with its tables written anew."""
    for name, made in TABLES.items():
        before, mark, rest = page.partition(MARK.format(name) + "\n\n")
        if not mark:
            raise ValueError(f"docs/nomenclature.md has no mark for the {name}")
        _, end, after = rest.partition("\n\n")
        page = before + mark + made() + (end + after if end else "\n")
    return page


if __name__ == "__main__":
    PAGE.write_text(renewed(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
