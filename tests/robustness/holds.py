"""What holds of every chute that is solved: its stream, what is told of it, and a batch of its variants."""

import io
import json
import re
from typing import Any

import numpy as np

import chutecalc
from chutecalc.design import Contact
from chutecalc.output.dataset import finite_numbers
from chutecalc.output.formats.csv import CsvRows
from chutecalc.output.printer import Printer
from chutecalc.output.report import print_case_findings, print_cases, print_report
from chutecalc.output.run import run_dataset
from chutecalc.results.columns import COLUMNS, IN_TABLES

NO_NUMBER = re.compile(r"\b(nan|inf|None)\b")
FAILURES = {"ok": [[]], "missed": [["missed"], ["passed_by"], ["contact_lost", "missed"]]}
"""Codes of the failures that go with a status, where they are others than its own name."""
ROUNDING = 1e-9
ALIKE = 1e-9
"""Relative difference of two ways to one velocity, of streams that land on an arc far below within the last digits."""

CREEPS = 0.01
"""Error estimate of a stall, a share of the segment, from which on it is that of a stream slower than 1 mm/s."""


def check(solution: chutecalc.Solution) -> None:
    """The status, the numbers along the stream, its energy, and the findings with their places."""
    status = str(solution.status[0])
    assert status in {"ok", "stall", "choke", "contact_lost", "missed"}
    assert np.isfinite(solution.exit_velocity[0]) == (status == "ok")
    passed = [segment.status[0] == "passed" for segment in solution.segments if segment.kind != "fall"]
    never_touched = all(passed)  # it leaves the chute as it came, from rest for example
    assert status != "ok" or 0.0 < solution.exit_velocity[0] < 1e4 or (never_touched and not solution.exit_velocity[0])
    found = solution.findings()
    failures = [finding.code for finding in found if finding.severity == "failure"]
    assert failures in FAILURES.get(status, [[status]])
    for finding in found:
        text = finding.message()
        assert not NO_NUMBER.search(text), text
        told = " at x " in text  # steel has a place whether a stream gets there or not
        assert bool(finding.key) or told or np.isfinite(finding.s_m[0]), (finding.code, finding.segment)
    table = solution.stations(
        points=7, columns=("segment", "kind", "s_m", "z_m", "velocity_m_s", "depth_m", "pressure_kpa")
    )
    reached = np.isfinite(table["s_m"][0])
    if not reached.any():  # flew off at the inlet, through pipes, or past all onto its belt
        assert status in ("missed", "choke") or (status == "ok" and never_touched)
        return
    velocity, s, z = (table[name][0][reached] for name in ("velocity_m_s", "s_m", "z_m"))
    assert np.isfinite(velocity).all()
    assert (velocity >= 0.0).all()
    assert (np.diff(s) >= -ROUNDING * max(1.0, s[-1])).all()
    assert not (table["depth_m"][0] < 0.0).any()
    assert not (table["pressure_kpa"][0] < 0.0).any()
    if solution.design.longitudinal_ratio[0] > 0.0:  # pressure along the stream drives it too
        return
    # Nothing but gravity drives, and what it drives is α_m v² where a surface guides the stream. Rounding is of v², and
    # of the height.
    names, guided = (table[name][0][reached] for name in ("segment", "kind"))
    factor = np.where(np.isin(guided, ("fall", "flight")), 1.0, solution.design.momentum_factor[0])
    gravity, squares = solution.design.gravity[0], factor * velocity**2
    energy, size = (
        0.5 * squares + gravity * z,
        1.0 + 0.5 * (squares[:-1] + squares[1:]) + gravity * np.abs(z[1:]) * 1e-6,
    )
    along = (names[1:] == names[:-1]) | (solution.design.momentum_factor[0] == 1.0)
    assert (np.diff(energy) <= ROUNDING * size)[along].all(), (np.diff(energy) / size, velocity, z)


def check_told(chute: chutecalc.Chute) -> None:
    """The report, and the files with their rows and their document: numbers, or nothing."""
    cases = chutecalc.solve_cases(chute)
    told = io.StringIO()
    printer = Printer(stream=told)
    print_report(printer, cases.main_solution, cases.main, IN_TABLES, "")
    if len(cases.names) > 1:
        print_cases(printer, cases)
    print_case_findings(printer, cases)
    assert not NO_NUMBER.search(told.getvalue()), told.getvalue()
    columns = list(COLUMNS)
    named = [name for name in columns if name not in ("spec", "case")]
    dataset = run_dataset([cases], lambda solution: solution.stations(5, None, named), columns)
    rows = io.StringIO()
    writer = CsvRows(rows, dataset)
    for block in dataset.blocks:
        writer.write(finite_numbers(block))
    assert not NO_NUMBER.search(rows.getvalue())
    json.dumps(dataset.document(), allow_nan=False)


