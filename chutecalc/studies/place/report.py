"""Placed segments for people and as a document."""

from collections.abc import Callable, Iterator
from typing import Any

from chutecalc.output.cases import CONCERNED
from chutecalc.output.dataset import Dataset, number
from chutecalc.output.grid import Grid
from chutecalc.results.finding import Severity
from chutecalc.segments.curve import Curve
from chutecalc.segments.registry import KINDS
from chutecalc.studies.place.placement import PlacedSegment, Placement
from chutecalc.studies.place.struck import Struck

COLUMNS: dict[str, Callable[[Struck], str]] = {
    "strike x\nm": lambda one: f"{one.x_m:z.3f}",
    "strike z\nm": lambda one: f"{one.z_m:z.3f}",
    "share": lambda one: f"{one.share:z.3f}",
    "incidence\n°": lambda one: f"{one.incidence_deg:z.2f}",
    "before\nm/s": lambda one: f"{one.velocity_m_s:.3f}",
    "after\nm/s": lambda one: f"{one.velocity_after_m_s:.3f}",
}
"""Headings of the columns of the table, and the text of each."""


def placement_table(placement: Placement) -> Grid:
    """Return a row for each placed segment in each state: how the stream strikes it.

    Args:
        placement: the placed segments.
    """
    states = [*placement.segments[0].strikes]
    table = Grid()
    table.column("segment", left=True, label=True)
    if len(states) > 1:
        table.column("case", left=True, label=True)
    for heading in COLUMNS:
        table.column(heading)
    strikes = [strike for each in placement.segments for strike in each.strikes.values() if strike]
    edges = list(dict.fromkeys(name for strike in strikes for name in strike.edges))
    for name in edges:
        table.column(f"{name} edge\n°")
    for each in placement.segments:
        for state, strike in each.strikes.items():
            numbers = [text(strike) if strike else "" for text in COLUMNS.values()]
            numbers[-1] = numbers[-1] if strike else "not struck"
            beside = (_edge(strike, name) for name in edges)
            table.row([each.name, *([state] if len(states) > 1 else []), *numbers, *beside])
    return table


def _edge(strike: Struck | None, name: str) -> str:
    """Return the incidence of an edge as text."""
    incidence = strike.edges.get(name) if strike else None
    return "" if incidence is None else "misses" if incidence != incidence else f"{incidence:z.2f}"


def shape_text(placed: PlacedSegment) -> str:
    """Return what a segment is: of a curve whether it flattens as a spoon or steepens as a crest.

    Args:
        placed: the segment.
    """
    begins = next(iter(placed.slopes.values()))
    if placed.ends_deg is None:
        return f"{placed.kind} at {begins:z.2f}°"
    turns = "spoon" if begins > placed.ends_deg else "crest"
    what = turns if KINDS[placed.kind] is Curve else placed.kind
    return f"{what} from {begins:z.2f}° to {placed.ends_deg:z.2f}°"


def drawn_lines(placed: PlacedSegment) -> Iterator[str]:
    """Yield what the spec needs for a segment to stand so, as lines of TOML.

    Args:
        placed: the segment.
    """
    yield f"start_m = {list(placed.start_m)}"
    yield from (f"{key} = {value!r}" for key, value in placed.slopes.items())


def outcome_lines(placement: Placement) -> Iterator[tuple[Severity, str, str]]:
    """Yield severity, code, and the segments and states of what a run of the placed chute has to tell.

    Args:
        placement: the placed segments.
    """
    if placement.cases is None:
        return
    found: dict[tuple[Severity, str], dict[str, list[str]]] = {}
    for state, solution in placement.cases.solutions.items():
        for finding in solution.findings():
            if finding.severity in CONCERNED:
                states = found.setdefault((finding.severity, finding.code), {}).setdefault(finding.subject, [])
                states += [] if state in states else [state]
    for (severity, code), subjects in sorted(found.items(), key=lambda item: CONCERNED.index(item[0][0])):
        every = len(placement.cases.names)
        where = (
            subject + ("" if len(states) == every else f" ({', '.join(states)})")
            for subject, states in subjects.items()
        )
        yield severity, code, ", ".join(where)


def placement_dataset(placement: Placement) -> Dataset:
    """Return the placed segments as a document: what to write into the spec, and how the stream then strikes.

    Args:
        placement: the placed segments.
    """
    return Dataset("place", {}, (), document=lambda: _document(placement))


def _document(placement: Placement) -> dict[str, Any]:
    """Return the entries of the document."""
    solution: dict[str, Any] = {}
    outcome: dict[str, Any] = {}
    for each in placement.segments:
        path = f"segments.{each.name}"
        solution |= {f"{path}.start_m": list(each.start_m)} | {f"{path}.{key}": at for key, at in each.slopes.items()}
        for state, strike in each.strikes.items():
            numbers = _numbers(strike) if strike else {}
            outcome.setdefault(state, {}).update({f"{path}.{name}": number(value) for name, value in numbers.items()})
    found = [
        {"code": code, "severity": severity, "segments": where} for severity, code, where in outcome_lines(placement)
    ]
    return {"solutions": [solution], "outcome": [outcome], "findings": found}


def _numbers(strike: Struck) -> dict[str, float]:
    """Return the numbers of a strike, by name."""
    return {
        "impact_x_m": strike.x_m,
        "impact_z_m": strike.z_m,
        "impact_share": strike.share,
        "impact_incidence_deg": strike.incidence_deg,
        "impact_velocity_m_s": strike.velocity_m_s,
        "impact_velocity_after_m_s": strike.velocity_after_m_s,
        **{f"{name}_edge_incidence_deg": incidence for name, incidence in strike.edges.items()},
    }
