"""Text of a user made safe to show: what would move a cursor, forge a line or break a file stands as its escape."""

from unicodedata import category

JOINERS = "\u200c\u200d"
"""Characters that do not show and that words of some languages are not spelt without."""
LONGEST_LINE = 2000
"""Characters that a line of a message has at most."""


def printable(text: str, keep: str = "") -> str:
    r"""Return text with escape sequences in place of characters that do not show.

    These are control characters, line ends, marks that turn the direction of writing, halves of characters that a file
    name that is not UTF-8 consists of, and what Unicode has not assigned. Spaces of all widths stay. XML 1.0 allows
    all that is left.

    Args:
        text: any text.
        keep: characters that stay as they are.

    >>> print(printable("coal\x1b]0;\u202ex\n42 designs: ok\udcff 石炭"))
    coal\x1b]0;\u202ex\n42 designs: ok\udcff 石炭
    """
    if text.isprintable():
        return text
    kept = JOINERS + keep
    shown = (each.isprintable() or each in kept or category(each) == "Zs" for each in text)
    return "".join(each if show else _escape(each) for each, show in zip(text, shown, strict=True))


def encodable(text: str) -> str:
    """Return text that UTF-8 can hold: halves of characters, as in a file name that is not UTF-8, stand as escapes.

    Args:
        text: any text.
    """
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _escape(character: str) -> str:
    """Return the escape sequence of a character."""
    return character.encode("unicode_escape").decode()


def abbreviated(text: str, most: int = LONGEST_LINE) -> str:
    """Return text with an ellipsis in its middle if it is too long.

    Args:
        text: any text.
        most: its largest number of characters.

    >>> abbreviated("radius_mmmmmmmmmmmmmmmmm", 9)
    'radi…mmmm'
    """
    half = most // 2
    return text if len(text) <= most else f"{text[:half]}…{text[len(text) - (most - half - 1) :]}"
