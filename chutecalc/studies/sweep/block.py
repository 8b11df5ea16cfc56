"""A block of a sweep's rows, and the best rows of all blocks."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index

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


def chosen(block: Block, rows: Index) -> Block:
    """Some rows of a block."""
    return {name: values[rows] for name, values in block.items()}


def best_of(blocks: Iterable[Block], top: Top) -> Iterator[Block]:
    """The best rows of all blocks as one, best first; blocks come in order."""
    kept: Block = {}
    for block in blocks:
        both = {name: np.concatenate([kept[name], block[name]]) for name in block} if kept else block
        kept = chosen(both, np.sort(top.best(both)))
    if kept:
        yield chosen(kept, top.best(kept))


def joined(blocks: Sequence[Block]) -> Block:
    """Return blocks as one, or an empty one for no blocks."""
    return {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]} if blocks else {}
