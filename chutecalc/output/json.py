"""A run as JSON: full double precision, null where a quantity does not exist."""

import json
import math
from collections.abc import Mapping
from typing import IO, Any

from chutecalc import __version__
from chutecalc.results.columns import COLUMNS
from chutecalc.results.segments import SegmentResult
from chutecalc.results.solved import SolvedChute

FORMAT = 1


def write_run(stream: IO[str], documents: list[dict[str, Any]]) -> None:
    """Writes one run as an object, several as a list."""
    json.dump(documents[0] if len(documents) == 1 else documents, stream, indent=2, allow_nan=False, ensure_ascii=False)
    stream.write("\n")


def run_document(solution: SolvedChute, stations: Mapping[str, Any] | None) -> dict[str, Any]:
    """One solved chute as JSON's own types.

    Args:
        solution: of one design.
        stations: what :meth:`chutecalc.Solution.stations` gave, where they are asked for.
    """
    segments = []
    for segment, flights in zip(solution.segments, solution.flights, strict=True):
        entry = _way(segment, stations)
        if segment.impact:
            entry["impact"] = _first(segment.impact)
        if flights:
            entry["flight"], *again = (_way(flight, stations) for flight in flights)
            entry |= {"flights_again": again} if again else {}
        segments.append(entry)
    return {
        "chutecalc": __version__,
        "format": FORMAT,
        "source": solution.source,
        "spec": solution.data,
        "tolerance": solution.rtol,
        "error_estimate": _number(solution.error_estimate[0]),
        "status": str(solution.status[0]),
        "inlet": _first(solution.inlet),
        "exit": _first(solution.exit),
        "segments": segments,
        "receiver": _first(solution.receiver) or None,
        "findings": [
            {
                "code": finding.code,
                "severity": finding.severity,
                "segment": finding.segment,
                "s_m": _number(finding.s_m[0]),
                "message": finding.message(),
                "numbers": _first(finding.numbers),
            }
            for finding in solution.findings()
        ],
    }


def _way(way: SegmentResult, stations: Mapping[str, Any] | None) -> dict[str, Any]:
    """A segment or a flight."""
    entry = {
        "name": way.name,
        "kind": way.kind,
        "status": str(way.status[0]),
        "entry": _first(way.entry),
        "exit": _first(way.exit),
        "minimum": _first(way.minimum),
        "maximum": _first(way.maximum),
        "duration_s": _number(way.duration[0]),
    }
    return entry if stations is None else entry | {"stations": _rows(stations, way.name)}


def _first(numbers: Mapping[str, Any]) -> dict[str, float | None]:
    """The first design's numbers."""
    return {name: _number(values[0]) for name, values in numbers.items()}


def _rows(stations: Mapping[str, Any], part: str) -> list[dict[str, float | None]]:
    """The stations of one part that the stream reached, an object each."""
    names = [name for name in COLUMNS if name in stations and name not in {"segment", "kind"}]
    chosen = (stations["segment"][0] == part) & (stations["s_m"][0] == stations["s_m"][0])
    columns = [stations[name][0][chosen].tolist() for name in names]
    return [
        {name: _number(value) for name, value in zip(names, row, strict=True)} for row in zip(*columns, strict=True)
    ]


def _number(value: float) -> float | None:
    """A number, or null."""
    return float(value) if math.isfinite(value) else None
