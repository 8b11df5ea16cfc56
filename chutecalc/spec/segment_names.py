"""The names of segments, in tables and in key paths: their own, or else their kind."""

from collections.abc import Sequence


def segment_names(segments: Sequence[tuple[str | None, str]]) -> list[str]:
    """Return the name of each segment; one without a name is called by its kind, numbered where that is taken.

    Args:
        segments: name, or None, and kind of each segment.

    >>> segment_names([(None, "fall"), ("spoon", "curve"), (None, "fall")])
    ['fall', 'spoon', 'fall_2']
    """
    names: list[str] = []
    taken = {name for name, _ in segments if name}
    for own, kind in segments:
        free = (f"{kind}_{number}" for number in range(2, len(segments) + 2))
        name = own or next(item for item in (kind, *free) if item not in taken)
        taken.add(name)
        names.append(name)
    return names
