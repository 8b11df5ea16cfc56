"""Where the results of a command go: data files, a picture, a chart, tables. Every command with results uses it."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING, ClassVar

import typer

from chutecalc.cli.options import OptionGroup, option
from chutecalc.cli.streams import reader_is_gone
from chutecalc.errors import UsageError
from chutecalc.extras import CHART, require_extra
from chutecalc.output.dataset import finite_numbers
from chutecalc.output.dxf import check_drawing
from chutecalc.output.files import open_whole
from chutecalc.output.formats import OutputFormat, RowWriter, output_formats
from chutecalc.output.held import reserve
from chutecalc.output.html_report.write import check_report
from chutecalc.output.plots.save import PICTURE_FORMATS, picture_format, save
from chutecalc.output.targets import STANDARD_STREAM, check_targets
from chutecalc.results.column import Units
from chutecalc.runtime import import_matplotlib

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from chutecalc.output.dataset import Dataset

ENDINGS = ", ".join(f".{ending}" for ending in PICTURE_FORMATS)


class Outputs(OptionGroup):
    """Data files that a user asks for. A subclass says what else its command offers."""

    picture: ClassVar[str] = ""
    """What ``--plot`` draws. Without it there is no such option."""
    drawing: ClassVar[str] = ""
    """What ``--dxf`` draws. Without it there is no such option."""
    reported: ClassVar[str] = ""
    """What ``--report`` is about. Without it there is no such option."""
    charted: ClassVar[str] = ""
    """What ``--chart`` shows. Without it there is no such option."""
    has_units: ClassVar[bool] = False
    """Whether there is ``--units``."""

    def __init__(
        self,
        plot: str | None = None,
        dxf: str | None = None,
        report: str | None = None,
        chart: bool = False,
        units: str = Units.METRIC,
        debug: bool = False,
        **files: str | None,
    ) -> None:
        """Take the values of the options.

        Args:
            plot: file of the picture.
            dxf: file of the drawing.
            report: file of the report.
            chart: whether to show a chart.
            units: units of tables, charts and pictures, ``metric`` or ``us``.
            debug: read from the command line by ``main`` alone.
            **files: data file by name of its format, ``-`` for standard output.
        """
        self.plot, self.dxf, self.report, self.chart, self.units = plot, dxf, report, chart, units
        self.files = {name: file for name, file in files.items() if file is not None}

    @classmethod
    def parameters(cls) -> list[inspect.Parameter]:
        """Return an option for each format that there is, and those that the command offers."""
        found = [
            option(each.name, str | None, typer.Option(None, metavar="FILE", help=each.help))
            for each in output_formats().values()
        ]
        if cls.picture:
            text = f"Draw {cls.picture} ({ENDINGS}; needs Matplotlib)."
            found.append(option("plot", str | None, typer.Option(None, metavar="FILE", help=text)))
        if cls.drawing:
            text = f"Draw {cls.drawing} in mm, for CAD (.dxf; needs ezdxf)."
            found.append(option("dxf", str | None, typer.Option(None, metavar="FILE", help=text)))
        if cls.reported:
            text = f"Write a report to print and sign of {cls.reported} (.html, .pdf; needs Jinja2, WeasyPrint)."
            found.append(option("report", str | None, typer.Option(None, metavar="FILE", help=text)))
        if cls.charted:
            text = f"Show {cls.charted} as a small chart (needs Plotille)."
            found.append(option("chart", bool, typer.Option(False, "--chart", help=text)))
        if cls.has_units:
            text = "Units of tables, charts and pictures. Data files are always metric."
            found.append(option("units", Units, typer.Option(Units.METRIC, help=text)))
        debug = typer.Option(False, "--debug", help="Show a traceback if chutecalc itself fails.")
        return [*found, option("debug", bool, debug)]

    @property
    def to_standard_output(self) -> OutputFormat | None:
        """The format of the data that go to standard output, where tables would be in their way."""
        names = (name for name, file in self.files.items() if file == STANDARD_STREAM)
        return next((output_formats()[name] for name in names), None)

    def check(self, inputs: Sequence[str | None] = (), **others: str | None) -> None:
        """Check that all outputs can be written, and keep others from writing them. Call it before anything is solved.

        Args:
            inputs: files that the command reads; None for one that was not given.
            **others: further files that it writes, by option.

        Raises:
            UsageError: two outputs are the same, one is an input, or a format does not fit its target.
            ExtraMissingError: an optional library is not installed.
            OutputError: a file cannot be opened, or another process is writing it.
        """
        own = {"plot": self.plot, "dxf": self.dxf, "report": self.report}
        targets = {f"--{name}": file for name, file in {**self.files, **own, **others}.items()}
        check_targets(targets, inputs)
        for name, file in self.files.items():
            _check_format(output_formats()[name], file)
        if self.plot is not None:
            picture_format(self.plot)
        if self.dxf is not None:
            check_drawing(self.dxf)
        if self.report is not None:
            check_report(self.report)
        if self.plot or self.report:
            import_matplotlib()  # before anything else does
        if self.chart:
            require_extra("--chart", CHART)
        for target in targets.values():
            reserve(target)

    def write(self, dataset: Dataset, *more: RowWriter) -> None:
        """Write all data files, each whole or not at all; stop where nobody reads the only one any more.

        Args:
            dataset: the results.
            *more: others that take the rows.
        """
        with ExitStack() as stack:
            writers = list(more)
            for name, file in self.files.items():
                form = output_formats()[name]
                stream = stack.enter_context(open_whole(file, "wb" if form.binary else "w"))
                if form.document and dataset.document:
                    form.document(stream, dataset)
                else:
                    writers.append(form.rows(stream, dataset))
            for block in dataset.blocks if writers else ():
                if self._only_standard_output and reader_is_gone():
                    return
                rows = finite_numbers(block)
                for writer in writers:
                    writer.write(rows)
            for writer in writers:
                writer.close()

    @property
    def _only_standard_output(self) -> bool:
        """Whether there is no other output than standard output."""
        return {*self.files.values(), self.plot, self.dxf, self.report} <= {STANDARD_STREAM, None}

    def draw(self, figure: Figure) -> None:
        """Write the picture. Call it only where there is a ``plot``.

        Args:
            figure: the picture.
        """
        assert self.plot is not None
        with open_whole(self.plot, "wb") as stream:
            save(figure, stream, picture_format(self.plot))


def _check_format(form: OutputFormat, file: str) -> None:
    """Check that a format can be written to a file."""
    if file == STANDARD_STREAM and not form.standard_output:
        others = " or ".join(f"--{each.name}" for each in output_formats().values() if each.standard_output)
        raise UsageError(f"--{form.name} cannot go to standard output: name a file, or use {others}")
    if form.extra:
        require_extra(f"--{form.name}", form.extra)
