"""The tables of docs/nomenclature.md, from the catalogues of columns and findings and the models of a spec.

python -m tests.nomenclature    writes them anew
"""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from chutecalc.fields.units import TEXT, first_unit
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Severity
from chutecalc.results.findings import CRITERIA
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.spec.chute_spec import ChuteSpec

PAGE = Path(__file__).resolve().parents[1] / "docs" / "nomenclature.md"
MARK = "<!-- {} from the code: python -m tests.nomenclature -->"
Row = Sequence[str]


def table(headings: Row, rows: Iterable[Row]) -> str:
    """As Markdown."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def columns(catalogue: dict[str, Any]) -> str:
    """Name, symbol, unit and meaning of columns."""
    rows = [(f"`{one.name}`", one.symbol, one.unit_text("metric"), one.meaning) for one in catalogue.values()]
    return table(("column", "symbol", "unit", "meaning"), rows)


def findings() -> str:
    """Code, severity, meaning, limit and source of findings."""
    rows = [
        (f"`{one.code}`", ", ".join(one.severities), one.summary, one.limit, one.source)
        for severity in Severity
        for one in CRITERIA
        if one.severities[0] is severity
    ]
    return table(("code", "severity", "meaning", "limit", "source"), rows)


def keys() -> str:
    """Every key of a spec in its first unit, table by table."""
    rows = sorted(_keys(ChuteSpec.model_json_schema()), key=lambda row: row[0])
    return table(("table", "key", "unit", "meaning"), rows)


def _keys(schema: dict[str, Any]) -> Iterator[Row]:
    for name, model in {"": schema, **schema["$defs"]}.items():
        described: set[tuple[str, str]] = set()
        for key, what in model["properties"].items():
            meaning, dimension = what.get("description", ""), what.get("x-dimension", "")
            if key in ("kind", "shape") or (dimension and (meaning, what["title"]) in described):
                continue  # the table's own name, or the same in another unit
            described.add((meaning, what.get("title", key)))
            unit = first_unit(dimension) if dimension not in ("", "number") else ""
            yield _table_name(name, model["properties"]), f"`{key}`", TEXT.get(unit, unit), meaning


def _table_name(model: str, properties: dict[str, Any]) -> str:
    """As it is written in a spec."""
    for key, table_ in (("kind", "segments"), ("shape", "sections")):
        if key in properties:
            which = properties[key].get("enum") or [properties[key]["const"]]
            return f"{table_}: {', '.join(which)}"
    return NAMES.get(model, model.lower())


NAMES = {
    "": "(top)",
    "Belt": "inlet.belt",
    "Facet": "sections: facets, a facet",
    "Liner": "liners",
    "Section": "sections",
}
TABLES = {
    "columns along the stream": lambda: columns(COLUMNS),
    "columns of the receiving belt": lambda: columns(RECEIVER_COLUMNS),
    "numbers of an impact": lambda: columns(IMPACT_COLUMNS),
    "findings": findings,
    "keys of a spec": keys,
}


def renewed(page: str) -> str:
    """The page with its tables as they must be."""
    for name, made in TABLES.items():
        before, mark, rest = page.partition(MARK.format(name) + "\n\n")
        if not mark:
            raise ValueError(f"docs/nomenclature.md has no place for the {name}")
        _, end, after = rest.partition("\n\n")
        page = before + mark + made() + (end + after if end else "\n")
    return page


if __name__ == "__main__":
    PAGE.write_text(renewed(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
