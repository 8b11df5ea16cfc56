"""Prints lines and tables, with the same digits on a terminal and in a pipe."""

from __future__ import annotations

import os
import sys
from functools import cached_property
from textwrap import wrap
from typing import TYPE_CHECKING, Any

from chutecalc.output.grid import Grid
from chutecalc.printable import printable
from chutecalc.results.finding import Severity

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

COLOURS: dict[str, str] = {Severity.FAILURE: "bold red", Severity.WARNING: "yellow", Severity.NOTE: "cyan"}
"""Styles of rich by the severity of a finding."""
PIPE_WIDTH = 80
"""Width of tables where there is no terminal, characters."""
NO_WRAP = 100_000
"""Width at which rich breaks no table, characters."""
HANGING = "    "
"""Text before the further lines of a line that is wrapped."""


class Printer:
    """Prints reports to a stream.

    Args:
        units: ``metric`` or ``us``.
        stream: where to print; None for standard output.
    """

    def __init__(self, units: str = "metric", stream: Any = None) -> None:
        self.units = units
        self.stream = stream or sys.stdout
        self.is_terminal = self.stream.isatty()

    @cached_property
    def console(self) -> Console:
        """Console of rich, for a terminal."""
        from rich.console import Console

        return Console(
            file=self.stream,
            color_system=None if os.environ.get("NO_COLOR") else "auto",
            force_terminal=True,
            highlight=False,
            markup=False,
            emoji=False,
        )

    @property
    def width(self) -> int:
        """Width of a line, characters."""
        return self.console.width if self.is_terminal else PIPE_WIDTH

    def text(self, text: str = "", plain: str = "", style: str = "") -> None:
        """Print a line. On a terminal it is wrapped between words; elsewhere it stays one line, for grep.

        What does not print stands as its escape sequence.

        Args:
            text: the line, or its beginning if there is ``plain``.
            plain: the rest of the line, without style.
            style: style of ``text`` on a terminal, as rich takes it.
        """
        text, plain = printable(text), printable(plain)
        if self.is_terminal:
            from rich.text import Text

            line = Text(text, style=style).append(plain, style="none")
            if line.cell_len > self.width:
                lines = line.wrap(self.console, self.width - len(HANGING))
                for each in lines:
                    each.rstrip()
                line = Text(f"\n{HANGING}").join(lines)
            self.console.print(line, no_wrap=True, overflow="ignore", crop=False)
        else:
            self.stream.write(f"{text}{plain}\n")

    def prose(self, text: str, style: str = "") -> None:
        """Print a sentence, wrapped between words wherever it is printed.

        Args:
            text: the sentence.
            style: as for :meth:`text`.
        """
        lines = wrap(text, self.width, subsequent_indent=HANGING, break_long_words=False, break_on_hyphens=False)
        for line in lines:
            self.text(line, style=style)

    def table(self, grid: Grid) -> None:
        """Print a table; one that is too wide as several, one below the other. Numbers are never cut or broken.

        Args:
            grid: the table.
        """
        for number, part in enumerate(grid.fitted(self.width)):
            if number:
                self.text()
            if self.is_terminal:
                self._drawn(part.drawn())
            else:
                self.stream.writelines(f"{line}\n" for line in part.lines())

    def _drawn(self, table: Table) -> None:
        """Print a table of rich at its own width."""
        from rich.measure import Measurement

        needed = Measurement.get(self.console, self.console.options.update(width=NO_WRAP), table).maximum
        self.console.width, width = max(self.console.width, needed), self.console.width
        self.console.print(table, crop=False)
        self.console.width = width
