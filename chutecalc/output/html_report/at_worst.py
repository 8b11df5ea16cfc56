"""The governing formulas with their numbers, where a chute is worst."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from chutecalc.design import Status
from chutecalc.output.html_report.walls import depth_formulas, friction_formulas
from chutecalc.output.html_report.worked import Number, Worked, stated, worked
from chutecalc.physics.pressure import vertical_pressure_ratio
from chutecalc.results.columns import COLUMNS
from chutecalc.results.part import Part
from chutecalc.results.solved import SolvedChute

STATIONS = np.linspace(0.0, 1.0, 101)
"""Shares of a segment's length among which the worst is looked for."""
SAME = 1e-9
"""Relative difference of two friction coefficients that are the same."""


PROFILE = "α_m the momentum factor"


class WorstPlace(NamedTuple):
    """The station whose numbers a report puts into the formulas."""

    part: Part
    share: float
    """Of the length travelled on the part."""
    why: str


def worst_place(solution: SolvedChute) -> WorstPlace | None:
    """Return where a chute is worst; None where its stream slides on nothing.

    That is where it chokes a segment, where it enters the segment on which it ends otherwise; else where it wears most.

    Args:
        solution: solution of one design.
    """
    touched = [part for part in solution.trajectory.parts if part.contact is not None and not part.segment.deflects]
    reached = {}
    for part in touched:
        at = part.at(STATIONS, ["normal_acceleration_m_s2", "wear_w_m2"])
        pressed = at["normal_acceleration_m_s2"][:, 0] > 0.0
        if (wear := np.where(pressed, at["wear_w_m2"][:, 0], np.nan))[np.isfinite(wear)].size:
            reached[part] = wear
    if not reached:
        return None
    last = [*reached][-1]
    if last.status()[0] == Status.CHOKE and np.isfinite(reached[last][-1]):
        return WorstPlace(last, 1.0, "where the stream chokes the segment")
    if last.status()[0] not in (Status.OK, Status.CONTACT_LOST) and np.isfinite(reached[last][0]):
        return WorstPlace(last, 0.0, "where the stream enters the segment on which it ends")
    part = max(reached, key=lambda each: float(np.nanmax(reached[each])))
    return WorstPlace(part, float(STATIONS[np.nanargmax(reached[part])]), "where the stream wears the surface most")


def where(place: WorstPlace, units: str) -> str:
    """Return a place in words.

    Args:
        place: on one of the segments.
        units: ``metric`` or ``us``.
    """
    at = place.part.at(np.array([place.share]), ["s_m", "x_m", "z_m"])
    shown = ", ".join(
        f"{name[0]} = {COLUMNS[name].shown(float(at[name][0, 0]), units)} {COLUMNS[name].unit_text(units)}"
        for name in at
    )
    return f"{place.part.name}, {shown}"


def station_formulas(solution: SolvedChute, place: WorstPlace) -> Iterator[Worked]:
    """Yield the formulas that give the stream at a place, each with the numbers there, in SI units.

    Args:
        solution: solution of one design.
        place: on one of its segments.
    """
    spec, design = solution.spec, solution.design
    at: Any = place.part.profile(np.array([place.share]))
    mass, density = number(design.mass_rate, "ṁ", "kg/s"), number(design.density, "ρ", "kg/m³")
    flow, v, area = number(design.volume_rate, "Q", "m³/s"), number(at.velocity, "v", "m/s"), number(at.area, "A", "m²")
    depth, slope = number(at.depth, "H", "m"), number(np.degrees(at.slope), "a", "°")
    n, factor = number(at.normal_acceleration, "n", "m/s²"), Number("α_m", float(spec.model.momentum_factor))
    gravity = number(design.gravity, "g", "m/s²")
    rate = number(design.mass_rate * 3.6, "rate", "t/h")
    yield worked(mass, "mass rate, of the rate in t/h", "{rate}/3.6", "the spec's rate", rate=rate)
    yield worked(flow, "volume rate", "{mass}/{density}", "continuity", mass=mass, density=density)
    yield worked(area, "flow area", "{flow}/{v}", "continuity", flow=flow, v=v)
    yield from depth_formulas(at, area, depth)
    yield _normal(at, slope, gravity, v, n, factor)
    yield from _friction(solution, at, area, depth)
    mu, equivalent = number(at.wall_friction, "μ"), number(at.friction, "μ_e")
    if not spec.model.longitudinal_pressure_ratio:  # whose terms are not for a pocket calculator
        change = (gravity.value * np.sin(np.radians(slope.value)) - equivalent.value * n.value) / factor.value
        yield worked(
            Number("v dv/ds", float(change), "m/s²"),
            "acceleration along the stream" + (f"; {PROFILE}" if factor.value != 1.0 else ""),
            "{g} · sin {a} − {mu_e} · {n}" if factor.value == 1.0 else "({g} · sin {a} − {mu_e} · {n})/{factor}",
            "paper, equation 1",
            g=gravity,
            a=slope,
            mu_e=equivalent,
            n=n,
            factor=factor,
        )
    yield from _loads(at, density, n, depth, mu, v, area)


