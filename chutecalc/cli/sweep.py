"""``chutecalc sweep``: many designs, a row each; without a spec the paper's friction study."""

from __future__ import annotations

import os
import sys
from collections.abc import Generator, Iterable
from contextlib import ExitStack, closing
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import typer

from chutecalc.cli.run import STANDARD_INPUT, Units, standard_input
from chutecalc.errors import ExitStatus, UsageError
from chutecalc.output.extras import require_extra

if TYPE_CHECKING:
    from chutecalc.chute import Chute
    from chutecalc.output.rows import Rows
    from chutecalc.output.sweep_table import ShownRows
    from chutecalc.studies.sweep import Block, Sweep, Top

MEANT = 10_000_000
"""Designs that a person can have meant."""
MOST_DRAWN = 1_000_000
STUDY_BARE = {"beta": "0:90:5", "delta": "30:55:5"}


class Keep(StrEnum):
    """What stays while the chamfer angle varies."""

    BASE = "base"
    WIDTH = "width"
    DEPTH = "depth"


def sweep(
    arguments: list[str] = typer.Argument(
        ...,
        metavar="ARG...",
        help="Parameters, such as beta, radius=1:4:0.5, rate=500,1000 or segments.1.drop_m=1:3:#21, and a spec (.toml,"
        " or - for standard input). Without a spec: the paper's friction study over beta and delta.",
    ),
    keep: Keep = typer.Option(Keep.BASE, help="What stays of a section while beta varies."),
    parallel: bool = typer.Option(False, "--zip", help="Take the lists side by side, not in all combinations."),
    columns: str | None = typer.Option(
        None,
        metavar="NAMES",
        help="Columns, between commas: exit_, max_ or min_ before a name of chutecalc columns,"
        " receiver_…, error_estimate, findings.",
    ),
    top: int | None = typer.Option(None, min=1, metavar="N", help="The N best rows only, with --by."),
    by: str | None = typer.Option(None, metavar="COLUMN:max|min", help="What is best, e.g. exit_velocity_m_s:max."),
    points: int | None = typer.Option(None, min=2, help="Rows are stations: so many along each segment."),
    stations: float | None = typer.Option(None, metavar="D", help="Rows are stations, every D metres."),
    csv: str | None = typer.Option(None, metavar="FILE", help="Write the rows; - for standard output."),
    parquet: str | None = typer.Option(None, metavar="FILE", help="Write the rows (extra parquet)."),
    json: str | None = typer.Option(None, metavar="FILE", help="Write the rows, and what was asked; - as above."),
    plot: str | None = typer.Option(
        None, metavar="FILE", help="Draw lines over one parameter, contours over two: .svg, .png or .pdf."
    ),
    chart: bool = typer.Option(False, "--chart", help="Show a small chart over one parameter too."),
    resume: bool = typer.Option(False, "--resume", help="Go on from the FILE.part of a sweep that was ended."),
    yes: bool = typer.Option(False, "--yes", help=f"Do not ask, also above {MEANT:,} designs."),
    jobs: int | None = typer.Option(None, min=1, help="Threads; as many as there are cores without it."),
    phi: float | None = typer.Option(None, help="Friction study: wall friction angle, degrees (25)."),
    base: float | None = typer.Option(None, help="Friction study: width between square corners, m (0.5)."),
    area: float | None = typer.Option(None, help="Friction study: flow area, m² (0.05)."),
    units: Units = typer.Option(Units.METRIC, help="Units of tables, charts and pictures."),
    rtol: float = typer.Option(1e-10, help="Relative error allowed to the velocity, 1e-13 to 1e-3."),
    debug: bool = typer.Option(False, "--debug", help="Show where the program itself fails."),
) -> int:
    """Vary parameters of a chute: a row for each design.

    Without a spec: the equivalent friction over the chamfer angle, as in the paper. Ends with status 0 whatever the
    rows say.
    """
    specs = [argument for argument in arguments if argument == "-" or argument.endswith(".toml")]
    given = [argument for argument in arguments if argument not in specs]
    if len(specs) > 1:
        raise UsageError(f"a sweep takes one spec, not {len(specs)}: {', '.join(specs)}")
    study = {"--phi": phi, "--base": base, "--area": area}
    if not specs:
        other: dict[str, Any] = {"--zip": parallel, "--columns": columns, "--top": top, "--by": by, "--points": points}
        other |= {"--stations": stations, "--parquet": parquet, "--chart": chart, "--resume": resume}
        _refuse(other, "goes with a spec: the friction study has its own rows, with --csv, --json and --plot")
        return _friction_study(given, keep, study, csv, json, plot, units)
    _refuse(study, "belongs to the friction study: with a spec, vary phi or base, or change the spec")
    if not given:
        raise UsageError("nothing is varied: add a parameter, such as beta, rate=500,1000 or segments.1.drop_m=1:3:0.5")
    from chutecalc.output.files import check_openable, check_targets
    from chutecalc.output.sweep_table import MOST_SHOWN
    from chutecalc.studies.parameters import read_parameters
    from chutecalc.studies.sweep import Sweep

    if points is not None and stations is not None:
        raise UsageError("--points and --stations both say where the stations are: give one of them")
    targets = {"csv": csv, "parquet": parquet, "json": json, "plot": plot}
    check_targets(list(targets.values()), specs)
    _check_extras(parquet, plot, chart)
    for target in targets.values():
        check_openable(target)
    chute = _chute(specs[0])
    parameters = read_parameters(given, chute)
    names = [name.strip() for name in columns.split(",")] if columns else []
    asked = Sweep(chute, parameters, parallel, keep, names, _top(top, by), points, stations, rtol)
    if not (names or asked.profiles or any(targets.values()) or asked.count > MOST_SHOWN):
        asked.columns.append("findings")  # a hundred times the work of all others, so by itself for few designs alone
    _check_drawn(asked, plot, chart)
    if asked.count > MEANT and not yes:
        _ask(asked)
    return _Run(asked, targets, chart, resume, jobs, units).run()


