"""Sweeps: a row for each of many designs, computed in independent blocks."""

import hashlib
import json
from collections import deque
from collections.abc import Generator, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from functools import cached_property
from typing import Any

import numpy as np

from chutecalc import __version__
from chutecalc.api.batch import CHUNK, exits
from chutecalc.api.chute import Chute, check_tolerance, solve
from chutecalc.api.solution import Solution
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index
from chutecalc.results.columns import AT_EXIT, AT_STATION, closest
from chutecalc.results.exits import output_numbers
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.runtime import cores
from chutecalc.studies.sweep.adjustment import SectionAdjustment
from chutecalc.studies.sweep.block import IMPOSSIBLE, TEXT, Top, select_rows
from chutecalc.studies.sweep.columns import PREFIXES, row_columns
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.parameters import Parameter

DEFAULT = ("exit_velocity_m_s", "exit_depth_m", "exit_slope_deg", "max_depth_m", "min_velocity_m_s")
EXTREME = {"max": LARGEST, "min": LEAST}
"""Prefixes of columns that are extremes."""
WITH_FINDINGS, STATIONS = 1024, 262_144
"""Designs of a block with findings, and stations of a block, roughly. Other blocks are one chunk of a batch."""


class Sweep:
    """Variants of a chute, and the columns to compute for them.

    >>> import chutecalc
    >>> from chutecalc.studies.sweep.parameters import Parameter
    >>> chute = chutecalc.parse(chutecalc.STARTER)
    >>> path = "flow.rate_t_h"
    >>> sweep = Sweep(chute, [Parameter(path, (path,), np.array([500.0, 1000.0]))], columns=["exit_velocity_m_s"])
    >>> sweep.block(0)["exit_velocity_m_s"].round(3).tolist()
    [3.963, 3.878]
    """

    def __init__(
        self,
        chute: Chute,
        parameters: Sequence[Parameter],
        parallel: bool = False,
        keep: str = "base",
        columns: Sequence[str] = (),
        top: Top | None = None,
        points: int | None = None,
        spacing: float | None = None,
        rtol: float = 1e-10,
    ) -> None:
        """Check the arguments; nothing is solved yet.

        Args:
            chute: A chute of one design.
            parameters: The parameters to vary, at least one.
            parallel: Whether their lists run side by side instead of in all combinations.
            keep: Dimension of a section that is constant while its chamfer angle varies: ``base``, ``width`` or
                ``depth``.
            columns: Names of the columns to compute, from :func:`~chutecalc.studies.sweep.columns.row_columns`, or
                a station's columns with ``points`` or ``spacing``.
            top: The rows to select; all by default.
            points: Number of stations of each segment, as in :meth:`chutecalc.Solution.stations`; rows are stations
                then.
            spacing: Spacing of stations, m, as in :meth:`chutecalc.Solution.stations`; rows are stations then.
            rtol: Relative tolerance, as in :func:`chutecalc.solve`.

        Raises:
            UsageError: Arguments that do not go together.
            SpecError: All paths that are not in the spec and all values that are out of bounds.
        """
        check_tolerance(rtol)
        self.chute, self.rtol, self.top, self.points, self.spacing = chute, rtol, top, points, spacing
        self.parameters, self.parallel, self.keep = tuple(parameters), parallel, keep
        self.profiles = points is not None or spacing is not None
        self.grid = Grid(parameters, parallel)
        self.columns = self._columns(columns)
        self._check_values()
        self.adjustment = SectionAdjustment(chute, [path for parameter in parameters for path in parameter.paths], keep)
        if self.top and self.profiles:
            raise UsageError("--top selects designs. It cannot be used with --points or --stations")
        if self.top and self.top.column not in self.header:
            self.columns = self._columns([*self.columns, self.top.column])
        if self.top and self.top.column in TEXT:
            raise UsageError(f"--by needs a column of numbers, not {self.top.column}")

    @property
    def count(self) -> int:
        """Number of designs."""
        return self.grid.count

    @property
    def header(self) -> list[str]:
        """Names of the columns of a row."""
        return [*(parameter.name for parameter in self.parameters), "status", *self.columns]

    @cached_property
    def block_size(self) -> int:
        """Number of designs in a block."""
        if self.profiles:
            stations = int(solve(self.chute, self.rtol).stations(self.points, self.spacing, ["s_m"])["s_m"].size)
            return max(1, min(CHUNK, STATIONS // max(stations, 1)))
        return WITH_FINDINGS if "findings" in self.columns else CHUNK

    @property
    def block_count(self) -> int:
        """Number of blocks."""
        return -(-self.count // self.block_size)

    def identity(self) -> dict[str, Any]:
        """Return everything that determines the rows, with the version of chutecalc.

        Blocks of two sweeps are interchangeable where these are equal.
        """
        values = [hashlib.sha256(parameter.values.tobytes()).hexdigest() for parameter in self.parameters]
        return {
            "chutecalc": __version__,
            "spec": json.loads(json.dumps(self.chute.data)),
            "parameters": [
                [parameter.name, list(parameter.paths), len(parameter.values), digest]
                for parameter, digest in zip(self.parameters, values, strict=True)
            ],
            "zip": self.parallel,
            "keep": self.keep,
            "columns": self.columns,
            "top": list(self.top) if self.top else None,
            "stations": [self.points, self.spacing],
            "tolerance": self.rtol,
            "block": self.block_size,
        }

    def blocks(self, numbers: Iterable[int], jobs: int | None = None) -> Generator[tuple[int, Block], None, None]:
        """Solve blocks in threads, a few ahead of the one yielded.

        Args:
            numbers: Numbers of the blocks, from 0.
            jobs: Number of threads; one for each core by default. The rows do not depend on it.

        Yields:
            Number and rows of each block, in the order of ``numbers``.
        """
        threads = jobs or cores()
        waiting: deque[tuple[int, Future[Block]]] = deque()
        with ThreadPoolExecutor(threads) as pool:
            try:
                for number in numbers:
                    waiting.append((number, pool.submit(self.block, number)))
                    if len(waiting) > threads:
                        yield waiting[0][0], waiting.popleft()[1].result()
                while waiting:
                    yield waiting[0][0], waiting.popleft()[1].result()
            finally:
                for _, future in waiting:
                    future.cancel()

    def block(self, number: int) -> Block:
        """Solve one block.

        Args:
            number: Number of the block, from 0.

        Returns:
            Its rows in the order of the grid, or the best of them with ``top``.
        """
        first = number * self.block_size
        rows = np.arange(first, min(first + self.block_size, self.count))
        pieces = list(self._pieces(rows))
        order: Index | slice
        if len(pieces) == 1 and pieces[0][0] is rows:  # all there, and in their order
            numbers, order, missing = rows, slice(None), rows[:0]
        else:
            solved = np.concatenate([rows[:0], *(numbers for numbers, _ in pieces)])
            missing = np.setdiff1d(rows, solved)
            numbers = np.concatenate([solved, missing])
            order = np.argsort(numbers, kind="stable")
        given = zip(self.parameters, self.grid.at(rows), strict=True)
        block: Block = {
            parameter.name: np.broadcast_to(values, len(rows))[numbers[order] - first] for parameter, values in given
        }
        for name in ("status", *self.columns):
            empty = np.full(len(missing), IMPOSSIBLE if name == "status" else "" if name in TEXT else np.nan)
            block[name] = np.concatenate([*(piece[name] for _, piece in pieces), empty])[order]
        return block if self.top is None else select_rows(block, np.sort(self.top.best(block)))

    def _pieces(self, rows: Index) -> Iterator[tuple[Index, Block]]:
        """Yield numbers and columns of rows, without designs that cannot be built."""
        given = zip(self.parameters, self.grid.at(rows), strict=True)
        changes, possible = self.adjustment.apply(
            {path: values for each, values in given for path in each.paths}, len(rows)
        )
        if not possible.all():
            if possible.any():
                yield from self._pieces(rows[possible])
            return
        try:
            variants = self.chute.vary(changes)
            piece = self._stations(rows, variants) if self.profiles else (rows, self._designs(variants, len(rows)))
        except SpecError as error:
            if error.designs is not None:
                rest = rows[~np.broadcast_to(error.designs, len(rows))]
                yield from self._pieces(rest) if rest.size else ()
            elif len(rows) > 1:
                half = len(rows) // 2
                yield from self._pieces(rows[:half])
                yield from self._pieces(rows[half:])
        else:
            yield piece

    def _designs(self, variants: Chute, count: int) -> Block:
        """Compute a row for each design."""
        by_prefix = {
            prefix: [name.removeprefix(f"{prefix}_") for name in self.columns if name.startswith(f"{prefix}_")]
            for prefix in PREFIXES
        }
        if self._at_ends:
            ends = exits(variants, self.rtol, by_prefix["exit"], jobs=1)
            status, ok, error = ends.status, ends.ok, ends.error_estimate
            exit_, belt = ends.exit, ends.receiver
            numbers: Block = {}
        else:
            run = solve(variants, self.rtol)
            status, ok, error = run.status, run.ok, run.error_estimate
            exit_ = run.exit_columns(by_prefix["exit"])
            belt = run.receiver if any(name.startswith("receiver_") for name in self.columns) else {}
            extremes = [(name, EXTREME[prefix]) for prefix in EXTREME for name in by_prefix[prefix]]
            keys = [f"{prefix}_{name}" for prefix in EXTREME for name in by_prefix[prefix]]
            numbers = dict(zip(keys, run.trajectory.extreme_columns(extremes).values(), strict=True))
        numbers |= output_numbers(exit_, belt, error)
        block: Block = {"status": status}
        for name in self.columns:
            block[name] = _codes(run) if name == "findings" else np.where(ok, numbers[name], np.nan)
        return {name: np.broadcast_to(values, count) for name, values in block.items()}

    def _stations(self, rows: Index, variants: Chute) -> tuple[Index, Block]:
        """Compute a row for each station that the stream of a design reaches."""
        run = solve(variants, self.rtol)
        table = run.stations(self.points, self.spacing, [*self.columns, "s_m"])
        table["status"] = run.status[:, None]
        shape = (len(rows), table["s_m"].shape[1])
        there = np.isfinite(np.broadcast_to(table["s_m"], shape))
        numbers = np.broadcast_to(rows[:, None], shape)[there]
        return numbers, {name: np.broadcast_to(table[name], shape)[there] for name in ("status", *self.columns)}

    @cached_property
    def _at_ends(self) -> bool:
        """Whether all columns are those of the end of the chute, so that nothing before it must be computed."""
        last = {f"exit_{name}" for name in AT_EXIT}
        return all(name in last or name == "error_estimate" or name.startswith("receiver_") for name in self.columns)

    def _columns(self, names: Sequence[str]) -> list[str]:
        """Return the columns asked for, each once, without those that every row has."""
        known = AT_STATION if self.profiles else row_columns()
        usual = AT_STATION if self.profiles else DEFAULT
        unknown = [name for name in names if name not in known and name != "status"]
        if unknown:
            own = (
                "Use the columns of a station" if self.profiles else "Use exit_, max_ or min_ before a station's column"
            )
            plural = "s" if len(unknown) > 1 else ""
            raise UsageError(
                f"unknown column{plural} {', '.join(unknown)}. {closest(unknown, known)}{own}; chutecalc columns lists"
                " them all"
            )
        belt = [name for name in names if name.startswith("receiver_")]
        if belt and self.chute.spec.receiver is None:
            raise UsageError(f"{belt[0]}: the spec has no [receiver]")
        return [name for name in dict.fromkeys(names or usual) if name != "status"]

    def _check_values(self) -> None:
        """Check that every path is in the spec and takes its values, whatever they make together.

        Raises:
            SpecError: All faults.
        """
        first = {path: each.values[:1] for each in self.parameters for path in each.paths}
        ends = {
            path: np.array([each.values.min(), each.values.max()]) for each in self.parameters for path in each.paths
        }
        faults: list[Fault] = []
        for path, values in ends.items():
            faults += self._faults({path: values})
        faults = faults or [*self._faults(first)]
        if faults:
            raise SpecError(list(dict.fromkeys(faults)), self.chute.source)

    def _faults(self, changes: Block) -> tuple[Fault, ...]:
        """Return the faults of values, other than that a section cannot be built."""
        try:
            self.chute.vary(changes)
        except SpecError as error:
            return error.faults if error.designs is None else ()
        return ()


def _codes(run: Solution) -> Any:
    """Return the codes of each design's findings, each once, with blanks between them."""
    codes: list[dict[str, None]] = [{} for _ in range(run.count)]
    for finding in run.findings():
        for k in np.flatnonzero(finding.mask):
            codes[k][finding.code] = None
    return np.array([" ".join(own) for own in codes])
