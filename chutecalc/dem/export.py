"""The discrete-element check as CSV and JSON, a row for each bed, those that failed too."""

import csv
import json
import math
from typing import IO, Any

from chutecalc import __version__
from chutecalc.dem.bed import Bed
from chutecalc.dem.columns import DEM_COLUMNS
from chutecalc.dem.report import failures
from chutecalc.dem.study import CLAIM, LAWS, Fit, Measured, Point, Series, Study

FORMAT = 1
Row = dict[str, Any]


def rows(study: Study) -> list[Row]:
    """A row for each bed, by :data:`chutecalc.dem.columns.DEM_COLUMNS` and then its walls."""
    found = []
    for series in study.series:
        for point in study.points:
            case = point.case
            if (case.pour, case.friction, case.body_force, case.raised_to) == series[:4]:
                found += [_row(study, series, point, bed) for bed in point.all]
    return found


def _row(study: Study, series: Series, point: Point, bed: Bed) -> Row:
    """One bed."""
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


def write_csv(stream: IO[str], study: Study) -> None:
    """Writes a row for each bed."""
    found = rows(study)
    names = dict.fromkeys([*DEM_COLUMNS, *(name for row in found for name in row)])
    writer = csv.DictWriter(stream, list(names), restval="")
    writer.writeheader()
    writer.writerows({name: "" if value is None else value for name, value in row.items()} for row in found)


def write_json(stream: IO[str], study: Study) -> None:
    """Writes all beds, means, fits and failures."""
    document = {
        "chutecalc": __version__,
        "format": FORMAT,
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
        "cases": rows(study),
        "failures": failures(study),
        "waiting": sum(point.waiting for point in study.points),
    }
    json.dump(document, stream, indent=2, allow_nan=False, ensure_ascii=False)
    stream.write("\n")


def _point_document(study: Study, series: Series, point: Point) -> Row:
    """Means and scatter of a point, and the laws at its area."""
    friction = math.tan(study.wall_friction)
    return {
        "chamfer_deg": point.case.slope_label,
        "seeds": len(point.beds),
        "area_m2": _pair(point.area),
        "depth_m": _pair(point.depth),
        "solid_fraction": _pair(point.solid_fraction),
        "load_ratio": _pair(point.ratio),
        "equivalent_friction": _pair(Measured(friction * point.ratio.mean, friction * point.ratio.scatter)),
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
        "internal_friction_deg": _number(math.degrees(fit.internal_friction)),
        "scatter_deg": _number(math.degrees(fit.scatter)),
        "residual": fit.residual,
    }


def _pair(value: Measured) -> Row:
    return {"mean": value.mean, "scatter": _number(value.scatter)}


def _number(value: float) -> float | None:
    """A number, or null."""
    return value if math.isfinite(value) else None
