"""One contact segment for many designs: adaptive panels, and the events that end or divide a stretch.

Each design first tries the whole way in one panel. Where the two rules disagree it goes on in its own steps: in c while
the velocity changes gently, in r = √v towards a stop or away from rest. A panel never crosses a kink of the friction
law (the top of a facet): it is cut where the depth passes it, as it is cut where the stream chokes or loses contact.
"""

from typing import NamedTuple

import numpy as np

from chutecalc.design import Status, take
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.physics.motion import ROOF
from chutecalc.physics.section import take_facet, take_row, wetted_facet
from chutecalc.solver.collocation import rule
from chutecalc.solver.crossing import LEVEL, first_crossing, slope_at
from chutecalc.solver.panel import PLACE_ROUNDING, Panel, panel_by_place, panel_by_root
from chutecalc.solver.slide import Slide, field, rates

RUNNING = -1
PASSES = 2000  # a bound, so that no input can hang; the hardest stretch of 12,000 random chutes took 300
BLOCK = {8: 2048, 12: 1680, 16: 960, 24: 432}  # designs whose matrix products stay in cache and on one core

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


class Stretch(NamedTuple):
    """What became of the designs on a segment, an entry each."""

    status: Index
    place: Array
    """c where the stretch ends."""
    velocity_squared: Array
    error: Array
    """Relative, of v²; after a stall, of the place in c."""
    beyond: Array
    """After a choke: c where the stream would stop, 1 where it would run on; NaN else."""
    pieces: list[Piece]


class _Front:
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


def solve_stretch(slide: Slide, place: Array, velocity_squared: Array, error: Array, effort: Effort) -> Stretch:
    """Carries n streams along one contact segment.

    Args:
        slide: the segment and the flow.
        place: c where each stream meets the segment, in [0, 1), shape (n,).
        velocity_squared: y there, m²/s², positive, shape (n,).
        error: its relative error, shape (n,).
        effort: how hard to work.

    Returns:
        How and where each ended. Statuses are those of :class:`~chutecalc.design.Status`.

    Raises:
        RuntimeError: a stretch took more than ``PASSES`` panels: a fault of the solver, not of the chute.
    """
    front = _Front(slide, place, velocity_squared, error, effort)
    running = np.arange(len(place))
    if front.watched:
        _start_events(front, running)
        running = np.flatnonzero(front.status == RUNNING)
    _advance(front, running, False, front.limit[running], effort.first, effort.tolerance, True)
    front.reach = front.limit - front.place  # the finer rules may yet do it in one
    for _ in range(PASSES):
        running = np.flatnonzero(front.status == RUNNING)
        if not running.size:
            return _result(front)
        change = _change(front, running)
        if _cross_boundaries(front, running, change):
            continue
        by_root, target = _choose(front, running, change)
        for mode in (False, True):
            chosen = by_root == mode
            _advance(front, running[chosen], mode, target[chosen], effort.later, effort.share, False)
    raise RuntimeError(f"a contact segment was not solved in {PASSES} panels")


def _first_limit(slide: Slide, place: Array) -> Array:
    """Where the first panel has to end: a roof that first rises is divided where it is level.

    There, and only there, the normal acceleration can fall to 0 and rise again within a segment.
    """
    if slide.side != ROOF:
        return np.ones(place.shape)
    level = -slide.entry_slope / np.where(slide.turn > 0.0, slide.turn, 1.0)
    return np.where((level > place) & (level < 1.0), level, 1.0)


def _change(front: _Front, rows: Index) -> Array:
    """dy/dc where the designs stand."""
    slide, facet = front.slide.rows(rows), front.facet[rows]
    at = field(slide, front.place[rows], np.ones(1))
    change, _ = rates(slide, take_facet(slide.facets, facet), at, front.y[rows])
    return change


def _cross_boundaries(front: _Front, rows: Index, change: Array) -> bool:
    """Takes designs that stand at a boundary of their facet, on their way out of it, over to the next."""
    slowest, fastest, _ = front.velocity_bounds(rows)
    velocity = np.sqrt(front.y[rows])
    deeper = (change < 0.0) & (velocity <= slowest * (1.0 + LEVEL))
    shallower = (change > 0.0) & (velocity >= fastest * (1.0 - LEVEL))
    leaving = deeper | shallower
    _happen(front, rows[leaving], np.where(deeper, DEEPER, SHALLOWER)[leaving])
    return bool(leaving.any())


