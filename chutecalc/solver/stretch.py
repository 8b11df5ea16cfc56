"""One contact segment for many designs: adaptive panels, and the events that end or divide a stretch.

Each design first tries the whole way in one panel. Where the two rules disagree it goes on in its own steps: in c while
the velocity changes gently, in r = √v towards a stop or away from rest. A panel never crosses a kink of the friction
law (the top of a facet, a row of a yield locus): it is cut there, as where the stream chokes or loses contact.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Index, Mask, shared
from chutecalc.solver.collocation import rule
from chutecalc.solver.crossing import LEVEL, evaluate, first_crossing
from chutecalc.solver.front import CHOKE, END, RUNNING, Effort, Front, Piece, Trial
from chutecalc.solver.panel import CLINGING, PLACE, ROOT, WHOLE, Panel, panel_by_place, panel_by_root
from chutecalc.solver.slide import Slide, field, linearised

STOPPING, STARTING = 0.5, 0.02  # of the way that is left: rest nearer than that ahead or behind takes a panel in r
SHY, AWAY = 0.667, 2.0  # of the distance to rest ahead or behind: as far as a panel in c may reach
STIFF = -6.0  # ∂f/∂y times a panel's length from which on the stream clings to a balance

NEAR_REST = (16, 24)  # the rules of a panel in r: on fewer nodes it is taken half as often
PASSES = 2000  # a bound, so that no input can hang
AT_END, ROUNDING = 1e-12, 1e-15  # of a panel, and of its variable: an event so near its end is at its end
CLOSE, BEYOND = 0.98, 1e-6  # of a panel: an event behind that is near its end; how far beyond an event the next goes
WELL_WITHIN = 10.0  # times the error of a panel's end, that its inside may have where it is cut
CREEP, PATIENCE = 1e-5, 300  # m/s below which a stream that needs more panels than that counts as stalled
BLOCK = 32768  # values in an array, nodes times designs: a dozen such arrays stay in the cache
MANY = 2048  # designs from which on the C library should keep memory


class Stretch(NamedTuple):
    """What became of the designs on a segment, an entry each."""

    status: Index
    place: Array
    """c where the stretch ends."""
    velocity_squared: Array
    error: Array
    """Relative, of v²; after a stall, of the place in c."""
    beyond: Array
    """After a choke: c where the stream would end on the segment between higher walls; NaN else."""
    beyond_status: Index
    """After a choke: how it would end there."""
    pieces: list[Piece]

    @classmethod
    def standing(cls, place: Array, velocity_squared: Array, error: Array) -> "Stretch":
        """Designs that go no way on the segment, and are well."""
        status = np.full(place.shape, Status.OK)
        return cls(status, place, velocity_squared, error, np.full(place.shape, np.nan), status, [])


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
    if not place.size:
        return Stretch.standing(place, velocity_squared, error)
    if len(place) >= MANY:
        _keep_memory()
    front = Front(slide, place, velocity_squared, error, effort)
    running = np.arange(len(place))
    if front.events:
        _start_events(front, running)
        running = np.flatnonzero(front.status == RUNNING)
    for number, pair in enumerate(effort.whole):
        _advance(front, running, PLACE if number else WHOLE, front.limit[running], pair, effort.tolerance)
        running = running[front.hopeful[running]]
    for passes in range(PASSES):
        running = np.flatnonzero(front.status == RUNNING)
        if passes > PATIENCE:  # it clings to a balance next to rest, where no place of a stall can be told
            creeping = running[front.y[running] < CREEP**2]
            front.status[creeping], front.error[creeping] = Status.STALL, 1.0 - front.place[creeping]
            running = np.flatnonzero(front.status == RUNNING)
        if not running.size:
            return _result(front)
        change, growth = _change(front, running)
        if _cross_boundaries(front, running, change):
            continue
        by_root, target = _choose(front, running, change)
        stiff = growth * (target - front.place[running]) < STIFF
        for way, chosen in ((ROOT, by_root), (PLACE, ~by_root & ~stiff), (CLINGING, ~by_root & stiff)):
            pair = NEAR_REST if way == ROOT else effort.later
            _advance(front, running[chosen], way, target[chosen], pair, effort.share)
    raise RuntimeError(f"a contact segment was not solved in {PASSES} panels")


@cache
def _keep_memory() -> None:
    """Has the C library keep freed memory for the next array instead of giving it back to the system each time.

    glibc learns from the largest block freed so far (up to 32 MiB) what to keep; page faults of temporary arrays took
    longer than the arithmetic on them. Elsewhere it does nothing. The block is never touched, so it takes no memory.
    """
    block = np.empty(2**22 - 2**10)
    del block


def _start_events(front: Front, rows: Index) -> None:
    """Streams that have no contact where they enter, or stand above the wall there."""
    slide = front.slide
    lost = slide.normal(front.place, front.y) < -LEVEL * slide.gravity
    if CHOKE in front.events:
        choked = ~lost & (slide.area(front.y) > slide.choke_area(front.place) * (1.0 + LEVEL))
        front.happen(rows[choked], np.full(int(choked.sum()), CHOKE))
    front.status[lost] = Status.CONTACT_LOST


def _change(front: Front, rows: Index) -> tuple[Array, Array]:
    """dy/dc where the designs stand, and its derivative to y."""
    at = field(front.course(rows), front.place[rows], np.ones(1))
    y = front.y[rows] / at.unit
    near = linearised(at, y)
    return (near.forcing + near.growth * y) * at.unit, near.growth


def _cross_boundaries(front: Front, rows: Index, change: Array) -> bool:
    """Takes designs that stand at an event, on their way into it, beyond it.

    Not those that have just come over one there: where a stream clings to a balance, which way it goes in the first
    instant is noise, and only a panel tells.
    """
    fresh = front.place[rows] != front.crossed[rows]
    rows, change = rows[fresh], change[fresh]
    if not (front.events and rows.size):
        return False
    place, y, step = front.place[rows], front.y[rows], 1e-6
    here = front.margins(rows, place, y, False)
    if not (here <= LEVEL).any():
        return False
    along = front.margins(rows, place + step, y, False) - here  # 0 but on tapers, and where pressure or contact counts
    faster = front.margins(rows, place, y * (1.0 + step), False) - here
    into = (here <= LEVEL) & (along + faster * change / y < 0.0)
    leaving = into.any(axis=0)
    front.happen(rows[leaving], np.array(front.events)[into.argmax(axis=0)[leaving]])
    return bool(leaving.any())


def _choose(front: Front, rows: Index, change: Array) -> tuple[Mask, Array]:
    """The variable and the end of each design's next panel.

    In r towards a stop that is near, or away from a start near rest; in c else. Panels that turn out too long are
    refused and shortened.
    """
    place, y = front.place[rows], front.y[rows]
    rest = front.limit[rows] - place
    scale = np.abs(y / change)
    slowest, fastest = front.velocity_bounds(rows)
    fresh = ~front.tired[rows]
    stopping = fresh & (change < 0.0) & (scale < STOPPING * rest)
    starting = fresh & (change > 0.0) & (scale < STARTING * rest)
    far = np.minimum((y + 0.5 * change * rest) ** 0.25, np.sqrt(fastest))
    clear = np.where(change < 0.0, SHY, AWAY) * scale
    step = np.minimum(front.reach[rows], clear)
    by_place = np.where(step < rest, place + step, front.limit[rows])
    by_root = stopping | starting
    root = np.sqrt(np.sqrt(y))
    goal = np.where(stopping, np.sqrt(slowest), far)
    stride = front.stride[rows]
    towards = np.where(stride < 1.0, root + stride * (goal - root), goal)
    target = np.where(by_root, towards, by_place)
    aimed = np.isfinite(front.aim[rows])
    return np.where(aimed, front.aim_by_root[rows], by_root), np.where(aimed, front.aim[rows], target)


def _advance(front: Front, rows: Index, way: int, target: Array, pair: tuple[int, int], tolerance: float) -> None:
    """Solves one panel for each of the rows, a block of designs at a time, and judges it."""
    block, by_root = BLOCK // pair[1] // 8 * 8, way == ROOT
    neighbours = len(rows) == len(front.place)  # then they are all, in order
    for first in range(0, len(rows), block):
        chunk, end = rows[first : first + block], target[first : first + block]
        window: Index | slice = slice(first, first + len(chunk)) if neighbours else chunk
        padded, inside = chunk, window
        if len(chunk) % 8:
            pad = np.minimum(np.arange(-(-len(chunk) // 8) * 8), len(chunk) - 1)
            padded, end = chunk[pad], end[pad]
            inside = padded
        course = front.course(inside)
        place, y = np.array(front.place[inside]), front.y[inside]
        if by_root:
            start = np.sqrt(np.sqrt(y))
            panel = panel_by_root(course, start, end - start, place, pair)
        else:
            start = place
            panel = panel_by_place(course, shared(start), shared(end - start), y, pair, way)
        good = panel.error <= tolerance
        if front.effort.complete:
            good &= panel.inner_error <= front.effort.inner_tolerance
        _judge(front, Trial(padded, window, by_root, start, end, panel, good), len(chunk))


def _judge(front: Front, trial: Trial, count: int) -> None:
    """Takes each panel, or sets what to try instead: a shorter one, or one that ends where an event lies inside it."""
    rows, start, end = trial.rows[:count], trial.start[:count], trial.end[:count]
    good = trial.good[:count]
    all_good = bool(good.all())
    front.hopeful[trial.window] = False if all_good else ~good & np.isfinite(trial.panel.error[:count])
    if not all_good:
        front.retreat(rows[~good], trial.by_root, (end - start)[~good])
    if not (front.events or trial.by_root):
        front.accept(trial, slice(count) if all_good else np.flatnonzero(good))
        return
    cut, event, hit = _events(front, trial)
    cut, event, hit = cut[:count], event[:count], hit[:, :count]
    near = AT_END + ROUNDING * np.abs(end / (end - start))
    cut = np.where((cut > 1.0 - near) & (cut < 1.0), np.inf, cut)  # found before, and aimed at
    aim = start + cut * (end - start)
    cut = np.where((cut < 1.0) & (np.abs(aim - start) <= ROUNDING * np.abs(start)), 0.0, cut)
    inside = good & (cut < 1.0) & (cut > 0.0)
    inner_error = trial.panel.inner_error[:count]
    short = inside & (inner_error <= WELL_WITHIN * front.effort.share)
    _accept_part(front, trial, np.flatnonzero(short), cut, event)
    # Where the event is only roughly known, the next panel goes a little beyond it: then it lies inside.
    spare = np.where(cut < CLOSE, 1.0 + np.minimum(BEYOND + 10.0 * inner_error, 0.01), 1.0)
    aimed = inside & ~short
    front.aim[rows[aimed]] = (start + cut * spare * (end - start))[aimed]
    front.aim_by_root[rows[aimed]] = trial.by_root
    at_once = good & (cut == 0.0)
    back = at_once & (front.place[rows] == front.crossed[rows])
    front.chatter(rows[back], trial.by_root, (end - start)[back])
    front.happen(rows[at_once], event[at_once])
    whole = np.flatnonzero(good & (cut > 1.0))
    front.accept(trial, whole)
    hit = hit[:, whole]
    stands = hit.any(axis=0)
    front.happen(rows[whole][stands], np.array([*front.events, END])[hit.argmax(axis=0)[stands]])


def _events(front: Front, trial: Trial) -> tuple[Array, Index, Mask]:
    """Of a panel: the share of it at which the first event lies, which that is, and which it ends at, one by one."""
    along = trial.start + rule(len(trial.panel.knots) - 2).knots[:, None] * (trial.end - trial.start)
    along[-1] = trial.end  # start + (end - start) loses what a panel down to a thousandth of r has left
    place, y = (trial.panel.knots, along**4) if trial.by_root else (along, trial.panel.knots)
    margins = front.margins(trial.rows, place, y, trial.by_root)
    crossings = np.stack([first_crossing(margin) for margin in margins])
    event = np.array([*front.events, END])[crossings.argmin(axis=0)]
    return crossings.min(axis=0), event, (margins[:, -1] <= LEVEL) & (margins[:, -1] < margins[:, 0])


def _accept_part(front: Front, trial: Trial, chosen: Index, cut: Array, event: Index) -> None:
    """Takes panels up to an event inside them, where their polynomials are right too."""
    if not chosen.size:
        return
    rows, cut, panel = trial.rows[chosen], cut[chosen], trial.panel
    start, inner_error = trial.start[chosen], panel.inner_error[chosen]
    end = start + cut * (trial.end[chosen] - start)
    knots = evaluate(panel.knots[:, chosen], cut * rule(len(panel.knots) - 2).knots[:, None])
    growth = evaluate(np.concatenate([np.ones((1, len(rows))), panel.growth[:, chosen]]), cut[None])
    part = Panel(knots, growth, inner_error, inner_error, panel.rounding[chosen])
    front.accept(Trial(rows, rows, trial.by_root, start, end, part, trial.good[chosen]), slice(len(rows)))
    front.happen(rows, event[chosen])


def _result(front: Front) -> Stretch:
    """Where each design ended; a choke comes before whatever was found beyond it."""
    place, y, error = front.choke
    if CHOKE not in front.events or not (choked := np.isfinite(place)).any():
        none = np.full(place.shape, np.nan)
        return Stretch(front.status, front.place, front.y, front.error, none, front.status, front.pieces)
    return Stretch(
        np.where(choked, Status.CHOKE, front.status),
        np.where(choked, place, front.place),
        np.where(choked, y, front.y),
        np.where(choked, error, front.error),
        np.where(choked, front.place, np.nan),
        front.status,
        front.pieces,
    )
