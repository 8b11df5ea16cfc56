"""How a design, or one of its segments, ends."""


class Status:
    """Numbers that say how a design, or one of its segments, ends.

    Plain numbers: NumPy takes ten microseconds to compare an array with a member of an enumeration.
    """

    OK, STALL, CHOKE, CONTACT_LOST, MISSED, NOT_REACHED, PASSED = range(7)
    """Number of each status. From ``MISSED`` on the stream has not touched the segment; one that it flies past is
    ``PASSED``."""

    LABELS = ("ok", "stall", "choke", "contact_lost", "missed", "not_reached", "passed")
    """Names of the statuses in tables, JSON and CSV, by number."""

    OK_LABEL = LABELS[OK]
    IMPOSSIBLE_LABEL = "impossible"
    """Status in a study of a variant whose section cannot be built, and which is therefore never solved."""


MEANINGS = dict(
    zip(
        Status.LABELS,
        (
            "the stream gets through",
            "the stream comes to rest",
            "the stream fills the section, or is deeper than its walls are high",
            "the stream leaves its surface, and nothing catches it",
            "the stream flies past what should catch it",
            "the stream does not get as far as this segment",
            "the stream flies past this segment or through it, which is no failure",
        ),
        strict=True,
    )
) | {Status.IMPOSSIBLE_LABEL: "the design cannot be built, and is not solved"}
"""What each status means."""
