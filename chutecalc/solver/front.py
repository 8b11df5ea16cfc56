"""Where each of many designs stands on a segment: what panels and events do to it."""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status, take
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.motion import ROOF
from chutecalc.physics.section import take_row, wetted_facet
from chutecalc.solver.collocation import rule
from chutecalc.solver.crossing import slope_at
from chutecalc.solver.panel import PLACE_ROUNDING, Panel
from chutecalc.solver.slide import Slide

RUNNING = -1

CONTACT, DEEPER, SHALLOWER, END = range(4)
"""What a margin below zero means, in the order in which margins are stacked."""


class Effort(NamedTuple):
    """How hard to work."""

    first: tuple[int, int]
    """Pair of rules for the whole stretch in one panel."""
    later: tuple[int, int]
    """For designs that the first pair does not solve."""
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
    later = (8, 24) if complete else (8, 16)
    first = (6, 12) if rtol >= 1e-9 and not complete else later
    return Effort(first, later, 0.2 * rtol, max(1e-3 * rtol, 3e-15), rtol, complete)


class Piece(NamedTuple):
    """A panel of some designs as it was solved."""

    rows: Index
    facet: Index
    by_root: bool
    start: Array
    """Of the independent variable (c, or r = √v)."""
    end: Array
    knots: Array
    """Of the unknown (y, or c), shape (N + 2, rows)."""


class Trial(NamedTuple):
    """A solved panel of a block, padded to a multiple of 8 designs."""

    rows: Index
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
        self.facet = np.broadcast_to(wetted_facet(slide.facets, slide.area(y)), y.shape).copy()
        self.status = np.full(y.shape, RUNNING)
        self.limit = _first_limit(slide, place)
        self.reach = self.limit - place
        """The next step in c."""
        self.aim = np.full(y.shape, np.nan)
        """Where an event has fixed the end of the next panel, in c or in r."""
        self.aim_by_root = np.zeros(y.shape, dtype=bool)
        self.tired = np.zeros(y.shape, dtype=bool)
        """Panels in r failed since the last one in c."""
        self.stride = np.ones(y.shape)
        """Share of the way to its goal that a panel in r takes."""
        self.choke = np.full((3, *y.shape), np.nan)
        """Place, y and error where the stream choked."""
        self.pieces: list[Piece] = []
        self.watched = (
            slide.can_lose_contact() or len(slide.facets.area) > 1 or bool(np.isfinite(slide.choke_area).any())
        )

    def velocity_bounds(self, rows: Index) -> tuple[Array, Array, Mask]:
        """Velocities that keep the surface on its facet and below the wall, and where the lower one is the wall's."""
        table = self.slide.facets.area
        foot = take_row(table, self.facet[rows], rows)
        top = take_row(np.concatenate([table[1:], np.full((1, table.shape[1]), np.inf)]), self.facet[rows], rows)
        choke = np.where(np.isfinite(self.choke[0, rows]), np.inf, take(self.slide.choke_area, rows))
        flow = take(self.slide.flow, rows)
        return flow / np.minimum(top, choke), flow / foot, choke <= top

    def margins(self, trial: Trial) -> Array:
        """How far each event is at a panel's knots, shape (events, N + 2, designs): 0 at the event, else of order 1."""
        rows, own = trial.rows, rule(len(trial.panel.knots) - 2).knots[:, None]
        along = trial.start + own * (trial.end - trial.start)
        along[-1] = trial.end  # start + (end - start) loses what a panel down to a thousandth of r has left
        place, velocity = (trial.panel.knots, along**2) if trial.by_root else (along, np.sqrt(trial.panel.knots))
        slowest, fastest, _ = self.velocity_bounds(rows)
        slide = self.slide.rows(rows)
        margins = np.ones((4, *place.shape))
        if slide.can_lose_contact():
            margins[CONTACT] = slide.normal(place, velocity**2) / slide.gravity
        margins[DEEPER] = np.where(slowest > 0.0, velocity / np.where(slowest > 0.0, slowest, 1.0) - 1.0, 1.0)
        margins[SHALLOWER] = 1.0 - velocity / fastest
        if trial.by_root:
            margins[END] = self.limit[rows] - place
        return margins

    def retreat(self, rows: Index, by_root: bool, step: Array) -> None:
        """After a panel that was too long: a step in c instead of one in r, or half the step."""
        self.aim[rows] = np.nan
        if by_root:
            self.stride[rows] *= 0.5
            self.tired[rows] = self.stride[rows] < 0.1
        else:
            self.reach[rows] = 0.5 * step

    def accept(self, trial: Trial, chosen: Index) -> None:
        """Moves designs to the ends of their panels; ``chosen`` are columns of the trial."""
        rows, panel = trial.rows[chosen], trial.panel
        start, end = trial.start[chosen], trial.end[chosen]
        growth, error, knots = panel.growth[chosen], panel.error[chosen], panel.knots[:, chosen]
        if trial.by_root:
            first, last = np.abs(slope_at(knots, 0)), np.abs(slope_at(knots, -1))  # dc over the panel's width in r
            width = np.abs(end - start)
            carried = self.error[rows] * start * first / (4.0 * width)
            shift = np.abs(growth) * carried + error * np.abs(knots[-1] - knots[0]) + PLACE_ROUNDING
            stopped = end == 0.0
            self.error[rows] = np.where(stopped, shift, shift * 4.0 * width / (end * last))
            self.place[rows], self.y[rows] = knots[-1], end**4
            self.status[rows[stopped]] = Status.STALL
            self.stride[rows] = np.minimum(2.0 * self.stride[rows], 1.0)
        else:
            self.error[rows] = np.abs(growth) * self.error[rows] * self.y[rows] / knots[-1] + error
            self.place[rows], self.y[rows] = end, knots[-1]
            self.reach[rows] = 4.0 * (end - start)
            self.stride[rows] = np.where(self.tired[rows], 0.5, self.stride[rows])
            self.tired[rows] = False
            self.arrive(rows[end >= self.limit[rows]])
        self.aim[rows] = np.nan
        if self.effort.complete and rows.size:
            self.pieces.append(Piece(rows, self.facet[rows], trial.by_root, start, end, knots))

    def arrive(self, rows: Index) -> None:
        """At the limit: on to the segment's end, or done."""
        done = self.limit[rows] == 1.0
        self.status[rows[done]] = Status.OK
        self.limit[rows] = 1.0
        self.reach[rows] = 1.0 - self.place[rows]

    def happen(self, rows: Index, event: Index) -> None:
        """What an event does to the designs that stand at it."""
        self.aim[rows] = np.nan
        self.status[rows[event == CONTACT]] = Status.CONTACT_LOST
        deeper = rows[event == DEEPER]
        _, _, is_choke = self.velocity_bounds(deeper)
        choked = deeper[is_choke]
        self.choke[:, choked] = self.place[choked], self.y[choked], self.error[choked]
        if not self.effort.complete:
            self.status[choked] = Status.CHOKE
        self.facet[deeper[~is_choke]] += 1
        self.facet[rows[event == SHALLOWER]] -= 1
        ended = rows[event == END]
        self.place[ended] = self.limit[ended]
        self.arrive(ended)


def _first_limit(slide: Slide, place: Array) -> Array:
    """Where the first panel has to end: a roof that first rises is divided where it is level.

    There, and only there, the normal acceleration can fall to 0 and rise again within a segment.
    """
    if slide.side != ROOF:
        return np.ones(place.shape)
    level = -slide.entry_slope / np.where(slide.turn > 0.0, slide.turn, 1.0)
    return np.where((level > place) & (level < 1.0), level, 1.0)
