"""Comparison of a stored baseline with the present one: what changed, where, and by how much."""

from collections import Counter
from collections.abc import Iterator, Mapping

from chutecalc.studies.regression.baseline import (
    EXTREME_MARGIN,
    STATIONS,
    Baseline,
    BaselineFinding,
    Row,
    RowKey,
    column_of,
)
from chutecalc.studies.regression.verdict import Change, Drift


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
    >>> from chutecalc.studies.regression.record import baseline_of
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
    changes += _states(was, now)
    changes += [
        Change("segment", name, f"segment {name} is in the baseline only")
        for name, number in before
        if (name, number) not in after
    ]
    for visit, segment in after.items():
        name, stored = visit[0], before.get(visit)
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


def _states(was: Baseline, now: Baseline) -> Iterator[Change]:
    """Yield the statuses that differ, of the design point and of cases."""
    before, after = was.states(), now.states()
    for name in dict.fromkeys([*before, *after]):
        stored, present = (states[name].status if name in states else "not there" for states in (before, after))
        if stored != present:
            yield Change("status", "", f"{name}the status is {present}; in the baseline it is {stored}")


def _findings(was: Baseline, now: Baseline, messages: Mapping[BaselineFinding, str]) -> Iterator[Change]:
    """Yield findings that only one of both has."""
    before, after = (
        Counter((name, item) for name, state in baseline.states().items() for item in state.findings)
        for baseline in (was, now)
    )
    for name, item in (after - before).elements():
        text = f": {messages[item]}" if item in messages else ""
        where = name + item.segment
        yield Change("finding", where, f"new finding: {item.severity} {item.code} in {where}{text}")
    for name, item in (before - after).elements():
        where = name + item.segment
        yield Change("finding", where, f"finding in the baseline only: {item.severity} {item.code} in {where}")


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
