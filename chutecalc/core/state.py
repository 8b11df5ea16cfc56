"""Where a stream stands on its segment, and how hard its solver is to work."""

from array import array
from typing import Any

from chutecalc.core import events, floats, gauss, matrix, panel, slide

OK, STALL, CHOKED, CONTACT_LOST, MISSED, NOT_REACHED, PASSED = range(7)
RUNNING, UNSOLVED, FAULT = -1, -2, -3
LEAST_STEP = 1e-14  # of the segment, so that every step is one
KEPT = 32  # numbers of a panel that is kept
PANEL, GAVE_UP, NOT_TANGENT = KEPT, UNSOLVED, FAULT  # as Python sees them; the others are C's where compiled


class Effort:
    """How hard to work, and the rules for it."""

    def __init__(self, first: "gauss.Pair", second: "gauss.Pair", later: "gauss.Pair", near_rest: "gauss.Pair") -> None:
        self.first, self.second = first, second
        """For the whole stretch in one panel; the second where the first does not solve it."""
        self.later, self.near_rest = later, near_rest
        """For panels of a stretch that neither solves; in r."""
        self.tolerance = self.share = 0.0
        """Error that one panel over the whole stretch may have, relative in v², and any panel inside; and that of each
        of several at its end (in r: of the way), for they add up, and near a stop they grow."""
        self.complete = False
        """Keep the panels, right at every place and not at the ends alone; go on past a choke."""


class Log:
    """Panels that are kept, and what it takes to solve one: the same for all segments of a chute."""

    def __init__(self, room: int) -> None:
        self.panel = panel.Panel()
        self.margins, self.values = floats.zeros(matrix.MOST), floats.zeros(matrix.MOST)
        self.kept: Any = floats.zeros(KEPT * max(room, 1))
        """Panels, one after the other: by root, nodes, facet, piece, start, end, knots."""
        self.room = room
        self.count = 0
        self.full = False
        """There was no room for a panel."""


class Stream:
    """Where a stream stands on its segment."""

    def __init__(self, way: "slide.Slide", log: Log) -> None:
        self.way = way
        self.log = log
        self.panel = log.panel
        self.margins, self.values = log.margins, log.values
        self.watched = array("i", [0] * 7)
        """Which events can happen on this segment at all."""
        self.eventful = False
        self.place = self.y = self.error = 0.0
        """c, v², and its relative error; after a stall, of the place."""
        self.status = RUNNING
        self.facet = self.piece = 0
        self.limit = self.reach = self.stride = 1.0
        """Where the panels have to end; the next step in c; the share of the way to its goal that one in r takes."""
        self.aim = floats.NAN
        """Where an event has fixed the end of the next panel, in c or in r."""
        self.aim_by_root = False
        self.promising = True
        """The last panel was a solution, if not a good one, and by its ellipse the finest rules may make it one."""
        self.tried = 0
        """How many panels, also such as were refused."""
        self.tired = False
        """Panels in r failed since the last one in c."""
        self.crossed = floats.NAN
        """Where the friction law's branch last changed."""
        self.choke_place = self.choke_y = self.choke_error = floats.NAN


def margin(stream: Stream, event: int, place: float, y: float) -> float:
    """How far an event is; a choke happens once."""
    if event == events.CHOKE and stream.choke_place == stream.choke_place:
        return 1.0
    return events.margin(stream.way, stream.facet, stream.piece, event, place, y, stream.limit)
