"""A block of a sweep's rows, and the best rows of all blocks."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from chutecalc.physics.arrays import Index

Block = dict[str, Any]
"""Arrays of one length by column name."""
TEXT = ("status", "findings", "segment", "kind")
"""Columns that are text."""
IMPOSSIBLE = "impossible"
"""The status of what cannot be built."""


class Top(NamedTuple):
    """The rows that are wanted of all: so many, those with the largest or least values of a column."""

    rows: int
    column: str
    largest: bool

    def best(self, block: Block) -> Index:
        """The places of the best rows, best first; the earlier first where they are equal. Empty cells are no rows."""
        values = -block[self.column] if self.largest else block[self.column]
        order: Index = np.argsort(values, kind="stable")
        best: Index = order[np.isfinite(values[order])][: self.rows]
        return best


def select_rows(block: Block, rows: Index) -> Block:
    """Some rows of a block."""
    return {name: values[rows] for name, values in block.items()}


def best_rows(blocks: Iterable[Block], top: Top) -> Iterator[Block]:
    """The best rows of all blocks as one, best first; blocks come in order."""
    best: Block = {}
    for block in blocks:
        both = {name: np.concatenate([best[name], block[name]]) for name in block} if best else block
        best = select_rows(both, np.sort(top.best(both)))
    if best:
        yield select_rows(best, top.best(best))
