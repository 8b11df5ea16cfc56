"""Check of standard designs against their baselines."""

import time
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.errors import SpecError
from chutecalc.runtime import cores, in_processes
from chutecalc.studies.regression.baseline import TOLERANCE, Baseline
from chutecalc.studies.regression.compare import compare, unknown_columns
from chutecalc.studies.regression.record import baseline_of, baseline_path, is_replaceable, read_baseline
from chutecalc.studies.regression.verdict import (
    BROKEN_BASELINE,
    CHANGED,
    DRIFTED,
    EDITED,
    NO_BASELINE,
    OK,
    Change,
    Drift,
    Verdict,
)

FOR_A_PROCESS = 40
"""Designs for each process: they take about twice as long to solve as the process to start."""


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
        cases = {name: solve(case, rtol) for name, case in chute.cases.items()}
    except SpecError as error:
        return error
    findings = solution.findings()
    now = baseline_of(chute, solution, findings, was.tolerance if was else TOLERANCE, cases)
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
    rewrite = update and (outcome != OK or bool(notes)) and (was is not None or is_replaceable(path))
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
        of_file = all(not fault.path and fault.line is None for fault in error.faults)  # with remedies for a spec
        lines = [f"{path}: {fault.problem}" for fault in error.faults] if of_file else str(error).splitlines()
        faults = [Change("baseline", "", line) for line in lines]
        remedy = (
            "correct it, or write a new one with --update"
            if is_replaceable(path)
            else "it is no baseline of chutecalc, and --update leaves it alone: give it another name, or delete it"
        )
        return None, [*faults, Change("baseline", "", remedy)]


def _outcome(changes: Sequence[Change], drifts: Sequence[Drift], path: Path) -> str:
    """Return the outcome that differences amount to."""
    kinds = {change.kind for change in changes}
    if "baseline" in kinds:
        return BROKEN_BASELINE if path.exists() else NO_BASELINE
    if "spec" in kinds:
        return EDITED
    return CHANGED if kinds else DRIFTED if drifts else OK


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
