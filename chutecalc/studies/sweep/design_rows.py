"""The rows of a block of a sweep: one for each design, or one for each station of each design."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from chutecalc.api.batch import exits
from chutecalc.api.chute import Chute
from chutecalc.api.solve import solve
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index
from chutecalc.results.columns import AT_EXIT
from chutecalc.results.exits import output_numbers
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.finding import Finding
from chutecalc.studies.sweep.columns import CODES, IMPACT, OwnColumn

EXTREME = {"max": LARGEST, "min": LEAST}
"""Prefixes of columns that are extremes."""


def design_rows(
    variants: Chute, count: int, columns: Sequence[str], rtol: float, own: Mapping[str, OwnColumn] | None = None
) -> Block:
    """Compute a row for each design.

    Args:
        variants: The designs.
        count: Number of designs.
        columns: Names of the columns to compute.
        rtol: Relative tolerance, as in :func:`chutecalc.solve`.
        own: Those of the columns that are of a segment, by name.

    Returns:
        Columns by name, each of shape (count,), with the status of each design.

    Raises:
        SpecError: Designs that cannot be built.

    >>> import chutecalc
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> design_rows(chute, 1, ["exit_velocity_m_s"], 1e-10)["exit_velocity_m_s"].round(3).tolist()
    [6.222]
    """
    impacts = [name for name in columns if name.startswith(f"{IMPACT}_")]
    along = [name for name in columns if name not in impacts]
    by_prefix = {
        prefix: [name.removeprefix(f"{prefix}_") for name in along if name.startswith(f"{prefix}_")]
        for prefix in ("exit", *EXTREME)
    }
    if at_ends(columns):
        ends = exits(variants, rtol, by_prefix["exit"], jobs=1)
        status, ok, error = ends.status, ends.ok, ends.error_estimate
        exit_, belt = ends.exit, ends.receiver
        numbers: Block = {}
    else:
        run = solve(variants, rtol)
        status, ok, error = run.status, run.ok, run.error_estimate
        exit_ = run.exit_columns(by_prefix["exit"])
        belt = run.receiver if any(name.startswith("receiver_") for name in columns) else {}
        extremes = [(name, EXTREME[prefix]) for prefix in EXTREME for name in by_prefix[prefix]]
        keys = [f"{prefix}_{name}" for prefix in EXTREME for name in by_prefix[prefix]]
        numbers = dict(zip(keys, run.trajectory.extreme_columns(extremes).values(), strict=True))
        struck = run.trajectory.greatest_impacts([name.removeprefix(f"{IMPACT}_") for name in impacts])
        numbers |= {f"{IMPACT}_{name}": values for name, values in struck.items()}
    numbers |= output_numbers(exit_, belt, error)
    coded = {name: severities for name, severities in CODES.items() if name in columns}
    findings = run.findings() if coded else []
    texts: Block = {
        name: _codes([finding for finding in findings if finding.severity in severities], run.count)
        for name, severities in coded.items()
    }
    segments = run.segments if own else ()
    for name, (number, column) in (own or {}).items():
        (numbers if column.dimension else texts)[name] = column.of(segments[number])
    block: Block = {"status": status}
    for name in columns:
        block[name] = texts[name] if name in texts else np.where(ok, numbers[name], np.nan)
    return {name: np.broadcast_to(values, count) for name, values in block.items()}


def station_rows(
    variants: Chute, rows: Index, columns: Sequence[str], rtol: float, points: int | None, spacing: float | None
) -> tuple[Index, Block]:
    """Compute a row for each station that the stream of a design reaches.

    Args:
        variants: The designs.
        rows: Number of each design in the sweep.
        columns: Names of the columns to compute.
        rtol: Relative tolerance, as in :func:`chutecalc.solve`.
        points: Number of stations of each segment, as in :meth:`chutecalc.Solution.stations`.
        spacing: Spacing of stations, m, as in :meth:`chutecalc.Solution.stations`.

    Returns:
        The number of the design of each row, and columns by name, with the status of each design.

    Raises:
        SpecError: Designs that cannot be built.
    """
    run = solve(variants, rtol)
    table = run.stations(points, spacing, [*columns, "s_m"])
    table["status"] = run.status[:, None]
    shape = (len(rows), table["s_m"].shape[1])
    there = np.isfinite(np.broadcast_to(table["s_m"], shape))
    numbers = np.broadcast_to(rows[:, None], shape)[there]
    return numbers, {name: np.broadcast_to(table[name], shape)[there] for name in ("status", *columns)}


def at_ends(columns: Sequence[str]) -> bool:
    """Return whether all columns are those of the end of the chute, so that nothing before it must be computed.

    Args:
        columns: Names of the columns.
    """
    last = {f"exit_{name}" for name in AT_EXIT}
    return all(name in last or name == "error_estimate" or name.startswith("receiver_") for name in columns)


def _codes(findings: Sequence[Finding], count: int) -> Any:
    """Return the codes of each design's findings, each once, with blanks between them."""
    codes: list[dict[str, None]] = [{} for _ in range(count)]
    for finding in findings:
        for k in np.flatnonzero(finding.mask):
            codes[k][finding.code] = None
    return np.array([" ".join(own) for own in codes])
