"""Write the tables of docs/nomenclature.md, from the catalogues of columns and findings and the models of a spec.

python -m tests.nomenclature
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from chutecalc.dem.columns import DEM_COLUMNS
from chutecalc.fields.units import TEXT, first_unit
from chutecalc.results.belts import RECEIVER_COLUMNS
from chutecalc.results.column import Column
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Severity
from chutecalc.results.finding_columns import FINDING_COLUMNS
from chutecalc.results.findings import CRITERIA
from chutecalc.results.impacts import IMPACT_COLUMNS
from chutecalc.results.loads import LOAD_COLUMNS
from chutecalc.spec.chute_spec import ChuteSpec
from chutecalc.spec.limits import LIMITS
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.sweep.columns import row_columns

PAGE = Path(__file__).resolve().parents[1] / "docs" / "nomenclature.md"
MARK = "<!-- {} from the code: python -m tests.nomenclature -->"
ROW_PREFIXES = ("exit_", "max_impact_", "max_", "min_", "receiver_")
"""First words of the columns of a sweep that are made from other columns."""
CATALOGUES: dict[str, Mapping[str, Column]] = {
    "columns along the stream": COLUMNS,
    "columns that only findings read": FINDING_COLUMNS,
    "columns of the receiving belt": RECEIVER_COLUMNS,
    "numbers of an impact": IMPACT_COLUMNS,
    "loads of a segment": LOAD_COLUMNS,
    "columns of a sweep": {name: one for name, one in row_columns().items() if not name.startswith(ROW_PREFIXES)},
    "columns of the friction study": FRICTION_COLUMNS,
    "columns of the discrete-element check": DEM_COLUMNS,
}
"""Every catalogue of columns, by the name of its table."""
Row = Sequence[str]


def table(headings: Row, rows: Iterable[Row]) -> str:
    """Return a table as Markdown."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def columns(catalogue: Mapping[str, Column]) -> str:
    """List columns: key, name, symbol, unit, meaning and source."""
    rows = [
        (f"`{one.name}`", one.words, one.symbol, one.unit_text("metric"), one.meaning, one.source)
        for one in catalogue.values()
    ]
    return table(("column", "name", "symbol", "unit", "meaning", "source"), rows)


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
    rows = sorted(_keys(ChuteSpec.model_json_schema()), key=lambda row: row[0])
    return table(("table", "key", "symbol", "unit", "meaning"), rows)


def _keys(schema: dict[str, Any]) -> Iterator[Row]:
    for name, model in {"": schema, **schema["$defs"]}.items():
        described: set[tuple[str, str]] = set()
        for key, what in model["properties"].items():
            meaning, dimension = what.get("description", ""), what.get("x-dimension", "")
            if key in ("kind", "shape") or (dimension and (meaning, what["title"]) in described):
                continue  # the table's own name, or the same in another unit
            described.add((meaning, what.get("title", key)))
            unit = first_unit(dimension) if dimension not in ("", "number") else ""
            symbol = SYMBOLS.get(f"{name}.{key}", SYMBOLS.get(key, ""))
            yield _table_name(name, model["properties"]), f"`{key}`", symbol, TEXT.get(unit, unit), meaning


def _table_name(model: str, properties: dict[str, Any]) -> str:
    """Return the name of a table as a spec has it."""
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
SYMBOLS = {
    "velocity_m_s": "v",
    "slope_deg": "a",
    "to_slope_deg": "a",
    "from_slope_deg": "a",
    "base_m": "B",
    "chamfer_deg": "β",
    "chamfer_m": "L",
    "radius_m": "R",
    "rate_t_h": "ṁ",
    "gravity_m_s2": "g",
    "friction_deg": "φ",
    "density_kg_m3": "ρ",
    "internal_friction_deg": "δ",
    "pressure_ratio": "K_v",
    "Facet.slope_deg": "ψ",
    "Circular.radius_m": "",
    "Belt.velocity_m_s": "",
    "Receiver.velocity_m_s": "",
    "Receiver.slope_deg": "",
    "Receiver.friction_deg": "",
}
"""Symbols of keys by their name, or by table and name where the key has another symbol there, or none."""
TABLES = {
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
