"""Baselines of solved designs, recorded from a solution or read from a file."""

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from chutecalc import __version__
from chutecalc.api.chute import Chute
from chutecalc.api.solution import Solution
from chutecalc.errors import SpecError
from chutecalc.results.columns import NUMERIC
from chutecalc.results.finding import Finding
from chutecalc.spec.faults import faults_of
from chutecalc.spec.parse import parse_text, read_text
from chutecalc.spec.reader import BASELINE_SUFFIX, read_bytes
from chutecalc.studies.regression.baseline import (
    EXTREME_MARGIN,
    RECEIVER,
    STATIONS,
    TOLERANCE,
    Baseline,
    BaselineFinding,
    BaselineSegment,
    Row,
    State,
)


def baseline_path(spec: Path) -> Path:
    """Return the path of the baseline of a spec.

    Args:
        spec: Path of the spec.

    >>> baseline_path(Path("spoon.toml")).name
    'spoon.baseline.toml'
    """
    return spec.with_name(spec.name.removesuffix(".toml") + BASELINE_SUFFIX)


def spec_path(baseline: Path) -> Path:
    """Return the path of the spec of a baseline.

    Args:
        baseline: Path of the baseline.

    >>> spec_path(Path("spoon.baseline.toml")).name
    'spoon.toml'
    """
    return baseline.with_name(baseline.name.removesuffix(BASELINE_SUFFIX) + ".toml")


def spec_hash(data: Mapping[str, Any]) -> str:
    """Compute the hash of the parsed content of a spec, whatever its comments, layout and line ends.

    A checkout that changes line ends passes, and a better comment needs no new baseline.

    Args:
        data: The parsed content.

    >>> spec_hash({"b": 1, "a": 2}) == spec_hash({"a": 2, "b": 1})
    True
    """
    text = json.dumps(data, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def baseline_of(
    chute: Chute,
    solution: Solution,
    findings: Sequence[Finding],
    tolerance: float = TOLERANCE,
    cases: Mapping[str, Solution] | None = None,
) -> Baseline:
    """Return the baseline of a solved design, unrounded.

    Args:
        chute: A chute of one design.
        solution: Its solution.
        findings: The findings of the solution.
        tolerance: Relative tolerance of the comparison.
        cases: Solutions of its cases by name.

    >>> import chutecalc
    >>> spoon = chutecalc.parse(chutecalc.STARTER)
    >>> baseline_of(spoon, chutecalc.solve(spoon), []).segments[1].stations[4]["velocity_m_s"].__round__(3)
    6.222
    """
    return Baseline(
        format=1,
        chutecalc=__version__,
        spec_sha256=spec_hash(chute.data),
        rtol=solution.rtol,
        tolerance=tolerance,
        **_state(solution, findings),
        cases={name: State(**_state(each, each.findings())) for name, each in (cases or {}).items()},
    )


def _state(solution: Solution, findings: Sequence[Finding]) -> dict[str, Any]:
    """Return the results in one operating state by the names of the fields of a baseline."""
    segments = []
    for result, part in zip(solution.trajectory.results, solution.trajectory.parts, strict=True):
        columns = part.at(STATIONS, NUMERIC)
        stations = [_finite({name: columns[name][k] for name in NUMERIC}) for k in range(len(STATIONS))]
        segments.append(
            BaselineSegment(
                name=result.name,
                kind=result.kind,
                status=str(result.status[0]),
                impact=_finite(result.impact),
                loads=_finite(result.loads),
                stations=[station for station in stations if station],
                minimum=_beyond(result.minimum, stations, -1.0),
                maximum=_beyond(result.maximum, stations, 1.0),
            )
        )
    return {
        "status": str(solution.status[0]),
        "findings": [
            BaselineFinding(severity=item.severity, code=item.code, segment=item.subject) for item in findings
        ],
        "inlet": _finite(solution.inlet),
        "segments": segments,
        "receiver": _finite({name: values for name, values in solution.receiver.items() if name in RECEIVER}),
    }


def _finite(numbers: Mapping[str, Any]) -> Row:
    """Return the numbers of the first design, without NaN."""
    return {name: float(values[0]) for name, values in numbers.items() if np.isfinite(values[0])}


def _beyond(extremes: Mapping[str, Any], stations: Sequence[Row], sign: float) -> Row:
    """Return the extremes that no station shows; beside a station that does, an extreme is rounding."""
    return {
        name: value
        for name, value in _finite(extremes).items()
        if all(sign * (value - row[name]) > EXTREME_MARGIN * abs(value) for row in stations if name in row)
    }


def is_replaceable(path: Path) -> bool:
    """Return whether what stands at a path may be written over: nothing in it, or a baseline that may be damaged.

    A spec, say, that somebody has named after another one is not to be lost. What is no file, or a link to another
    name, is refused where it is written.

    Args:
        path: Path of the baseline.
    """
    try:
        return (
            not path.is_file()
            or not path.stat().st_size
            or not path.resolve().name.endswith(BASELINE_SUFFIX)
            or b"spec_sha256" in read_bytes(path)
        )
    except (SpecError, OSError):
        return False


def read_baseline(path: Path) -> Baseline:
    """Read a baseline from its file.

    Args:
        path: Path of the baseline.

    Raises:
        SpecError: The file cannot be read; otherwise all faults in it.
    """
    text = read_text(path)
    data = parse_text(text, str(path))
    try:
        return Baseline.model_validate(data)
    except ValidationError as error:
        raise SpecError(faults_of(error, data, text), str(path)) from None
