"""Sliding of the second solver: the equation of motion along one surface, smooth piece by smooth piece."""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, inf, sin, sqrt
from typing import Any

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq

from tests.verification.second_flights import Surface
from tests.verification.second_sections import Friction, Load, Section, between, section_of

RTOL = 1e-12
STEPS = 4000
SPLITS = 200


class UndecidedError(Exception):
    """The second solver cannot solve this case."""


@dataclass
class Setting:
    """What a stream slides on and what it is."""

    surface: Surface
    tables: tuple[dict[str, Any], dict[str, Any]]
    friction: Friction
    ratio: float
    law: str
    rate: float  # m³/s
    density: float
    g: float
    profile: float = 1.0  # momentum factor
    lengthwise: float = 0.0  # longitudinal pressure ratio

    def __post_init__(self) -> None:
        self.tapers = self.tables[0] != self.tables[1]
        self.fixed = section_of(self.tables[0], self.ratio)

    def section(self, u: float) -> Section:
        if not self.tapers:
            return self.fixed
        return section_of(between(*self.tables, u / self.surface.length), self.ratio)

    def load(self, u: float, v: float, piece: int | None = None) -> Load:
        return self.section(u).load(self.rate / v, piece)

    def press(self, u: float, v: float) -> float:
        """n."""
        surface = self.surface
        return surface.side * (self.g * cos(surface.slope_at(u)) + surface.kappa * self.profile * v * v)

    def accelerated(self, u: float, v: float, force: float, facet: int) -> tuple[float, float]:
        """Return v dv/ds times a positive factor, and that factor.

        Over ρ, momentum and pressure along the stream are M = α Q v + K n T, and dM/ds = A · force but for a taper's
        walls, which with the change of T at the same flow area come to -K n A times the change of depth there. So
        v dv/ds = (A · force - ∂M/∂s) v / (∂M/∂v), with derivatives of M by differences.
        """
        if self.lengthwise == 0:
            return force, self.profile
        section, area, surface, k = self.section(u), self.rate / v, self.surface, self.lengthwise

        def momentum(v: float) -> float:
            return self.profile * self.rate * v + k * self.press(u, v) * section.load(self.rate / v, facet).moment

        n, load = self.press(u, v), section.load(area, facet)
        turned = surface.side * surface.kappa * self.g * sin(surface.slope_at(u))  # ∂n/∂s at the same v
        change = k * turned * load.moment
        if self.tapers:
            deeper = _derivative(lambda at: self.section(at).load(area, facet).depth, u, 1e-2 * surface.length)
            change += k * n * area * deeper
        return force - change / area, _derivative(momentum, v, 1e-2 * v) / self.rate

    def stress(self, load: Load, n: float) -> float:
        return load.factor(self.law) * self.density * n * load.depth

    def equivalent(self, u: float, v: float) -> float:
        """μ_e, of a stream that slides here."""
        load = self.load(u, v)
        mu = self.friction.coefficient(self.stress(load, max(self.press(u, v), 0.0)))
        return mu * (1 + load.chi(self.law))

    def at_impact(self, u: float, v: float, incidence: float) -> float:
        """μ_e of a stream that strikes here, with the arriving velocity.

        On a yield locus it is the shear stress that the blow adds to what presses there anyway, over the blow: only so
        do many short straights tend to the curve, as section 5 asks, where a locus does not point to the origin.
        """
        load = self.load(u, v)
        scale = load.factor(self.law) * self.density * load.depth
        before = scale * max(0.0, self.press(u, v))
        blow = scale * v * v * sin(incidence) * max(sin(incidence) / load.depth, 1 / self.surface.length)
        return self.friction.secant(before, blow) * (1 + load.chi(self.law))

    def chokes(self, u: float, v: float) -> bool:
        section = self.section(u)
        return section.wall < inf and self.rate / v > section.area_at(section.wall)


