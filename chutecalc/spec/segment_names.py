"""The names of segments, in tables and in key paths: their own, or else their kind."""

from collections.abc import Iterator, Sequence
from itertools import count


def segment_names(segments: Sequence[tuple[str | None, str]]) -> list[str]:
    """Return the name of each segment; one without a name is called by its kind, numbered where that is taken.

    Args:
        segments: name, or None, and kind of each segment.

    >>> segment_names([(None, "fall"), ("spoon", "curve"), (None, "fall")])
    ['fall', 'spoon', 'fall_2']
    """
    names: list[str] = []
    taken = {name for name, _ in segments if name}
    free = {kind: _numbered(kind) for _, kind in segments}
    for own, kind in segments:
        name = own or next(item for item in free[kind] if item not in taken)
        taken.add(name)
        names.append(name)
    return names


def _numbered(kind: str) -> Iterator[str]:
    """Yield the names that segments of a kind may have."""
    yield kind
    yield from (f"{kind}_{number}" for number in count(2))
