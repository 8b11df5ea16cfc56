"""A sweep on its way to its outputs: solved, kept where it may have to go on, written, shown."""

import os
import sys
from collections.abc import Generator, Iterable, Mapping
from contextlib import ExitStack, closing

from chutecalc.errors import ExitStatus, UsageError
from chutecalc.output.files import open_whole
from chutecalc.output.progress import progress
from chutecalc.output.table import Printer
from chutecalc.studies.sweep.block import Block, best_rows
from chutecalc.studies.sweep.block_store import BlockStore
from chutecalc.studies.sweep.rows import CsvRows, JsonRows, KeptRows, ParquetRows, Rows
from chutecalc.studies.sweep.sweep import Sweep
from chutecalc.studies.sweep.table import MOST_SHOWN, SHOWN_WITH_FILE, ShownRows


class SweepRun:
    """A sweep, and where it goes."""

    def __init__(
        self, sweep: Sweep, targets: Mapping[str, str | None], chart: bool, resume: bool, jobs: int | None, units: str
    ) -> None:
        """Opens the store of blocks, where there is a file.

        Args:
            sweep: to run.
            targets: files for ``csv``, ``parquet``, ``json`` and ``plot``.
            chart: whether a chart is shown.
            resume: whether blocks that are kept beside the file are taken.
            jobs: threads.
            units: of tables, charts and pictures.

        Raises:
            UsageError: there is nothing to go on with.
        """
        self.sweep, self.targets, self.chart, self.jobs, self.units = sweep, targets, chart, jobs, units
        files = [file for kind, file in targets.items() if kind != "plot" and file and _is_regular(file)]
        if resume and not files:
            raise UsageError("--resume goes on with a file: give the --csv, --parquet or --json that was written")
        self.store = BlockStore(files[0], sweep.identity(), resume) if files else None

    def run(self) -> int:
        """Solves, writes, prints."""
        count, store = self.sweep.block_count, self.store
        if store is None:
            with closing(self._solved(list(range(count)))) as blocks:
                self._write((block for _, block in blocks), whole=True)
            return ExitStatus.OK
        try:
            with closing(self._solved([number for number in range(count) if number not in store])) as blocks:
                for number, block in blocks:
                    store.save(number, block)
        except KeyboardInterrupt:
            self._write(store.blocks(count), whole=False)
            done = next((number for number in range(count) if number not in store), count)
            told = f"{min(done * self.sweep.block_size, self.sweep.count):,} of {self.sweep.count:,} designs"
            print(f"chutecalc: {told} are written; --resume goes on from {store.name}", file=sys.stderr)
            raise
        self._write(store.blocks(count), whole=True)
        store.remove()
        return ExitStatus.OK

    def _solved(self, numbers: list[int]) -> Generator[tuple[int, Block], None, None]:
        """Blocks as they are solved, with a bar of progress."""
        done = self.sweep.count - sum(self._size(number) for number in numbers)
        with progress("designs") as told, closing(self.sweep.blocks(numbers, self.jobs)) as blocks:
            told(done, self.sweep.count)
            for number, block in blocks:
                yield number, block
                done += self._size(number)
                told(done, self.sweep.count)

    def _size(self, number: int) -> int:
        """How many designs a block has."""
        return min(self.sweep.block_size, self.sweep.count - number * self.sweep.block_size)

    def _write(self, blocks: Iterable[Block], whole: bool) -> None:
        """Writes files from blocks and, where all are there, draws and prints."""
        header = self.sweep.header
        csv, parquet, json = (self.targets[kind] for kind in ("csv", "parquet", "json"))
        files = [file for file in (csv, parquet, json) if file]
        shown, kept = ShownRows(self.sweep, SHOWN_WITH_FILE if files else MOST_SHOWN), KeptRows()
        with ExitStack() as outputs:
            sinks: list[Rows] = [shown, *([kept] if self.chart or self.targets["plot"] else [])]
            if stream := outputs.enter_context(open_whole(csv)):
                sinks.append(CsvRows(stream, header))
            if stream := outputs.enter_context(open_whole(parquet, "wb")):
                sinks.append(ParquetRows(stream, header))
            if stream := outputs.enter_context(open_whole(json)):
                sinks.append(JsonRows(stream, self.sweep))
            for block in best_rows(blocks, self.sweep.top) if self.sweep.top else blocks:
                for sink in sinks:
                    sink.write(block)
            for sink in sinks:
                sink.close()
        if whole:
            self._draw(kept.block)
            self._print(shown, kept.block, files)

    def _draw(self, block: Block) -> None:
        """The picture."""
        plot = self.targets["plot"]
        if plot:
            from chutecalc.output.plots.save import picture_format, save
            from chutecalc.studies.sweep.plot import draw_sweep

            with open_whole(plot, "wb") as stream:
                assert stream is not None
                save(draw_sweep(self.sweep, block, self.units), stream, picture_format(plot))

    def _print(self, shown: ShownRows, block: Block, files: list[str]) -> None:
        """The table, unless data goes where it would."""
        if "-" in files:
            return
        printer = Printer(self.units)
        shown.show(printer, files)
        if self.chart:
            from chutecalc.studies.sweep.chart import print_sweep_chart

            print_sweep_chart(printer, self.sweep, block)


def _is_regular(target: str) -> bool:
    """Whether it is a file, or can become one: no stream, pipe or device."""
    return target != "-" and (os.path.isfile(target) or not os.path.exists(target))
