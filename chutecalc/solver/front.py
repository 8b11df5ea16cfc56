"""Where each of many designs stands on a segment: what panels and events do to it."""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.intervals import take_row
from chutecalc.physics.motion import ROOF
from chutecalc.physics.section import take_facet, wetted_facet
from chutecalc.physics.wall import wall_piece
from chutecalc.solver.crossing import LEVEL, slope_at
from chutecalc.solver.panel import PLACE_ROUNDING, Panel
from chutecalc.solver.slide import Course, Slide

RUNNING = -1
LEAST_STEP = 1e-14  # of the segment, so that every step is one
TIRED, AGAIN = 0.1, 0.15  # of the way to its goal: the least that a panel in r tries, and the first after one in c
CLEAR = 4.0 * LEVEL  # beyond an event by more than it is found within

CONTACT, CHOKE, DEEPER, SHALLOWER, FIRMER, LOOSER, END = range(7)
"""What happens where a margin falls below zero; of two that do at once the first counts."""


class Effort(NamedTuple):
    """How hard to work."""

    whole: tuple[tuple[int, int], ...]
    """Pairs of rules for the whole stretch in one panel, each for the designs that the one before does not solve."""
    later: tuple[int, int]
    """For panels of those that none solves."""
    tolerance: float
    """Error that one panel over the whole stretch may have, relative in v²."""
    share: float
    """The same of each of several panels (in r: of the way): their errors add up, and near a stop they grow."""
    inner_tolerance: float
    """The same between the ends of a panel, where errors are shown but not handed on."""
    complete: bool
    """Keep the panels, right at every place and not at the ends alone; go on past a choke."""


def effort(rtol: float, complete: bool) -> Effort:
    """What it takes to have velocities right within a relative error."""
    first = (6, 8) if rtol >= 1e-7 else (6, 12) if rtol >= 1e-11 else (8, 16)
    whole, later = (((8, 24), (16, 24)), (8, 24)) if complete else ((first, (16, 24)), (8, 16))
    return Effort(whole, later, rtol, max(1e-3 * rtol, 3e-15), rtol, complete)


class Piece(NamedTuple):
    """A panel of some designs as it was solved."""

    rows: Index
    facet: Index
    piece: Index
    by_root: bool
    start: Array
    """Of the independent variable (c, or r = √v)."""
    end: Array
    knots: Array
    """Of the unknown (y, or c), shape (N + 2, rows)."""


class Trial(NamedTuple):
    """A solved panel of a block, padded to a multiple of 8 designs."""

    rows: Index
    window: Index | slice
    """The same designs without the padding, as a slice where they are neighbours."""
    by_root: bool
    start: Array
    end: Array
    panel: Panel
    good: Mask


