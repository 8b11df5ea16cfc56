"""Whether standard designs still come out as their baselines say: what drifted, where, and by how much."""

import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from chutecalc.api.chute import Chute, solve
from chutecalc.errors import SpecError
from chutecalc.runtime import cores, in_processes
from chutecalc.studies.regression.baseline import (
    BEYOND,
    STATIONS,
    TOLERANCE,
    Baseline,
    KeptFinding,
    Place,
    Row,
    baseline_of,
    baseline_path,
    column_of,
    read_baseline,
    spec_path,
)

OK, DRIFTED, CHANGED, EDITED = "ok", "drifted", "changed", "edited"
"""Outcomes of a check: as the baseline says; numbers are off by more than the tolerance; a segment, an outcome or a
finding is not what it was; the spec is not the one of the baseline."""
NO_BASELINE, BROKEN_BASELINE, NO_SPEC = "no_baseline", "broken_baseline", "no_spec"
"""There is nothing to hold the spec to; what there is cannot be read; a baseline stands without its spec."""
FOR_A_PROCESS = 40  # designs, which take about twice as long to solve as a process to start


class Change(NamedTuple):
    """Something other than a number that is not what it was."""

    kind: str
    """``spec``, ``status``, ``segment`` or ``finding``; ``baseline`` where there is none to compare with."""
    segment: str
    """Empty for the whole design."""
    message: str


class Drift(NamedTuple):
    """A number that is off by more than the tolerance."""

    place: Place
    column: str
    s_m: float | None
    """Of its station, m from the inlet."""
    was: float | None
    """None where the quantity did not exist."""
    now: float | None
    off: float
    """|was − now| over the larger of both and of the column's scale; 1 where it came to be, or ceased to."""


class Verdict(NamedTuple):
    """What the check of one design found."""

    spec: str
    outcome: str
    changes: tuple[Change, ...] = ()
    drifts: tuple[Drift, ...] = ()
    notes: tuple[str, ...] = ()
    """Other conditions than those of the baseline, which explain differences and are none themselves."""
    tolerance: float = TOLERANCE
    seconds: float = 0.0
    document: Mapping[str, Any] | None = None
    """The baseline to write, where that was asked for and the one there is does not hold."""


def worst(drifts: Sequence[Drift]) -> list[tuple[Drift, Drift]]:
    """For each column that is off, the first drift along the way and the largest."""
    columns: dict[str, list[Drift]] = {}
    for drift in drifts:
        columns.setdefault(drift.column, []).append(drift)
    return [(found[0], max(found, key=lambda drift: drift.off)) for found in columns.values()]


def compare(
    was: Baseline, now: Baseline, said: Mapping[KeptFinding, str] | None = None
) -> tuple[list[Change], list[Drift]]:
    """Differences between what a baseline holds and what comes out now; ``said`` is what the findings say now.

    A number has drifted where |a − b| > tolerance · max(|a|, |b|, scale), with the scale of its column in this chute,
    as :meth:`Baseline.scales` has it. Numbers of segments that only one of both has are not listed, and no columns that
    the baseline does not know: see :func:`unknown`.
    """
    then, today = was.visits(), now.visits()
    changes = []
    if was.spec_sha256 != now.spec_sha256:
        changes.append(Change("spec", "", "the spec has been edited since its baseline was written"))
    if was.status != now.status:
        changes.append(Change("status", "", f"the design ends with {now.status}, and did with {was.status}"))
    changes += [Change("segment", here[0], f"segment {here[0]} is gone") for here in then if here not in today]
    for here, segment in today.items():
        name = segment.name
        if here not in then:
            changes.append(Change("segment", name, f"segment {name} is not in the baseline"))
        elif segment.kind != then[here].kind:
            changes.append(Change("segment", name, f"segment {name} is a {segment.kind}, and was a {then[here].kind}"))
        elif segment.status != then[here].status:
            message = f"segment {name} ends with {segment.status}, and did with {then[here].status}"
            changes.append(Change("status", name, message))
    changes += _findings(was, now, said or {})
    return changes, list(_drifts(was, now, then.keys() & today.keys()))


def _findings(was: Baseline, now: Baseline, said: Mapping[KeptFinding, str]) -> Iterator[Change]:
    """Findings that are new, and those that are gone."""
    then, today = Counter(was.findings), Counter(now.findings)
    for item in (today - then).elements():
        text = f": {said[item]}" if item in said else ""
        yield Change("finding", item.segment, f"finding new: {item.severity} {item.code} in {item.segment}{text}")
    for item in (then - today).elements():
        yield Change("finding", item.segment, f"finding gone: {item.severity} {item.code} in {item.segment}")


def unknown(was: Baseline, now: Baseline) -> list[str]:
    """Columns that come out now and stand nowhere in the baseline: newer versions tell more than older ones."""
    then = dict(was.rows())
    known = {name for row in then.values() for name in row}
    return list(dict.fromkeys(name for at, row in now.rows() if at in then for name in row if name not in known))


