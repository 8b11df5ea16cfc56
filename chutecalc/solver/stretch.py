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
from chutecalc.solver.events import cross_boundaries, judge, start_events
from chutecalc.solver.front import CHOKE, LEAST_STEP, RUNNING, Effort, Front, Piece, Trial
from chutecalc.solver.panel import CLINGING, PLACE, ROOT, WHOLE, panel_by_place, panel_by_root
from chutecalc.solver.slide import Slide, field, linearised

STOPPING, STARTING = 0.5, 0.02  # of the way that is left: rest nearer than that ahead or behind takes a panel in r
SHY, AWAY = 0.667, 2.0  # of the distance to rest ahead or behind: as far as a panel in c may reach
STIFF = -6.0  # ∂f/∂y times a panel's length from which on the stream clings to a balance

NEAR_REST = (16, 24)  # the rules of a panel in r: on fewer nodes it is taken half as often
PASSES = 2000  # a bound, so that no input can hang
CREEP, PATIENCE = 1e-3, 60  # m/s below which a stream that needs more panels than that counts as stalled
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
        start_events(front, running)
        running = np.flatnonzero(front.status == RUNNING)
    for number, pair in enumerate(effort.whole):
        _advance(front, running, PLACE if number else WHOLE, front.limit[running], pair, effort.tolerance)
        running = running[front.hopeful[running]]
    for _ in range(PASSES):
        running = np.flatnonzero(front.status == RUNNING)
        if not running.size:
            return _result(front)
        change, growth = _change(front, running)
        if _stop(front, running, change) or cross_boundaries(front, running, change):
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


def _change(front: Front, rows: Index) -> tuple[Array, Array]:
    """dy/dc where the designs stand, and its derivative to y."""
    at = field(front.course(rows), front.place[rows], np.ones(1))
    y = front.y[rows] / at.unit
    near = linearised(at, y)
    return (near.forcing + near.growth * y) * at.unit, near.growth


def _stop(front: Front, rows: Index, change: Array) -> bool:
    """Stalls that no panel finds: where rest is nearer than any step, or a stream clings to a balance next to it.

    Of the second no place could be told: its error is what is left of the segment.
    """
    place, y = front.place[rows], front.y[rows]
    near = y < -2.0 * LEAST_STEP * change  # from twice as far the least step is short enough
    creeping = ~near & (front.tried[rows] > PATIENCE) & (y < CREEP**2)
    stopped = near | creeping
    front.status[rows[stopped]] = Status.STALL
    front.y[rows[near]], front.error[rows[near]] = 0.0, 2.0 * LEAST_STEP
    front.error[rows[creeping]] = 1.0 - place[creeping]
    return bool(stopped.any())


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
    if not rows.size:
        return
    front.tried[rows] += 1
    by_root = way == ROOT
    blocks = -(-len(rows) * pair[1] // BLOCK)
    block = -(-len(rows) // blocks // 8) * 8  # all alike: a small last one costs as many calls
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
        judge(front, Trial(padded, window, by_root, start, end, panel, good), len(chunk))


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
