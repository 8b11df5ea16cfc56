"""Lines of a report on what flows, how it ends, and what it strikes."""

from collections.abc import Iterator

from chutecalc.fields.units import convert
from chutecalc.results.column import Units, quantity_text
from chutecalc.results.columns import COLUMNS
from chutecalc.results.solved import SolvedChute


def flow_line(solution: SolvedChute, units: str) -> str:
    """Return the spec and what flows, in a line.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    material, flow = solution.spec.material, solution.spec.flow
    rate, density = f"{flow.rate_t_h:g} t/h", f"{material.density_kg_m3:g} kg/m³"
    if units == Units.US:
        rate = f"{convert(flow.rate_t_h, 'mass rate', 't_h', 'stph'):.6g} short tons/h"
        density = f"{convert(material.density_kg_m3, 'density', 'kg_m3', 'lb_ft3'):.4g} lb/ft³"
    strength = f"δ {material.internal_friction_deg:g}°" if material.internal_friction_deg is not None else ""
    ratio = f"K_v {material.pressure_ratio:g}" if material.pressure_ratio is not None else ""
    what = ", ".join(part for part in (density, strength, ratio) if part)
    return f"{solution.source}: {rate} of {material.name or 'material'} ({what})"


def outcome(solution: SolvedChute, units: str, error_from: float = 0.0) -> str:
    """Return the status of a chute and the stream at its exit, in a line.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
        error_from: relative error estimate from which on it is told, dimensionless.
    """
    if not solution.ok[0]:
        return f"status {solution.status[0]}"
    parts = []
    for name in ("velocity_m_s", "depth_m", "slope_deg"):
        column, value = COLUMNS[name], float(solution.exit[name][0])
        if value == value:
            parts.append(f"{column.heading} {column.shown(value, units)} {column.unit_text(units)}")
    error = float(solution.error_estimate[0])
    estimate = "" if error < error_from else f" (error estimate {error:.0e})"
    return f"status {solution.status[0]}, exit {', '.join(parts)}{estimate}"


def impact_lines(solution: SolvedChute, units: str) -> Iterator[str]:
    """Yield a line for each impact of the stream on a surface.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    for segment in solution.trajectory.results:
        text = {name: quantity_text(name, float(values[0]), units) for name, values in segment.impact.items()}
        if segment.impact and segment.impact["incidence_deg"][0] == segment.impact["incidence_deg"][0]:
            roof = ", on its roof" if segment.strikes_roof[0] else ""
            yield (
                f"impact  {segment.name}{roof}: at {text['incidence_deg']}, {text['velocity_before_m_s']} before and"
                f" {text['velocity_after_m_s']} after, {text['pressure_kpa']} and {text['wear_w_m2']} over a length"
                f" of {text['footprint_m']}"
            )