def _derivative(function: Callable[[float], float], at: float, step: float) -> float:
    """Central differences of the eighth order."""
    weights = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    total = 0.0
    for k, weight in enumerate(weights, 1):
        total += weight * (function(at + k * step) - function(at - k * step))
    return total / step


@dataclass
class Slid:
    how: str  # end, stall, choke, lost
    u: float
    v: float


class _Piece:
    """The stretch on which depth stays on one facet and pressure on one row of the locus."""

    def __init__(self, setting: Setting, u: float, v: float) -> None:
        self.setting = setting
        load = setting.load(u, v)
        self.facet = setting.section(u).piece(load.area)
        self.row = setting.friction.piece(setting.stress(load, max(setting.press(u, v), 0.0)))

    def state(self, u: float, v: float) -> tuple[float, float, float, Section, float]:
        """Acceleration along the flow times the bracket, n, stress, section, and the bracket."""
        setting = self.setting
        section = setting.section(u)
        load = section.load(setting.rate / v, self.facet)
        n = setting.press(u, v)
        stress = setting.stress(load, n)
        mu = setting.friction.coefficient(stress, self.row) * (1 + load.chi(setting.law)) if n else 0.0
        force = setting.g * sin(setting.surface.slope_at(u)) - mu * n
        force, bracket = setting.accelerated(u, v, force, self.facet)
        return force, n, stress, section, bracket

    def rate(self, u: float, v: float) -> float:
        """Acceleration along the flow."""
        force, *_, bracket = self.state(u, v)
        return force / bracket

    def margins(self, u: float, v: float) -> list[float]:
        """Return what stays positive on this piece: bounds of facet and row, wall height, n, bracket; and the force."""
        setting = self.setting
        f, n, stress, section, bracket = self.state(u, v)
        area = setting.rate / v
        low, high = section.bounds(self.facet)
        out = [area / low - 1 if low else 1.0, 1 - area / high]
        first, last = setting.friction.bounds(self.row)
        out += [stress / first - 1 if first else 1.0, 1 - stress / last]
        out.append(1 - area / section.area_at(section.wall) if section.wall < inf else 1.0)
        out.append(n if setting.surface.kappa * setting.surface.side < 0 or setting.surface.side < 0 else 1.0)
        return [*out, bracket, f]


CREEP = 1e-3  # m/s: a stream that ends slower has stalled
CHOKE, LOST, JUMP, TURN, END, SWITCH = 4, 5, 6, 7, 8, 9


def slide(setting: Setting, u: float, v: float) -> Slid:
    """Follows a stream from u with velocity v to the surface's end or to what ends it."""
    piece = _Piece(setting, u, v)
    event = -1
    if piece.state(u, v)[-1] <= 0:
        return Slid("choke", u, v)
    for _ in range(SPLITS):
        event, u, v = _stretch(piece, u, v, event)
        if event == END:
            return Slid("end" if v >= CREEP else "stall", u, v)
        if v == 0:
            return Slid("stall", u, 0.0)
        if event in (CHOKE, LOST, JUMP):
            return Slid("lost" if event == LOST else "choke", u, v)
        if event in (0, 1):
            piece.facet += 2 * event - 1
        if event in (2, 3):
            piece.row += 2 * event - 5
    raise UndecidedError("too many pieces")


def _slow(f: float, v: float, length: float, share: float) -> bool:
    """Return whether the stream would stop within this share of the segment, at the force that it feels now."""
    return f < 0 and v * v < -2 * f * length * share


