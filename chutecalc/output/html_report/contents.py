"""What the report of one chute contains, as values for its template."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
from markupsafe import Markup

from chutecalc.output.band import band_lines, band_table
from chutecalc.output.cases import case_findings, cases_table
from chutecalc.output.html_report.at_joints import joint_formulas
from chutecalc.output.html_report.at_worst import station_formulas, where, worst_place
from chutecalc.output.html_report.reported import Reported
from chutecalc.output.html_report.svg import inline_svg
from chutecalc.output.html_report.tables import inputs_table, limits_table, points_table, steel_table
from chutecalc.output.html_report.worked import symbols_in
from chutecalc.output.inlet import inlet_lines
from chutecalc.output.loads import loads_table
from chutecalc.output.outcome import flow_line, impact_lines, outcome
from chutecalc.output.plots.notes import by_weight, numbered_by_place
from chutecalc.output.plots.run import draw_parts
from chutecalc.output.plots.steel import draw_steel
from chutecalc.output.receiver import receiver_lines
from chutecalc.output.table import StreamTables
from chutecalc.output.told import against_each_other
from chutecalc.results.cases import Cases
from chutecalc.results.columns import IN_TABLES
from chutecalc.results.described import status_words
from chutecalc.results.drawn import drawn_segment, drawn_surfaces, points_of
from chutecalc.results.finding import Severity
from chutecalc.results.solved import SolvedChute
from chutecalc.spec.operating import DESIGN_POINT


def contents(chute: Reported, units: str) -> dict[str, Any]:
    """Return the values that the template of one chute takes.

    Args:
        chute: what was solved.
        units: ``metric`` or ``us``.
    """
    states, solution = chute.states, chute.states.main_solution
    findings = solution.findings()
    numbered, marks = numbered_by_place(by_weight(findings))
    counts = Counter(str(finding.severity) for finding in findings)
    place = worst_place(solution)
    worked, joints = list(station_formulas(solution, place)) if place else [], joint_formulas(solution)
    return {
        **head(chute, units),
        "fails": not all(each.ok[0] for each in states.solutions.values()),
        "counts": [f"{count} {name}{'s' if count > 1 else ''}" for name, count in counts.items()],
        "findings": [(no, each, each.where(0, units), each.message(0, units)) for no, each in numbered],
        "against": list(against_each_other(findings)),
        "inputs": inputs_table(solution),
        **_pictures(chute, solution, marks, units),
        "segments": StreamTables(IN_TABLES, units).segments(solution.trajectory.rows),
        "stream_lines": [*impact_lines(solution, units), *inlet_lines(solution, units)],
        "cases": cases_table(states, units) if len(states.names) > 1 else None,
        "receiver_lines": [line.partition("  ")[2] for line in receiver_lines(solution, units)],
        "struck": any(result.impact for result in solution.trajectory.results),
        "loads": loads_table(solution.segments, units),
        "place": place and {"where": where(place, units), "why": place.why},
        "worked": worked,
        "joints": joints,
        "symbols": symbols_in([*worked, *(line for lines in joints.values() for line in lines)]),
        "band": chute.band and band_table(chute.band, units),
        "band_lines": list(band_lines(chute.band, units)) if chute.band else [],
        "model": solution.spec.model,
        "limits": limits_table(solution, units),
    }


def _statuses(states: Cases) -> str:
    """Return the statuses of several operating states in words; empty for one."""
    if len(states.names) == 1:
        return ""
    failing = [f"{name} {status_words(each.status[0])}" for name, each in states.solutions.items() if not each.ok[0]]
    count, through = len(states.names), len(states.names) - len(failing)
    solutions = states.solutions.values()
    warned = sum(any(found.severity == Severity.WARNING for found in each.findings()) for each in solutions)
    return ", ".join([f"{through} of {count} get through", *failing, *([f"{warned} with warnings"] if warned else [])])


def head(chute: Reported, units: str) -> dict[str, Any]:
    """Return what the title block takes.

    Args:
        chute: what was solved.
        units: ``metric`` or ``us``.
    """
    solution = chute.states.main_solution
    return {
        "title": solution.spec.title or solution.source,
        "project": solution.spec.project,
        "source": solution.source,
        "digest": chute.digest,
        "library": chute.library,
        "case": "" if chute.states.main == DESIGN_POINT else chute.states.main,
        "states": _statuses(chute.states),
        "case_findings": list(case_findings(chute.states, units)),
        "settings": chute.settings,
        "tolerance": f"{solution.rtol:g}",
        "error": f"{solution.error_estimate[0]:.0e}" if solution.ok[0] else "",
        "outcome": outcome(solution, units, np.inf),
        "flow": flow_line(solution, units).removeprefix(f"{solution.source}: "),
    }


def _pictures(chute: Reported, solution: SolvedChute, marks: Any, units: str) -> dict[str, Any]:
    """Return the pictures, and the tables of the steel."""
    segments = [drawn_segment(*each) for each in drawn_surfaces(solution)]
    points = points_of(segments)
    side, along = draw_parts(chute.states, marks, units, chute.band)
    name = solution.spec.title or solution.source
    texts = {
        "side": f"The stream in the chute from the side, to scale: {name}. Its numbers are in the table of segments.",
        "along": "Velocity, depth, pressure and wear along the stream. Their values are in the table of segments.",
        "steel": "The steel from the side, to scale. Its points and dimensions are in the tables below.",
    }
    figures = {"side": side, "along": along}
    if segments:
        figures["steel"] = draw_steel(solution, segments, points, units)
    drawn = {"steel": ""} | {key: Markup(inline_svg(figure, key, texts[key])) for key, figure in figures.items()}
    return {
        "pictures": drawn,
        "points": points_table(points, units),
        "steel": steel_table(solution, segments, points, units),
    }
