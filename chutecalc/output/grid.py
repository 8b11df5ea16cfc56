"""Columns of text under headings: drawn by rich on a terminal, laid out the same as plain lines elsewhere.

To load rich takes a tenth of the time of a whole run, and a pipe shows nothing of what it can do.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING
from unicodedata import category, east_asian_width

if TYPE_CHECKING:
    from rich.table import Table

GAP = "  "
NO_ROOM = ("Mn", "Me", "Cf")  # marks on the letter before, and what is not seen


class Grid:
    """Headings, of one line or two, and rows of cells."""

    def __init__(self, title: str = "", indent: str = "") -> None:
        self.title, self.indent = title, indent
        self.headings: list[str] = []
        self.to_left: list[bool] = []
        self.rows: list[Sequence[str]] = []

    def column(self, heading: str, to_left: bool = False) -> None:
        """Adds one: numbers to the right, words to the left."""
        self.headings.append(heading)
        self.to_left.append(to_left)

    def row(self, cells: Iterable[str]) -> None:
        """Adds one; cells that it has too few of are empty."""
        row = tuple(cells)
        self.rows.append(row + ("",) * (len(self.headings) - len(row)))

    def lines(self) -> Iterator[str]:
        """As plain text, without spaces at the end of a line."""
        if self.title:
            yield self.title
        headings = [heading.split("\n") for heading in self.headings]
        height = max(map(len, headings), default=0)
        head = [[""] * (height - len(lines)) + lines for lines in headings]
        rows = [*zip(*head, strict=True), *self.rows]
        widths = [max(map(width, cells)) for cells in zip(*rows, strict=True)]
        for row in rows:
            cells = map(_filled, row, widths, self.to_left)
            yield (self.indent + GAP.join(cells)).rstrip()

    def drawn(self) -> Table:
        """For a terminal."""
        from rich.table import Table

        table = Table(
            box=None,
            header_style="bold",
            padding=(0, 0, 0, len(GAP)),
            pad_edge=bool(self.indent),
            title=self.title or None,
            title_justify="left",
        )
        for heading, to_left in zip(self.headings, self.to_left, strict=True):
            table.add_column(heading, justify="left" if to_left else "right", no_wrap=True)
        for row in self.rows:
            table.add_row(*row)
        return table


def width(text: str) -> int:
    """How many columns of a terminal it takes; of an emoji that several make up, more.

    >>> width("μ_e"), width("石炭")
    (3, 4)
    """
    if text.isascii():
        return len(text)
    return sum(0 if category(letter) in NO_ROOM else 2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _filled(cell: str, size: int, to_left: bool) -> str:
    """A cell as wide as its column."""
    space = " " * (size - width(cell))
    return cell + space if to_left else space + cell
