"""The layers of a drawing, and how each is drawn."""

from collections.abc import Sequence
from typing import NamedTuple


class Layer(NamedTuple):
    """A layer of a drawing."""

    name: str
    colour: int
    """Number in AutoCAD's index of colours; 7 is black on white."""
    linetype: str
    """One of :data:`LINETYPES`, or ``CONTINUOUS``."""
    weight: int
    """Thickness of its lines, 1/100 mm."""
    holds: str
    """What is on it."""
    shown: bool = True
    """Whether it is to be seen, or frozen."""


LINETYPES = {
    "HIDDEN": ("dashes, 3 mm", (3.0, -1.5)),
    "CENTER": ("long and short dashes", (9.0, -1.5, 1.5, -1.5)),
    "DOT": ("dots", (0.3, -1.2)),
}
"""Meaning and pattern of line types, mm on paper: dashes, and gaps as negative lengths."""

STEEL = Layer("STEEL", 7, "CONTINUOUS", 50, "surfaces that the stream slides on: inner face of the liner")
ROOFS = Layer("ROOFS", 7, "CONTINUOUS", 35, "the opposite wall of pipes and boxes, and their ends")
WALLS = Layer("WALLS", 8, "CONTINUOUS", 25, "tops of walls whose height is given, and their ends")
FOLDS = Layer("FOLDS", 8, "HIDDEN", 18, "edges of facets, such as the tops of chamfers")
SECTIONS = Layer("SECTIONS", 7, "CONTINUOUS", 35, "sections at both ends of each segment, looking along the stream")
STREAM = Layer("STREAM", 30, "CONTINUOUS", 18, "the stream on its surfaces and on the belt, and its level in sections")
FLIGHT = Layer("FLIGHT", 30, "HIDDEN", 18, "edges of the stream in flight")
LOST = Layer("LOST", 1, "DOT", 18, "how a stream flies on that misses or leaves the chute; not solved")
BELTS = Layer("BELTS", 5, "CONTINUOUS", 35, "both belts, and the head pulley with its axes")
DIMENSIONS = Layer("DIMENSIONS", 3, "CONTINUOUS", 18, "coordinates, lengths, radii, and slopes from the horizontal")
TEXT = Layer("TEXT", 7, "CONTINUOUS", 18, "title, names, and the table of setting-out points")
LAYERS = (STEEL, ROOFS, WALLS, FOLDS, SECTIONS, STREAM, FLIGHT, LOST, BELTS, DIMENSIONS, TEXT)
"""All layers of a chute; each of its cases adds one."""


def case_layer(case: str, others: Sequence[str] = ()) -> Layer:
    """Return the layer of the stream of a case, which is frozen.

    Args:
        case: its name.
        others: names of cases that have layers already, for which capitals make no difference.

    >>> case_layer("wet").name, case_layer("Wet", ["wet"]).name
    ('STREAM_wet', 'STREAM_Wet_2')
    """
    alike = sum(case.casefold() == other.casefold() for other in others)
    name = f"STREAM_{case}_{alike + 1}" if alike else f"STREAM_{case}"
    return Layer(name, 6, "CONTINUOUS", 13, f"the stream of the case {case}", shown=False)