class Front:
    """Where each design stands while the segment is solved; arrays of shape (designs,), changed in place."""

    def __init__(self, slide: Slide, place: Array, y: Array, error: Array, effort: Effort) -> None:
        self.slide, self.effort = slide, effort
        self.place, self.y, self.error = place.copy(), y.copy(), error.copy()
        table = slide.facets_at(place)
        self.facet = np.zeros(y.shape, dtype=np.intp)
        if len(table.area) > 1:
            self.facet[:] = wetted_facet(table, slide.area(y))
        self.piece = np.zeros(y.shape, dtype=np.intp)
        if len(slide.wall.starts) > 1:
            self.piece = wall_piece(slide.wall, slide.stress(place, y, take_facet(table, self.facet)))
        self.status = np.full(y.shape, RUNNING)
        self.limit = _first_limit(slide, place)
        self.reach = self.limit - place
        """The next step in c."""
        self.aim = np.full(y.shape, np.nan)
        """Where an event has fixed the end of the next panel, in c or in r."""
        self.aim_by_root = np.zeros(y.shape, dtype=bool)
        self.hopeful = np.ones(y.shape, dtype=bool)
        """The last panel was a solution, if not a good one: finer rules may make it one."""
        self.tried = np.zeros(y.shape, dtype=np.intp)
        """How many panels, also such as were refused."""
        self.tired = np.zeros(y.shape, dtype=bool)
        """Panels in r failed since the last one in c."""
        self.stride = np.ones(y.shape)
        """Share of the way to its goal that a panel in r takes."""
        self.crossed = np.full(y.shape, np.nan)
        """Where the friction law's branch last changed."""
        self.choke = np.full((3, *y.shape), np.nan)
        """Place, y and error where the stream choked."""
        self.pieces: list[Piece] = []
        watched = {
            CONTACT: slide.can_lose_contact(),
            CHOKE: bool(np.isfinite(slide.section.wall_height).any()),
            DEEPER: len(table.area) > 1,
            SHALLOWER: len(table.area) > 1,
            FIRMER: len(slide.wall.starts) > 1,
            LOOSER: len(slide.wall.starts) > 1,
        }
        self.events = tuple(event for event, there in watched.items() if there)
        """What can happen on this segment at all."""

    def course(self, rows: Index | slice) -> Course:
        """The branches of the friction law that designs are on."""
        return Course(self.slide.rows(rows), self.facet[rows], self.piece[rows])

    def velocity_bounds(self, rows: Index) -> tuple[Array, Array]:
        """Velocities that keep the surface on its facet, and below the wall; none along a taper, where they move."""
        slide, facet = self.slide.rows(rows), self.facet[rows]
        if slide.end_section is not None:
            return np.zeros(len(rows)), np.full(len(rows), np.inf)
        foot, top = _ends(slide.drawn.area, facet)
        if CHOKE in self.events:
            unchoked = ~np.isfinite(self.choke[0, rows])
            top = np.minimum(top, np.where(unchoked, slide.choke_area(self.place[rows]), np.inf))
        return slide.flow / top, slide.flow / foot

    def margins(self, rows: Index, place: Array, y: Array, by_root: bool) -> Array:
        """How far each event is, 0 at it and else of order 1, at places and their v².

        Args:
            rows: the designs.
            place, y: shape (..., designs).
            by_root: whether the segment's end is an event too.

        Returns:
            Shape (events, ..., designs); the events are ``self.events``, and ``END`` last.
        """
        slide, facet, velocity = self.slide.rows(rows), self.facet[rows], np.sqrt(y)
        table = slide.facets_at(place)
        found: dict[int, Array] = {}
        if CONTACT in self.events:
            found[CONTACT] = slide.normal(place, y) / slide.gravity
        if CHOKE in self.events:
            near = _closeness(velocity * slide.choke_area(place), slide.flow)
            found[CHOKE] = np.where(np.isnan(self.choke[0, rows]), near, 1.0)
        if DEEPER in self.events:
            foot, top = _ends(table.area, facet)
            found[DEEPER] = _closeness(velocity * top, slide.flow)
            found[SHALLOWER] = 1.0 - velocity * foot / slide.flow
        if FIRMER in self.events:
            stress = slide.stress(place, y, take_facet(table, facet))
            least, most = _ends(slide.wall.starts, self.piece[rows])
            press, pull = np.maximum(stress, 0.0), np.minimum(stress, 0.0)  # pull: beyond a loss of contact
            found[FIRMER] = _balance(most, press) - 2.0 * pull / most
            found[LOOSER] = np.where(least > 0.0, _balance(press, least) + 2.0 * pull / least, 1.0)
        if by_root:
            found[END] = self.limit[rows] - place
        return np.stack([np.broadcast_to(margin, y.shape) for margin in found.values()])

    def retreat(self, rows: Index, by_root: bool, step: Array) -> None:
        """After a panel that was too long: a step in c instead of one in r, or half the step."""
        self.aim[rows] = np.nan
        if by_root:
            self.stride[rows] *= 0.5
            self.tired[rows] = self.stride[rows] < TIRED
        else:
            self.reach[rows] = np.maximum(0.5 * step, LEAST_STEP)

    def chatter(self, rows: Index, by_root: bool, step: Array) -> None:
        """Designs that a panel takes back over the boundary that they have just crossed: a shorter one will tell.

        Next to a balance that does not hold, a long one lets rounding grow until it decides.
        """
        self.reach[rows] = np.maximum(0.25 * (self.reach[rows] if by_root else step), LEAST_STEP)
        self.tired[rows] |= by_root

    def accept(self, trial: Trial, chosen: Index | slice) -> None:
        """Moves designs to the ends of their panels; ``chosen`` are columns of the trial, a slice for all of them."""
        rows, panel = trial.rows[chosen], trial.panel
        where = trial.window if isinstance(chosen, slice) else rows
        start, end = trial.start[chosen], trial.end[chosen]
        growth, last = panel.growth[-1, chosen], panel.knots[-1, chosen]
        error = panel.error[chosen] + panel.rounding[chosen]
        keep = self.effort.complete and rows.size > 0
        knots = panel.knots[:, chosen] if keep or trial.by_root else panel.knots
        if trial.by_root:
            fast, slow = np.abs(slope_at(knots, 0)), np.abs(slope_at(knots, -1))  # dc over the panel's width in r
            width = np.abs(end - start)
            carried = self.error[where] * start * fast / (4.0 * width)
            shift = np.abs(growth) * carried + error * np.abs(last - knots[0]) + PLACE_ROUNDING
            stopped = end == 0.0
            self.error[where] = np.where(stopped, shift, shift * 4.0 * width / (end * slow))
            self.place[where], self.y[where] = last, end**4
            self.status[rows[stopped]] = Status.STALL
            self.stride[where] = np.minimum(2.0 * self.stride[where], 1.0)
        else:
            self.error[where] = np.abs(growth) * self.error[where] * self.y[where] / last + error
            self.place[where], self.y[where] = end, last
            reached = end >= self.limit[where]
            if reached.all():
                self.arrive(where)
            else:
                self.arrive(rows[reached])
                self.step_on(rows[~reached], (end - start)[~reached])
        self.aim[where] = np.nan
        if keep:
            self.pieces.append(Piece(rows, self.facet[rows], self.piece[rows], trial.by_root, start, end, knots))

    def step_on(self, rows: Index, step: Array) -> None:
        """After a panel in c that has not come to the limit."""
        before = np.where(np.isfinite(self.aim[rows]), self.reach[rows], LEAST_STEP)  # cut short by an event
        self.reach[rows] = np.maximum(4.0 * step, before)
        self.stride[rows] = np.where(self.tired[rows], AGAIN, self.stride[rows])
        self.tired[rows] = False

    def arrive(self, rows: Index | slice) -> None:
        """At the limit: on to the segment's end, or done."""
        limit = self.limit[rows]
        if (limit == 1.0).all():
            self.status[rows] = Status.OK
            return
        self.status[rows] = np.where(limit == 1.0, Status.OK, self.status[rows])
        self.limit[rows] = 1.0
        self.reach[rows] = 1.0 - self.place[rows]

    def happen(self, rows: Index, event: Index) -> None:
        """What an event does to the designs that stand at it."""
        self.aim[rows] = np.nan
        self.status[rows[event == CONTACT]] = Status.CONTACT_LOST
        choked = rows[event == CHOKE]
        self.choke[:, choked] = self.place[choked], self.y[choked], self.error[choked]
        if not self.effort.complete:
            self.status[choked] = Status.CHOKE
        crossing = rows[(event != CONTACT) & (event != CHOKE) & (event != END)]
        self.crossed[crossing] = self.place[crossing]
        self._cross(rows[event == DEEPER], rows[event == SHALLOWER], rows[event == FIRMER], rows[event == LOOSER])
        ended = rows[event == END]
        self.place[ended] = self.limit[ended]
        self.arrive(ended)

    def _cross(self, deeper: Index, shallower: Index, firmer: Index, looser: Index) -> None:
        """On to the next facet or piece that is not empty."""
        for rows, side in ((deeper, 1), (shallower, -1)):
            if rows.size:
                slide = self.slide.rows(rows)
                area = slide.area(self.y[rows]) * (1.0 + side * CLEAR)
                there = wetted_facet(slide.facets_at(self.place[rows]), area)
                self.facet[rows] = _beyond(self.facet[rows], there, side)
        for rows, side in ((firmer, 1), (looser, -1)):
            if rows.size:
                slide, place = self.slide.rows(rows), self.place[rows]
                facet = take_facet(slide.facets_at(place), self.facet[rows])
                stress = slide.stress(place, self.y[rows], facet) * (1.0 + side * CLEAR)
                there = wall_piece(slide.wall, stress)
                self.piece[rows] = _beyond(self.piece[rows], there, side)


