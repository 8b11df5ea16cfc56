"""A slow solver that shares nothing with chutecalc but the model: Gragg's midpoint rule extrapolated in 80-bit numbers.

Along one segment of a section without kinks (a base with endless chamfers, a vee, a rectangle) it follows share c and
r = √v over a variable σ with dc/dσ = 4 r³ w, dr/dσ = w dy/dc, where w, the square of the surface's and the base's
width times r, vanishes with r where the walls are vertical: smooth through rest, where velocity and depth are not.
Numbers are of `numpy.longdouble`, 64 bits of mantissa where the machine has them.
"""

from typing import NamedTuple

import numpy as np

Real = np.longdouble
ORDER = 10  # columns of the extrapolation
TOLERANCE = Real(1e-17)
STEPS = 120  # streams that need more cling to a balance, too stiff for an explicit rule: they are left open
OK, STALL, CONTACT_LOST = 0, 1, 3


class Flow(NamedTuple):
    """n streams, each on its segment; arrays of shape (n,)."""

    gravity: np.ndarray
    side: np.ndarray
    """1 on a floor, -1 under a roof."""
    slope: np.ndarray
    turn: np.ndarray
    length: np.ndarray
    rate: np.ndarray
    """m³/s."""
    base: np.ndarray
    chamfer: np.ndarray
    sine: np.ndarray
    """sin δ."""
    friction: np.ndarray
    """tan φ."""
    equilibrium: np.ndarray
    velocity: np.ndarray

    def some(self, rows):
        return Flow(*(field[rows] for field in self))


class Ended(NamedTuple):
    """Where each stream ends; arrays of shape (n,)."""

    status: np.ndarray
    """-1 where the solver gave up."""
    share: np.ndarray
    """Of its segment's length."""
    velocity: np.ndarray

    def some(self, rows):
        return Ended(*(field[rows] for field in self))


def real(flow):
    """Return numbers in 80 bits, each computed from the double that chutecalc is given."""
    return Flow(*(np.asarray(field).astype(Real) for field in flow))


def press(flow, c, r):
    """Normal acceleration."""
    slope = flow.slope + flow.turn * c
    return flow.side * (flow.gravity * np.cos(slope) - flow.turn / flow.length * r**4)


def rise(flow, c, r):
    """dc/dσ and dr/dσ."""
    cosine, sine = np.cos(flow.chamfer), np.sin(flow.chamfer)
    cosine = np.where(flow.chamfer == Real(np.pi / 2), Real(0), cosine)
    ratio = (1 + flow.sine * (1 - 2 * sine**2)) / (1 + flow.sine)
    meeting = 4 * cosine * flow.rate / sine
    wide = (flow.base * r + np.sqrt((flow.base * r) ** 2 + meeting)) ** 2
    share = 4 * flow.rate / sine  # over wide: what a load coefficient gets over the area
    walls = ratio * 2 * np.sin(flow.chamfer / 2) ** 2 * share
    carried = np.where(flow.equilibrium > 0, wide - (1 - ratio) * cosine * share, wide)
    slope = flow.slope + flow.turn * c
    drag = flow.friction * (wide + wide * walls / carried) * press(flow, c, r)
    scale = flow.base**2 + meeting
    return 4 * r**3 * wide / scale, 2 * flow.length * (flow.gravity * np.sin(slope) * wide - drag) / scale


def step(flow, c, r, h):
    """One extrapolated step, and its error relative to the state."""
    rows = []
    error = np.zeros(c.shape, Real)
    f0 = rise(flow, c, r)
    for k in range(ORDER):
        count = 2 * (k + 1)
        d = h / count
        before, now = (c, r), (c + d * f0[0], r + d * f0[1])
        for _ in range(count - 1):
            f = rise(flow, *now)
            before, now = now, (before[0] + 2 * d * f[0], before[1] + 2 * d * f[1])
        f = rise(flow, *now)
        row = [tuple((now[i] + before[i] + d * f[i]) / 2 for i in range(2))]
        for j in range(1, k + 1):
            shrink = (Real(count) / (2 * (k + 1 - j))) ** 2 - 1
            row.append(tuple(row[j - 1][i] + (row[j - 1][i] - rows[-1][j - 1][i]) / shrink for i in range(2)))
        rows.append(row)
    last, previous = rows[-1][-1], rows[-1][-2]
    error = np.maximum(abs(last[0] - previous[0]), abs(last[1] - previous[1]) / np.maximum(abs(r), Real(1e-8)))
    return last[0], last[1], error