def _normal(at: Any, slope: Number, gravity: Number, v: Number, n: Number, factor: Number) -> Worked:
    """Return how the stream is pressed on its surface."""
    curvature, floor = number(at.contact.surface.curvature, "κ", "1/m"), np.ravel(at.contact.side)[0] > 0.0
    meaning, terms = "normal acceleration, which presses the stream on its surface", "{g} · cos {a}"
    if curvature.value:
        meaning += "; κ the curvature, positive where the surface flattens"
        meaning += f"; {PROFILE}" if factor.value != 1.0 else ""
        terms += " + {kappa} · {v}²" if factor.value == 1.0 else " + {factor} · {kappa} · {v}²"
    template = terms if floor else f"−({terms})"
    numbers = {"g": gravity, "a": slope, "factor": factor, "kappa": curvature, "v": v}
    return worked(n, meaning, template, "physics, equation of motion", **numbers)


def _friction(solution: SolvedChute, at: Any, area: Number, depth: Number) -> Iterator[Worked]:
    """Yield how the equivalent friction follows from that of the wall and from the section."""
    spec, mu, equivalent = solution.spec, number(at.wall_friction, "μ"), number(at.friction, "μ_e")
    missing, strength = number(at.missing, "m"), spec.material.internal_friction_deg
    if not mu.value:  # then the walls beside the floor do not count
        yield _wall_friction(at, mu, Number("δ", 0.0, "°"))
        yield worked(equivalent, "equivalent friction of a wall without friction", "{mu}", "physics", mu=mu)
        return
    equilibrium, of_law = spec.model.friction_law == "equilibrium", equivalent.value / mu.value - 1.0
    excess = Number("χ", of_law * (1.0 - missing.value) if equilibrium else of_law)
    delta = Number("δ", float(strength or 0.0), "°")
    if spec.material.pressure_ratio is not None:
        ratio = Number("K_v", float(spec.material.pressure_ratio))
    else:
        ratio = Number("K_v", float(vertical_pressure_ratio(np.radians(delta.value))))
        meaning = "pressure on a vertical wall over that on the floor"
        yield worked(ratio, meaning, "(1 − sin {d})/(1 + sin {d})", "paper, equation 4", d=delta)
    yield from friction_formulas(at, area, depth, ratio, excess, missing)
    yield _wall_friction(at, mu, delta)
    law = "{mu} · (1 + {excess}/(1 − {m}))" if equilibrium else "{mu} · (1 + {excess})"
    source = f"physics, friction law {spec.model.friction_law}"
    yield worked(equivalent, "equivalent friction", law, source, mu=mu, excess=excess, m=missing)


def _wall_friction(at: Any, mu: Number, delta: Number) -> Worked:
    """Return the friction of the wall: that of the material on itself where the wall is rougher, or a yield locus."""
    meaning, wall = "wall friction", at.contact.segment.wall
    strength = np.sin(np.radians(delta.value))
    if not wall.changes and strength and abs(mu.value / strength - 1.0) < SAME:
        return worked(mu, f"{meaning}: the material slides on itself", "sin {d}", "paper, section 6", d=delta)
    if wall.changes:
        stress = number(at.stress / 1000.0, "σ", "kPa")
        return stated(mu, f"{meaning}: of the yield locus at σ = {stress.text} kPa", "τ(σ)/σ", "the spec's yield locus")
    angle = Number("φ", float(np.degrees(np.arctan(mu.value))), "°")
    return worked(mu, meaning, "tan {phi}", "the spec's friction angle", phi=angle)


def _loads(at: Any, density: Number, n: Number, depth: Number, mu: Number, v: Number, area: Number) -> Iterator[Worked]:
    """Yield pressure, wear and Froude number."""
    pressure, slip = number(at.pressures[0] / 1000.0, "p", "kPa"), number(at.contact.segment.slip_ratio, "r_s")
    stress = float(np.ravel(at.stress)[0]) / 1000.0
    source, numbers = "physics, pressure and wear", {"rho": density, "n": n, "H": depth}
    factor = Number("f", 1000.0 * stress / (density.value * n.value * depth.value))
    meaning, template = "pressure on the floor", "{rho} · {n} · {H}/1000"
    if abs(factor.value - 1.0) > SAME:
        meaning += "; f = (1 + χ)/(1 + χ − m), or 1/(1 − m) with the law equilibrium, carries the whole weight"
        template = f"{{f}} · {template}"
    if abs(stress - pressure.value) < SAME * stress:
        yield worked(pressure, meaning, template, source, f=factor, **numbers)
    else:
        yield stated(pressure, "pressure on the flanks at their foot", "f K(ψ_1) ρ n H", source)
    wear = Number("w", float(np.ravel(at.wear(0))[0]) * slip.value, "W/m²")
    meaning, template = "wear: friction times pressure times slip velocity", "{mu} · 1000 · {p} · {v}"
    if slip.value != 1.0:
        meaning, template = f"{meaning}; r_s the slip ratio", f"{template} · {{slip}}"
    yield worked(wear, meaning, template, source, mu=mu, p=pressure, slip=slip, v=v)
    width = number(at.width, "b_s", "m")
    froude = Number("Fr", v.value / float(np.sqrt(n.value * area.value / width.value)))
    meaning = "Froude number; b_s the width of the free surface"
    yield worked(froude, meaning, "{v}/√({n} · {A}/{b})", "open-channel flow", v=v, n=n, A=area, b=width)


def number(values: Any, symbol: str, unit: str = "") -> Number:
    """Return a number of one design.

    Args:
        values: array of one value.
        symbol: as the field writes it.
        unit: as people write it.
    """
    return Number(symbol, float(np.ravel(values)[0]), unit)
