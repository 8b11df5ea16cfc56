"""A block of a sweep as bytes that say themselves which block they are, and whether they are whole.

The first line is JSON: number, rows, digest of the sweep, size and checksum of all that follows, a NumPy archive.
"""

import hashlib
import io
import json
from typing import IO, Any

import numpy as np

from chutecalc.output.dataset import Block

HEAD = 1000
"""Bytes within which the first line ends."""


class DamagedError(Exception):
    """A block is not what was stored. Its text says which one and why, as the beginning of a sentence."""


def packed(block: Block, number: int, sweep: str) -> tuple[bytes, bytes]:
    """Return a block as bytes, in two pieces.

    Args:
        block: its rows.
        number: its number.
        sweep: digest of the sweep it belongs to.
    """
    stream = io.BytesIO()
    np.savez(stream, **block)
    content = stream.getvalue()
    return json.dumps(_head(number, _rows(block), sweep, content)).encode() + b"\n", content


def unpacked(stored: IO[bytes], number: int, sweep: str, rows: int | None) -> Block:
    """Return the block in a stream, of which no more is read than the block has.

    Args:
        stored: the stream.
        number: the number that it is to have.
        sweep: digest of the sweep it is to belong to.
        rows: how many rows it is to have; None where only its solution tells.

    Raises:
        DamagedError: it is not such a block.

    >>> both = b"".join(packed({"x_m": np.array([1.5])}, 3, "a digest"))
    >>> unpacked(io.BytesIO(both), 3, "a digest", 1)
    {'x_m': array([1.5])}
    >>> unpacked(io.BytesIO(both), 2, "a digest", 1)
    Traceback (most recent call last):
    chutecalc.studies.sweep.stored_block.DamagedError: is another block
    """
    try:
        head: Any = json.loads(stored.readline(HEAD))
        content = stored.read(max(head["bytes"], 0) + 1)  # one more than there may be
        own = head == _head(number, head["rows"], sweep, content)
        whole = own or head["sha256"] == _sum(content)
        block = _read(content) if own else {}
    except Exception:  # whatever the readers of damaged files raise
        raise DamagedError("is damaged") from None
    if not own:
        raise DamagedError("is another block" if whole else "is damaged")
    if head["rows"] != _rows(block) or rows not in (None, _rows(block)):
        raise DamagedError("has another number of rows")
    return block


def _head(number: int, rows: Any, sweep: str, content: bytes) -> dict[str, Any]:
    return {"block": number, "rows": rows, "sweep": sweep, "bytes": len(content), "sha256": _sum(content)}


def _sum(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _read(content: bytes) -> Block:
    """Return the arrays of an archive."""
    with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
        return dict(arrays)


def _rows(block: Block) -> int:
    """Return the number of rows of a block, or -1 if its columns differ in it."""
    counts = {len(values) for values in block.values()}
    return counts.pop() if len(counts) == 1 else -1
