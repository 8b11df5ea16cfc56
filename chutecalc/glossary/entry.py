"""What is known of a word."""

from collections.abc import Iterator
from typing import NamedTuple

Facts = tuple[tuple[str, str], ...]
"""What is known beside the meaning: pairs of a heading and a text."""


NAMED = (("sections",), ("liners",), ("segments",))
"""Tables of a spec whose tables have names of the user's own."""


class Entry(NamedTuple):
    """A word, as one catalogue explains it."""

    group: str
    """Name of the catalogue."""
    word: str
    meaning: str
    facts: Facts = ()
    places: tuple[str, ...] = ()
    """Paths of the tables in which a key stands."""
    derived: bool = False
    """Whether it is made from another word: a key in another unit, a column of a sweep."""

    def stands_at(self, path: tuple[str, ...]) -> bool:
        """Return whether a key path leads to it.

        Args:
            path: parts of the path before the key.

        >>> Entry("keys", "radius_m", "radius", places=("segments",)).stands_at(("segments", "spoon"))
        True
        """
        own = [part for part in path[:1] + path[2 if path[:1] in NAMED else 1 :] if not part.isdecimal()]
        return ".".join(own) in self.places

    def mentions(self, text: str) -> bool:
        """Return whether the word, its meaning or what is known of it has some text in it.

        Args:
            text: in lower case.
        """
        return text in f"{self.word}\n{self.meaning}\n{dict(self.facts).get('name', '')}".lower()


def facts(**texts: str) -> Facts:
    """Return facts of those texts that are not empty; an underscore in a heading stands for a blank.

    Args:
        texts: by heading.

    >>> facts(unit="m", read_by="", usual_range="0.1 to 2")
    (('unit', 'm'), ('usual range', '0.1 to 2'))
    """
    return tuple((heading.replace("_", " "), text) for heading, text in texts.items() if text)


def listed(names: Iterator[str] | list[str] | tuple[str, ...]) -> str:
    """Return names with commas between.

    Args:
        names: of anything.
    """
    return ", ".join(names)