def _drifts(was: Baseline, now: Baseline, common: set[tuple[str, int]]) -> Iterator[Drift]:
    """Numbers that are off, along the way."""
    then, today, scales = dict(was.rows()), dict(now.rows()), was.scales()
    new = {*unknown(was, now)}
    for place in dict.fromkeys([*today, *then]):
        if place.row and (place.segment, place.visit) not in common:
            continue
        before, after = then.get(place, {}), today.get(place, {})
        for column in (name for name in {**after, **before} if name not in new):
            a, b = before.get(column), after.get(column)
            spare = 0.0
            if (a is None or b is None) and place.row in ("minimum", "maximum"):  # kept by one where it passes stations
                a = station_extreme(then, place, column) if a is None else a
                b = station_extreme(today, place, column) if b is None else b
                spare = 2.0 * BEYOND
            off = 1.0 if a is None or b is None else abs(a - b) / max(abs(a), abs(b), scales[column_of(column)])
            if off > was.tolerance + spare:
                station = place._replace(row="station 1") if place.row == "impact" else place
                s = today.get(station, {}).get("s_m", then.get(station, {}).get("s_m"))
                yield Drift(place, column, s, a, b, off)


def station_extreme(rows: Mapping[Place, Row], place: Place, column: str) -> float | None:
    """The least or largest value of a column at the stations of a segment; None where there is none."""
    names = [place._replace(row=f"station {number}") for number in range(1, len(STATIONS) + 1)]
    values = [rows[name][column] for name in names if column in rows.get(name, {})]
    if not values:
        return None
    return min(values) if place.row == "minimum" else max(values)


def verdict(chute: Chute, rtol: float, update: bool) -> Verdict | SpecError:
    """What the check of one design finds, or the fault that shows only in solving it.

    Args:
        chute: of one design; its source is its file.
        rtol: see :func:`chutecalc.solve`.
        update: whether a baseline to write is wanted.
    """
    start = time.perf_counter()
    path = baseline_path(Path(chute.source))
    was, changes = _kept(path, chute.source)
    try:
        solution = solve(chute, rtol)
    except SpecError as error:
        return error
    findings = solution.findings()
    now = baseline_of(chute, solution, findings, was.tolerance if was else TOLERANCE)
    drifts: list[Drift] = []
    notes: list[str] = []
    if was:
        said = {kept: item.message() for kept, item in zip(now.findings, findings, strict=True)}
        changes, drifts = compare(was, now, said)
        if was.chutecalc != now.chutecalc:
            notes.append(f"the baseline is of chutecalc {was.chutecalc}, this is {now.chutecalc}")
        if new := unknown(was, now):
            notes.append(f"not in the baseline, and not compared until --update adds it: {', '.join(new)}")
        if was.rtol != now.rtol:
            notes.append(f"solved to an rtol of {now.rtol:g}, the baseline to {was.rtol:g}")
    outcome = _outcome(changes, drifts, path)
    wanted = update and (outcome != OK or bool(notes))
    return Verdict(
        spec=chute.source,
        outcome=outcome,
        changes=tuple(changes),
        drifts=tuple(drifts),
        notes=tuple(notes),
        tolerance=now.tolerance,
        seconds=time.perf_counter() - start,
        document=now.document() if wanted else None,
    )


def _kept(path: Path, spec: str) -> tuple[Baseline | None, list[Change]]:
    """The baseline, or why there is none to compare with."""
    if not path.exists():
        return None, [Change("baseline", "", f"there is none to hold it to; chutecalc check --update {spec} writes it")]
    try:
        return read_baseline(path), []
    except SpecError as error:
        faults = [Change("baseline", "", line) for line in str(error).splitlines()]
        return None, [*faults, Change("baseline", "", "mend it, or write it anew with --update")]


def _outcome(changes: Sequence[Change], drifts: Sequence[Drift], path: Path) -> str:
    """The one word for it."""
    kinds = {change.kind for change in changes}
    if "baseline" in kinds:
        return BROKEN_BASELINE if path.exists() else NO_BASELINE
    if "spec" in kinds:
        return EDITED
    return CHANGED if kinds else DRIFTED if drifts else OK


def without_spec(baseline: Path) -> Verdict:
    """The verdict on a baseline whose spec is gone: nothing holds what it says any more."""
    message = f"{spec_path(baseline).name} is gone: bring it back, or remove its baseline too"
    return Verdict(str(baseline), NO_SPEC, (Change("baseline", "", message),))


def check(
    chutes: Sequence[Chute], rtol: float = 1e-10, update: bool = False, processes: int | None = None
) -> Iterator[Verdict | SpecError]:
    """The verdicts on designs, in their order.

    Args:
        chutes: of one design each, their sources being their files.
        rtol: see :func:`chutecalc.solve`.
        update: whether baselines to write are wanted.
        processes: how many share the work; without it one, or one a core where there are enough designs.
    """
    if processes is None:
        processes = min(cores(), len(chutes) // FOR_A_PROCESS)
    return in_processes(partial(verdict, rtol=rtol, update=update), chutes, processes)
