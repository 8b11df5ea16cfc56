"""Words by name, by key path, by what they mean."""

from collections.abc import Iterable
from difflib import get_close_matches
from functools import cache

from chutecalc.glossary.columns import column_entries
from chutecalc.glossary.entry import Entry, facts
from chutecalc.glossary.findings import finding_entries
from chutecalc.glossary.keys import key_entries, table_entries
from chutecalc.results.symbols import SYMBOLS

SYMBOLS_GROUP = "symbols"
OF_OTHER_PATHS = {"cases": 2, "uncertainty": 1}
"""Tables whose keys are paths, with the number of names before those."""


@cache
def entries() -> tuple[Entry, ...]:
    """Return all entries, catalogue by catalogue.

    >>> len({entry.group for entry in entries()}) > 10
    True
    """
    symbols = (
        Entry(SYMBOLS_GROUP, name, one.meaning, facts(unit=one.unit, source=one.source, docs="docs/nomenclature.md"))
        for one in SYMBOLS
        for name in one.symbol.split(", ")
    )
    return (*key_entries(), *table_entries(), *finding_entries(), *column_entries(), *symbols)


def found(word: str, others: Iterable[Entry] = ()) -> list[Entry]:
    """Return the entries of a word: a name, or a key path such as ``segments.spoon.radius_mm``.

    Args:
        word: as a spec, a command line or a table has it; its case counts only where there are both.
        others: entries beside those of this package.

    >>> [entry.group for entry in found("froude")], [dict(entry.facts)["unit"][:2] for entry in found("flow.rate_kg_s")]
    (['columns along the stream'], ['kg'])
    """
    known = [*entries(), *others]
    *path, name = word.strip("[]").split(".")
    path = path[OF_OTHER_PATHS.get(path[0], 0) :] if path else path
    if path:
        return [entry for entry in known if entry.word == name and entry.stands_at(tuple(path))]
    exact = [entry for entry in known if entry.word == name]
    return exact or [entry for entry in known if entry.word.lower().lstrip("-") == name.lower()]


def about(text: str, others: Iterable[Entry] = ()) -> list[Entry]:
    """Return the entries that have some text in their name or meaning.

    Args:
        text: any.
        others: entries beside those of this package.

    >>> [entry.word for entry in about("thicker than")]
    []
    >>> "sliding_life_h" in [entry.word for entry in about("wears through")]
    True
    """
    return [entry for entry in [*entries(), *others] if not entry.derived and entry.mentions(text.lower())]


def close_to(word: str, others: Iterable[Entry] = ()) -> list[str]:
    """Return the words that are spelt most like one that there is not.

    Args:
        word: the word, or a key path that ends in it.
        others: entries beside those of this package.

    >>> close_to("segments.spoon.radus_m")[0]
    'radius_m'
    """
    names = dict.fromkeys(entry.word for entry in [*entries(), *others])
    return get_close_matches(word.rpartition(".")[2], names, n=3)
