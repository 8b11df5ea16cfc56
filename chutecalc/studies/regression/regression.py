"""Check of standard designs against their baselines: what changed, where, and by how much."""

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
    EXTREME_MARGIN,
    STATIONS,
    TOLERANCE,
    Baseline,
    BaselineFinding,
    Row,
    RowKey,
    baseline_of,
    baseline_path,
    column_of,
    read_baseline,
    spec_path,
)

OK, DRIFTED, CHANGED, EDITED = "ok", "drifted", "changed", "edited"
"""Outcomes of a check: as the baseline; numbers differ by more than the tolerance; a segment, a status or a finding has
changed; the spec is not the one that the baseline was written for."""
NO_BASELINE, BROKEN_BASELINE, NO_SPEC = "no_baseline", "broken_baseline", "no_spec"
"""Outcomes without a comparison: the spec has no baseline; the baseline cannot be read; the baseline has no spec."""
FOR_A_PROCESS = 40
"""Designs for each process: they take about twice as long to solve as the process to start."""


class Change(NamedTuple):
    """A difference other than that of a number."""

    kind: str
    """``spec``, ``status``, ``segment`` or ``finding``; ``baseline`` where none can be compared with."""
    segment: str
    """Name of the segment; empty for the whole design."""
    message: str
    """The difference in words."""


class Drift(NamedTuple):
    """A number that differs by more than the tolerance."""

    key: RowKey
    """The row that it stands in."""
    column: str
    """The column that it stands in, which names its unit."""
    s_m: float | None
    """Distance of its station from the inlet, m."""
    was: float | None
    """Value in the baseline, in the column's unit; None where it has none."""
    now: float | None
    """Value now, in the column's unit; None where there is none."""
    off: float
    """|was - now| over the largest of both and the column's scale, a ratio; 1 where only one of both has a value."""


class Verdict(NamedTuple):
    """The result of checking one design."""

    spec: str
    """Path of the spec."""
    outcome: str
    """One of the outcomes above."""
    changes: tuple[Change, ...] = ()
    """Differences other than those of numbers."""
    drifts: tuple[Drift, ...] = ()
    """Numbers that differ, in the order of the flow."""
    notes: tuple[str, ...] = ()
    """Conditions that differ from those of the baseline. They may explain differences; they are none themselves."""
    tolerance: float = TOLERANCE
    """Relative tolerance of the comparison."""
    seconds: float = 0.0
    """Time that the check took, s."""
    document: Mapping[str, Any] | None = None
    """The baseline to write, with ``update`` and where the existing one does not agree."""


def first_and_largest(drifts: Sequence[Drift]) -> list[tuple[Drift, Drift]]:
    """Select the first and the largest drift of each column.

    Args:
        drifts: Drifts in the order of the flow.

    >>> key = RowKey("spoon", 1, "station 1")
    >>> near = Drift(key, "depth_m", s_m=1.0, was=0.1, now=0.101, off=0.01)
    >>> [(first.s_m, largest.s_m) for first, largest in first_and_largest([near, near._replace(s_m=2.0, off=0.02)])]
    [(1.0, 2.0)]
    """
    columns: dict[str, list[Drift]] = {}
    for drift in drifts:
        columns.setdefault(drift.column, []).append(drift)
    return [(found[0], max(found, key=lambda drift: drift.off)) for found in columns.values()]


