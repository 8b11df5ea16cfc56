"""Formulas of impacts, forces and the receiving belt with their numbers."""

from collections.abc import Iterator

import numpy as np

from chutecalc.output.html_report.at_worst import number
from chutecalc.output.html_report.worked import Number, Worked, worked
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
    """Yield what an impact does to the stream and to the surface."""
    assert part.contact is not None
    arrival, numbers = part.contact.arrival, part.impact()
    before, after = number(arrival.velocity, "v_1", "m/s"), number(numbers["velocity_after_m_s"], "v_2", "m/s")
    angle, friction = number(numbers["incidence_deg"], "i", "°"), number(arrival.impact.friction, "μ_e")
    density, pressure = number(solution.design.density, "ρ", "kg/m³"), number(numbers["pressure_kpa"], "p", "kPa")
    meaning = "velocity after the impact; μ_e on the impulse, i the angle between stream and surface"
    kept = "cos {i} − {mu} · sin {i}"
    if after.value > 0.0:
        yield worked(after, meaning, f"{{v}} · ({kept})", IMPACT, v=before, i=angle, mu=friction)
    else:
        incidence = np.radians(angle.value)
        share = Number("v_2/v_1", float(np.cos(incidence) - friction.value * np.sin(incidence)))
        yield worked(share, f"{meaning}; where it is not above 0 the stream stops", kept, IMPACT, i=angle, mu=friction)
    footprint = number(numbers["footprint_m"], "L", "m")
    yield worked(
        pressure,
        f"impact pressure on a length of {footprint.text} m",
        "{rho} · {v}² · sin² {i}/1000",
        IMPACT,
        rho=density,
        v=before,
        i=angle,
    )


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
