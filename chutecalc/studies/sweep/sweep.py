"""Sweeps: a row for each of many designs, worked out in blocks that do not know of each other."""

import hashlib
import json
from collections import deque
from collections.abc import Generator, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from difflib import get_close_matches
from functools import cached_property
from typing import Any

import numpy as np

from chutecalc import __version__
from chutecalc.api.batch import CHUNK, exits
from chutecalc.api.chute import Chute, check_tolerance, solve
from chutecalc.design import Status
from chutecalc.errors import Fault, SpecError, UsageError
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index
from chutecalc.results.columns import COLUMNS, WAYS, row_columns
from chutecalc.results.exits import NOT_AT_EXIT, named
from chutecalc.results.extremes import LARGEST, LEAST
from chutecalc.results.solution import Solution
from chutecalc.runtime import cores
from chutecalc.studies.sweep.block import IMPOSSIBLE, TEXT, Top, chosen
from chutecalc.studies.sweep.grid import Grid
from chutecalc.studies.sweep.kept import Kept
from chutecalc.studies.sweep.parameters import Parameter

DEFAULT = ("exit_velocity_m_s", "exit_depth_m", "exit_slope_deg", "max_depth_m", "min_velocity_m_s")
EXTREME = {"max": LARGEST, "min": LEAST}
WITH_FINDINGS, STATIONS = 1024, 262_144
"""Designs of a block where findings are asked for, and stations, about; a block is a chunk of a batch otherwise."""


