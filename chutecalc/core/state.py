"""Hold the state of a stream on its segment and the options of its solver."""

from array import array
from typing import Any

from chutecalc.core import events, floats, gauss, guide_surface, matrix, panel

OK, STALL, CHOKED, CONTACT_LOST, MISSED, NOT_REACHED, PASSED, JUMPED = range(8)
RUNNING, UNSOLVED, FAULT = -1, -2, -3
LEAST_STEP = 1e-14  # share: the shortest step that still advances
PANEL_SIZE = 32  # numbers of a stored panel
# For Python; the others are C constants if compiled.
PANEL_NUMBERS, GAVE_UP, NOT_TANGENT, HAS_JUMPED = PANEL_SIZE, UNSOLVED, FAULT, JUMPED


class SolverOptions:
    """Tolerances, and pairs of collocation rules for each use."""

    def __init__(
        self,
        first_pair: "gauss.RulePair",
        second_pair: "gauss.RulePair",
        step_pair: "gauss.RulePair",
        r_pair: "gauss.RulePair",
    ) -> None:
        self.first_pair, self.second_pair = first_pair, second_pair
        """Rules for the whole segment as one panel; the second pair is tried where the first misses the tolerance."""
        self.step_pair, self.r_pair = step_pair, r_pair
        """Rules for the panels of a segment that takes several: in c, and in r."""
        self.tolerance = self.panel_tolerance = 0.0
        """Error allowed to one panel over the whole segment, relative in v², and inside any panel. ``panel_tolerance``
        is allowed at the end of each of several panels (in r relative to its length): errors add up, and grow near
        a stop."""
        self.dense_output = False
        """Keep the panels, accurate at every share and not at their ends alone, and continue past a choke."""


class PanelStore:
    """Accepted panels, and the work arrays to solve one; all segments of a chute share it."""

    def __init__(self, capacity: int) -> None:
        self.panel = panel.Panel()
        self.event_values, self.work = floats.zeros(matrix.ROOM), floats.zeros(matrix.ROOM)
        self.panels: Any = floats.zeros(PANEL_SIZE * max(capacity, 1))
        """Panels one after the other: in r (1 or 0), nodes, facet, piece, start, end, solution at the knots."""
        self.capacity = capacity
        self.count = 0
        self.full = False
        """Set when there was no room for a panel."""


class Stream:
    """State of a stream on its segment, as the stepping routines advance it."""

    def __init__(self, guide: "guide_surface.Guide", store: PanelStore) -> None:
        self.guide = guide
        self.store = store
        self.panel = store.panel
        self.event_values, self.work = store.event_values, store.work
        self.active_events = array("i", [0] * events.SEGMENT_END)
        """Which events can occur on this segment at all."""
        self.has_events = False
        self.share = self.y = self.error = 0.0
        """Share c of the segment's length, v² in m²/s², and its relative error; after a stall the error of the
        share."""
        self.status = RUNNING
        self.facet = self.piece = 0
        self.breakpoint = self.next_step = self.r_fraction = 1.0
        """Share where the next panels have to end; next step in c; fraction of the distance to the goal that a step in
        r takes."""
        self.event_target = floats.NAN
        """End of the next panel if an event has fixed it, in c or in r; else NaN."""
        self.target_in_r = False
        self.try_finer = True
        """Whether the last panel has a solution that the finest rules may bring within tolerance, by its ellipse."""
        self.attempts = 0
        """Number of panels solved, rejected ones included."""
        self.r_rejected = False
        """Whether panels in r have failed since the last accepted one in c."""
        self.last_crossing = floats.NAN
        """Share at which the branch of the friction law last changed."""
        self.shift = 0.0
        """Error of the share at which its last panel ends; after a panel in c that of v², relative."""
        self.choke_share = self.choke_y = self.choke_error = floats.NAN


def event_function(stream: Stream, event: int, share: float, y: float) -> float:
    """Return the value of an event function at a share and a v²; a choke occurs once."""
    if event == events.CHOKE and stream.choke_share == stream.choke_share:
        return 1.0
    return events.event_function(stream.guide, stream.facet, stream.piece, event, share, y, stream.breakpoint)
