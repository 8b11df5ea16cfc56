"""A block of rows of a sweep, and the best rows of all blocks."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from chutecalc.output.dataset import Block
from chutecalc.physics.arrays import Index

TEXT = ("status", "findings", "warnings", "segment", "kind")
"""Columns of text; all others are numbers."""


class Top(NamedTuple):
    """A selection of the rows with the largest or smallest values of a column."""

    rows: int
    """Number of rows."""
    column: str
    """Name of the column."""
    largest: bool
    """Whether the largest values are best."""

    def best(self, block: Block) -> Index:
        """Find the best rows of a block, best first.

        Equal values stay in the order of the block; rows without a value are left out.

        Args:
            block: The block, with the column.

        Returns:
            Row numbers in the block.

        >>> Top(rows=2, column="depth_m", largest=True).best({"depth_m": np.array([0.1, np.nan, 0.3, 0.2])}).tolist()
        [2, 3]
        """
        values = -block[self.column] if self.largest else block[self.column]
        order: Index = np.argsort(values, kind="stable")
        best: Index = order[np.isfinite(values[order])][: self.rows]
        return best


def select_rows(block: Block, rows: Index) -> Block:
    """Return some rows of a block.

    Args:
        block: The block.
        rows: Row numbers, in the order to return.

    >>> select_rows({"depth_m": np.array([0.1, 0.3, 0.2])}, np.array([2, 0]))["depth_m"].tolist()
    [0.2, 0.1]
    """
    return {name: values[rows] for name, values in block.items()}


def best_rows(blocks: Iterable[Block], top: Top) -> Iterator[Block]:
    """Select the best rows of all blocks.

    Args:
        blocks: The blocks, in order.
        top: Which rows to select.

    Yields:
        One block with the best rows, best first; none where there are no blocks.

    >>> blocks = [{"depth_m": np.array([0.1, 0.3])}, {"depth_m": np.array([0.2])}]
    >>> next(best_rows(blocks, Top(rows=2, column="depth_m", largest=False)))["depth_m"].tolist()
    [0.1, 0.2]
    """
    best: Block = {}
    for block in blocks:
        both = {name: np.concatenate([best[name], block[name]]) for name in block} if best else block
        best = select_rows(both, np.sort(top.best(both)))
    if best:
        yield select_rows(best, top.best(best))


def joined(blocks: Sequence[Block]) -> Block:
    """Return blocks as one, or an empty one for no blocks.

    Args:
        blocks: Blocks with the same columns, in order.
    """
    return {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]} if blocks else {}
