"""The discrete-element check as tables for people. Failed beds are shown, and never averaged."""

import math

from chutecalc.dem.fit import INSENSITIVE, Fit, residual
from chutecalc.dem.point import Measured
from chutecalc.dem.study import CLAIM, LAWS, Series, Study
from chutecalc.output.grid import Grid
from chutecalc.output.printer import COLOURS, Printer

SHALLOW = 6.0
"""Depth below which a bed is reported as shallow, in particle diameters (practice)."""


def print_study(printer: Printer, study: Study) -> None:
    """Print a table for each series with its fits, then failures.

    Args:
        printer: where to print.
        study: the results.
    """
    for series in study.series:
        if series.points:
            printer.text(series_title(series), style="bold")
            printer.table(_table(study, series))
            for line in (*_fit_lines(study, series), *_shallow_lines(series)):
                printer.text(line)
            printer.text()
    for line in failures(study):
        printer.text(line, style=COLOURS["failure"])
    waiting = sum(point.waiting for point in study.points)
    if waiting:
        printer.text(f"{waiting} cases have not been run. More may follow, until beds are level")
    printer.text(CLAIM)


def series_title(series: Series) -> str:
    """Return the name of a series.

    Args:
        series: a series of beds.
    """
    force = f", {series.body_force:g} g" if series.body_force != 1.0 or series.raised_to else ""
    raised = f" raised to {series.raised_to:g} g" if series.raised_to else ""
    return f"{series.pour}, particle friction {series.friction:g}{force}{raised}"


def _table(study: Study, series: Series) -> Grid:
    """Return a row for each trough and wall: measured, and by the law with the fitted δ."""
    table = Grid()
    headings = ("β", "area", "depth", "solids", "wall", "K", "±", "law", "N_t/N", "±", "paper", "equil.", "μ_e", "±")
    units = ("°", "m²", "m", "", "", "", "", "", "", "", "", "", "", "")
    for heading, unit in zip((*headings, "seeds"), (*units, ""), strict=True):
        table.column(f"{heading}\n{unit}", left=heading == "wall", label=heading in ("β", "wall"))
    for point in series.points:
        walls = {name: both for name, both in point.walls.items() if name != "floor"}
        law = point.law(series.fits["paper"].vertical_ratio, "paper")
        friction = math.tan(study.wall_friction)
        for number, (name, (load, pressure)) in enumerate(walls.items()):
            by_law = law.walls[name] * pressure.mean / load.mean
            bed = ("",) * 4
            loads = ("",) * 7
            if number == 0:
                bed = (
                    point.case.slope_label,
                    f"{point.area.mean:.5f}",
                    f"{point.depth.mean:.4f}",
                    f"{point.solid_fraction.mean:.3f}",
                )
                equilibrium = point.law(series.fits["equilibrium"].vertical_ratio, "equilibrium")
                loads = (
                    *_shown(point.ratio, 4),
                    f"{law.ratio:.4f}",
                    f"{equilibrium.ratio:.4f}",
                    *_shown(point.ratio.scaled(friction), 4),
                    f"{len(point.beds)} of {point.group.seeds}",
                )
            table.row([*bed, name, *_shown(pressure, 3), f"{by_law:.3f}", *loads])
    return table


def _shown(value: Measured, digits: int) -> tuple[str, str]:
    """Return a mean and its scatter as cells."""
    return f"{value.mean:.{digits}f}", "" if value.scatter != value.scatter else f"{value.scatter:.{digits}f}"


def _fit_lines(study: Study, series: Series) -> list[str]:
    """Return lines on the fitted δ of each law, and on how far the beds are from it."""
    lines = []
    for law, fit in series.fits.items():
        off = f"rms error {fit.residual:.4f} in N_t/N"
        if fit.internal_friction != fit.internal_friction:
            lines.append(f"{law} law: no dependence on δ, {off}")
        elif len(series.points) == 1 and fit.residual < INSENSITIVE:
            lines.append(f"{law} law: δ = {delta_text(fit)} gives the measured N_t/N")
        else:
            lines.append(f"{law} law: δ = {delta_text(fit)} fits best, {off}")
    if study.vertical_ratio is not None:
        errors = ", ".join(f"{residual(series.points, study.vertical_ratio, law):.4f} ({law})" for law in LAWS)
        lines.append(f"with the given K_v = {study.vertical_ratio:.4f}: rms error {errors} in N_t/N")
    return lines


def _shallow_lines(series: Series) -> list[str]:
    """Return a line if beds are too shallow to be a continuum."""
    layers = min(point.depth.mean / point.case.diameter for point in series.points)
    if layers >= SHALLOW:
        return []
    return [f"the shallowest bed is only {layers:.1f} particles deep: below {SHALLOW:g} it is hardly a continuum"]


def delta_text(fit: Fit) -> str:
    """Return a fitted δ with its scatter, as text.

    Args:
        fit: the fit of a friction law.
    """
    if fit.internal_friction != fit.internal_friction:
        return "any"
    scatter = "" if fit.scatter != fit.scatter else f" ± {math.degrees(fit.scatter):.1f}°"
    delta = math.degrees(fit.internal_friction)
    bound = "" if 0.05 < delta < 89.95 else " (the end of its range)"
    return f"{delta:.1f}°{scatter}{bound}"


def failures(study: Study) -> list[str]:
    """Return a line for each failure, with the folder of the case.

    Args:
        study: the results.
    """
    lines = []
    for point in study.points:
        for bed in point.failed:
            why = ", ".join(f"{check.name} {check.value:.2g}, allowed {check.allowed:g}" for check in bed.failed)
            lines.append(f"failed {study.store.case_folder(bed.case)}: {why}")
        lines += [f"error {error}" for error in point.errors]
    return lines