class Sweep:
    """Variants of a chute, and what is asked of them."""

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
        """Checks what is asked; solves nothing.

        Args:
            chute: of one design.
            parameters: what is varied, at least one.
            parallel: their lists go side by side, rather than in all combinations.
            keep: what stays of a section while its chamfer angle varies, see
                :class:`~chutecalc.studies.sweep.kept.Kept`.
            columns: names of those wanted, of :func:`chutecalc.results.columns.row_columns`, or of stations.
            top: which rows are wanted; all, without it.
            points, spacing: rows are stations then, as of :meth:`chutecalc.Solution.stations`.
            rtol: as of :func:`chutecalc.solve`.

        Raises:
            UsageError: what does not go together.
            SpecError: paths that lead nowhere and values out of bounds, all of them.
        """
        check_tolerance(rtol)
        self.chute, self.rtol, self.top, self.points, self.spacing = chute, rtol, top, points, spacing
        self.parameters, self.parallel, self.keep = tuple(parameters), parallel, keep
        self.profiles = points is not None or spacing is not None
        self.grid = Grid(parameters, parallel)
        self.columns = self._columns(columns)
        self._check_values()
        self.kept = Kept(chute, [path for parameter in parameters for path in parameter.paths], keep)
        if self.top and self.profiles:
            raise UsageError("--top chooses among designs: it does not go with --points or --stations")
        if self.top and self.top.column not in self.header:
            self.columns = self._columns([*self.columns, self.top.column])
        if self.top and self.top.column in TEXT:
            raise UsageError(f"--by takes a column of numbers, not {self.top.column}")

    @property
    def count(self) -> int:
        """How many designs there are."""
        return self.grid.count

    @property
    def header(self) -> list[str]:
        """The names of the rows' columns."""
        return [*(parameter.name for parameter in self.parameters), "status", *self.columns]

    @cached_property
    def block_size(self) -> int:
        """Designs of a block."""
        if self.profiles:
            stations = int(solve(self.chute, self.rtol).stations(self.points, self.spacing, ["s_m"])["s_m"].size)
            return max(1, min(CHUNK, STATIONS // max(stations, 1)))
        return WITH_FINDINGS if "findings" in self.columns else CHUNK

    @property
    def block_count(self) -> int:
        """How many blocks there are."""
        return -(-self.count // self.block_size)

    def identity(self) -> dict[str, Any]:
        """All that the rows follow from, and with which version: equal where blocks of one fit the other."""
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
        """Blocks with their numbers, in the order asked for; a few are solved ahead.

        Args:
            numbers: which.
            jobs: threads; as many as there are cores where that is not given. The rows do not depend on it.
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
        """The rows of one block, in the order of the grid."""
        first = number * self.block_size
        rows = np.arange(first, min(first + self.block_size, self.count))
        pieces = list(self._pieces(rows))
        order: Index | slice
        if len(pieces) == 1 and pieces[0][0] is rows:  # all there, and in their order
            numbers, order, missing = rows, slice(None), rows[:0]
        else:
            told = np.concatenate([rows[:0], *(numbers for numbers, _ in pieces)])
            missing = np.setdiff1d(rows, told)
            numbers = np.concatenate([told, missing])
            order = np.argsort(numbers, kind="stable")
        given = zip(self.parameters, self.grid.at(rows), strict=True)
        block: Block = {
            parameter.name: np.broadcast_to(values, len(rows))[numbers[order] - first] for parameter, values in given
        }
        for name in ("status", *self.columns):
            empty = np.full(len(missing), IMPOSSIBLE if name == "status" else "" if name in TEXT else np.nan)
            block[name] = np.concatenate([*(told[name] for _, told in pieces), empty])[order]
        return block if self.top is None else chosen(block, np.sort(self.top.best(block)))

    def _pieces(self, rows: Index) -> Iterator[tuple[Index, Block]]:
        """The numbers of rows and what is told of them, without those of designs that cannot be."""
        given = zip(self.parameters, self.grid.at(rows), strict=True)
        changes, possible = self.kept({path: values for each, values in given for path in each.paths}, len(rows))
        if not possible.all():
            if possible.any():
                yield from self._pieces(rows[possible])
            return
        try:
            variants = self.chute.vary(changes)
            told = self._stations(rows, variants) if self.profiles else (rows, self._designs(variants, len(rows)))
        except SpecError as error:
            if error.designs is not None:
                rest = rows[~np.broadcast_to(error.designs, len(rows))]
                yield from self._pieces(rest) if rest.size else ()
            elif len(rows) > 1:
                half = len(rows) // 2
                yield from self._pieces(rows[:half])
                yield from self._pieces(rows[half:])
        else:
            yield told

    def _designs(self, variants: Chute, count: int) -> Block:
        """A row for each design."""
        ways = {
            way: [name.removeprefix(f"{way}_") for name in self.columns if name.startswith(f"{way}_")] for way in WAYS
        }
        if self._at_ends:
            ends = exits(variants, self.rtol, ways["exit"], jobs=1)
            codes, error, exit_, belt = ends.codes, ends.error_estimate, ends.exit, ends.receiver
            numbers: Block = {}
        else:
            run = solve(variants, self.rtol)
            codes, error, exit_ = run.codes, run.error_estimate, run.exit_columns(ways["exit"])
            belt = run.receiver if any(name.startswith("receiver_") for name in self.columns) else {}
            wanted = [(name, EXTREME[way]) for way in EXTREME for name in ways[way]]
            keys = [f"{way}_{name}" for way in EXTREME for name in ways[way]]
            numbers = dict(zip(keys, run.extreme_columns(wanted).values(), strict=True))
        numbers |= named(exit_, belt, error)
        well = codes == Status.OK
        block: Block = {"status": np.array(Status.LABELS)[codes]}
        for name in self.columns:
            block[name] = _codes(run) if name == "findings" else np.where(well, numbers[name], np.nan)
        return {name: np.broadcast_to(values, count) for name, values in block.items()}

    def _stations(self, rows: Index, variants: Chute) -> tuple[Index, Block]:
        """A row for each station that a design's stream reached."""
        run = solve(variants, self.rtol)
        table = run.stations(self.points, self.spacing, [*self.columns, "s_m"])
        table["status"] = run.status[:, None]
        shape = (len(rows), table["s_m"].shape[1])
        there = np.isfinite(np.broadcast_to(table["s_m"], shape))
        numbers = np.broadcast_to(rows[:, None], shape)[there]
        return numbers, {name: np.broadcast_to(table[name], shape)[there] for name in ("status", *self.columns)}

    @cached_property
    def _at_ends(self) -> bool:
        """Whether nothing is asked that lies between the inlet and the end of the chute."""
        last = {f"exit_{name}" for name in COLUMNS if name not in NOT_AT_EXIT}
        return all(name in last or name == "error_estimate" or name.startswith("receiver_") for name in self.columns)

    def _columns(self, wanted: Sequence[str]) -> list[str]:
        """The columns asked for, each once, without those that are always there."""
        known = {name for name in COLUMNS if name != "spec"} if self.profiles else {*row_columns()}
        usual = [name for name in COLUMNS if name != "spec"] if self.profiles else DEFAULT
        unknown = [name for name in wanted if name not in known and name != "status"]
        if unknown:
            close = [match for name in unknown for match in get_close_matches(name, known, n=1)]
            hint = f"did you mean {', '.join(close)}? " if close else ""
            own = "a station's columns" if self.profiles else "exit_, max_ and min_ before a station's columns"
            raise UsageError(
                f"there is no column {', '.join(unknown)} here: {hint}known are {own}; chutecalc columns lists all"
            )
        belt = [name for name in wanted if name.startswith("receiver_")]
        if belt and self.chute.spec.receiver is None:
            raise UsageError(f"{belt[0]}: the spec has no [receiver]")
        return [name for name in dict.fromkeys(wanted or usual) if name != "status"]

    def _check_values(self) -> None:
        """That every path leads somewhere and takes its values, whatever they make together.

        Raises:
            SpecError: all faults.
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
        """What is wrong with values, unless it is that no such section can be."""
        try:
            self.chute.vary(changes)
        except SpecError as error:
            return error.faults if error.designs is None else ()
        return ()


def _codes(run: Solution) -> Any:
    """The codes of each design's findings, each once, with a blank between them."""
    told: list[dict[str, None]] = [{} for _ in range(run.count)]
    for finding in run.findings():
        for k in np.flatnonzero(finding.mask):
            told[k][finding.code] = None
    return np.array([" ".join(codes) for codes in told])