def _stretch(piece: _Piece, u: float, v: float, last_event: int) -> tuple[int, float, float]:
    """To the next event; y = v² over s, or, where the stream may come to rest, s over r = √v."""
    setting = piece.setting
    length = setting.surface.length
    beyond = 1.2 * length  # old SciPy tries its first step anywhere, where a taper may have no width
    least, most = 1e-12 * v * v, 10 * (v * v + 2 * setting.g * beyond)  # 10 times what gravity gives

    def speed_of(y: float) -> float:
        """v, also of a trial step: one that overshoots to rest meets a bed of any depth, and forces of any size."""
        return sqrt(min(max(y, least), most))

    slow = _slow(piece.rate(u, v), v, length, 0.2)
    if slow:

        def rhs(r: float, state: np.ndarray) -> list[float]:
            if r <= 0:
                return [0.0]
            force, *_, bracket = piece.state(min(float(state[0]), beyond), r * r)
            return [2 * r**3 * bracket / force]

        solver = DOP853(rhs, sqrt(v), [u], 0.0, rtol=RTOL, atol=RTOL * 1e-2 * length, max_step=sqrt(v) / 12)
    else:

        def rhs(s: float, state: np.ndarray) -> list[float]:
            return [2 * piece.rate(min(s, beyond), speed_of(float(state[0])))]

        solver = DOP853(rhs, u, [v * v], length, rtol=RTOL, atol=1e-200, max_step=length / 10)

    def state_at(t: float, y: float) -> tuple[float, float]:
        return (y, t * t) if slow else (t, sqrt(y))

    def watched(t: float, y: float) -> list[float]:
        if slow:
            at, speed = y, max(t * t, 1e-30)  # at rest it is deeper than any wall
        else:
            at, speed = t, speed_of(y)
        margins = piece.margins(at, speed)
        far = _ratio(margins[TURN] / abs(margins[JUMP]), speed, length)
        if slow:  # no turn can come before the stream is fast again
            return [*margins[:TURN], 1.0, length - at, 0.4 - far]
        return [*margins, 1.0, far - 0.1]

    before = watched(solver.t, float(solver.y[0]))
    if last_event == TURN:
        before[TURN] = 0.0
    t_begin = solver.t
    for _ in range(STEPS):
        message = solver.step()
        if solver.status == "failed":
            raise UndecidedError(f"integration: {message}")
        dense = solver.dense_output()
        last = solver.t_old
        for share in (0.25, 0.5, 0.75, 1.0):
            t = solver.t_old + (solver.t - solver.t_old) * share
            y = float(dense(t)[0] if share < 1 else solver.y[0])
            after = watched(t, y)
            hits = [k for k in range(10) if after[k] <= 0 < before[k] or (k == TURN and _turns(before[k], after[k]))]
            if t != solver.t and last == t_begin:
                back = [k for k in range(4) if before[k] <= 0 and after[k] < min(before[k], -1e-14)]
                if back:  # it stands on the edge of a piece, and goes the other way
                    return back[0], u, v
            if hits:
                return _first(hits, watched, dense, last, t, state_at)
            before, last = after, t
        if solver.status == "finished":
            if slow:
                return TURN, float(solver.y[0]), 0.0
            return END, length, sqrt(float(solver.y[0]))
    raise UndecidedError("too many steps")


def _ratio(f: float, v: float, length: float) -> float:
    """Stopping distance over the segment's length; large where nothing slows the stream."""
    return v * v / (-2 * f * length) if f < 0 and v * v < -2e3 * f * length else 1e3


def _first(
    hits: list[int],
    watched: Callable[[float, float], list[float]],
    dense: Callable[[float], np.ndarray],
    begin: float,
    end: float,
    state_at: Callable[[float, float], tuple[float, float]],
) -> tuple[int, float, float]:
    """Return the earliest of the events of a step."""
    found = []
    for hit in hits:

        def value(t: float, hit: int = hit) -> float:
            return watched(t, float(dense(t)[0]))[hit]

        one, other = value(begin), value(end)
        t = brentq(value, begin, end, xtol=1e-300, rtol=1e-15) if one * other < 0 else end
        found.append((abs(t - begin), hit, t))
    _, hit, t = min(found)
    u, v = state_at(t, float(dense(t)[0]))
    return hit, u, v


def _turns(before: float, after: float) -> bool:
    """Return whether the force changes sign; not where it is 0 up to rounding, on a stream at its balance."""
    return before * after < 0 and max(abs(before), abs(after)) > 1e-8