def _beyond(number: Index, there: Index, side: int) -> Index:
    """The interval found on a side of the one left, and the next one at least."""
    further: Index = side * np.maximum(side * there, side * number + 1)
    return further


def _ends(starts: Array, number: Index) -> tuple[Array, Array]:
    """Where the interval of a number begins and ends, of those that begin at ``starts``, shape (intervals, ...)."""
    ends = np.concatenate([starts[1:], np.full((1, *starts.shape[1:]), np.inf)])
    return take_row(starts, number), take_row(ends, number)


def _balance(more: Array, less: Array) -> Array:
    """(more - less)/(more + less), with its limits where one of the two is infinite."""
    inside = (more - less) / (more + less)
    return np.where(np.isfinite(more), np.where(np.isfinite(less), inside, -1.0), 1.0)


def _closeness(value: Array, limit: Array) -> Array:
    """Value over limit less 1; 1 where there is no limit to come near."""
    return np.where(np.isfinite(value), value / limit - 1.0, 1.0)


def _first_limit(slide: Slide, place: Array) -> Array:
    """Where the first panel has to end: a roof that first rises is divided where it is level.

    There, and only there, the normal acceleration can fall to 0 and rise again within a segment.
    """
    if slide.side != ROOF:
        return np.ones(place.shape)
    level = -slide.entry_slope / np.where(slide.turn > 0.0, slide.turn, 1.0)
    return np.where((level > place) & (level < 1.0), level, 1.0)
