"""Columns of text under headings: drawn by rich on a terminal, and laid out alike as plain lines elsewhere.

Loading rich takes a tenth of the time of a whole run, and a pipe shows none of what it can do.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING
from unicodedata import category, east_asian_width

if TYPE_CHECKING:
    from rich.table import Table

GAP = "  "
"""Text between two columns."""
ZERO_WIDTH = ("Mn", "Me", "Cf")
"""Unicode categories of characters without width: marks on the letter before, and format characters."""


class Grid:
    """Headings of one line or two, and rows of cells.

    Args:
        title: a line above the headings, or empty.
        indent: text before each line.
    """

    def __init__(self, title: str = "", indent: str = "") -> None:
        self.title, self.indent = title, indent
        self.headings: list[str] = []
        self.left_aligned: list[bool] = []
        self.rows: list[Sequence[str]] = []

    def column(self, heading: str, left: bool = False) -> None:
        """Add a column.

        Args:
            heading: its heading, with a line break before the unit.
            left: whether cells are aligned to the left, as words are, rather than to the right, as numbers are.
        """
        self.headings.append(heading)
        self.left_aligned.append(left)

    def row(self, cells: Iterable[str]) -> None:
        """Add a row. Missing cells at its end are empty.

        Args:
            cells: text of the cells, from the first column on.
        """
        row = tuple(cells)
        self.rows.append(row + ("",) * (len(self.headings) - len(row)))

    def lines(self) -> Iterator[str]:
        """Yield lines of plain text, without blanks at their ends."""
        if self.title:
            yield self.title
        headings = [heading.split("\n") for heading in self.headings]
        height = max(map(len, headings), default=0)
        head = [[""] * (height - len(lines)) + lines for lines in headings]
        rows = [*zip(*head, strict=True), *self.rows]
        widths = [max(map(width, cells)) for cells in zip(*rows, strict=True)]
        for row in rows:
            cells = map(_padded, row, widths, self.left_aligned)
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
        for heading, left in zip(self.headings, self.left_aligned, strict=True):
            table.add_column(heading, justify="left" if left else "right", no_wrap=True)
        for row in self.rows:
            table.add_row(*row)
        return table


def width(text: str) -> int:
    """Return how many columns of a terminal a text takes. Emoji made of several characters count more than they take.

    Args:
        text: any text.

    >>> width("μ_e"), width("石炭")
    (3, 4)
    """
    if text.isascii():
        return len(text)
    return sum(0 if category(letter) in ZERO_WIDTH else 2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _padded(cell: str, size: int, left: bool) -> str:
    """Return a cell as wide as its column."""
    space = " " * (size - width(cell))
    return cell + space if left else space + cell