def check_variants(chute: chutecalc.Chute) -> int:
    """A batch solved for its ends: the same as in full, without energy gained, and slower on rougher walls.

    Returns:
        How many end well in one way only: they creep at less than 1 mm/s, and their error estimate says that, or the
        last digit decides, so that they end in several ways where their rate or velocity is another by 1e-9.
    """
    ends = chutecalc.exits(chute, columns=("velocity_m_s", "z_m"), jobs=1)
    ok, velocity = ends.status == "ok", ends.exit["velocity_m_s"]
    assert (np.isfinite(velocity) == ok).all()
    design = chute.design
    start = 0.5 * design.inlet_velocity**2 + design.gravity * design.inlet_position[1]
    energy = 0.5 * velocity**2 + design.gravity * ends.exit["z_m"]
    driven = np.broadcast_to((design.longitudinal_ratio > 0.0) | (design.momentum_factor > 1.0), ok.shape)
    size = 1.0 + np.abs(start) + np.abs(energy)
    assert (energy <= start + ROUNDING * size)[ok & ~driven].all()
    solved = chutecalc.solve(chute)
    both, other = ok & (solved.status == "ok"), (solved.status == "ok") != ok
    creeps = np.maximum(ends.error_estimate, solved.error_estimate) >= CREEPS
    for number in np.flatnonzero(other & ~creeps):
        assert not decided(chute, number), number
    allowed = (ends.error_estimate + solved.error_estimate + ALIKE) * velocity  # 0 of one that falls from rest
    off = np.abs(solved.exit_velocity - velocity)
    worst = int(np.argmax(np.where(both, off - allowed, -np.inf)))
    alike = not both[worst] or not off[worst] > allowed[worst] or not decided(chute, worst)
    assert alike, (worst, off[worst], allowed[worst], velocity[worst])
    if rougher := slower_with(chute):
        slow = chutecalc.exits(chute.vary(rougher), columns=("velocity_m_s",), jobs=1)
        both = ok & (slow.status == "ok") & ~driven
        worth = ends.error_estimate + slow.error_estimate + 1e-12
        assert (slow.exit["velocity_m_s"] <= velocity * (1.0 + worth))[both].all()
    return int(other.sum())


def decided(chute: chutecalc.Chute, number: int) -> bool:
    """Whether one of the designs ends alike where its rate or its first velocity is another by 1e-9."""
    one, nudge = chutecalc.parse(alone(chute.data, number)), 1.0 + np.linspace(-1e-9, 1e-9, 41)
    tables = {"flow": one.data["flow"], "inlet": one.data["inlet"], "inlet.belt": one.data["inlet"].get("belt", {})}
    given = {f"{name}.{key}": value for name, table in tables.items() for key, value in table.items()}
    ends: set[str] = set()
    for path in (path for path in given if path.split(".")[-1].startswith(("rate_", "velocity_"))):
        near = one.vary({path: given[path] * nudge})
        ends |= {*chutecalc.exits(near, jobs=1).status, *chutecalc.solve(near).status}
    return len(ends) == 1


def alone(data: Any, number: int) -> Any:
    """The spec of one of several designs, as a file has it."""
    if isinstance(data, dict):
        return {key: alone(item, number) for key, item in data.items()}
    if isinstance(data, list):
        return [alone(item, number) for item in data]
    return data[min(number, data.size - 1)].item() if isinstance(data, np.ndarray) else data


def slower_with(chute: chutecalc.Chute) -> dict[str, Any]:
    """Changes with which a stream must be slower: more friction, where it lands nowhere else for that."""
    segments = chute.design.segments
    liner = chute.spec.liners["wall"]
    if len(segments) != 1 or not isinstance(segments[0], Contact) or segments[0].closed or segments[0].deflects:
        return {}
    if liner.friction_deg is None or np.max(liner.friction_deg) > 80.0:
        return {}
    return {"liners.wall.friction_deg": np.asarray(liner.friction_deg) + 1e-3}