def _choose(front: _Front, rows: Index, change: Array) -> tuple[Mask, Array]:
    """The variable and the end of each design's next panel.

    In r towards a stop that is near, or away from a start near rest; in c else. Panels that turn out too long are refused
    and shortened.
    """
    place, y = front.place[rows], front.y[rows]
    rest = front.limit[rows] - place
    scale = np.abs(y / change)
    slowest, fastest, _ = front.velocity_bounds(rows)
    fresh = ~front.tired[rows]
    stopping = fresh & (change < 0.0) & (scale < 0.5 * rest)
    starting = fresh & (change > 0.0) & (scale < 0.2 * rest)
    far = np.minimum((y + 0.5 * change * rest) ** 0.25, np.sqrt(fastest))
    step = np.where(fresh, front.reach[rows], np.minimum(front.reach[rows], 0.5 * scale))
    by_place = np.where(step < rest, place + step, front.limit[rows])
    by_root = stopping | starting
    root = np.sqrt(np.sqrt(y))
    goal = np.where(stopping, np.sqrt(slowest), far)
    stride = front.stride[rows]
    towards = np.where(stride < 1.0, root + stride * (goal - root), goal)
    target = np.where(by_root, towards, by_place)
    aimed = np.isfinite(front.aim[rows])
    return np.where(aimed, front.aim_by_root[rows], by_root), np.where(aimed, front.aim[rows], target)


