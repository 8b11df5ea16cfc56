"""The results of a run as rows, a station each, and as a document."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from chutecalc.output.cases import cases_document
from chutecalc.output.dataset import Block, Dataset, column_types, first, number, numbers
from chutecalc.output.workbook import run_tables
from chutecalc.results.cases import Cases
from chutecalc.results.columns import AT_STATION, COLUMNS
from chutecalc.results.edges import EDGE_NUMBERS
from chutecalc.results.inlet import INLET_NUMBERS
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute

StationsOf = Callable[[SolvedChute], Mapping[str, Any]]
"""A function that returns the stations of a solution."""


def run_dataset(
    chutes: Sequence[Cases],
    stations: StationsOf | None,
    columns: Sequence[str] = tuple(COLUMNS),
    more: Callable[[int], Mapping[str, Any]] = lambda number: {},
) -> Dataset:
    """Return the results of a run: stations as rows; a document with an object for each chute.

    Args:
        chutes: chutes of one design each, in all their states. Rows and documents begin with the one shown in full.
        stations: returns the stations of a solution, if a user asked for some. The document holds those of the state
            shown in full then. Without them the rows are the default stations, and the document has none.
        columns: names of the station columns.
        more: returns further entries of the document of each chute, by its number from 0.
    """

    def blocks() -> Iterator[Block]:
        for chute in chutes:
            for name, solution in chute.solutions.items():  # one after the other: each may have millions of numbers
                table = stations(solution) if stations else solution.stations(columns=needed(columns))
                yield _station_rows(solution.source, name, table, columns)

    def document() -> dict[str, Any]:
        found = [
            _chute(chute, stations(chute.main_solution) if stations else None, columns) | dict(more(number))
            for number, chute in enumerate(chutes)
        ]
        return tolerance | {"chutes": found}

    tolerance = {"tolerance": chutes[0].main_solution.rtol}
    specs = [{"source": chute.main_solution.source, "spec": chute.main_solution.data} for chute in chutes]
    asked, types = tolerance | {"specs": specs}, column_types(COLUMNS[name] for name in columns)
    tables = partial(run_tables, chutes, columns)
    return Dataset("run", types, blocks(), asked, document, name="stations", tables=tables)


def needed(columns: Sequence[str]) -> list[str]:
    """Return the columns that stations need to have: those asked for, and those that say which station it is.

    Args:
        columns: names of the columns asked for.

    >>> needed(["depth_m", "spec"])
    ['segment', 's_m', 'depth_m']
    """
    return [name for name in AT_STATION if name in {"segment", "s_m", *columns}]


def _station_rows(source: str, case: str, table: Mapping[str, Any], columns: Sequence[str]) -> Block:
    """Return the stations that the stream reached, with the spec and the operating state that they belong to."""
    reached = np.isfinite(table["s_m"][0])
    labels = {"spec": source, "case": case}
    count = np.count_nonzero(reached)
    return {name: np.full(count, labels[name]) if name in labels else table[name][0][reached] for name in columns}


def _chute(chute: Cases, stations: Mapping[str, Any] | None, columns: Sequence[str]) -> dict[str, Any]:
    """Return the results of one chute in all its states, with the stations of the one shown in full."""
    solution = chute.main_solution
    return {
        "source": solution.source,
        "spec": solution.data,
        "case": chute.main,
        **_results(solution, stations, columns),
        **cases_document(chute, _results),
    }


def _results(
    solution: SolvedChute, stations: Mapping[str, Any] | None = None, columns: Sequence[str] = ()
) -> dict[str, Any]:
    """Return the results of one state."""
    segments, edges, shown = [], _edges(solution), _rows(stations, columns)
    for segment, flights in zip(solution.segments, solution.flights, strict=True):
        flown = [_segment(flight, shown) for flight in flights]
        more = {
            "impact": first(segment.impact) or None,
            "strikes_roof": bool(segment.strikes_roof[0]) if segment.impact else None,
            "loads": first(segment.loads) or None,
            "edges": edges[segment.name],
            "flight": flown[0] if flown else None,
            "flights_again": flown[1:],
        }
        segments.append(_segment(segment, shown) | more)
    return {
        "error_estimate": number(solution.error_estimate[0]),
        "status": str(solution.status[0]),
        "inlet": first(solution.inlet, INLET_NUMBERS) | {"edges": edges[""]},
        "exit": first(solution.exit),
        "segments": segments,
        "last_flights": [_segment(flight, shown) for flight in solution.last_flights],
        "receiver": first(solution.receiver) or None,
        "findings": [
            {
                "code": finding.code,
                "severity": finding.severity,
                "segment": finding.segment or None,
                "key": finding.key or None,
                "s_m": number(finding.s_m[0]),
                "message": finding.message(),
                "numbers": first(finding.numbers),
            }
            for finding in solution.findings()
        ],
    }


def _edges(solution: SolvedChute) -> dict[str, list[dict[str, Any]]]:
    """Return the edges of the flights by the segment that the stream leaves; of one from the belt it is empty."""
    found = defaultdict(list)
    for edge in solution.edges:
        numbers = first(edge.numbers, EDGE_NUMBERS)
        found[edge.leaves].append({"name": edge.name, "segment": edge.segment[0] or None, **numbers})
    return found


def _segment(result: SegmentResult, shown: Mapping[str, list[dict[str, Any]]] | None) -> dict[str, Any]:
    """Return a segment or a flight, with its stations if there are any."""
    return {
        "name": result.name,
        "kind": result.kind,
        "status": str(result.status[0]),
        "entry": first(result.entry),
        "exit": first(result.exit),
        "minimum": first(result.minimum),
        "maximum": first(result.maximum),
        "duration_s": number(result.duration[0]),
        "landing_margin_m": number(result.landing_margin[0]),
        "stations": None if shown is None else shown[result.name],
    }


def _rows(stations: Mapping[str, Any] | None, columns: Sequence[str]) -> dict[str, list[dict[str, Any]]] | None:
    """Return the stations that the stream reached by segment or flight, an object each; None if none are asked for."""
    if stations is None:
        return None
    names = [name for name in columns if name not in {"spec", "case", "segment", "kind"}]
    chosen = np.isfinite(stations["s_m"][0])
    values = [numbers(stations[name][0][chosen]) for name in names]
    found = defaultdict(list)
    for segment, *row in zip(stations["segment"][0][chosen].tolist(), *values, strict=True):
        found[segment].append(dict(zip(names, row, strict=True)))
    return found
