"""What a solved panel means to the designs on it: taken whole, up to an event inside it, or tried again shorter."""

import numpy as np

from chutecalc.design import Status
from chutecalc.physics.arrays import Array, Index, Mask
from chutecalc.solver.collocation import rule
from chutecalc.solver.crossing import LEVEL, evaluate, first_crossing
from chutecalc.solver.front import CHOKE, END, Front, Trial
from chutecalc.solver.panel import Panel

AT_END, ROUNDING = 1e-12, 1e-15  # of a panel, and of its variable: an event so near its end is at its end
CLOSE, BEYOND = 0.98, 1e-6  # of a panel: an event behind that is near its end; how far beyond an event the next goes
WELL_WITHIN = 10.0  # times the error of a panel's end, that its inside may have where it is cut


def start_events(front: Front, rows: Index) -> None:
    """Streams that have no contact where they enter, or stand above the wall there."""
    slide = front.slide
    lost = slide.normal(front.place, front.y) < -LEVEL * slide.gravity
    if CHOKE in front.events:
        choked = ~lost & (slide.area(front.y) > slide.choke_area(front.place) * (1.0 + LEVEL))
        front.happen(rows[choked], np.full(int(choked.sum()), CHOKE))
    front.status[lost] = Status.CONTACT_LOST


def cross_boundaries(front: Front, rows: Index, change: Array) -> bool:
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


def judge(front: Front, trial: Trial, count: int) -> None:
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
    cut = np.where(cut > 1.0 - near, np.inf, cut)  # found before, and aimed at
    aim = start + cut * (end - start)
    cut = np.where((cut < 1.0) & (np.abs(aim - start) <= ROUNDING * np.abs(start)), 0.0, cut)
    inside = good & (cut < 1.0) & (cut > 0.0)
    inner_error = trial.panel.inner_error[:count]
    short = inside & (inner_error <= WELL_WITHIN * front.effort.share)
    short &= _happens(front, trial, np.flatnonzero(short), cut, event)
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
    margins = _margins(front, trial.rows, trial.by_root, along, trial.panel.knots)
    crossings = np.stack([first_crossing(margin) for margin in margins])
    event = np.array([*front.events, END])[crossings.argmin(axis=0)]
    return crossings.min(axis=0), event, (margins[:, -1] <= LEVEL) & (margins[:, -1] < margins[:, 0])


def _margins(front: Front, rows: Index, by_root: bool, along: Array, unknown: Array) -> Array:
    """How far each event is, where a panel's variable and its unknown have these values."""
    place, y = (unknown, along**4) if by_root else (along, unknown)
    return front.margins(rows, place, y, by_root)


def _happens(front: Front, trial: Trial, chosen: Index, cut: Array, event: Index) -> Mask:
    """Whether the event is where its margin's polynomial falls to 0.

    Not at the bottom of a dip, nor where a taper bends the margin more than its polynomial can.
    """
    there = np.zeros(len(cut), dtype=bool)
    if chosen.size:
        share, panel = cut[chosen], trial.panel
        along = trial.start[chosen] + share * (trial.end[chosen] - trial.start[chosen])
        unknown = evaluate(panel.knots[:, chosen], share[None])[0]
        margins = _margins(front, trial.rows[chosen], trial.by_root, along, unknown)
        names = np.array([*front.events, END])[: len(margins)]
        own = margins[(names[:, None] == event[chosen]).argmax(axis=0), np.arange(len(chosen))]
        there[chosen] = np.abs(own) <= LEVEL + WELL_WITHIN * panel.inner_error[chosen]
    return there


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
