"""Text of a given width in the columns of a terminal."""

from unicodedata import category, east_asian_width

ZERO_WIDTH = ("Mn", "Me", "Cf")
"""Unicode categories of characters without width: marks on the letter before, and format characters."""


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


def padded(cell: str, size: int, left: bool) -> str:
    """Return a cell as wide as its column.

    Args:
        cell: text.
        size: width of the column, characters.
        left: whether the text is aligned to the left.
    """
    space = " " * (size - width(cell))
    return cell + space if left else space + cell


def shortened(text: str, most: int) -> str:
    """Return text with an ellipsis in its middle if it is too long.

    Args:
        text: a line.
        most: its largest width, characters.

    >>> shortened("specs/paper/r3_d55_chamfered.toml", 20)
    'specs/pape…ered.toml'
    """
    kept, short = most, text
    while width(short) > most:
        kept -= 1
        short = f"{text[: kept - kept // 2]}…{text[len(text) - kept // 2 :]}"
    return short