def _advance(
    front: _Front, rows: Index, by_root: bool, target: Array, pair: tuple[int, int], tolerance: float, whole: bool
) -> None:
    """Solves one panel for each of the rows, a block of designs at a time, and judges it."""
    block = BLOCK[pair[1]]
    for first in range(0, len(rows), block):
        chunk = rows[first : first + block]
        pad = np.minimum(np.arange(-(-len(chunk) // 8) * 8), len(chunk) - 1)
        padded, end = chunk[pad], target[first : first + block][pad]
        slide = front.slide.rows(padded)
        facet = take_facet(slide.facets, front.facet[padded])
        place, y = front.place[padded], front.y[padded]
        if by_root:
            start = np.sqrt(np.sqrt(y))
            panel = panel_by_root(slide, facet, start, end - start, place, pair)
        else:
            start = place
            panel = panel_by_place(slide, facet, start, end - start, y, pair, whole)
        good = panel.error <= tolerance
        if front.effort.complete:
            good &= panel.inner_error <= front.effort.inner_tolerance
        _judge(front, _Trial(padded, by_root, start, end, panel, good), len(chunk))


class _Trial(NamedTuple):
    """A solved panel of a block, padded to a multiple of 8 designs."""

    rows: Index
    by_root: bool
    start: Array
    end: Array
    panel: Panel
    good: Mask


def _judge(front: _Front, trial: _Trial, count: int) -> None:
    """Takes each panel, or sets what to try instead: a shorter one, or one that ends where an event lies inside it."""
    rows, start, end = trial.rows[:count], trial.start[:count], trial.end[:count]
    good = trial.good[:count]
    if not good.all():
        _retreat(front, rows[~good], trial.by_root, (end - start)[~good])
    if not (front.watched or trial.by_root):
        _accept(front, trial, np.flatnonzero(good))
        return
    margins = _margins(front, trial)
    crossings = np.stack([first_crossing(margin)[:count] for margin in margins])
    cut, event = crossings.min(axis=0), crossings.argmin(axis=0)
    inside = good & (cut < 1.0) & (cut > 0.0)
    front.aim[rows[inside]] = (start + cut * (end - start))[inside]
    front.aim_by_root[rows[inside]] = trial.by_root
    at_once = good & (cut == 0.0)
    _happen(front, rows[at_once], event[at_once])
    whole = np.flatnonzero(good & (cut > 1.0))
    _accept(front, trial, whole)
    ends = ((margins[:, -1] <= LEVEL) & (margins[:, -1] < margins[:, 0]))[:, whole]
    hit = ends.any(axis=0)
    _happen(front, rows[whole][hit], ends.argmax(axis=0)[hit])


def _retreat(front: _Front, rows: Index, by_root: bool, step: Array) -> None:
    """After a panel that was too long: a step in c instead of one in r, or half the step."""
    front.aim[rows] = np.nan
    if by_root:
        front.stride[rows] *= 0.5
        front.tired[rows] = front.stride[rows] < 0.1
    else:
        front.reach[rows] = 0.5 * step


def _accept(front: _Front, trial: _Trial, chosen: Index) -> None:
    """Moves designs to the ends of their panels; ``chosen`` are columns of the trial."""
    rows, panel = trial.rows[chosen], trial.panel
    start, end = trial.start[chosen], trial.end[chosen]
    growth, error, knots = panel.growth[chosen], panel.error[chosen], panel.knots[:, chosen]
    if trial.by_root:
        first, last = np.abs(slope_at(knots, 0)), np.abs(slope_at(knots, -1))  # dc over the panel's width in r
        width = np.abs(end - start)
        carried = front.error[rows] * start * first / (4.0 * width)
        shift = np.abs(growth) * carried + error * np.abs(knots[-1] - knots[0]) + PLACE_ROUNDING
        stopped = end == 0.0
        front.error[rows] = np.where(stopped, shift, shift * 4.0 * width / (end * last))
        front.place[rows], front.y[rows] = knots[-1], end**4
        front.status[rows[stopped]] = Status.STALL
        front.stride[rows] = np.minimum(2.0 * front.stride[rows], 1.0)
    else:
        front.error[rows] = np.abs(growth) * front.error[rows] * front.y[rows] / knots[-1] + error
        front.place[rows], front.y[rows] = end, knots[-1]
        front.reach[rows] = 4.0 * (end - start)
        front.stride[rows] = np.where(front.tired[rows], 0.5, front.stride[rows])
        front.tired[rows] = False
        _arrive(front, rows[end >= front.limit[rows]])
    front.aim[rows] = np.nan
    if front.effort.complete and rows.size:
        front.pieces.append(Piece(rows, front.facet[rows], trial.by_root, start, end, knots))


def _arrive(front: _Front, rows: Index) -> None:
    """At the limit: on to the segment's end, or done."""
    done = front.limit[rows] == 1.0
    front.status[rows[done]] = Status.OK
    front.limit[rows] = 1.0
    front.reach[rows] = 1.0 - front.place[rows]


def _margins(front: _Front, trial: _Trial) -> Array:
    """How far each event is at a panel's knots, shape (events, N + 2, designs): 0 at the event, else of order 1."""
    rows, own = trial.rows, rule(len(trial.panel.knots) - 2).knots[:, None]
    along = trial.start + own * (trial.end - trial.start)
    along[-1] = trial.end  # start + (end - start) loses what a panel down to a thousandth of r has left
    place, velocity = (trial.panel.knots, along**2) if trial.by_root else (along, np.sqrt(trial.panel.knots))
    slowest, fastest, _ = front.velocity_bounds(rows)
    slide = front.slide.rows(rows)
    margins = np.ones((4, *place.shape))
    if slide.can_lose_contact():
        margins[CONTACT] = slide.normal(place, velocity**2) / slide.gravity
    margins[DEEPER] = np.where(slowest > 0.0, velocity / np.where(slowest > 0.0, slowest, 1.0) - 1.0, 1.0)
    margins[SHALLOWER] = 1.0 - velocity / fastest
    if trial.by_root:
        margins[END] = front.limit[rows] - place
    return margins


def _start_events(front: _Front, rows: Index) -> None:
    """Streams that have no contact where they enter, or stand above the wall there."""
    slide = front.slide
    lost = slide.normal(front.place, front.y) < -LEVEL * slide.gravity
    choked = slide.area(front.y) > slide.choke_area * (1.0 + LEVEL)
    _happen(front, rows[choked & ~lost], np.full(int((choked & ~lost).sum()), DEEPER))
    front.status[lost] = Status.CONTACT_LOST


def _happen(front: _Front, rows: Index, event: Index) -> None:
    """What an event does to the designs that stand at it."""
    front.aim[rows] = np.nan
    front.status[rows[event == CONTACT]] = Status.CONTACT_LOST
    deeper = rows[event == DEEPER]
    _, _, is_choke = front.velocity_bounds(deeper)
    choked = deeper[is_choke]
    front.choke[:, choked] = front.place[choked], front.y[choked], front.error[choked]
    if not front.effort.complete:
        front.status[choked] = Status.CHOKE
    front.facet[deeper[~is_choke]] += 1
    front.facet[rows[event == SHALLOWER]] -= 1
    ended = rows[event == END]
    front.place[ended] = front.limit[ended]
    _arrive(front, ended)


def _result(front: _Front) -> Stretch:
    """Where each design ended; a choke comes before whatever was found beyond it."""
    place, y, error = front.choke
    choked = np.isfinite(place)
    return Stretch(
        np.where(choked, Status.CHOKE, front.status),
        np.where(choked, place, front.place),
        np.where(choked, y, front.y),
        np.where(choked, error, front.error),
        np.where(choked, front.place, np.nan),
        front.pieces,
    )