def compare(
    was: Baseline, now: Baseline, messages: Mapping[BaselineFinding, str] | None = None
) -> tuple[list[Change], list[Drift]]:
    """Compare a stored baseline with the present one.

    A number has drifted where |a - b| > tolerance · max(|a|, |b|, scale). The scale is that of its column in the chute,
    from :meth:`chutecalc.studies.regression.baseline.Baseline.scales`. Numbers of segments that only one of both has
    are not compared, nor are columns that the stored baseline does not have: see :func:`unknown_columns`.

    Args:
        was: The stored baseline, which gives the tolerance.
        now: The baseline that the design gives now.
        messages: Messages of the present findings, to add to changes.

    Returns:
        Changes, and drifts in the order of the flow.

    >>> import chutecalc
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> now = baseline_of(chute, chutecalc.solve(chute), [])
    >>> changes, drifts = compare(now.model_copy(update={"status": "stall"}), now)
    >>> [change.message for change in changes], drifts
    (['the status is ok; in the baseline it is stall'], [])
    """
    before, after = was.visits(), now.visits()
    changes = []
    if was.spec_sha256 != now.spec_sha256:
        message = "the spec has been edited since its baseline was written; if that is intended, run check --update"
        changes.append(Change("spec", "", message))
    if was.status != now.status:
        changes.append(Change("status", "", f"the status is {now.status}; in the baseline it is {was.status}"))
    changes += [
        Change("segment", name, f"segment {name} is in the baseline only")
        for name, number in before
        if (name, number) not in after
    ]
    for visit, segment in after.items():
        name, stored = segment.name, before.get(visit)
        if stored is None:
            changes.append(Change("segment", name, f"segment {name} is not in the baseline"))
        elif segment.kind != stored.kind:
            message = f"segment {name} is a {segment.kind}; in the baseline it is a {stored.kind}"
            changes.append(Change("segment", name, message))
        elif segment.status != stored.status:
            message = f"the status of segment {name} is {segment.status}; in the baseline it is {stored.status}"
            changes.append(Change("status", name, message))
    changes += _findings(was, now, messages or {})
    return changes, list(_drifts(was, now, before.keys() & after.keys()))


def _findings(was: Baseline, now: Baseline, messages: Mapping[BaselineFinding, str]) -> Iterator[Change]:
    """Yield findings that only one of both has."""
    before, after = Counter(was.findings), Counter(now.findings)
    for item in (after - before).elements():
        text = f": {messages[item]}" if item in messages else ""
        yield Change("finding", item.segment, f"new finding: {item.severity} {item.code} in {item.segment}{text}")
    for item in (before - after).elements():
        yield Change(
            "finding", item.segment, f"finding in the baseline only: {item.severity} {item.code} in {item.segment}"
        )


def unknown_columns(was: Baseline, now: Baseline) -> list[str]:
    """List the columns that a stored baseline does not have at all: newer versions of chutecalc may add columns.

    Args:
        was: The stored baseline.
        now: The baseline that the design gives now.
    """
    before = dict(was.rows())
    known = {name for row in before.values() for name in row}
    return list(dict.fromkeys(name for key, row in now.rows() if key in before for name in row if name not in known))


def _drifts(was: Baseline, now: Baseline, common: set[tuple[str, int]]) -> Iterator[Drift]:
    """Yield numbers that differ, in the order of the flow."""
    before, after, scales = dict(was.rows()), dict(now.rows()), was.scales()
    new = {*unknown_columns(was, now)}
    for key in dict.fromkeys([*after, *before]):
        if key.row and (key.segment, key.visit) not in common:
            continue
        stored, present = before.get(key, {}), after.get(key, {})
        for column in (name for name in {**present, **stored} if name not in new):
            a, b = stored.get(column), present.get(column)
            spare = 0.0
            if (a is None or b is None) and key.row in ("minimum", "maximum"):  # only one exceeds the stations
                a = station_extreme(before, key, column) if a is None else a
                b = station_extreme(after, key, column) if b is None else b
                spare = 2.0 * EXTREME_MARGIN
            off = 1.0 if a is None or b is None else abs(a - b) / max(abs(a), abs(b), scales[column_of(column)])
            if off > was.tolerance + spare:
                station = key._replace(row="station 1") if key.row == "impact" else key
                s = after.get(station, {}).get("s_m", before.get(station, {}).get("s_m"))
                yield Drift(key, column, s_m=s, was=a, now=b, off=off)


def station_extreme(rows: Mapping[RowKey, Row], key: RowKey, column: str) -> float | None:
    """Find the smallest or largest value of a column at the stations of a segment.

    Args:
        rows: Rows of a baseline.
        key: The segment's row ``minimum`` or ``maximum``.
        column: Name of the column.

    Returns:
        The value in the column's unit; None where no station has one.

    >>> rows = {RowKey("spoon", 1, f"station {number}"): {"depth_m": 0.1 * number} for number in (1, 2)}
    >>> station_extreme(rows, RowKey("spoon", 1, "maximum"), "depth_m")
    0.2
    """
    names = [key._replace(row=f"station {number}") for number in range(1, len(STATIONS) + 1)]
    values = [rows[name][column] for name in names if column in rows.get(name, {})]
    if not values:
        return None
    return min(values) if key.row == "minimum" else max(values)