class _Run:
    """A sweep on its way to its outputs."""

    def __init__(
        self, sweep: Sweep, targets: dict[str, str | None], chart: bool, resume: bool, jobs: int | None, units: Units
    ) -> None:
        from chutecalc.output.blocks import BlockStore

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
        from chutecalc.output.progress import progress

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
        from chutecalc.output.files import open_whole
        from chutecalc.output.rows import CsvRows, JsonRows, KeptRows, ParquetRows
        from chutecalc.output.sweep_table import MOST_SHOWN, SHOWN_WITH_FILE, ShownRows
        from chutecalc.studies.sweep import best_of

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
            for block in best_of(blocks, self.sweep.top) if self.sweep.top else blocks:
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
            from chutecalc.output.files import open_whole
            from chutecalc.output.plot import picture_format, save
            from chutecalc.output.plot_sweep import draw_sweep

            with open_whole(plot, "wb") as stream:
                assert stream is not None
                save(draw_sweep(self.sweep, block, self.units), stream, picture_format(plot))

    def _print(self, shown: ShownRows, block: Block, files: list[str]) -> None:
        """The table, unless data goes where it would."""
        from chutecalc.output.table import Printer

        if "-" in files:
            return
        printer = Printer(self.units)
        shown.show(printer, files)
        if self.chart:
            from chutecalc.output.chart import print_sweep_chart

            print_sweep_chart(printer, self.sweep, block)


def _friction_study(
    given: list[str],
    keep: Keep,
    study: dict[str, float | None],
    csv: str | None,
    json: str | None,
    plot: str | None,
    units: Units,
) -> int:
    """The study, over the angles given."""
    from chutecalc.cli.friction import run_friction_study
    from chutecalc.studies.parameters import split_argument

    angles: dict[str, Any] = {}
    for argument in given:
        name = argument.partition("=")[0].strip()
        if name not in STUDY_BARE:
            raise UsageError(
                f"{argument}: without a spec only beta and delta are varied; name a spec (.toml) for others"
            )
        if name in angles:
            raise UsageError(f"{name} is given twice: keep one of them")
        angles[name] = split_argument(argument, STUDY_BARE)[1].tolist()
    angles |= {name.removeprefix("--"): value for name, value in study.items() if value is not None}
    return run_friction_study(**angles, keep=keep.value, csv=csv, json=json, plot=plot, units=units)


def _refuse(options: dict[str, Any], why: str) -> None:
    """Options that were given, whatever their value, and do not fit."""
    given = [name for name, value in options.items() if value is not None and value is not False]
    if given:
        raise UsageError(f"{', '.join(given)} {why}")


def _chute(spec: str) -> Chute:
    """The chute that is varied."""
    from chutecalc.chute import load, parse

    return parse(standard_input(), STANDARD_INPUT) if spec == "-" else load(spec)


def _check_extras(parquet: str | None, plot: str | None, chart: bool) -> None:
    """That what is asked for can be written, before anything is solved."""
    if parquet == "-":
        raise UsageError("--parquet writes a file: standard output takes --csv or --json")
    if parquet:
        require_extra("parquet")
    if plot:
        from chutecalc.output.plot import picture_format

        picture_format(plot)
    if chart:
        require_extra("chart")


def _check_drawn(sweep: Sweep, plot: str | None, chart: bool) -> None:
    """That the rows can be drawn."""
    option, most = ("--chart", 1) if chart else ("--plot", 2)
    if not (plot or chart):
        return
    if sweep.profiles or sweep.top:
        raise UsageError(f"{option} draws all designs: it does not go with --points, --stations or --top")
    varied = [parameter.name for parameter in sweep.parameters if len(parameter.values) > 1]
    if not varied or (len(varied) > most and not sweep.parallel):
        raise UsageError(
            f"{option} draws over {'one parameter' if most == 1 else 'one or two parameters'} of several"
            f" values, not {len(varied)}"
        )
    if sweep.count > MOST_DRAWN:
        raise UsageError(f"{option} draws at most {MOST_DRAWN:,} designs, not {sweep.count:,}")


def _top(top: int | None, by: str | None) -> Top | None:
    """What is best."""
    from chutecalc.studies.sweep import Top

    if top is None and by is None:
        return None
    name, _, way = (by or "").rpartition(":")
    if top is None or not name or way not in ("max", "min"):
        raise UsageError("the best rows are asked for with --top N --by COLUMN:max or COLUMN:min")
    return Top(top, name, way == "max")


def _ask(sweep: Sweep) -> None:
    """Whether so many designs are meant, where somebody can be asked."""
    if sys.stdin.isatty() and sys.stderr.isatty():
        lists = " × ".join(f"{len(parameter.values):,} {parameter.name}" for parameter in sweep.parameters)
        if not typer.confirm(f"{lists}: {sweep.count:,} designs. Go on?", err=True):
            raise UsageError("nothing was solved")


def _is_regular(target: str) -> bool:
    """Whether it is a file, or can become one: no stream, pipe or device."""
    return target != "-" and (os.path.isfile(target) or not os.path.exists(target))
