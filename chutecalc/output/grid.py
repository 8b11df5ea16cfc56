"""Columns of text under headings: drawn by rich on a terminal, and laid out alike as plain lines elsewhere.

Loading rich takes a tenth of the time of a whole run, and a pipe shows none of what it can do.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from textwrap import wrap
from typing import TYPE_CHECKING, NamedTuple

from chutecalc.output.cells import padded, shortened, width
from chutecalc.printable import printable

if TYPE_CHECKING:
    from rich.table import Table

GAP = "  "
"""Text between two columns."""
LEAST_WORDS = 24
"""Width that a column of words has at least, beside others, unless it needs less. Long words may need more."""
LEAST_SHARE = 0.25
"""Share of the width that columns beside the labels have at least, however long the labels are."""
LEAST_LABEL, LEAST_CELL = 12, 22
"""Characters that labels, and cells beside them, keep at least: longer than any number, and any code of a finding."""


class GridColumn(NamedTuple):
    """How a column is laid out."""

    heading: str
    """Its heading, with a line break before the unit."""
    left: bool
    """Whether cells are aligned to the left, as words are, rather than to the right, as numbers are."""
    label: bool
    """Whether it says what a row is, and so stands in each of the tables that a wide one becomes."""
    words: bool
    """Whether its cells may be broken between words."""


class Grid:
    """Headings of a few lines, and rows of cells.

    Args:
        title: a line above the headings, or empty.
        indent: text before each line.
    """

    def __init__(self, title: str = "", indent: str = "") -> None:
        self.title, self.indent = printable(title), indent
        self.columns: list[GridColumn] = []
        self.rows: list[Sequence[str]] = []

    def column(self, heading: str, left: bool = False, label: bool = False, words: bool = False) -> None:
        """Add a column. What does not print in its heading and its cells stands as its escape sequence.

        Args:
            heading: its heading, with a line break before the unit.
            left: whether cells are aligned to the left, as words are, rather than to the right, as numbers are.
            label: whether it says what a row is, and so stands in each of the tables that a wide one becomes.
            words: whether its cells may be broken between words.
        """
        self.columns.append(GridColumn(printable(heading, keep="\n"), left, label, words))

    def row(self, cells: Iterable[str]) -> None:
        """Add a row. Missing cells at its end are empty.

        Args:
            cells: text of the cells, from the first column on.
        """
        row = tuple(map(printable, cells))
        self.rows.append(row + ("",) * (len(self.columns) - len(row)))

    def fitted(self, most: int) -> list[Grid]:
        """Return the table as one that fits, or as several of the same rows: the labels, and some of the columns each.

        No number is cut or left out, but names that leave no room for numbers are shortened. A row that has nothing
        beside its labels is in the first table only.

        Args:
            most: largest width, characters.

        >>> grid = Grid()
        >>> for k, heading in enumerate(["segment", "velocity", "depth"]):
        ...     grid.column(heading, left=k == 0, label=k == 0)
        >>> grid.row(["spoon", "3.878", "0.1399"])
        >>> for part in grid.fitted(20):
        ...     list(part.lines())
        ['segment  velocity', 'spoon       3.878']
        ['segment   depth', 'spoon    0.1399']
        """
        table = self._shortened(most - len(self.indent))
        sizes = [
            len(GAP) + (min(size, LEAST_WORDS) if own.words else size)
            for own, size in zip(table.columns, table._widths(), strict=True)
        ]
        labels = [k for k, own in enumerate(table.columns) if own.label]
        others = {k: size for k, size in enumerate(sizes) if not table.columns[k].label}
        room = most - len(table.indent) + len(GAP) - sum(sizes[k] for k in labels)
        room = max(room, int(LEAST_SHARE * most))
        chosen = _shared(others, room)
        while room > max(others.values(), default=0) and len(_shared(others, room - 1)) == len(chosen):
            room -= 1  # several tables of about the same width
            chosen = _shared(others, room)
        return [table._part(sorted([*labels, *some]), most, first=k == 0) for k, some in enumerate(chosen)]

    def _shortened(self, most: int) -> Grid:
        """Return the table with the longest labels shortened until numbers have room, and cells that need more."""
        widths, table = self._widths(), Grid(self.title, self.indent)
        labels = [size for size, own in zip(widths, self.columns, strict=True) if own.label]
        longest, room = max(labels, default=0), most - LEAST_CELL - len(GAP) * len(labels)
        while longest > LEAST_LABEL and sum(min(size, longest) for size in labels) > room:
            longest -= 1
        beside = max(most - sum(min(size, longest) + len(GAP) for size in labels), LEAST_CELL)
        sizes = [
            size if own.words else longest if own.label else beside
            for size, own in zip(widths, self.columns, strict=True)
        ]
        for own, size in zip(self.columns, sizes, strict=True):
            heading = "\n".join(shortened(line, size) for line in own.heading.split("\n"))
            table.columns.append(own._replace(heading=heading))
        kept = [size if own.left else max(size, LEAST_CELL) for size, own in zip(sizes, self.columns, strict=True)]
        table.rows = [[shortened(cell, size) for cell, size in zip(row, kept, strict=True)] for row in self.rows]
        return table

    def _part(self, chosen: Sequence[int], most: int, first: bool) -> Grid:
        """Return a table of some of the columns, whose words are broken where they must."""
        part = Grid(self.title if first else "", self.indent)
        part.columns = [self.columns[k] for k in chosen]
        own = [k for k in chosen if not self.columns[k].label]
        part.rows = [[row[k] for k in chosen] for row in self.rows if first or any(row[k] for k in own)]
        widths = part._widths()
        over = len(self.indent) + sum(widths) + len(GAP) * (len(widths) - 1) - most
        for k, column in enumerate(part.columns):
            if column.words and over > 0:
                part.rows = [line for row in part.rows for line in _broken(row, k, max(widths[k] - over, 1))]
        return part

    def _headings(self) -> list[tuple[str, ...]]:
        """Return the lines of the headings, each with a cell for each column."""
        headings = [column.heading.split("\n") for column in self.columns]
        height = max(map(len, headings), default=0)
        return list(zip(*([""] * (height - len(lines)) + lines for lines in headings), strict=True))

    def _widths(self) -> list[int]:
        """Return the widths of the columns."""
        return [max(map(width, cells)) for cells in zip(*self._headings(), *self.rows, strict=True)]

    def lines(self) -> Iterator[str]:
        """Yield lines of plain text, without blanks at their ends."""
        if self.title:
            yield self.title
        widths, left = self._widths(), [column.left for column in self.columns]
        for row in (*self._headings(), *self.rows):
            cells = map(padded, row, widths, left)
            yield (self.indent + GAP.join(cells)).rstrip()

    def drawn(self) -> Table:
        """Return the table for a terminal."""
        from rich.table import Table

        table = Table(
            box=None,
            header_style="bold",
            padding=(0, 0, 0, len(GAP)),
            pad_edge=bool(self.indent),
            title=self.title or None,
            title_justify="left",
        )
        for column in self.columns:
            table.add_column(column.heading, justify="left" if column.left else "right", no_wrap=True)
        for row in self.rows:
            table.add_row(*row)
        return table


def _shared(sizes: Mapping[int, int], room: int) -> list[list[int]]:
    """Return columns in turn in as many groups as they need to fit, each of at least one column."""
    groups: list[list[int]] = [[]]
    for column, size in sizes.items():
        if groups[-1] and sum(sizes[each] for each in groups[-1]) + size > room:
            groups.append([])
        groups[-1].append(column)
    return groups


def _broken(row: Sequence[str], column: int, most: int) -> Iterator[Sequence[str]]:
    """Yield a row, and further lines of the words of one of its cells."""
    begin, *rest = wrap(row[column], most, break_long_words=False, break_on_hyphens=False) or [""]
    yield [*row[:column], begin, *row[column + 1 :]]
    for line in rest:
        yield [*("" for _ in row[:column]), line, *("" for _ in row[column + 1 :])]
