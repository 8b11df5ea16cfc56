"""The friction study as a table for people, as CSV and as JSON."""

import json
import math
from collections.abc import Iterator
from typing import IO, Any

import numpy as np

from chutecalc import __version__
from chutecalc.output.csv import write_columns
from chutecalc.output.grid import Grid
from chutecalc.output.json import FORMAT
from chutecalc.output.table import Printer
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.friction.study import Best, FrictionStudy

SECTION_COLUMNS = ("base_m", "chamfer_wetted_m", "depth_m")
"""What follows from the chamfer angle alone."""
KEPT_TEXT = {
    "base": "centre section kept (as in Figure 5 of the paper)",
    "width": "total width kept (as in Figure 7 of the paper)",
    "depth": "flow depth kept (as in Figure 9 of the paper)",
}


def print_study(printer: Printer, study: FrictionStudy) -> None:
    """Prints the study: a row for each angle, a column for each material, and the best angle of each."""
    printer.text(f"Equivalent friction over the chamfer angle, {KEPT_TEXT[study.keep]}")
    printer.text(given_text(study, printer.units))
    printer.text()
    printer.table(_table(study, printer.units))
    printer.text()
    for line in _notes(study, printer.units):
        printer.text(line)


def write_study_csv(stream: IO[str], study: FrictionStudy) -> None:
    """Writes all rows, the impossible ones too."""
    write_columns(stream, study.columns)


def write_study_json(stream: IO[str], study: FrictionStudy) -> None:
    """Writes what was given, all rows, and the best angles."""
    rows = zip(*(values.tolist() for values in study.columns.values()), strict=True)
    document = {
        "chutecalc": __version__,
        "format": FORMAT,
        "study": "friction",
        "keep": study.keep,
        "wall_friction_deg": study.wall_friction_deg,
        "base_m": study.base_m,
        "area_m2": study.area_m2,
        "rows": [dict(zip(study.columns, map(_plain, row), strict=True)) for row in rows],
        "best": [{name: _plain(value) for name, value in best._asdict().items()} for best in study.best()],
    }
    json.dump(document, stream, indent=2, allow_nan=False, ensure_ascii=False)
    stream.write("\n")


def given_text(study: FrictionStudy, units: str) -> str:
    """What the study was given beside its angles."""
    base = FRICTION_COLUMNS["base_m"]
    width = f"{base.shown(study.base_m, units)} {base.unit_text(units)}"
    friction, area = f"wall friction {study.wall_friction_deg:g}°", f"flow area {study.area_m2:g} m²"
    return f"{friction}, width between square corners {width}, {area}"


def _table(study: FrictionStudy, units: str) -> Grid:
    """The possible rows."""
    table = Grid()
    friction = FRICTION_COLUMNS["equivalent_friction"]
    for name in ("chamfer_deg", *SECTION_COLUMNS):
        column = FRICTION_COLUMNS[name]
        table.column(f"{column.symbol}\n{column.unit_text(units)}")
    for delta in study.internal_friction_deg:
        table.column(f"{friction.symbol}\nδ {delta:g}°")
    count = len(study.chamfer_deg)
    values = study.columns["equivalent_friction"].reshape(-1, count)
    for k in np.flatnonzero(study.columns["status"][:count] == "ok"):
        cells = [
            FRICTION_COLUMNS[name].shown(study.columns[name][k], units) for name in ("chamfer_deg", *SECTION_COLUMNS)
        ]
        table.row([*cells, *(friction.shown(value, units) for value in values[:, k])])
    return table


def _notes(study: FrictionStudy, units: str) -> Iterator[str]:
    """The best angles, what was left out, and what cannot be."""
    for best in study.best():
        yield f"δ {best.internal_friction_deg:g}°: {_best_text(best, units)}"
    count = len(study.chamfer_deg)
    impossible = study.chamfer_deg[study.columns["status"][:count] == "impossible"]
    if impossible.size:
        some = f"β = {impossible.min():g}°" + (f" to {impossible.max():g}°" if impossible.size > 1 else "")
        yield f"left out: {some}, {impossible.size} of {count} angles, where the centre section would be less than 0"
    weak = study.inadmissible()
    if weak:
        materials = ", ".join(f"{delta:g}°" for delta in weak)
        yield f"warning: a wall friction of {study.wall_friction_deg:g}° is more than atan(sin δ) for δ = {materials}"


def _best_text(best: Best, units: str) -> str:
    """Where a material has its least friction."""
    angle, friction = FRICTION_COLUMNS["chamfer_deg"], FRICTION_COLUMNS["equivalent_friction"]

    def said(degrees: float, value: float) -> str:
        return f"{angle.shown(degrees, units)}° (μ_e {friction.shown(value, units)})"

    if math.isnan(best.end_deg):
        return "no angle has a section"
    if math.isnan(best.inside_deg):
        return f"no best β inside the range, least at its end, {said(best.end_deg, best.end_friction)}"
    text = f"best β inside the range {said(best.inside_deg, best.inside_friction)}"
    lower = best.end_friction < best.inside_friction
    return text + (f"; lower at its end, {said(best.end_deg, best.end_friction)}" if lower else "")


def _plain(value: Any) -> Any:
    """A value as JSON has it."""
    return None if isinstance(value, float) and math.isnan(value) else value
