"""The blocks of a sweep, solved on workers: its variants in batches, without those that cannot be built."""

from collections import deque
from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import Future

import numpy as np

from chutecalc.design import Status
from chutecalc.errors import SpecError
from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index
from chutecalc.studies.sweep.adjustment import SectionAdjustment
from chutecalc.studies.sweep.block import select_rows
from chutecalc.studies.sweep.design_rows import design_rows, station_rows
from chutecalc.studies.sweep.parameters import Parameter
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.text_parameter import TextParameter
from chutecalc.workers import Pool


def solve_blocks(sweep: Sweep, numbers: Iterable[int], pool: Pool) -> Generator[tuple[int, Block], None, None]:
    """Solve blocks on workers, a few ahead of the one yielded.

    Args:
        sweep: What is asked for.
        numbers: Numbers of the blocks, from 0.
        pool: Where blocks are solved. The rows do not depend on it.

    Yields:
        Number and rows of each block, in the order of ``numbers``.
    """
    waiting: deque[tuple[int, Future[Block]]] = deque()
    with pool.workers() as workers:
        shared = workers.shared(sweep)
        for number in numbers:
            waiting.append((number, workers.executor.submit(solve_block, shared, number)))
            if len(waiting) > pool.at_once:
                yield waiting[0][0], waiting.popleft()[1].result()
        while waiting:
            yield waiting[0][0], waiting.popleft()[1].result()


def solve_block(sweep: Sweep, number: int) -> Block:
    """Solve one block.

    Args:
        sweep: What is asked for.
        number: Number of the block, from 0.

    Returns:
        Its rows in the order of the grid, or the best of them with ``top``.
    """
    first = number * sweep.block_size
    rows = np.arange(first, min(first + sweep.block_size, sweep.count))
    pieces = [piece for adjustment, some in _by_names(sweep, rows) for piece in _pieces(sweep, some, adjustment)]
    order: Index | slice
    if len(pieces) == 1 and np.array_equal(pieces[0][0], rows):  # all there, and in their order
        numbers, order, missing = rows, slice(None), rows[:0]
    else:
        solved = np.concatenate([rows[:0], *(numbers for numbers, _ in pieces)])
        missing = np.setdiff1d(rows, solved)
        numbers = np.concatenate([solved, missing])
        order = np.argsort(numbers, kind="stable")
    block: Block = {
        parameter.name: np.broadcast_to(values, len(rows))[numbers[order] - first]
        for parameter, values in sweep.grid.at(rows)
    }
    for name in ("status", *sweep.columns):
        empty = np.full(
            len(missing), Status.IMPOSSIBLE_LABEL if name == "status" else "" if name in sweep.texts else np.nan
        )
        block[name] = np.concatenate([*(piece[name] for _, piece in pieces), empty])[order]
    return block if sweep.top is None else select_rows(block, np.sort(sweep.top.best(block)))


def _by_names(sweep: Sweep, rows: Index) -> Iterator[tuple[SectionAdjustment, Index]]:
    """Yield the chutes that can be built, with the rows that share their names."""
    texts = [values for parameter, values in sweep.grid.at(rows) if isinstance(parameter, TextParameter)]
    for names, adjustment in sweep.adjustments.items():
        here = np.ones(len(rows), dtype=bool)
        for values, name in zip(texts, names, strict=True):
            here &= values == name
        if here.any():
            yield adjustment, rows[here]


def _pieces(sweep: Sweep, rows: Index, adjustment: SectionAdjustment) -> Iterator[tuple[Index, Block]]:
    """Yield numbers and columns of rows of one chute, without designs that cannot be built."""
    numbers = {
        path: values for each, values in sweep.grid.at(rows) if isinstance(each, Parameter) for path in each.paths
    }
    changes, possible = adjustment.apply(numbers, len(rows))
    if not possible.all():
        if possible.any():
            yield from _pieces(sweep, rows[possible], adjustment)
        return
    try:
        variants = adjustment.chute.vary(changes)
        if sweep.profiles:
            piece = station_rows(variants, rows, sweep.columns, sweep.rtol, sweep.points, sweep.spacing)
        else:
            piece = rows, design_rows(variants, len(rows), sweep.columns, sweep.rtol, sweep.own)
    except SpecError as error:
        if error.designs is not None:
            rest = rows[~np.broadcast_to(error.designs, len(rows))]
            yield from _pieces(sweep, rest, adjustment) if rest.size else ()
        elif len(rows) > 1:
            half = len(rows) // 2
            yield from _pieces(sweep, rows[:half], adjustment)
            yield from _pieces(sweep, rows[half:], adjustment)
    else:
        yield piece
