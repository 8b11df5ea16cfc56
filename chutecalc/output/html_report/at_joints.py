"""Formulas of impacts, forces and the receiving belt with their numbers."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from chutecalc.output.html_report.at_worst import SAME, number
from chutecalc.output.html_report.walls import depth_formulas
from chutecalc.output.html_report.worked import Number, Worked, worked
from chutecalc.physics.pressure import pressure_factor
from chutecalc.results.part import Part
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute

IMPACT, FORCES, BELTS = "physics, flight and impact", "physics, forces", "physics, belts"


def joint_formulas(solution: SolvedChute) -> dict[str, list[Worked]]:
    """Return the formulas of the hardest impact, of the greatest force on a segment, and of the receiving belt.

    Args:
        solution: solution of one design.

    Returns:
        Formulas by what they are about, in SI units; empty where there is nothing of the kind.
    """
    found = {}
    struck = [part for part in solution.trajectory.parts if part.impact()]
    if struck:
        hardest = max(struck, key=lambda part: float(part.impact()["pressure_kpa"][0]))
        found[f"Hardest impact: on {hardest.name}"] = [*_impact(solution, hardest)]
    pairs = zip(solution.trajectory.parts, solution.trajectory.results, strict=True)
    loaded = [(part, result) for part, result in pairs if result.loads and np.isfinite(result.loads["force_n"][0])]
    if loaded:
        part, result = max(loaded, key=lambda pair: float(pair[1].loads["force_n"][0]))
        found[f"Greatest force: on {part.name}"] = [*_force(solution, part, result)]
    if solution.receiver and np.isfinite(solution.receiver["velocity_ratio"][0]):
        found["Landing on the receiving belt"] = [*_landing(solution)]
    return found


def _impact(solution: SolvedChute, part: Part) -> Iterator[Worked]:
    """Yield what an impact does to the stream and to the surface, from the stream as it arrives."""
    assert part.contact is not None
    arrival, numbers, model = part.contact.arrival, part.impact(), solution.spec.model
    before, after = number(arrival.velocity, "v_1", "m/s"), number(numbers["velocity_after_m_s"], "v_2", "m/s")
    at: Any = part.profile(np.zeros(1))
    at = at.with_velocity_squared(float(model.momentum_factor) * before.value**2)
    flow, depth = number(solution.design.volume_rate, "Q", "m³/s"), number(at.depth, "H_1", "m")
    area = Number("A_1", flow.value / before.value, "m²")
    yield worked(area, "flow area of the stream that arrives", "{Q}/{v}", "continuity", Q=flow, v=before)
    yield from depth_formulas(at, area, depth)
    angle, density = number(numbers["incidence_deg"], "i", "°"), number(solution.design.density, "ρ", "kg/m³")
    footprint, pressure = number(numbers["footprint_m"], "L_i", "m"), number(numbers["pressure_kpa"], "p", "kPa")
    if abs(footprint.value * np.sin(np.radians(angle.value)) / depth.value - 1.0) < SAME:
        meaning = "length of surface that is struck; i the angle between stream and surface"
        yield worked(footprint, meaning, "{H}/sin {i}", IMPACT, H=depth, i=angle)
    of_pressure = {"rho": density, "v": before, "i": angle, "H": depth, "L": footprint}
    yield worked(pressure, "impact pressure", "{rho} · {v}² · sin {i} · {H}/{L}/1000", IMPACT, **of_pressure)
    yield from _kept(solution, arrival, float(np.ravel(at.missing)[0]), before, after, angle, pressure)


def _kept(
    solution: SolvedChute, arrival: Any, missing: float, before: Number, after: Number, angle: Number, pressure: Number
) -> Iterator[Worked]:
    """Yield friction, the velocity that is left, and wear."""
    mu, friction = number(arrival.impact.wall_friction, "μ"), number(arrival.impact.friction, "μ_e")
    excess = Number("χ_1", friction.value / mu.value - 1.0 if mu.value else 0.0)
    if mu.value:
        meaning = "equivalent friction on the impulse; χ_1 the excess friction of the friction law at the depth H_1"
        yield worked(friction, meaning, "{mu} · (1 + {chi})", IMPACT, mu=mu, chi=excess)
    kept = "cos {i} − {mu} · sin {i}"
    if not after.value > 0.0:
        incidence = np.radians(angle.value)
        share = Number("v_2/v_1", float(np.cos(incidence) - friction.value * np.sin(incidence)))
        meaning = "share of the velocity that is left; where it is not above 0 the stream stops"
        yield worked(share, meaning, kept, IMPACT, i=angle, mu=friction)
        return
    meaning = "velocity after the impact"
    yield worked(after, meaning, f"{{v}} · ({kept})", IMPACT, v=before, i=angle, mu=friction)
    factor = float(pressure_factor(excess.value, missing, solution.spec.model.friction_law == "equilibrium"))
    wear = Number("w", float(np.ravel(arrival.impact.wear)[0]), "W/m²")
    meaning = "wear of the impact, at a slip ratio of 1; f_1 the pressure factor of the friction law at the depth H_1"
    template = "{mu} · {f} · 1000 · {p} · ({v1} · cos {i} + {v2})/2"
    numbers = {"mu": mu, "f": Number("f_1", factor), "p": pressure, "v1": before, "v2": after, "i": angle}
    yield worked(wear, meaning, template, IMPACT, **numbers)


def _force(solution: SolvedChute, part: Part, result: SegmentResult) -> Iterator[Worked]:
    """Yield the momentum balance of the stream on a segment."""
    assert part.contact is not None
    arrival, solved = part.contact.arrival, part.solved
    entry = number(np.degrees(solved.entry.slope + part.contact.surface.side * arrival.incidence), "a_1", "°")
    numbers = {
        "m": number(solution.design.mass_rate, "ṁ", "kg/s"),
        "v1": number(arrival.velocity, "v_1", "m/s"),
        "a1": entry,
        "v2": number(solved.exit.velocity, "v_2", "m/s"),
        "a2": number(np.degrees(solved.exit.slope), "a_2", "°"),
        "g": number(solution.design.gravity, "g", "m/s²"),
        "t": number(result.duration, "t", "s"),
    }
    along, upwards = number(result.loads["force_x_n"], "F_x", "N"), number(result.loads["force_z_n"], "F_z", "N")
    yield worked(along, "force along the chute", "{m} · ({v1} · cos {a1} − {v2} · cos {a2})", FORCES, **numbers)
    meaning = "force upwards; t the time that the stream takes along the segment"
    yield worked(upwards, meaning, "{m} · ({v2} · sin {a2} − {v1} · sin {a1} − {g} · {t})", FORCES, **numbers)


def _landing(solution: SolvedChute) -> Iterator[Worked]:
    """Yield the components of the velocity of the stream on the belt."""
    belt, numbers = solution.design.receiver, solution.receiver
    assert belt is not None
    ends = solution.trajectory.ends
    of = {
        "v": number(ends.landing_velocity, "v", "m/s"),
        "a": number(np.degrees(ends.landing_slope), "a", "°"),
        "ab": number(np.degrees(belt.slope), "a_b", "°"),
        "psi": number(np.degrees(belt.plan_angle), "ψ", "°"),
        "rho": number(solution.design.density, "ρ", "kg/m³"),
        "into": number(numbers["velocity_into_m_s"], "v_n", "m/s"),
    }
    along = number(numbers["velocity_along_m_s"], "v_b", "m/s")
    speed = number(belt.velocity, "V_b", "m/s")
    template = "{v} · (cos {a} · cos {ab} · cos {psi} + sin {a} · sin {ab})"
    yield worked(along, "velocity along the belt; a_b its slope, ψ the angle in plan", template, BELTS, **of)
    template = "|{v} · (sin {a} · cos {ab} − cos {a} · sin {ab} · cos {psi})|"
    yield worked(of["into"], "velocity into the belt", template, BELTS, **of)
    ratio = number(numbers["velocity_ratio"], "r_b")
    yield worked(ratio, "velocity ratio; V_b the velocity of the belt", "{v}/{V}", BELTS, v=along, V=speed)
    pressure = number(numbers["impact_pressure_kpa"], "p", "kPa")
    yield worked(pressure, "impact pressure on the belt", "{rho} · {into}²/1000", BELTS, **of)
