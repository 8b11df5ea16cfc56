"""Lines of a report on the belt that the stream comes from, and on the edges of the stream in flight."""

from collections.abc import Iterator, Mapping
from typing import Any

from chutecalc.results.column import quantity_text
from chutecalc.results.edges import Edge
from chutecalc.results.solved import SolvedChute


def inlet_lines(solution: SolvedChute, units: str) -> Iterator[str]:
    """Yield lines on how a stream leaves its belt, on the load there, and on where the edges of its flights land.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    yield from _belt_lines(solution, units)
    yield from (_edge_line(edge, units) for edge in solution.edges)


def _belt_lines(solution: SolvedChute, units: str) -> Iterator[str]:
    """Yield lines on the belt that a stream comes from, if it does."""
    belt = solution.spec.inlet.belt
    if belt is None:
        return
    text = _texts(solution.inlet, units)
    yield (
        f"inlet  the stream leaves the belt at {text['slope_deg']} (V²/(g r) {text['discharge_froude']}); centre line"
        f" from x {text['x_m']}, z {text['z_m']}, lower edge from x {text['lower_edge_x_m']}, z"
        f" {text['lower_edge_z_m']}"
    )
    if "belt_fill" in text:
        taken = "" if belt.roll_m else f"; middle roll taken as {text['roll_m']}, a third of the width and 10 mm"
        yield (
            f"belt  a load of {text['load_area_m2']} covers {text['load_width_m']} of the belt and is"
            f" {text['material_depth_m']} deep on the pulley; fill {text['belt_fill']}{taken}"
        )


def _edge_line(edge: Edge, units: str) -> str:
    """Return how an edge of one design begins to fly and lands."""
    text = _texts(edge.numbers, units)
    from_where, depth = (f" {edge.leaves}", f", {text['depth_m']} deep") if edge.leaves else ("", "")
    leaves = f"edge  {edge.name}: leaves{from_where} at {text['slope_deg']} and {text['velocity_m_s']}{depth}"
    if not edge.segment[0]:
        return f"{leaves}{',' if depth else ''} and lands nowhere"
    return (
        f"{leaves}, lands on {edge.segment[0]} {text['landing_distance_m']} along it, at x {text['landing_x_m']}, z"
        f" {text['landing_z_m']}, with {text['landing_velocity_m_s']} and an incidence of {text['incidence_deg']}"
    )


def _texts(numbers: Mapping[str, Any], units: str) -> dict[str, str]:
    """Return numbers of one design with their units."""
    return {
        name: quantity_text(name, float(values[0]), units, "in" if name in _INCHES else "")
        for name, values in numbers.items()
    }


_INCHES = ("depth_m", "material_depth_m", "load_width_m", "roll_m")
"""Lengths that are in inches in US units."""
