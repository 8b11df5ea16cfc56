"""The discrete-element check for files: a row for each bed, the failed ones too."""

import math
from collections.abc import Sequence
from typing import Any

from chutecalc.dem.bed import Bed
from chutecalc.dem.columns import DEM_COLUMNS
from chutecalc.dem.fit import Fit
from chutecalc.dem.point import Measured, Point
from chutecalc.dem.report import failures
from chutecalc.dem.study import CLAIM, LAWS, Series, Study, series_key
from chutecalc.output.dataset import Dataset, block_of, column_types, number

Row = dict[str, Any]


def rows(study: Study) -> list[Row]:
    """Return a row for each bed: the columns :data:`chutecalc.dem.columns.DEM_COLUMNS`, then those of its walls.

    Args:
        study: the results.
    """
    found = []
    for series in study.series:
        for point in study.points:
            if series_key(point) == series[:4]:
                found += [_row(study, series, point, bed) for bed in point.all]
    return found


def _row(study: Study, series: Series, point: Point, bed: Bed) -> Row:
    """Return the row of one bed. Numbers that do not exist are None."""
    case, checks = bed.case, {check.name: check.value for check in bed.checks}
    row = {
        "case": case.name,
        "pour": case.pour,
        "particle_friction": case.friction,
        "body_force_g": case.body_force,
        "raised_to_g": case.raised_to or None,
        "base_m": case.base,
        "chamfer_deg": point.case.slope_label,
        "seed": case.seed,
        "spread": case.spread,
        "status": "failed " + " ".join(check.name for check in bed.failed) if bed.failed else "ok",
        "area_m2": bed.area,
        "depth_m": bed.depth,
        "solid_fraction": bed.solid_fraction,
        "load_ratio": bed.ratio,
        "equivalent_friction": math.tan(study.wall_friction) * bed.ratio,
        "balance": checks["balance"],
        "sides": checks["sides"],
        "rest": checks["rest"],
        "unevenness": checks["level"],
    }
    for law in LAWS:
        fit = series.fits.get(law)
        row[f"{law}_load_ratio"] = bed.case.trough.load(bed.area, fit.vertical_ratio, law).ratio if fit else None
    for name, value in bed.pressure_ratios.items():
        row[f"pressure_ratio_{name.replace(' ', '_')}"] = value
        row[f"load_{name.replace(' ', '_')}"] = bed.by_name[name]
    return row


def study_dataset(study: Study) -> Dataset:
    """Return a row for each bed; the document has means, fits and failures as well.

    Args:
        study: the results.
    """
    found = rows(study)
    measured = dict.fromkeys(name for row in found for name in row)
    columns = column_types(DEM_COLUMNS.values()) | {"seed": int}
    columns |= {name: float for name in measured if name not in columns}
    return Dataset("dem", columns, [block_of(found, columns)], document=lambda: _document(study, found))


def _document(study: Study, found: Sequence[Row]) -> dict[str, Any]:
    """Return all beds, means, fits and failures."""
    return {
        "claim": CLAIM,
        "series": [
            {
                "pour": series.pour,
                "particle_friction": series.friction,
                "body_force_g": series.body_force,
                "raised_to_g": series.raised_to or None,
                "fits": {law: _fit_document(fit) for law, fit in series.fits.items()},
                "points": [_point_document(study, series, point) for point in series.points],
            }
            for series in study.series
        ],
        "cases": found,
        "failures": failures(study),
        "waiting": sum(point.waiting for point in study.points),
    }


def _point_document(study: Study, series: Series, point: Point) -> Row:
    """Return means and scatter of a point, and the results of the friction laws at its area."""
    friction = math.tan(study.wall_friction)
    return {
        "chamfer_deg": point.case.slope_label,
        "seeds": len(point.beds),
        "area_m2": _pair(point.area),
        "depth_m": _pair(point.depth),
        "solid_fraction": _pair(point.solid_fraction),
        "load_ratio": _pair(point.ratio),
        "equivalent_friction": _pair(point.ratio.scaled(friction)),
        "walls": {
            name: {"load": _pair(load), "pressure_ratio": _pair(pressure)}
            for name, (load, pressure) in point.walls.items()
        },
        "laws": {
            law: {
                "load_ratio": (load := point.law(fit.vertical_ratio, law)).ratio,
                "missing": load.missing_load,
                "loads": load.walls,
            }
            for law, fit in series.fits.items()
        },
    }


def _fit_document(fit: Fit) -> Row:
    return {
        "internal_friction_deg": number(math.degrees(fit.internal_friction)),
        "scatter_deg": number(math.degrees(fit.scatter)),
        "residual": fit.residual,
    }


def _pair(value: Measured) -> Row:
    return {"mean": value.mean, "scatter": number(value.scatter)}