def solve(flow):
    """Return where each stream ends."""
    flow = real(flow)
    n = len(flow.velocity)
    c, r = np.zeros(n, Real), np.sqrt(flow.velocity)
    status = np.full(n, -1)
    status[press(flow, c, r) < 0] = CONTACT_LOST
    with np.errstate(all="ignore"):
        h = Real(0.05) * r / np.maximum(abs(rise(flow, c, r)[1]), Real(1e-30))
        h = np.minimum(h, Real(0.05) / np.maximum(rise(flow, c, r)[0], Real(1e-30)))
        for _ in range(STEPS):
            rows = np.flatnonzero(status < 0)
            if not rows.size:
                break
            here = flow.some(rows)
            at, root, error = step(here, c[rows], r[rows], h[rows])
            dips = dipping(here, (c[rows], r[rows]), (at, root), h[rows])
            good = (error <= TOLERANCE * 50) & ~dips
            ended = good & ((at >= 1) | (root <= 0) | (press(here, at, root) < 0))
            on = rows[good & ~ended]
            c[on], r[on] = at[good & ~ended], root[good & ~ended]
            if ended.any():
                last = rows[ended]
                status[last], c[last], r[last] = finish(flow.some(last), c[last], r[last], h[last])
            growth = np.clip((TOLERANCE * 5 / np.maximum(error, Real(1e-30))) ** (Real(1) / (2 * ORDER - 1)), 0.1, 3)
            growth = np.where(np.isfinite(growth), growth, Real(0.1))
            h[rows] *= np.where(dips, np.minimum(growth, Real(0.5)), growth)
    return Ended(status, share=c, velocity=r**2)


def dipping(flow, start, end, h):
    """Return whether a stream that presses on its surface at both ends of a step leaves it in between, by a cubic."""
    value, change = [], []
    for c, r in (start, end):
        dc, dr = rise(flow, c, r)
        slope = flow.slope + flow.turn * c
        value.append(press(flow, c, r))
        bend = flow.gravity * np.sin(slope) * dc + 4 / flow.length * r**3 * dr
        change.append(-h * flow.side * flow.turn * bend)
    share = np.linspace(0, 1, 33)[1:-1, None]
    left, right = (1 - share) ** 2, share**2
    between = left * ((1 + 2 * share) * value[0] + share * change[0])
    between = between + right * ((3 - 2 * share) * value[1] - (1 - share) * change[1])
    return (value[0] >= 0) & (value[1] >= 0) & (between.min(axis=0) < 0)


def finish(flow, c, r, h):
    """Return the first of the events within a step: regula falsi, with Illinois' halving, on the step's length."""
    first, status, end = np.full(h.shape, np.inf, Real), np.full(h.shape, -1), (c, r)
    for kind, event in (
        (STALL, lambda at, root: root),  # first: beyond its rest a stream would come back into the segment
        (OK, lambda at, root: 1 - at),
        (CONTACT_LOST, lambda at, root: press(flow, at, root)),
    ):
        until = np.minimum(h, first)  # beyond the segment's end a stream may press on its surface again
        at, root, _ = step(flow, c, r, until)
        low, high, above, below = np.zeros(h.shape, Real), until, event(c, r), event(at, root)
        inside, side = below < 0, np.zeros(h.shape)
        for _ in range(20 if inside.any() else 0):
            middle = high - below * (high - low) / np.where(inside, below - above, 1)
            at, root, _ = step(flow, c, r, middle)
            value = event(at, root)
            over = value < 0
            above = np.where(over & (side > 0), above / 2, above)
            below = np.where(~over & (side < 0), below / 2, below)
            low, above = np.where(over, low, middle), np.where(over, above, value)
            high, below = np.where(over, middle, high), np.where(over, value, below)
            side = np.where(over, 1, -1)
        earlier = inside & (middle < first) if inside.any() else inside
        if earlier.any():
            first, status = np.where(earlier, middle, first), np.where(earlier, kind, status)
            end = tuple(np.where(earlier, new, old) for new, old in zip((at, root), end, strict=True))
    return status, end[0], np.maximum(end[1], 0)
