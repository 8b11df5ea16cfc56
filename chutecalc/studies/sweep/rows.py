"""The rows of a sweep for output formats, and all of them together for pictures."""

from collections.abc import Iterable

from chutecalc.output.dataset import Block, Dataset
from chutecalc.studies.sweep.block import joined
from chutecalc.studies.sweep.sweep import Sweep


def sweep_dataset(sweep: Sweep, blocks: Iterable[Block]) -> Dataset:
    """Return a sweep as a dataset: a row for each design, or for each station.

    Args:
        sweep: what was asked for.
        blocks: its rows in order.
    """
    asked = {
        "source": sweep.chute.source,
        "spec": sweep.chute.data,
        "tolerance": sweep.rtol,
        "parameters": [
            {"name": parameter.name, "paths": parameter.paths, "values": len(parameter.values)}
            for parameter in sweep.parameters
        ],
        "zip": sweep.parallel,
        "keep": sweep.keep,
    }
    columns = {name: str if name in sweep.texts else float for name in sweep.header}
    return Dataset("sweep", columns, blocks, asked)


class CollectedRows:
    """All rows in memory, for a picture or a chart."""

    def __init__(self) -> None:
        self._blocks: list[Block] = []

    def write(self, block: Block) -> None:
        """Take the next block.

        Args:
            block: the block.
        """
        self._blocks.append(block)

    def close(self) -> None:
        """Do nothing."""

    @property
    def block(self) -> Block:
        """All rows as one block."""
        return joined(self._blocks)
