"""The friction study as a table for people, and as a dataset for files."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from chutecalc.design import Status
from chutecalc.output.dataset import Dataset, column_types, number, numbers
from chutecalc.output.grid import Grid
from chutecalc.output.printer import Printer
from chutecalc.results.columns import COLUMNS
from chutecalc.studies.friction.columns import FRICTION_COLUMNS
from chutecalc.studies.friction.study import Best, FrictionStudy

SECTION_COLUMNS = ("base_m", "chamfer_wetted_m", "depth_m")
"""Columns that depend on the chamfer angle alone."""
CONSTRAINT_TEXT = {
    "base": "constant centre section (as in Figure 5 of the paper)",
    "width": "constant total width (as in Figure 7 of the paper)",
    "depth": "constant flow depth (as in Figure 9 of the paper)",
}
"""What stays constant while the chamfer angle varies, by the value of ``keep``."""


def print_study(printer: Printer, study: FrictionStudy) -> None:
    """Print the study: a row for each angle, a column for each material, and the best angle of each material.

    Args:
        printer: where to print, and in which units.
        study: the study.
    """
    printer.text(f"Equivalent friction over the chamfer angle, {CONSTRAINT_TEXT[study.keep]}")
    printer.text(given_text(study, printer.units))
    printer.text()
    printer.table(_table(study, printer.units))
    printer.text()
    for line in _notes(study, printer.units):
        printer.text(line)


def study_dataset(study: FrictionStudy) -> Dataset:
    """Return all rows, those of impossible sections too; the document has the inputs and the best angles as well.

    Args:
        study: the study.
    """

    def document() -> dict[str, Any]:
        rows = zip(*map(numbers, study.columns.values()), strict=True)
        return asked | {
            "rows": [dict(zip(study.columns, row, strict=True)) for row in rows],
            "best": [{name: number(value) for name, value in best._asdict().items()} for best in study.best()],
        }

    asked = {
        "keep": study.keep,
        "wall_friction_deg": study.wall_friction_deg,
        "base_m": study.base_m,
        "area_m2": study.area_m2,
    }
    return Dataset("friction_study", column_types(FRICTION_COLUMNS.values()), [study.columns], asked, document)


def given_text(study: FrictionStudy, units: str) -> str:
    """Return the inputs of the study beside its angles, as a line of text.

    Args:
        study: the study.
        units: ``metric`` or ``us``.
    """
    base = FRICTION_COLUMNS["base_m"]
    width = f"{base.shown(study.base_m, units)} {base.unit_text(units)}"
    wetted = COLUMNS["area_m2"]
    area = f"flow area {wetted.converted(study.area_m2, units):.6g} {wetted.unit_text(units)}"
    friction = f"wall friction {study.wall_friction_deg:g}°"
    return f"{friction}, width between square corners {width}, {area}"


def _table(study: FrictionStudy, units: str) -> Grid:
    """Return a row for each angle that has a section."""
    table = Grid()
    friction = FRICTION_COLUMNS["equivalent_friction"]
    for name in ("chamfer_deg", *SECTION_COLUMNS):
        column = FRICTION_COLUMNS[name]
        table.column(f"{column.symbol}\n{column.unit_text(units)}", label=name == "chamfer_deg")
    for delta in study.internal_friction_deg:
        table.column(f"{friction.symbol}\nδ {delta:g}°")
    count = len(study.chamfer_deg)
    values = study.columns["equivalent_friction"].reshape(-1, count)
    for k in np.flatnonzero(study.columns["status"][:count] == Status.OK_LABEL):
        cells = [
            FRICTION_COLUMNS[name].shown(study.columns[name][k], units) for name in ("chamfer_deg", *SECTION_COLUMNS)
        ]
        table.row([*cells, *(friction.shown(value, units) for value in values[:, k])])
    return table


def _notes(study: FrictionStudy, units: str) -> Iterator[str]:
    """Yield the best angles, the angles left out, and the materials that are too weak."""
    for best in study.best():
        yield f"δ {best.internal_friction_deg:g}°: {_best_text(best, units)}"
    count = len(study.chamfer_deg)
    impossible = study.chamfer_deg[study.columns["status"][:count] == Status.IMPOSSIBLE_LABEL]
    if impossible.size:
        angles = f"β = {impossible.min():g}°" + (f" to {impossible.max():g}°" if impossible.size > 1 else "")
        yield f"left out: {angles}, {impossible.size} of {count} angles: the centre section would have a negative width"
    weak = study.inadmissible()
    if weak:
        materials = ", ".join(f"{delta:g}°" for delta in weak)
        yield f"warning: a wall friction of {study.wall_friction_deg:g}° is more than atan(sin δ) for δ = {materials}"


def _best_text(best: Best, units: str) -> str:
    """Return where a material has its lowest friction, as text."""
    angle, friction = FRICTION_COLUMNS["chamfer_deg"], FRICTION_COLUMNS["equivalent_friction"]

    def text(degrees: float, value: float) -> str:
        return f"{angle.shown(degrees, units)}° (μ_e {friction.shown(value, units)})"

    if math.isnan(best.end_deg):
        return "no angle gives a possible section"
    if math.isnan(best.inside_deg):
        return f"no minimum inside the range; lowest at its end, {text(best.end_deg, best.end_friction)}"
    minimum = f"minimum inside the range at {text(best.inside_deg, best.inside_friction)}"
    lower = best.end_friction < best.inside_friction
    return minimum + (f"; lower at the end, {text(best.end_deg, best.end_friction)}" if lower else "")
