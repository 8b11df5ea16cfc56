"""Lines of a report on the belt that receives the stream."""

from collections.abc import Iterator

import numpy as np

from chutecalc.results.column import quantity_text
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.limits import LIMITS


def receiver_lines(solution: SolvedChute, units: str) -> Iterator[str]:
    """Yield lines on where and how a stream lands on its belt, and on what would suit the belt better.

    Args:
        solution: solution of one design.
        units: ``metric`` or ``us``.
    """
    belt = solution.receiver
    if not belt or belt["velocity_ratio"][0] != belt["velocity_ratio"][0]:
        return
    text = {name: quantity_text(name, float(values[0]), units) for name, values in belt.items()}
    if solution.spec.receiver is not None and solution.spec.receiver.at_m is not None:
        yield (
            f"receiver  lands at x {text['landing_x_m']}, z {text['landing_z_m']}, at a slope of"
            f" {text['landing_slope_deg']}"
        )
    across = f"; {text['velocity_across_m_s']} across it" if belt["velocity_across_m_s"][0] else ""
    yield (
        f"receiver  {text['velocity_along_m_s']} along the belt, {text['velocity_ratio']} times its speed;"
        f" {text['velocity_into_m_s']} into it ({text['impact_pressure_kpa']}){across}; belt wear {text['wear_w_m2']}"
    )
    yield (
        f"receiver  {_reached(belt['acceleration_length_m'][0], units)}, with {text['acceleration_power_kw']}; after"
        f" friction at the impact: {text['landed_velocity_m_s']} along the belt,"
        f" {_reached(belt['landed_acceleration_length_m'][0], units).removeprefix('reaches ')}"
    )
    yield f"receiver  {_advice(solution, text, units)}"


def _reached(length: float, units: str) -> str:
    """Return where the material reaches the velocity of the belt, as text."""
    if length == float("inf"):
        return "never reaches belt speed"
    distance = quantity_text("length_m", abs(length), units)
    if length < 0.0:
        return f"runs back first, then reaches belt speed {distance} behind the loading point"
    return f"reaches belt speed after {distance}"


def _advice(solution: SolvedChute, text: dict[str, str], units: str) -> str:
    """Return what the stream would have to be so as to have the belt's velocity along it, and what that costs."""
    belt = solution.receiver
    low, high, hardest = (
        float(LIMITS[key].of(solution.design.limits)[0])
        for key in ("min_velocity_ratio", "max_velocity_ratio", "max_velocity_into_m_s")
    )
    ratio = belt["velocity_ratio"][0]
    if low <= ratio <= high:
        return "along the belt, the stream has about the speed of the belt"
    off = f"the stream is too {'slow' if ratio < low else 'fast'} for the belt"
    velocity = f"at this slope it would match at {text['matching_velocity_m_s']}"
    match = belt["matching_slope_deg"][0]
    if np.isnan(belt["matching_velocity_m_s"][0]):
        return f"{off}, whose heading the stream does not have: no velocity would match"
    if np.isnan(match):
        return f"{off} at any slope; {velocity}"
    change = "flatter" if match < belt["landing_slope_deg"][0] else "steeper"
    slope = f"at {text['matching_slope_deg']}, {change} than now"
    into = text["matching_velocity_into_m_s"]
    if belt["matching_velocity_into_m_s"][0] > hardest:
        limit = quantity_text("limit_m_s", hardest, units)
        return f"{off}; {velocity}; {slope}, it would match too, but with {into} into the belt (limit {limit})"
    return f"{off}; {velocity}, or {slope}, with {into} into the belt"
