"""A sweep from its blocks to its outputs: solved, stored so that it can be resumed, written, printed."""

import sys
from collections.abc import Generator, Iterable, Iterator
from contextlib import closing, suppress
from pathlib import Path

from chutecalc.cli.outputs import Outputs
from chutecalc.errors import ChutecalcError, ExitStatus, UsageError
from chutecalc.output.dataset import Block
from chutecalc.output.held import is_special
from chutecalc.output.printer import Printer
from chutecalc.output.progress import progress
from chutecalc.output.targets import STANDARD_STREAM
from chutecalc.printable import printable
from chutecalc.studies.sweep.block import best_rows
from chutecalc.studies.sweep.block_store import BlockStore
from chutecalc.studies.sweep.part_folder import part_folder
from chutecalc.studies.sweep.rows import CollectedRows, sweep_dataset
from chutecalc.studies.sweep.solved_blocks import solve_block, solve_blocks
from chutecalc.studies.sweep.stored_block import DamagedError
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import MOST_SHOWN, SHOWN_WITH_FILE, FirstRows
from chutecalc.workers import Pool


def check_resumed(outputs: Outputs) -> None:
    """Check that there is something to resume. Call it before outputs are held, so that a refusal is in nobody's way.

    Args:
        outputs: the outputs, which need not be checked yet.

    Raises:
        UsageError: there is nothing.
    """
    if target := _data_file(outputs, resume=True):
        part_folder(target, resume=True)


def _data_file(outputs: Outputs, resume: bool) -> str | None:
    """Return the file beside which blocks are stored; None without one.

    Raises:
        UsageError: it is needed.
    """
    files = (name for name in outputs.files.values() if name != STANDARD_STREAM and not is_special(Path(name)))
    target = next(files, None)
    if resume and not target:
        raise UsageError(
            "--resume needs --csv, --json or --parquet: repeat the interrupted command with --resume added."
        )
    return target


class SweepRun:
    """A sweep and its outputs."""

    def __init__(self, sweep: Sweep, outputs: Outputs, resume: bool, pool: Pool) -> None:
        """Open the store of blocks, if there is a data file.

        Args:
            sweep: the designs, and the columns of their rows.
            outputs: checked outputs.
            resume: whether to use the blocks that an interrupted sweep stored beside its file.
            pool: where blocks are solved.

        Raises:
            UsageError: there is nothing to resume.
        """
        self.sweep, self.outputs, self.pool = sweep, outputs, pool
        target = _data_file(outputs, resume)
        self.store = BlockStore(target, sweep.identity(), resume) if target else None

    def run(self) -> int:
        """Solve all blocks, write the outputs, print the table.

        Returns:
            The exit status.
        """
        count, store = self.sweep.block_count, self.store
        if store is None:
            with closing(self._solved(list(range(count)))) as blocks:
                self._write((block for _, block in blocks), complete=True)
            return ExitStatus.OK
        try:
            self._fill(store)
            self._write((self._block(store, number) for number in range(count)), complete=True)
        except KeyboardInterrupt:
            _tell(f"--resume continues from {store.name}")
            raise
        store.remove()
        return ExitStatus.OK

    def _fill(self, store: BlockStore) -> None:
        """Solve the blocks that are not in the store. Where this is interrupted, write the rows that there are."""
        try:
            with closing(self._solved(self._needed(store))) as blocks:
                for number, block in blocks:
                    store.save(number, block)
        except KeyboardInterrupt:
            done: list[int] = []
            try:
                self._write(self._first_blocks(store, done), complete=False)
                _tell(f"wrote {sum(done):,} of {self.sweep.count:,} designs")
            except ChutecalcError as error:
                _tell(str(error))
            raise

    def _needed(self, store: BlockStore) -> list[int]:
        """Return the numbers of the blocks that are not stored whole; say which of them should be."""
        numbers = range(self.sweep.block_count)
        last = max((number for number in numbers if number in store), default=-1)
        damaged = (number for number in numbers[: last + 1] if self._stored(store, number) is None)
        return [*damaged, *numbers[last + 1 :]]

    def _block(self, store: BlockStore, number: int) -> Block:
        """Return a block from the store, or solve it where somebody has damaged it meanwhile."""
        block = self._stored(store, number)
        return solve_block(self.sweep, number) if block is None else block

    def _stored(self, store: BlockStore, number: int) -> Block | None:
        """Return a block from the store; say where it is not whole, and return None."""
        try:
            return store.load(number, self._rows(number))
        except DamagedError as error:
            _tell(f"{error}: it is solved again")
            return None

    def _first_blocks(self, store: BlockStore, done: list[int]) -> Iterator[Block]:
        """Yield the stored blocks up to the first that is not whole, and note how many designs each has."""
        with suppress(DamagedError):
            for number in range(self.sweep.block_count):
                block = store.load(number, self._rows(number))
                done.append(self._size(number))
                yield block

    def _solved(self, numbers: list[int]) -> Generator[tuple[int, Block], None, None]:
        """Yield blocks as they are solved, with a progress bar."""
        done = self.sweep.count - sum(self._size(number) for number in numbers)
        with progress("designs") as show, closing(solve_blocks(self.sweep, numbers, self.pool)) as blocks:
            show(done, self.sweep.count)
            for number, block in blocks:
                yield number, block
                done += self._size(number)
                show(done, self.sweep.count)

    def _size(self, number: int) -> int:
        """Return the number of designs in a block."""
        return min(self.sweep.block_size, self.sweep.count - number * self.sweep.block_size)

    def _rows(self, number: int) -> int | None:
        """Return the number of rows in a block; None where only its solution tells."""
        return None if self.sweep.profiles or self.sweep.top else self._size(number)

    def _write(self, blocks: Iterable[Block], complete: bool) -> None:
        """Write the data files and, once all blocks are there, draw and print."""
        outputs = self.outputs
        shown = FirstRows(self.sweep, SHOWN_WITH_FILE if outputs.files else MOST_SHOWN)
        collected = CollectedRows()
        rows = best_rows(blocks, self.sweep.top) if self.sweep.top else blocks
        more = [collected] if outputs.chart or outputs.plot else []
        outputs.write(sweep_dataset(self.sweep, rows), shown, *more)
        if not complete:
            return
        if outputs.plot:
            from chutecalc.studies.sweep.plot import draw_sweep

            outputs.draw(draw_sweep(self.sweep, collected.block, outputs.units))
        self._print(shown, collected)

    def _print(self, shown: FirstRows, collected: CollectedRows) -> None:
        """Print the table and the chart, unless data go to standard output."""
        if self.outputs.to_standard_output:
            return
        printer = Printer(self.outputs.units)
        shown.show(printer, list(self.outputs.files.values()))
        if self.outputs.chart:
            from chutecalc.studies.sweep.chart import print_sweep_chart

            print_sweep_chart(printer, self.sweep, collected.block)


def _tell(text: str) -> None:
    """Say something on standard error."""
    print(printable(f"chutecalc: {text}"), file=sys.stderr)