def verdict(chute: Chute, rtol: float, update: bool) -> Verdict | SpecError:
    """Check one design against its baseline.

    Args:
        chute: A chute of one design, whose source is the path of its spec.
        rtol: Relative tolerance of the solution, as in :func:`chutecalc.solve`.
        update: Whether to return the baseline to write.

    Returns:
        The verdict, or the error in the spec that only solving it shows.
    """
    start = time.perf_counter()
    path = baseline_path(Path(chute.source))
    was, changes = _stored(path, chute.source)
    try:
        solution = solve(chute, rtol)
    except SpecError as error:
        return error
    findings = solution.findings()
    now = baseline_of(chute, solution, findings, was.tolerance if was else TOLERANCE)
    drifts: list[Drift] = []
    notes: list[str] = []
    if was:
        messages = {stored: item.message() for stored, item in zip(now.findings, findings, strict=True)}
        changes, drifts = compare(was, now, messages)
        if was.chutecalc != now.chutecalc:
            notes.append(f"the baseline was written by chutecalc {was.chutecalc}; this is {now.chutecalc}")
        if new := unknown_columns(was, now):
            notes.append(
                f"not compared, because the baseline does not have it until --update adds it: {', '.join(new)}"
            )
        if was.rtol != now.rtol:
            notes.append(f"solved with rtol {now.rtol:g}; the baseline with {was.rtol:g}")
    outcome = _outcome(changes, drifts, path)
    rewrite = update and (outcome != OK or bool(notes))
    return Verdict(
        spec=chute.source,
        outcome=outcome,
        changes=tuple(changes),
        drifts=tuple(drifts),
        notes=tuple(notes),
        tolerance=now.tolerance,
        seconds=time.perf_counter() - start,
        document=now.document() if rewrite else None,
    )


def _stored(path: Path, spec: str) -> tuple[Baseline | None, list[Change]]:
    """Read the stored baseline, or say why there is none to compare with."""
    if not path.exists():
        return None, [
            Change("baseline", "", f"there is none to compare with. Write it: chutecalc check --update {spec}")
        ]
    try:
        return read_baseline(path), []
    except SpecError as error:
        faults = [Change("baseline", "", line) for line in str(error).splitlines()]
        return None, [*faults, Change("baseline", "", "correct it, or write a new one with --update")]


def _outcome(changes: Sequence[Change], drifts: Sequence[Drift], path: Path) -> str:
    """Return the outcome that differences amount to."""
    kinds = {change.kind for change in changes}
    if "baseline" in kinds:
        return BROKEN_BASELINE if path.exists() else NO_BASELINE
    if "spec" in kinds:
        return EDITED
    return CHANGED if kinds else DRIFTED if drifts else OK


def without_spec(baseline: Path) -> Verdict:
    """Return the verdict on a baseline whose spec does not exist.

    Args:
        baseline: Path of the baseline.

    >>> without_spec(Path("spoon.baseline.toml")).changes[0].message
    'spoon.toml does not exist. Restore it, or delete its baseline'
    """
    message = f"{spec_path(baseline).name} does not exist. Restore it, or delete its baseline"
    return Verdict(str(baseline), NO_SPEC, (Change("baseline", "", message),))


def check(
    chutes: Sequence[Chute], rtol: float = 1e-10, update: bool = False, processes: int | None = None
) -> Iterator[Verdict | SpecError]:
    """Check designs against their baselines.

    Args:
        chutes: Chutes of one design each, whose sources are the paths of their specs.
        rtol: Relative tolerance of the solutions, as in :func:`chutecalc.solve`.
        update: Whether to return the baselines to write.
        processes: Number of processes; by default one, or one for each core where there are enough designs.

    Returns:
        The verdicts in the order of the designs, or the errors in specs that only solving them shows.

    >>> import chutecalc
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "spoon.toml")
    ...     size = path.write_text(chutecalc.STARTER, encoding="utf-8")
    ...     (found,) = check([chutecalc.load(path)])
    >>> found.outcome
    'no_baseline'
    """
    if processes is None:
        processes = min(cores(), len(chutes) // FOR_A_PROCESS)
    return in_processes(partial(verdict, rtol=rtol, update=update), chutes, processes)
